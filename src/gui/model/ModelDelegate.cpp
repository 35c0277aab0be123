#include "ModelDelegate.h"

#include <QLineEdit>
#include <QLocale>
#include <QPainter>
#include <QSortFilterProxyModel>
#include <algorithm>

#include "kit/RowPaint.h"
#include "kit/Theme.h"

namespace velum::gui {

namespace {

constexpr int kBarMargin = 6, kBarHeight = 9, kKnob = 3;

void paintColor(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index, bool visible) {
  auto color = index.data(ModelTree::ColorRole).value<QColor>();
  if (!color.isValid()) return;
  if (!visible) color.setAlphaF(0.35f);
  QPointF c = QRectF(option.rect).center();
  paintSwatch(painter, QRectF(c - QPointF(6.5, 6.5), QSizeF(13, 13)), color, QColor(0, 0, 0, 70));
}

void paintText(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index, bool strong,
               Qt::Alignment alignment) {
  QRect box = option.rect.adjusted(4, 0, -4, 0);
  QFont font = option.font;
  if (alignment == Qt::AlignLeft && !index.data(TypeTree::IsTypeRole).toBool()) font.setWeight(QFont::DemiBold);
  painter.setFont(font);
  QString text = QFontMetrics(font).elidedText(index.data().toString(), Qt::ElideMiddle, box.width());
  painter.setPen(rowTextColor(option, strong));
  painter.drawText(box, alignment | Qt::AlignVCenter, text);
}

QRectF grooveIn(QRect cell) {
  QRectF box = QRectF(cell).adjusted(kBarMargin, 0, -kBarMargin, 0);
  return {box.left(), box.center().y() - kBarHeight / 2.0, box.width(), double(kBarHeight)};
}

const QModelIndex sourceOf(const QModelIndex& index) {
  auto* order = qobject_cast<const QSortFilterProxyModel*>(index.model());
  return order ? order->mapToSource(index) : index;
}

}  // namespace

RowBar ModelDelegate::barOf(const TypeTree::Row& row, QRect cell) const {
  render::TypeCount count = mTree.countOf(row);
  auto total = double(count.total());
  if (total == 0.0) return {};
  QRectF box = grooveIn(cell);
  auto place = [&](double number) { return box.width() * mTree.scale().place(number, total); };
  return {box, place(double(count.visible)), place(double(count.rendered())), place(total)};
}

/// Seen, hidden and removed differ in lightness: whoever sees red and green alike can tell them apart.
void ModelDelegate::paintBar(QPainter& painter, const QStyleOptionViewItem& option, const TypeTree::Row& row) const {
  RowBar bar = barOf(row, option.rect);
  if (bar.box.isEmpty()) return;
  ThemeKind theme = themeOf(option.palette);
  painter.setPen(Qt::NoPen);
  auto part = [&](double from, double to, const char* color) {
    if (to <= from) return;
    double width = std::max(1.0, to - from);
    painter.fillRect(QRectF(bar.box.left() + from, bar.box.top(), width, bar.box.height()), themeColor(theme, color));
  };
  painter.setRenderHint(QPainter::Antialiasing, false);
  if (option.state & QStyle::State_Selected)
    painter.fillRect(QRectF(bar.box.left(), bar.box.top(), bar.all, bar.box.height()).adjusted(-1, -1, 1, 1),
                     option.palette.color(QPalette::Window));
  part(bar.drawn, bar.all, "removed");
  part(bar.seen, bar.drawn, "hidden");
  part(0.0, bar.seen, "seen");
  // Knobs say that the ends can be dragged.
  painter.setRenderHint(QPainter::Antialiasing, true);
  QColor line = option.palette.color(QPalette::Window);
  auto knob = [&](double at, const char* color, double grow) {
    QRectF box(bar.box.left() + at - kKnob / 2.0, bar.box.top() - grow, kKnob, bar.box.height() + 2.0 * grow);
    painter.setPen(QPen(line, 1.0));
    painter.setBrush(themeColor(theme, color));
    painter.drawRoundedRect(box.adjusted(-0.5, 0, 0.5, 0), 1.5, 1.5);
  };
  bool isHot = option.state & (QStyle::State_MouseOver | QStyle::State_Selected);
  if (isHot && bar.seen < bar.drawn) knob(bar.seen, "seen", 2.0);
  knob(bar.drawn, "white", isHot ? 4.0 : 2.5);
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
  if (column == ModelTree::Bar) paintBar(*painter, option, row);
  if (column == ModelTree::Count) paintText(*painter, option, index, false, Qt::AlignRight);
  painter->restore();
}

QWidget* ModelDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const {
  auto* field = new QLineEdit(parent);
  field->setObjectName("modelNumber");
  field->setFrame(false);
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
  if (field->isModified()) emit typed(index, field->text());
}

ModelHeader::ModelHeader(const ModelTree& tree, QWidget* parent) : QHeaderView(Qt::Horizontal, parent), mTree(tree) {}

QSize ModelHeader::sizeHint() const { return {40, fontMetrics().height() + 6}; }

/// Percent from 0 to 100, or powers of ten as far as they have room.
void ModelHeader::paintSection(QPainter* painter, const QRect& rect, int section) const {
  painter->save();
  painter->fillRect(rect, palette().color(QPalette::Base));
  painter->setPen(palette().color(QPalette::PlaceholderText));
  QFont font = this->font();
  font.setPointSizeF(font.pointSizeF() * 0.82);
  painter->setFont(font);
  QFontMetrics metrics(font);
  if (section == ModelTree::Name)
    painter->drawText(rect.adjusted(4, 0, -4, 0), Qt::AlignLeft | Qt::AlignVCenter, tr("Name"));
  if (section == ModelTree::Count)
    painter->drawText(rect.adjusted(4, 0, -4, 0), Qt::AlignRight | Qt::AlignVCenter, tr("Drawn"));
  if (section == ModelTree::Bar) {
    QRectF groove = grooveIn(rect);
    double free = -1e9;  // where the last word ends
    auto tick = [&](double place, const QString& text) {
      double x = groove.left() + groove.width() * place, width = metrics.horizontalAdvance(text);
      painter->drawLine(QPointF(x, rect.bottom() - 3), QPointF(x, rect.bottom()));
      double left = std::clamp(x - width / 2.0, double(rect.left()), rect.right() - width);
      if (left < free) return;
      painter->drawText(QRectF(left, rect.top(), width + 1.0, rect.height() - 3), Qt::AlignLeft | Qt::AlignVCenter,
                        text);
      free = left + width + 4.0;
    };
    const BarScale& scale = mTree.scale();
    if (scale.isPercent) {
      for (int percent : {0, 50, 100}) tick(percent / 100.0, percent == 100 ? tr("100 %") : QString::number(percent));
    } else {
      tick(0.0, "0");
      QLocale locale;
      const char* units[] = {"", "k", "M", "G"};
      for (int power = 0; std::pow(10.0, power) <= scale.most; ++power)
        tick(scale.place(std::pow(10.0, power), scale.most),
             locale.toString(std::pow(10.0, power % 3), 'f', 0) + units[std::min(3, power / 3)]);
    }
  }
  painter->restore();
}

}  // namespace velum::gui
