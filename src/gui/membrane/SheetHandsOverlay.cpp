#include "SheetHandsOverlay.h"

#include <QEvent>
#include <algorithm>

#include "view/GizmoPaint.h"

namespace velum::gui {

SheetHandsOverlay::SheetHandsOverlay(const SheetTool& tool, const session::Document& document, QWidget* view,
                                     const SliceView* slice)
    : QWidget(view), mTool(tool), mDocument(document), mView(view), mSlice(slice) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  view->installEventFilter(this);
  resize(view->size());
  lower();  // a slice's own buttons stay on top
  hide();
}

bool SheetHandsOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) resize(mView->size());
  return QWidget::eventFilter(watched, event);
}

/// Hidden while there is nothing to draw, so that it costs nothing then.
void SheetHandsOverlay::refresh() {
  const scene::Cut* cut = mTool.membrane();
  bool has = cut && (!cut->membrane->pins.empty() || !cut->membrane->field.kernels.empty());
  setVisible(has && (!mSlice || mDocument.scene().slices.showCuts));
  if (has) update();
}

void SheetHandsOverlay::paintEvent(QPaintEvent*) {
  const scene::Cut* cut = mTool.membrane();
  if (!cut) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(cut->enabled ? 1.0 : 0.45);
  if (mSlice)
    paintHands(painter, *cut, mSlice->frame(), mTool.marks());
  else
    paintHands(painter, *cut, mDocument.scene().camera, {std::max(1, width()), std::max(1, height())}, mTool.marks());
  painter.setOpacity(1.0);
  drawTag(painter, mTool.pointer(), size(), mTool.tagFor(mView));
}

}  // namespace velum::gui
