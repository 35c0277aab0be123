#include "gui/structure/StructureList.h"

#include <QColorDialog>
#include <QContextMenuEvent>
#include <QMouseEvent>
#include <QStyledItemDelegate>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "gui/rows/RowPaint.h"
#include "gui/structure/StructureCommands.h"

namespace velum::gui {

namespace {

constexpr int kWidths[StructureModel::kColumns] = {28, 22, 0, 70, 64, 64, 52, 24, 122};
constexpr double kBarMargin = 5.0;

class Delegate : public QStyledItemDelegate {
 public:
  Delegate(const StructureModel& rows, QObject* parent) : QStyledItemDelegate(parent), mRows(rows) {}

  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {40, BarList::kRowHeight}; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    int column = index.column();
    paintRowGround(*painter, option, column == 0, column >= StructureModel::Solo);
    bool visible = index.data(StructureModel::VisibleRole).toBool();
    QRectF box(option.rect);
    if (column == StructureModel::Eye) paintEye(*painter, box, rowTextColor(option, visible), visible);
    if (column == StructureModel::Swatch) paintColor(*painter, option, index, visible);
    if (column == StructureModel::Name) paintText(*painter, option, index, visible, Qt::AlignLeft);
    if (column == StructureModel::Mean || column == StructureModel::Most)
      paintText(*painter, option, index, false, Qt::AlignRight);
    if (column == StructureModel::Size) paintText(*painter, option, index, false, Qt::AlignRight);
    if (column == StructureModel::Opacity) paintBar(*painter, option, index, visible);
    if (column == StructureModel::Bar)
      paintCountBar(*painter, option, mRows.barOf(index.data(StructureModel::IdRole).toInt(), option.rect), false);
    if (column == StructureModel::Solo) paintSolo(*painter, option, index.data(StructureModel::SoloRole).toBool());
    painter->restore();
  }

  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const override {
    // The editor's own frame needs more than a row, and may reach over the size beside it.
    editor->setGeometry(option.rect.adjusted(-4, -2, kWidths[StructureModel::Size], 2));
  }

 private:
  static void paintColor(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index,
                         bool visible) {
    QColor color = index.data(StructureModel::ColorRole).value<QColor>();
    QPointF c = QRectF(option.rect).center();
    if (!visible) color.setAlphaF(0.35);
    paintSwatch(painter, QRectF(c - QPointF(6.5, 6.5), QSizeF(13, 13)), color, QColor(0, 0, 0, 70));
  }
  static void paintText(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index, bool strong,
                        Qt::Alignment alignment) {
    QRect box = option.rect.adjusted(4, 0, -4, 0);
    // Names of structures differ at their ends: left and right, upper and lower.
    QString text = option.fontMetrics.elidedText(index.data().toString(), Qt::ElideMiddle, box.width());
    painter.setPen(rowTextColor(option, strong));
    painter.drawText(box, alignment | Qt::AlignVCenter, text);
  }
  static void paintBar(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index, bool visible) {
    QRectF box = QRectF(option.rect).adjusted(kBarMargin, 0, -kBarMargin, 0);
    QRectF groove(box.left(), box.center().y() - 2.5, box.width(), 5);
    QColor color = rowTextColor(option, visible);
    QColor ground = color;
    ground.setAlphaF(0.22);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(groove, 2.5, 2.5);
    groove.setWidth(std::max(5.0, groove.width() * index.data(StructureModel::OpacityRole).toDouble()));
    if (index.data(StructureModel::OpacityRole).toDouble() <= 0.0) return;
    painter.setBrush(color);
    painter.drawRoundedRect(groove, 2.5, 2.5);
  }
  static void paintSolo(QPainter& painter, const QStyleOptionViewItem& option, bool solo) {
    QPointF c = QRectF(option.rect).center();
    QRectF box(c - QPointF(8, 8), QSizeF(16, 16));
    bool near = option.state & (QStyle::State_MouseOver | QStyle::State_Selected);
    if (solo) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(option.palette.color(QPalette::Link));
      painter.drawRoundedRect(box, 3, 3);
    }
    QColor color = solo ? option.palette.color(QPalette::Base) : rowTextColor(option, false);
    if (!solo && !near) color.setAlphaF(0.55);
    QFont font = option.font;
    font.setBold(solo);
    font.setPointSizeF(font.pointSizeF() * 0.88);
    painter.setFont(font);
    painter.setPen(color);
    painter.drawText(box, Qt::AlignCenter, "S");
  }

  const StructureModel& mRows;
};

}  // namespace

StructureList::StructureList(StructureCommands& commands, AreaMeter& areas, QWidget* parent)
    : BarList(parent),
      mCommands(commands),
      mAreas(areas),
      mModel(new StructureModel(commands.meter(), areas, this)),
      mOrder(new StructureOrder(this)) {
  setObjectName("structureList");
  setAccessibleName(tr("Structures"));
  mOrder->setSourceModel(mModel);
  setModel(mOrder);
  setItemDelegate(new Delegate(*mModel, this));
  setRootIsDecorated(false);
  setHeaderHidden(true);
  setEditTriggers(EditKeyPressed);
  layColumns(kWidths, 6);
  setShown(Shown::Opacity);
  connect(&mAreas, &AreaMeter::measured, mModel, &StructureModel::areasChanged);
  connect(&mAreas, &AreaMeter::told, this, [this](const QString& words) {
    int id = mBarId ? mBarId : currentIndex().data(StructureModel::IdRole).toInt();
    QToolTip::showText(viewport()->mapToGlobal(cellOf(id, StructureModel::Bar).bottomLeft()), words, viewport());
  });
  connect(mModel, &StructureModel::renamed, &mCommands, &StructureCommands::rename);
}

void StructureList::setShown(Shown shown) {
  for (int column : {StructureModel::Opacity, StructureModel::Solo}) setColumnHidden(column, shown != Shown::Opacity);
  for (int column : {StructureModel::Mean, StructureModel::Most}) setColumnHidden(column, shown != Shown::Values);
  setColumnHidden(StructureModel::Size, shown == Shown::Bars);
  setColumnHidden(StructureModel::Bar, shown != Shown::Bars);
  setHeaderHidden(shown != Shown::Values);  // numbers say what they are of
}

bool StructureList::takeBar(int id, double x) {
  CountBar bar = barOf(id);
  if (bar.box.isEmpty()) return false;
  selectId(id);
  mBarId = id;
  if (!mAreas.take(id)) {
    mBarId = 0;
    return true;
  }
  holdKnob(x, bar.box.left() + bar.left);
  return true;
}

void StructureList::dragKnob(double x) {
  if (mOpacityId) return dragOpacity(int(x));
  const Counts* area = mAreas.find(mBarId);
  if (area) mAreas.moveTo(barOf(mBarId).countAt(x, BarScale(), double(area->total())));
}

void StructureList::stepKnob(int steps, bool) {
  int id = currentIndex().data(StructureModel::IdRole).toInt();
  const Counts* area = mAreas.find(id);
  if (!area || !mAreas.take(id)) return;
  mAreas.moveTo(double(area->left()) + kStep * steps * double(area->total()));
  mAreas.letGo();
}

std::vector<int> StructureList::selectedIds() const {
  std::vector<int> ids;
  for (const auto& index : selectionModel()->selectedRows()) ids.push_back(index.data(StructureModel::IdRole).toInt());
  return ids;
}

std::vector<int> StructureList::listedIds() const {
  std::vector<int> ids;
  for (int i = 0; i < mOrder->rowCount(); ++i) ids.push_back(mOrder->index(i, 0).data(StructureModel::IdRole).toInt());
  return ids;
}

void StructureList::selectId(int id) {
  mIsQuiet = true;
  int row = mModel->rowOf(id);
  QModelIndex index = row < 0 ? QModelIndex() : mOrder->mapFromSource(mModel->index(row, StructureModel::Name));
  if (!index.isValid()) {
    selectionModel()->clear();
  } else if (currentIndex().siblingAtColumn(StructureModel::Name) != index || selectedIds().empty()) {
    setCurrentIndex(index);
    scrollTo(index);
  }
  mIsQuiet = false;
}

void StructureList::editName(int id) {
  selectId(id);
  if (currentIndex().isValid()) edit(currentIndex().siblingAtColumn(StructureModel::Name));
}

QRect StructureList::cellOf(int id, StructureModel::Column column) const {
  return visualRect(mOrder->mapFromSource(mModel->index(mModel->rowOf(id), column)));
}

void StructureList::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
  QTreeView::currentChanged(current, previous);
  if (!mIsQuiet && current.isValid()) emit picked(current.data(StructureModel::IdRole).toInt());
}

/// The ids of all selected rows, when this row is one of them; else that of this row alone.
std::vector<int> StructureList::idsFor(int id) const {
  std::vector<int> ids = selectedIds();
  return std::find(ids.begin(), ids.end(), id) != ids.end() ? ids : std::vector<int>{id};
}

bool StructureList::pressCell(const QModelIndex& index, QMouseEvent* event) {
  int id = index.data(StructureModel::IdRole).toInt();
  switch (index.column()) {
    case StructureModel::Eye:
      if (event->modifiers() & Qt::AltModifier)
        mCommands.toggleSolo(id);
      else
        mCommands.setVisible(idsFor(id), !index.data(StructureModel::VisibleRole).toBool());
      return true;
    case StructureModel::Swatch:
      chooseColor(id);
      return true;
    case StructureModel::Opacity:
      mOpacityId = id;
      holdKnob(event->position().x());
      return true;
    case StructureModel::Solo:
      mCommands.toggleSolo(id);
      return true;
    case StructureModel::Bar:
      return takeBar(id, event->position().x());
    default:
      return false;
  }
}

void StructureList::letKnobGo() {
  if (mBarId) mAreas.letGo();
  if (mOpacityId) mCommands.document().endMerge();
  mBarId = mOpacityId = 0;
}

void StructureList::giveKnobUp() {
  mBarId = 0;
  mAreas.giveUp();
}

void StructureList::mouseDoubleClickEvent(QMouseEvent* event) {
  QModelIndex index = indexAt(event->position().toPoint());
  bool isName = index.column() == StructureModel::Name || index.column() == StructureModel::Size;
  if (index.isValid() && isName) return mCommands.goTo(index.data(StructureModel::IdRole).toInt());
  mousePressEvent(event);  // two quick clicks on an eye are two clicks
}

void StructureList::dragOpacity(int x) {
  QRect cell = cellOf(mOpacityId, StructureModel::Opacity);
  double width = cell.width() - 2.0 * kBarMargin;
  double opacity = std::clamp((x - cell.left() - kBarMargin) / width, 0.0, 1.0);
  mCommands.dragOpacity(idsFor(mOpacityId), std::round(opacity * 100.0) / 100.0);
}

void StructureList::chooseColor(int id) {
  QModelIndex index = mModel->index(mModel->rowOf(id), 0);
  QColor color = QColorDialog::getColor(index.data(StructureModel::ColorRole).value<QColor>(), window(),
                                        tr("Colour of the structure"));
  if (color.isValid()) mCommands.setColor(idsFor(id), {color.redF(), color.greenF(), color.blueF()});
}

void StructureList::keyPressEvent(QKeyEvent* event) {
  std::vector<int> ids = selectedIds();
  if (!ids.empty() && event->key() == Qt::Key_Space) {
    bool visible = currentIndex().data(StructureModel::VisibleRole).toBool();
    if (event->modifiers() & Qt::AltModifier) return mCommands.toggleSolo(ids[0]);
    return mCommands.setVisible(ids, !visible);
  }
  bool isEnter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (!ids.empty() && isEnter) return mCommands.goTo(ids[0]);
  // The cursor stands on a row; a name is what it edits.
  if (event->key() == Qt::Key_F2 && currentIndex().isValid())
    return edit(currentIndex().siblingAtColumn(StructureModel::Name));
  BarList::keyPressEvent(event);
}

void StructureList::contextMenuEvent(QContextMenuEvent* event) {
  QModelIndex index = event->reason() == QContextMenuEvent::Mouse ? indexAt(event->pos()) : currentIndex();
  if (!index.isValid()) return;
  QMenu menu(this);
  mCommands.fillMenu(menu, idsFor(index.data(StructureModel::IdRole).toInt()));
  menu.exec(event->reason() == QContextMenuEvent::Mouse ? event->globalPos()
                                                        : viewport()->mapToGlobal(visualRect(index).center()));
}

}  // namespace velum::gui
