#pragma once
#include "gui/rows/BarList.h"
#include "gui/structure/StructureModel.h"

namespace velum::gui {

class StructureCommands;

/// The list of structures: an eye, a colour, the name, the size, an opacity that is dragged, and S for solo. What is
/// done to a selected row is done to all selected rows.
class StructureList : public BarList {
  Q_OBJECT
 public:
  StructureList(StructureCommands& commands, AreaMeter& areas, QWidget* parent);
  /// What stands beside the names: sizes with opacities, sizes with the scan's values, or bars that tell how much of
  /// each structure is seen.
  enum class Shown { Opacity, Values, Bars };
  void setShown(Shown shown);
  CountBar barOf(int id) const { return mModel->barOf(id, cellOf(id, StructureModel::Bar)); }

  StructureModel& rows() { return *mModel; }
  StructureOrder& order() { return *mOrder; }
  /// Ids of the rows that are selected, in the order of the rows.
  std::vector<int> selectedIds() const;
  /// Ids of the rows that the search leaves.
  std::vector<int> listedIds() const;
  /// Selects a structure's row and brings it into view; 0 selects nothing.
  void selectId(int id);
  void editName(int id);
  /// Where a column of a structure's row is, for tests.
  QRect cellOf(int id, StructureModel::Column column) const;

 signals:
  /// The user has selected another structure; 0: none.
  void picked(int id);

 protected:
  bool pressCell(const QModelIndex& index, QMouseEvent* event) override;
  void dragKnob(double x) override;
  void letKnobGo() override;
  bool isKnobHeld() const override { return mAreas.isHeld(); }
  void giveKnobUp() override;
  void stepKnob(int steps, bool isSeen) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

 private:
  std::vector<int> idsFor(int id) const;
  void dragOpacity(int x);
  void chooseColor(int id);

  bool takeBar(int id, double x);

  StructureCommands& mCommands;
  AreaMeter& mAreas;
  StructureModel* mModel;
  StructureOrder* mOrder;
  int mBarId = 0;      ///< The structure whose bar is dragged; 0: none.
  int mOpacityId = 0;  ///< The structure whose opacity is dragged; 0: none.
  bool mIsQuiet = false;
};

}  // namespace velum::gui
