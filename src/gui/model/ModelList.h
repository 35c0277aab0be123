#pragma once
#include "gui/model/Equalizer.h"
#include "gui/model/ModelCommands.h"
#include "gui/model/ModelDelegate.h"
#include "gui/model/ModelTree.h"
#include "gui/rows/BarList.h"

namespace velum::gui {

/// The tree of compartments and types: an eye, a colour, the name, a bar of how many instances are seen, hidden and
/// removed ([VE] 7), whose handles set these numbers, and a number. What is done to a selected row is done to all
/// selected rows; what is done to a compartment is done to all types below it. A drag of a bar acts on its own row
/// alone.
class ModelList : public BarList {
  Q_OBJECT
 public:
  ModelList(ModelCommands& commands, Equalizer& equalizer, QWidget* parent);

  ModelTree& tree() { return *mTree; }
  TypeOrder& order() { return *mOrder; }
  /// Shows the layer; opens the tree of another model as far as its rows have room.
  void showLayer(const scene::ModelLayer& layer);
  void setSearch(const QString& text);
  /// The types of the rows that are selected; listedTypes(): of the rows that the search leaves.
  session::TypeNumbers selectedTypes() const;
  session::TypeNumbers listedTypes() const;
  /// The path of the current row; empty: there is none, or it is the row of all types.
  std::string selectedPath() const;
  /// Opens the field in which a row's name is typed. @param path  of a type or compartment
  void startRename(const std::string& path);
  /// Selects a type's row and brings it into view; -1 selects nothing.
  void selectType(int type);
  /// Shows bars in percent of each row's own total; false: as numbers on a ruler that all rows share.
  void setPercent(bool percent);
  /// Sets the type that is under the pointer in the picture; -1: none.
  void setPointed(int type);
  /// Where a row's bar and its parts are, for tests. @param row  of the tree
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
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

 private:
  const TypeTree::Row& rowOf(const QModelIndex& shown) const;
  session::TypeNumbers typesFor(const QModelIndex& shown) const;
  void openSome();
  void fitNumbers();
  void showCounts();
  void sayWords(const QString& words);
  Equalizer::Handle handleAt(const QModelIndex& index, double x) const;
  bool takeHandle(const QModelIndex& index, double x);
  void setTyped(const QModelIndex& index, const QString& text);
  void setName(const QModelIndex& index, const QString& text);
  void tellHover(const QModelIndex& index);

  ModelCommands& mCommands;
  Equalizer& mEqualizer;
  ModelTree* mTree;
  TypeOrder* mOrder;
  ModelDelegate* mDelegate;
  QPersistentModelIndex mHeldBar;  ///< The row whose bar's handle is dragged.
  int mHoveredRow = -1;
  bool mIsQuiet = false;
};

}  // namespace velum::gui
