#pragma once
#include "gui/model/Equalizer.h"
#include "gui/model/ModelCommands.h"
#include "gui/model/ModelDelegate.h"
#include "gui/model/ModelTree.h"
#include "gui/rows/BarList.h"

namespace velum::gui {

/// The tree of compartments and types: an eye, a colour, the name, a bar of what is seen, hidden and removed ([VE] 7),
/// whose handles set how much is, and a number. What is done to a selected row is done to all that are selected; what
/// is done to a compartment, to all below it. A bar is its row's alone.
class ModelList : public BarList {
  Q_OBJECT
 public:
  ModelList(ModelCommands& commands, Equalizer& equalizer, QWidget* parent);

  ModelTree& tree() { return *mTree; }
  TypeOrder& order() { return *mOrder; }
  /// Follows the layer; opens what is new as far as it has room.
  void showLayer(const scene::ModelLayer& layer);
  void setSearch(const QString& text);
  /// Types of the rows that are selected, and of those that the search leaves.
  session::TypeNumbers selectedTypes() const;
  session::TypeNumbers listedTypes() const;
  /// Of the row that the keyboard is in; empty: none, or that of all types.
  std::string selectedPath() const;
  /// Selects a type's row and brings it into view; -1 selects nothing.
  void selectType(int type);
  /// Bars in percent of their rows; else numbers on a ruler that all share.
  void setPercent(bool percent);
  /// The type under the pointer in the picture; -1: none.
  void setPointed(int type);
  /// The ends of a row's bar, for tests. @param row  of the tree
  CountBar barOf(int row) const;
  /// Where a column of a type's or a compartment's row is, for tests.
  QRect cellOfType(int type, ModelTree::Column column) const;

 signals:
  /// The user has selected a type; -1: none, or a compartment.
  void picked(int type);
  /// The pointer is on the row of these types; none: on no row.
  void hovered(const velum::session::TypeNumbers& types);
  void refused(const QString& why);

 protected:
  bool pressCell(const QModelIndex& index, QMouseEvent* event) override;
  void dragKnob(double x) override;
  void letKnobGo() override;
  bool isKnobHeld() const override { return mEqualizer.isHeld(); }
  void giveKnobUp() override;
  void stepKnob(int steps, bool isSeen) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

 private:
  const TypeTree::Row& rowOf(const QModelIndex& shown) const;
  session::TypeNumbers typesFor(const QModelIndex& shown) const;
  void openSome();
  void showCounts();
  void sayWords(const QString& words);
  Equalizer::Handle handleAt(const QModelIndex& index, double x) const;
  bool takeHandle(const QModelIndex& index, double x);
  void setTyped(const QModelIndex& index, const QString& text);
  void tellHover(const QModelIndex& index);

  ModelCommands& mCommands;
  Equalizer& mEqualizer;
  ModelTree* mTree;
  TypeOrder* mOrder;
  ModelDelegate* mDelegate;
  QPersistentModelIndex mHeldBar;  ///< Whose handle is dragged.
  int mHoveredRow = -1;
  bool mIsQuiet = false;
};

}  // namespace velum::gui
