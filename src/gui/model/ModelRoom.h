#pragma once
#include "Legend.h"
#include "ModelPanel.h"
#include "view/Room.h"

namespace velum::gui {

/// Models of molecules: their page, their legend, and what a click on an instance does.
class ModelRoom : public Room {
  Q_OBJECT
 public:
  explicit ModelRoom(const WindowParts& parts);
  void refresh(const session::Session&) override;
  ModelCommands& commands() { return *mCommands; }
  Legend& legend() { return mLegend; }
  void findType();
  /// Puts the legend over the handles that are there by now.
  void addLegend() { mParts.toolbox.add(mLegend); }

 private:
  void connectViews();
  void addActions();
  void showLegend(bool shown);

  ModelCommands* mCommands;
  ModelPanel* mPanel;
  Legend mLegend;
  QAction* mLegendAction = nullptr;
  bool mHadModel = false;
};

}  // namespace velum::gui
