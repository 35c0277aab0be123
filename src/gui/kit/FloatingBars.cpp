#include "gui/kit/FloatingBars.h"

#include <QEvent>
#include <algorithm>

namespace velum::gui {

namespace {

constexpr int kFromEdge = 10, kSpacing = 6;
constexpr int kWidest = 820;  // longer lines are hard to read

int heightOf(const QWidget& bar, int width) {
  return bar.hasHeightForWidth() ? bar.heightForWidth(width) : bar.sizeHint().height();
}

}  // namespace

void FloatingBars::add(QWidget& bar, std::vector<QWidget*>& bars) {
  bars.push_back(&bar);
  bar.installEventFilter(this);
  place();
}

bool FloatingBars::eventFilter(QObject* watched, QEvent* event) {
  bool isOfPage = event->type() == QEvent::Resize || event->type() == QEvent::Move;
  bool isOfBar =
      event->type() == QEvent::Show || event->type() == QEvent::Hide || event->type() == QEvent::LayoutRequest;
  if (watched == &mPage ? isOfPage : isOfBar) place();
  return QObject::eventFilter(watched, event);
}

void FloatingBars::place() {
  QRect page = mPage.geometry();
  int width = std::min(page.width() - 2 * kFromEdge, kWidest), left = page.left() + (page.width() - width) / 2;
  int top = page.top() + kFromEdge, bottom = page.bottom() + 1 - kFromEdge;
  auto put = [&](QWidget& bar, int y, int height) {
    bar.setGeometry(left, y, width, height);
    bar.raise();
  };
  for (QWidget* bar : mTop) {
    if (bar->isHidden()) continue;
    int height = heightOf(*bar, width);
    put(*bar, top, height);
    top += height + kSpacing;
  }
  for (QWidget* bar : mBottom) {
    if (bar->isHidden()) continue;
    int height = heightOf(*bar, width);
    put(*bar, bottom - height, height);
    bottom -= height + kSpacing;
  }
}

}  // namespace velum::gui
