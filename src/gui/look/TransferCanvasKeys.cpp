// The selected point or stop of a transfer function: keys and numbers for it.
#include <QKeyEvent>
#include <algorithm>

#include "gui/look/TransferCanvas.h"

#include "scene/Scene.h"

namespace velum::gui {

/// An undo step's name, as the Edit menu shows it: "Move opacity point", "Move gradient point".
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
  setView(session::zoomAxis(view(), about, factor, mWhole));
  emit viewChanged();
}

/// The keys that change the selected point or stop, while there is one.
bool TransferCanvas::isOwnKey(int key) const {
  bool selects = key == Qt::Key_PageUp || key == Qt::Key_PageDown || key == Qt::Key_Insert;
  bool changes = key == Qt::Key_Delete || key == Qt::Key_Backspace || (key >= Qt::Key_Left && key <= Qt::Key_Down);
  return selects || (changes && mSelection.part != Selection::Part::None);
}

/// Goes through all points, then through all stops of colours.
void TransferCanvas::selectNext(int by) {
  int points = int(curve().size()), count = points + (hasColors() ? int(mTransfer.colors.size()) : 0);
  if (count == 0) return;
  bool isNone = mSelection.part == Selection::Part::None;
  int now = mSelection.index + (mSelection.part == Selection::Part::Stop ? points : 0);
  int next = isNone ? (by > 0 ? 0 : count - 1) : std::clamp(now + by, 0, count - 1);
  select(next < points ? Selection{Selection::Part::Point, next} : Selection{Selection::Part::Stop, next - points});
}

/// A point on the line, or a colour in the bar, half way from the selected one to the next.
void TransferCanvas::addBeside() {
  bool isStop = mSelection.part == Selection::Part::Stop;
  if (mSelection.part == Selection::Part::None) selectNext(1);
  int count = int(isStop ? mTransfer.colors.size() : curve().size()), from = std::min(mSelection.index, count - 2);
  if (from < 0) return;
  auto valueOf = [&](int i) { return isStop ? mTransfer.colors[std::size_t(i)].value : curve()[std::size_t(i)].value; };
  double value = 0.5 * (valueOf(from) + valueOf(from + 1));
  scene::TransferFunction next = mTransfer;
  int index = isStop ? session::addStop(next.colors, value)
                     : session::addPoint(curveOf(next), value, scene::opacityAt(curve(), value));
  emit edited(isStop ? tr("Add colour") : named("Add"), next, false);
  select({isStop ? Selection::Part::Stop : Selection::Part::Point, index});
}

void TransferCanvas::step(int sideways, int up, bool wide) {
  if (mSelection.part == Selection::Part::None) return;
  double factor = wide ? 10.0 : 1.0;
  double pixel = (view().high - view().low) / frame().size.x;
  bool isStop = mSelection.part == Selection::Part::Stop;
  auto index = std::size_t(mSelection.index);
  double value = isStop ? mTransfer.colors[index].value : curve()[index].value;
  double opacity = isStop ? 0.0 : curve()[index].opacity;
  moveSelected(value + sideways * factor * pixel, opacity + up * factor * 0.01);
}

void TransferCanvas::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (mSelection.part == Selection::Part::Stop) emit colorWanted();
      return;
    case Qt::Key_Backspace:
      return removeSelected();
    case Qt::Key_Plus:
      return zoom(0.5 * (view().low + view().high), 0.8);
    case Qt::Key_Minus:
      return zoom(0.5 * (view().low + view().high), 1.25);
    default:
      CurveCanvas::keyPressEvent(event);
  }
}

void TransferCanvas::keyReleaseEvent(QKeyEvent* event) {
  bool isArrow = event->key() >= Qt::Key_Left && event->key() <= Qt::Key_Down;
  if (isArrow && !event->isAutoRepeat()) emit settled();
  QWidget::keyReleaseEvent(event);
}

}  // namespace velum::gui
