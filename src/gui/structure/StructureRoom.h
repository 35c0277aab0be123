#pragma once
#include "gui/structure/StructureCommands.h"
#include "gui/structure/StructurePanel.h"
#include "gui/view/Room.h"

namespace velum::gui {

/// Labelled structures: their list, what can be done to them, and what a click on one in a view does.
class StructureRoom : public Room {
  Q_OBJECT
 public:
  explicit StructureRoom(const WindowParts& parts);
  void refresh(const session::Session& session) override;
  StructureCommands& commands() { return *mCommands; }
  AreaMeter& areas() { return *mAreas; }
  /// Of the rows that are selected in the list.
  std::vector<int> selectedIds() const { return mPanel->selectedIds(); }

 signals:
  /// A file of labels for what is open is to be chosen.
  void openLabelsAsked();
  /// Something is to be searched where the page of structures is not there.
  void findAskedElsewhere();

 private:
  void addActions();
  void connectViews();
  void smooth(const std::vector<int>& ids, double deviation);

  StructureCommands* mCommands;
  AreaMeter* mAreas;
  StructurePanel* mPanel;
  bool mIsModelAlone = false;  ///< Nothing is open that could have structures.
};

}  // namespace velum::gui
