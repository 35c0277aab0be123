#pragma once
#include <QTreeView>

#include "ModelCommands.h"
#include "ModelTree.h"

namespace velum::gui {

/// The tree of compartments and types: an eye, a colour, the name, how many instances. What is done to a selected row
/// is done to all that are selected; what is done to a compartment, to all below it.
class ModelList : public QTreeView {
  Q_OBJECT
 public:
  ModelList(ModelCommands& commands, QWidget* parent);

  ModelTree& tree() { return *mTree; }
  TypeOrder& order() { return *mOrder; }
  /// Follows the layer; opens what is new as far as it has room.
  void showLayer(const scene::ModelLayer& layer);
  void setSearch(const QString& text);
  /// Types of the rows that are selected, and of those that the search leaves.
  session::TypeNumbers selectedTypes() const;
  session::TypeNumbers listedTypes() const;
  /// Selects a type's row and brings it into view; -1 selects nothing.
  void selectType(int type);
  /// Where a column of a type's or a compartment's row is, for tests.
  QRect cellOfType(int type, ModelTree::Column column) const;

 signals:
  /// The user has selected a type; -1: none, or a compartment.
  void picked(int type);

 protected:
  bool event(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

 private:
  const TypeTree::Row& rowOf(const QModelIndex& shown) const;
  session::TypeNumbers typesFor(const QModelIndex& shown) const;
  bool pressCell(const QModelIndex& index, QMouseEvent* event);
  void openSome();

  ModelCommands& mCommands;
  ModelTree* mTree;
  TypeOrder* mOrder;
  bool mIsHeld = false;  ///< A press was taken by a cell: what follows is not for the selection.
  bool mIsQuiet = false;
};

}  // namespace velum::gui
