#include "gui/rows/BarList.h"

#include <QHeaderView>
#include <QMouseEvent>
#include <QScrollBar>
#include <algorithm>
#include <cmath>

namespace velum::gui {

namespace {

constexpr double kGrip = 5.0;  // pixels about a knob

bool isEnter(const QKeyEvent& event) { return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter; }

/// Ctrl+Right, Ctrl+Left: a step; else 0.
int stepOf(const QKeyEvent& event) {
  if (!(event.modifiers() & Qt::ControlModifier)) return 0;
  return event.key() == Qt::Key_Right ? 1 : event.key() == Qt::Key_Left ? -1 : 0;
}

}  // namespace

BarList::BarList(QWidget* parent) : QTreeView(parent) {
  setUniformRowHeights(true);
  setMouseTracking(true);
  setAllColumnsShowFocus(true);
  setSelectionMode(ExtendedSelection);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollMode(ScrollPerPixel);
  verticalScrollBar()->setSingleStep(kRowHeight);
}

void BarList::layColumns(std::span<const int> widths, int leastRows) {
  setMinimumHeight(leastRows * kRowHeight);
  header()->setStretchLastSection(false);
  header()->setMinimumSectionSize(10);
  for (int i = 0; i < int(widths.size()); ++i) {
    int width = widths[std::size_t(i)];
    header()->setSectionResizeMode(i, width ? QHeaderView::Fixed : QHeaderView::Stretch);
    if (width) header()->resizeSection(i, width);
  }
}

void BarList::holdKnob(double x, double knob) {
  mIsDragging = true;
  mGrip = std::abs(x - knob) <= kGrip ? x - knob : 0.0;
  if (mGrip == 0.0) dragKnob(x);
}

void BarList::selectRowOf(const QModelIndex& index, int nameColumn) {
  if (!selectionModel()->isRowSelected(index.row(), index.parent())) setCurrentIndex(index.siblingAtColumn(nameColumn));
}

void BarList::mousePressEvent(QMouseEvent* event) {
  QModelIndex index = indexAt(event->position().toPoint());
  mIsHeld = event->button() == Qt::LeftButton && index.isValid() && pressCell(index, event);
  if (!mIsHeld) QTreeView::mousePressEvent(event);
}

void BarList::mouseMoveEvent(QMouseEvent* event) {
  if (mIsDragging) return dragKnob(event->position().x() - mGrip);
  if (!mIsHeld) QTreeView::mouseMoveEvent(event);
}

void BarList::mouseReleaseEvent(QMouseEvent* event) {
  if (mIsDragging) letKnobGo();
  mIsDragging = false;
  if (!mIsHeld) QTreeView::mouseReleaseEvent(event);
  mIsHeld = false;
}

bool BarList::event(QEvent* event) {
  if (event->type() == QEvent::KeyPress && state() == EditingState && isEnter(static_cast<const QKeyEvent&>(*event))) {
    event->accept();
    return true;
  }
  if (event->type() == QEvent::ShortcutOverride && hasKeys()) {
    const auto& stroke = static_cast<const QKeyEvent&>(*event);
    constexpr int kOwn[] = {Qt::Key_Space, Qt::Key_Return, Qt::Key_Enter, Qt::Key_F2,
                            Qt::Key_Delete};  // Del would remove a cut that nobody thinks of here
    bool isOwn = std::find(std::begin(kOwn), std::end(kOwn), stroke.key()) != std::end(kOwn);
    if (isOwn || stepOf(stroke) || (stroke.key() == Qt::Key_Escape && isKnobHeld())) event->accept();
  }
  return QTreeView::event(event);
}

void BarList::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && isKnobHeld()) {
    mIsDragging = false;
    return giveKnobUp();
  }
  if (int steps = stepOf(*event); steps && hasKeys())
    return stepKnob(steps, bool(event->modifiers() & Qt::ShiftModifier));
  QTreeView::keyPressEvent(event);
}

}  // namespace velum::gui
