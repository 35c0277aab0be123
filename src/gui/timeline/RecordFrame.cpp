#include "gui/timeline/RecordFrame.h"

#include <QEvent>
#include <QPainter>

namespace velum::gui {

namespace {
constexpr double kFrameWide = 3.0;
}  // namespace

RecordFrame::RecordFrame(QWidget& view) : QWidget(&view) {
  setObjectName("recordFrame");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  resize(view.size());
  view.installEventFilter(this);
  hide();
}

bool RecordFrame::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) resize(parentWidget()->size());
  return QWidget::eventFilter(watched, event);
}

void RecordFrame::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(kRecordRed, kFrameWide));
  painter.drawRect(QRectF(rect()).adjusted(0.5 * kFrameWide, 0.5 * kFrameWide, -0.5 * kFrameWide, -0.5 * kFrameWide));
}

}  // namespace velum::gui
