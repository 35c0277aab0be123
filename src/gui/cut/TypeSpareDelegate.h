#pragma once
#include <QStyledItemDelegate>

namespace velum::gui {

constexpr double kShareBarMargin = 6.0;  ///< pixels of a cell beside its bar

/// Paints the rows of a TypeSpareView: name, bar, share. Rows that only have what is above them are quieter.
class TypeSpareDelegate : public QStyledItemDelegate {
 public:
  TypeSpareDelegate(int rowHeight, QObject* parent) : QStyledItemDelegate(parent), mRowHeight(rowHeight) {}
  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {40, mRowHeight}; }
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  int mRowHeight;
};

}  // namespace velum::gui
