#include "gui/membrane/ShareBar.h"

#include <QPainter>
#include <QPainterPath>
#include <initializer_list>
#include <utility>

#include "gui/kit/Theme.h"

namespace velum::gui {

namespace {
constexpr int kHeight = 8;
}

ShareBar::ShareBar(QWidget* parent) : QWidget(parent) {
  setObjectName("membraneShares");
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
}

QSize ShareBar::sizeHint() const { return {120, kHeight}; }

void ShareBar::setShares(const membrane::Shares& shares) {
  mShares = shares;
  setToolTip(tr("Blue: stays whole. Grey: removed whole. Red: cut."));
  setAccessibleName(tr("%1 % stays whole, %2 % is removed whole, %3 % is cut")
                        .arg(100.0 * shares.kept, 0, 'f', 0)
                        .arg(100.0 * shares.removed, 0, 'f', 0)
                        .arg(100.0 * shares.cut, 0, 'f', 0));
  update();
}

void ShareBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath outline;
  outline.addRoundedRect(QRectF(rect()), kHeight / 2.0, kHeight / 2.0);
  painter.setClipPath(outline);
  QColor strong = kAccent, alarm = kAlarm, gone = palette().color(QPalette::PlaceholderText);
  if (!isEnabled())
    for (QColor* colour : {&strong, &alarm, &gone}) colour->setAlphaF(0.4f);
  double x = 0.0;
  for (auto [share, colour] : {std::pair{mShares.kept, strong}, {mShares.removed, gone}, {mShares.cut, alarm}}) {
    painter.fillRect(QRectF(x, 0.0, share * width(), height()), colour);
    x += share * width();
  }
}

}  // namespace velum::gui
