#include "gui/model/ModelDelegate.h"

#include <QLineEdit>
#include <QPainter>
#include <QSortFilterProxyModel>

#include "gui/rows/RowPaint.h"

namespace velum::gui {

namespace {

void paintColor(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index, bool visible) {
  auto color = index.data(ModelTree::ColorRole).value<QColor>();
  if (!color.isValid()) return;
  if (!visible) color.setAlphaF(0.35f);
  QPointF c = QRectF(option.rect).center();
  paintSwatch(painter, QRectF(c - QPointF(6.5, 6.5), QSizeF(13, 13)), color, QColor(0, 0, 0, 70));
}

void paintText(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index, bool strong,
               Qt::Alignment alignment) {
  QRect box = option.rect.adjusted(ModelDelegate::kTextMargin, 0, -ModelDelegate::kTextMargin, 0);
  QFont font = option.font;
  if (alignment == Qt::AlignLeft && !index.data(TypeTree::IsTypeRole).toBool()) font.setWeight(QFont::DemiBold);
  font.setUnderline(index.column() == ModelTree::Count && index.data(ModelTree::HeldRole).toBool());
  painter.setFont(font);
  painter.setPen(rowTextColor(option, strong));
  painter.drawText(box, alignment | Qt::AlignVCenter, ModelDelegate::textOf(index, QFontMetrics(font), box.width()));
}

QModelIndex sourceOf(const QModelIndex& index) {
  auto* order = qobject_cast<const QSortFilterProxyModel*>(index.model());
  return order ? order->mapToSource(index) : index;
}

}  // namespace

QString ModelDelegate::textOf(const QModelIndex& index, const QFontMetrics& metrics, int width) {
  QString text = index.data().toString();
  return index.column() == ModelTree::Count ? text : metrics.elidedText(text, Qt::ElideMiddle, width);
}

CountBar ModelDelegate::barOf(const TypeTree::Row& row, QRect cell) const {
  return layCountBar(cell, mTree.scale(), mTree.countOf(row));
}

void ModelDelegate::paint(QPainter* painter, const QStyleOptionViewItem& given, const QModelIndex& index) const {
  QStyleOptionViewItem option = given;
  const TypeTree::Row& row = mTree.rowAt(sourceOf(index));
  if (row.isType && int(row.number) == mPointed) option.state |= QStyle::State_MouseOver;
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  int column = index.column();
  paintRowGround(*painter, option, column == 0, column == ModelTree::kColumns - 1);
  auto shown = ModelTree::Shown(index.data(ModelTree::VisibleRole).toInt());
  if (column == ModelTree::Eye)
    paintEye(*painter, option.rect, rowTextColor(option, shown == ModelTree::All), shown != ModelTree::None);
  if (column == ModelTree::Swatch) paintColor(*painter, option, index, shown != ModelTree::None);
  if (column == ModelTree::Name) paintText(*painter, option, index, shown != ModelTree::None, Qt::AlignLeft);
  if (column == ModelTree::Bar) paintCountBar(*painter, option, barOf(row, option.rect), true);
  if (column == ModelTree::Count) paintText(*painter, option, index, false, Qt::AlignRight);
  painter->restore();
}

QWidget* ModelDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const {
  auto* field = new QLineEdit(parent);
  field->setFrame(false);
  if (index.column() == ModelTree::Name) {
    field->setObjectName("modelTypeName");
    field->setAccessibleName(tr("Name"));
    field->setToolTip(
        tr("What it is called from now on; nothing: %1, as in the file").arg(mTree.rowAt(sourceOf(index)).fileName));
    return field;
  }
  field->setObjectName("modelNumber");
  field->setAccessibleName(tr("How many %1 are drawn").arg(mTree.rowAt(sourceOf(index)).name));
  field->setToolTip(tr("A number of instances, or a share: 50, 20 %"));
  return field;
}

void ModelDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
  auto* field = static_cast<QLineEdit*>(editor);
  field->setText(index.data().toString());
  field->selectAll();
}

void ModelDelegate::setModelData(QWidget* editor, QAbstractItemModel*, const QModelIndex& index) const {
  auto* field = static_cast<QLineEdit*>(editor);
  if (!field->isModified()) return;
  index.column() == ModelTree::Name ? emit renamed(index, field->text()) : emit typed(index, field->text());
}

ModelHeader::ModelHeader(const ModelTree& tree, QWidget* parent) : QHeaderView(Qt::Horizontal, parent), mTree(tree) {}

QSize ModelHeader::sizeHint() const { return {40, fontMetrics().height() + 6}; }

void ModelHeader::paintSection(QPainter* painter, const QRect& rect, int section) const {
  painter->save();
  painter->fillRect(rect, palette().color(QPalette::Base));
  painter->setPen(palette().color(QPalette::PlaceholderText));
  QFont font = this->font();
  font.setPointSizeF(font.pointSizeF() * 0.82);
  painter->setFont(font);
  if (section == ModelTree::Name)
    painter->drawText(rect.adjusted(4, 0, -4, 0), Qt::AlignLeft | Qt::AlignVCenter, tr("Name"));
  if (section == ModelTree::Count)
    painter->drawText(rect.adjusted(4, 0, -4, 0), Qt::AlignRight | Qt::AlignVCenter, tr("Drawn"));
  if (section == ModelTree::Bar) paintBarRuler(*painter, rect, mTree.scale());
  painter->restore();
}

}  // namespace velum::gui
