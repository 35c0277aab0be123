#pragma once
#include "gui/structure/StructureCommands.h"
#include "gui/structure/StructurePanel.h"
#include "gui/view/Room.h"

namespace velum::gui {

/// Labelled structures: their list, their commands, and what a click on a structure in a view does.
class StructureRoom : public Room {
  Q_OBJECT
 public:
  explicit StructureRoom(const WindowParts& parts);
  void refresh(const session::Session& session) override;
  StructureCommands& commands() { return *mCommands; }
  AreaMeter& areas() { return *mAreas; }
  /// Ids of the structures whose rows are selected in the list.
  std::vector<int> selectedIds() const { return mPanel->selectedIds(); }

 signals:
  /// A file of labels for what is open is to be chosen.
  void openLabelsAsked();
  /// The user wants to search while the page of structures is hidden: another room has to do it.
  void findAskedElsewhere();

 private:
  void addActions();
  void connectViews();
  void smooth(const std::vector<int>& ids, double deviation);

  StructureCommands* mCommands;
  AreaMeter* mAreas;
  StructurePanel* mPanel;
  bool mIsModelAlone = false;  ///< Only a model is open, and nothing that could have labels.
};

}  // namespace velum::gui
