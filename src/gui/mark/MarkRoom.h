#pragma once
#include <memory>
#include <vector>

#include "gui/mark/MarkGrips.h"
#include "gui/mark/MarkPanel.h"
#include "gui/mark/MarkTool.h"
#include "gui/view/Room.h"

namespace velum::gui {

/// Marks and all other lettering: the page, the tools that set marks, and what stands over the views to be dragged.
class MarkRoom : public Room {
  Q_OBJECT
 public:
  explicit MarkRoom(const WindowParts& parts);
  void refresh(const session::Session& session) override;
  /// Adds a caption, and gives the keyboard to its words.
  void addCaption();

 private:
  void addTools(QMenu* menu);
  void addActions(QMenu* menu);
  void rename(int mark);

  MarkMenu mMenu;
  MarkPanel* mPanel;
  MarkGrips mGrips;
  std::vector<std::unique_ptr<MarkTool>> mTools;
  QAction* mNames = nullptr;
};

}  // namespace velum::gui
