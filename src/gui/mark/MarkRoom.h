#pragma once
#include <memory>
#include <vector>

#include "gui/mark/MarkGrips.h"
#include "gui/mark/MarkPanel.h"
#include "gui/mark/MarkTool.h"
#include "gui/service/NewestJob.h"
#include "gui/view/LetteringOverlay.h"
#include "gui/view/Room.h"

namespace velum::gui {

/// Marks and all other lettering: the page, the tools that set marks, and what stands over the views to be dragged.
class MarkRoom : public Room {
  Q_OBJECT
 public:
  /// @param lettering  paints the marks; outlives the room
  MarkRoom(const WindowParts& parts, LetteringOverlay& lettering);
  void refresh(const session::Session& session) override;
  /// Adds a caption, and gives the keyboard to its words.
  void addCaption();
  /// Measures all marks and structures and writes the table. @param path  .csv or .json
  void saveTableTo(const QString& path);

 private:
  void addTools(QMenu* menu);
  void addActions(QMenu* menu);
  void saveTable();
  void rename(int mark);
  void measure(const session::Session& session);

  LetteringOverlay& mLettering;
  NewestJob mMeter;
  scene::Scene mMeasured;  ///< what the marks measured last depended on
  MarkMenu mMenu;
  MarkPanel* mPanel;
  MarkGrips mGrips;
  std::vector<std::unique_ptr<MarkTool>> mTools;
  QAction* mNames = nullptr;
};

}  // namespace velum::gui
