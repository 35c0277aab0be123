#include "gui/tool/KeyPointer.h"

#include <QPainterPath>
#include <algorithm>

#include "gui/tool/HandlePaint.h"
#include "gui/tool/Toolbox.h"

namespace velum::gui {

namespace {

constexpr double kStep = 4.0, kLargeStep = 24.0;  // pixels
constexpr double kRadius = 9.0, kArm = 15.0;

/// Which way an arrow goes on the screen.
QPointF wayOf(int key) {
  return {double(key == Qt::Key_Right) - double(key == Qt::Key_Left),
          double(key == Qt::Key_Down) - double(key == Qt::Key_Up)};
}

}  // namespace

KeyAnswer KeyPointer::key(const KeyStroke& stroke, ToolView& view) {
  if (stroke.keys & ~(Qt::ShiftModifier | Qt::KeypadModifier)) return {};
  if (QPointF way = wayOf(stroke.key); !way.isNull()) {
    double step = stroke.keys & Qt::ShiftModifier ? kLargeStep : kStep;
    return [this, &view, way, step] { move(view, way * step); };
  }
  if (stroke.key == Qt::Key_Space) return [this, &view] { toggle(view); };
  if (stroke.key == Qt::Key_Return || stroke.key == Qt::Key_Enter)
    return [this, &view] {
      if (!mIsDown) toggle(view);
      if (mIsDown) toggle(view);
    };
  return {};
}

/// From the middle of a view that it comes to.
void KeyPointer::move(ToolView& view, QPointF step) {
  const QWidget& widget = view.widget();
  if (!isIn(view)) {
    if (mIsDown) release();
    mView = &view;
    mPlace = QPointF(widget.width() / 2.0, widget.height() / 2.0);
  }
  QPointF place = mPlace + step;
  mPlace = {std::clamp(place.x(), 0.0, widget.width() - 1.0), std::clamp(place.y(), 0.0, widget.height() - 1.0)};
  mHasMoved = mHasMoved || !step.isNull();
  mIsDown ? mToolbox.dragAt(view, mPlace) : mToolbox.hoverAt(view, mPlace);
  mToolbox.repaint();
}

void KeyPointer::toggle(ToolView& view) {
  if (!isIn(view)) move(view, {});
  mIsDown ? release() : press();
  mToolbox.repaint();
}

void KeyPointer::press() {
  mIsDown = true;
  mHasMoved = false;
  mToolbox.pressAt(*mView, mPlace);
}

void KeyPointer::release() {
  mIsDown = false;
  mToolbox.releaseAt(*mView, mPlace, !mHasMoved);
}

void KeyPointer::letGo() {
  mIsDown = false;
  mView = nullptr;
}

void KeyPointer::paint(ViewPainter& over) const {
  if (!isIn(over.view)) return;
  QPainterPath mark;
  mark.addEllipse(mPlace, kRadius, kRadius);
  for (QPointF way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
    mark.moveTo(mPlace + way * kRadius * 0.5);
    mark.lineTo(mPlace + way * kArm);
  }
  strokeTwice(over.painter, mark, QColor(255, 255, 255), mIsDown ? 2.6 : 1.4);
}

}  // namespace velum::gui
