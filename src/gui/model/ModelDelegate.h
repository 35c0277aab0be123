#pragma once
#include <QHeaderView>
#include <QStyledItemDelegate>

#include "gui/model/ModelTree.h"
#include "gui/rows/CountBar.h"

namespace velum::gui {

/// Paints the rows of a ModelList: eye, colour, name, bar, number; and makes the fields in which a row's name and
/// its number are typed.
class ModelDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  ModelDelegate(const ModelTree& tree, int rowHeight, QObject* parent)
      : QStyledItemDelegate(parent), mTree(tree), mRowHeight(rowHeight) {}
  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {40, mRowHeight}; }
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  /// What a cell of the columns Name and Count says in a width: names are shortened in their middle, numbers never are.
  static QString textOf(const QModelIndex& index, const QFontMetrics& metrics, int width);
  static constexpr int kTextMargin = 4;  ///< pixels left and right of a cell's text
  /// @param cell  of the column Bar
  CountBar barOf(const TypeTree::Row& row, QRect cell) const;
  /// Sets the type that is under the pointer in the picture, whose row is marked; -1: none.
  void setPointed(int type) { mPointed = type; }

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const override;
  void setEditorData(QWidget* editor, const QModelIndex& index) const override;
  void setModelData(QWidget* editor, QAbstractItemModel*, const QModelIndex& index) const override;

 signals:
  /// A number was typed into a row.
  void typed(const QModelIndex& index, const QString& text) const;
  /// A name was typed into a row.
  void renamed(const QModelIndex& index, const QString& text) const;

 private:
  const ModelTree& mTree;
  int mRowHeight;
  int mPointed = -1;
};

/// The heads of the columns; the head of the bars is their ruler.
class ModelHeader : public QHeaderView {
  Q_OBJECT
 public:
  ModelHeader(const ModelTree& tree, QWidget* parent);
  QSize sizeHint() const override;

 protected:
  void paintSection(QPainter* painter, const QRect& rect, int section) const override;

 private:
  const ModelTree& mTree;
};

}  // namespace velum::gui
