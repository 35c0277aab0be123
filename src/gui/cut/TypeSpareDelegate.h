#pragma once
#include <QStyledItemDelegate>

namespace velum::gui {

constexpr double kShareBarMargin = 6.0;  ///< pixels of a cell beside its bar

/// Paints the rows of a TypeSpareView: name, bar, share. A row without a share of its own, which has that of the row
/// above it in the tree, is quieter.
class TypeSpareDelegate : public QStyledItemDelegate {
 public:
  TypeSpareDelegate(int rowHeight, QObject* parent) : QStyledItemDelegate(parent), mRowHeight(rowHeight) {}
  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {40, mRowHeight}; }
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  int mRowHeight;
};

}  // namespace velum::gui
