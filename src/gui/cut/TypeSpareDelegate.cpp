#include "gui/cut/TypeSpareDelegate.h"

#include <algorithm>

#include "gui/cut/TypeSpareView.h"
#include "gui/rows/RowPaint.h"

namespace velum::gui {

namespace {

void paintBar(QPainter& painter, const QStyleOptionViewItem& option, double share, bool isOwn) {
  QRectF box = QRectF(option.rect).adjusted(kShareBarMargin, 0, -kShareBarMargin, 0);
  QRectF groove(box.left(), box.center().y() - 2.5, box.width(), 5);
  bool isSelected = option.state & QStyle::State_Selected;
  QColor color = isOwn && !isSelected ? option.palette.color(QPalette::Link) : rowTextColor(option, isOwn);
  QColor ground = color;
  ground.setAlphaF(0.22f);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ground);
  painter.drawRoundedRect(groove, 2.5, 2.5);
  painter.setBrush(color);
  if (share > 0.0)
    painter.drawRoundedRect(QRectF(groove.topLeft(), QSizeF(std::max(5.0, groove.width() * share), 5)), 2.5, 2.5);
  // The knob says that it can be dragged.
  painter.drawEllipse(QPointF(groove.left() + groove.width() * share, groove.center().y()), 4.5, 4.5);
}

}  // namespace

void TypeSpareDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  paintRowGround(*painter, option, false, index.column() == TypeSpareTree::kColumns - 1);
  bool isOwn = index.data(TypeSpareTree::OwnRole).toBool();
  if (index.column() == TypeSpareTree::Bar) {
    paintBar(*painter, option, index.data(TypeSpareTree::ShareRole).toDouble(), isOwn);
  } else {
    bool isName = index.column() == TypeSpareTree::Name;
    QRect box = option.rect.adjusted(4, 0, -4, 0);
    QFont font = option.font;
    if (isName && !index.data(TypeTree::IsTypeRole).toBool()) font.setWeight(QFont::DemiBold);
    painter->setFont(font);
    painter->setPen(rowTextColor(option, isName || isOwn));
    painter->drawText(box, (isName ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter,
                      QFontMetrics(font).elidedText(index.data().toString(), Qt::ElideMiddle, box.width()));
  }
  painter->restore();
}

}  // namespace velum::gui
