// The selected point or stop of a transfer function: keys and numbers for it.
#include <QKeyEvent>
#include <algorithm>

#include "TransferCanvas.h"

namespace velum::gui {

/// A step's name, as the Edit menu says it: "Move opacity point", "Move gradient point".
QString TransferCanvas::named(const char* what) const {
  return QString("%1 %2 point").arg(what, hasColors() ? "opacity" : "gradient");
}

void TransferCanvas::select(Selection selection) {
  if (selection == mSelection) return;
  mSelection = selection;
  update();
  emit selectionChanged();
}

void TransferCanvas::removeSelected() {
  scene::TransferFunction next = mTransfer;
  bool isStop = mSelection.part == Selection::Part::Stop;
  bool removed = isStop ? session::removeStop(next.colors, mSelection.index)
                        : session::removePoint(curveOf(next), mSelection.index);
  if (!removed) return;
  select({});
  emit edited(isStop ? tr("Remove colour") : named("Remove"), next, false);
}

void TransferCanvas::moveSelected(double value, double opacity) {
  scene::TransferFunction next = mTransfer;
  bool isStop = mSelection.part == Selection::Part::Stop;
  if (isStop)
    session::moveStop(next.colors, mSelection.index, value);
  else
    session::movePoint(curveOf(next), mSelection.index, value, opacity);
  emit edited(isStop ? tr("Move colour") : named("Move"), next, true);
}

void TransferCanvas::colorSelected(glm::vec3 color) {
  if (mSelection.part != Selection::Part::Stop || mSelection.index >= int(mTransfer.colors.size())) return;
  scene::TransferFunction next = mTransfer;
  next.colors[std::size_t(mSelection.index)].color = color;
  emit edited(tr("Change colour"), next, false);
}

void TransferCanvas::zoom(double about, double factor) {
  setView(session::zoomAxis(mView, about, factor, mWhole));
  emit viewChanged();
}

/// Keys that the window has other uses for are the canvas' while something in it is selected.
bool TransferCanvas::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && mSelection.part != Selection::Part::None) {
    int key = static_cast<QKeyEvent*>(event)->key();
    for (int ours :
         {Qt::Key_Delete, Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::Key_PageUp, Qt::Key_PageDown})
      if (key == ours) event->accept();
  }
  return QWidget::event(event);
}

void TransferCanvas::selectNext(int by) {
  bool isStop = mSelection.part == Selection::Part::Stop;
  int count = int(isStop ? mTransfer.colors.size() : curve().size());
  if (count == 0) return;
  int index = mSelection.index < 0 ? (by > 0 ? 0 : count - 1) : std::clamp(mSelection.index + by, 0, count - 1);
  select({isStop ? Selection::Part::Stop : Selection::Part::Point, index});
}

void TransferCanvas::step(int sideways, int up, bool wide) {
  if (mSelection.part == Selection::Part::None) return;
  double factor = wide ? 10.0 : 1.0;
  double pixel = (mView.high - mView.low) / frame().size.x;
  bool isStop = mSelection.part == Selection::Part::Stop;
  auto index = std::size_t(mSelection.index);
  double value = isStop ? mTransfer.colors[index].value : curve()[index].value;
  double opacity = isStop ? 0.0 : curve()[index].opacity;
  moveSelected(value + sideways * factor * pixel, opacity + up * factor * 0.01);
}

void TransferCanvas::keyPressEvent(QKeyEvent* event) {
  bool wide = event->modifiers() & Qt::ShiftModifier;
  switch (event->key()) {
    case Qt::Key_Left:
      return step(-1, 0, wide);
    case Qt::Key_Right:
      return step(1, 0, wide);
    case Qt::Key_Up:
      return step(0, 1, wide);
    case Qt::Key_Down:
      return step(0, -1, wide);
    case Qt::Key_PageUp:
      return selectNext(-1);
    case Qt::Key_PageDown:
      return selectNext(1);
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      return removeSelected();
    case Qt::Key_Plus:
      return zoom(0.5 * (mView.low + mView.high), 0.8);
    case Qt::Key_Minus:
      return zoom(0.5 * (mView.low + mView.high), 1.25);
    default:
      QWidget::keyPressEvent(event);
  }
}

void TransferCanvas::keyReleaseEvent(QKeyEvent* event) {
  bool isArrow = event->key() >= Qt::Key_Left && event->key() <= Qt::Key_Down;
  if (isArrow && !event->isAutoRepeat()) emit settled();
  QWidget::keyReleaseEvent(event);
}

}  // namespace velum::gui
