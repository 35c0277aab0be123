#include "gui/tool/ToolOverlay.h"

#include <QEvent>
#include <QPainter>

#include "gui/tool/Toolbox.h"

namespace velum::gui {

ToolOverlay::ToolOverlay(const Toolbox& toolbox, ToolView& view)
    : QWidget(&view.widget()), mToolbox(toolbox), mView(view) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  resize(view.widget().size());
  lower();  // a view's own buttons stay on top
  view.widget().installEventFilter(this);
}

bool ToolOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) resize(mView.widget().size());
  return QWidget::eventFilter(watched, event);
}

void ToolOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  ViewPainter over{painter, mView, mView.space(), size()};
  mToolbox.paint(over);
}

}  // namespace velum::gui
