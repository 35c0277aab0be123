#include "gui/rows/CountBar.h"

#include <QLocale>
#include <QObject>
#include <algorithm>

#include "gui/kit/Text.h"
#include "gui/kit/Theme.h"
#include "gui/kit/Words.h"

namespace velum::gui {

namespace {

constexpr int kMargin = 6, kHeight = 9, kKnob = 3;

}  // namespace

QString countTitle() {
  QStringList words;
  for (const CountKind& kind : kCountKinds) words << wordsOf(kind.adjective);
  QString title = words.join(", ");
  return title.left(1).toUpper() + title.mid(1);
}

QColor countColor(CountOf kind) { return QColor(toText(kCountKinds[std::size_t(kind)].fill)); }

QRectF countBarBox(QRect cell) {
  QRectF box = QRectF(cell).adjusted(kMargin, 0, -kMargin, 0);
  return {box.left(), box.center().y() - kHeight / 2.0, box.width(), double(kHeight)};
}

CountBar layCountBar(QRect cell, const BarScale& scale, const Counts& counts) {
  auto total = double(counts.total());
  if (total <= 0.0) return {};
  CountBar bar{countBarBox(cell)};
  std::uint64_t upTo = 0;
  for (std::size_t i = 0; i < kCountKinds.size(); ++i) {
    upTo += counts.parts[i];
    bar.ends[i] = bar.box.width() * scale.place(double(upTo), total);
    if (kCountKinds[i].isSeen) bar.seen = bar.ends[i];
    if (kCountKinds[i].isLeft) bar.left = bar.ends[i];
  }
  return bar;
}

void paintCountBar(QPainter& painter, const QStyleOptionViewItem& option, const CountBar& bar, bool hasSeenKnob) {
  if (bar.box.isEmpty()) return;
  painter.setPen(Qt::NoPen);
  painter.setRenderHint(QPainter::Antialiasing, false);
  if (option.state & QStyle::State_Selected)
    painter.fillRect(QRectF(bar.box.left(), bar.box.top(), bar.ends.back(), bar.box.height()).adjusted(-1, -1, 1, 1),
                     option.palette.color(QPalette::Window));
  for (std::size_t i = kCountKinds.size(); i-- > 0;) {
    double from = i > 0 ? bar.ends[i - 1] : 0.0, to = bar.ends[i];
    if (to <= from) continue;
    QRectF part(bar.box.left() + from, bar.box.top(), std::max(1.0, to - from), bar.box.height());
    painter.fillRect(part, countColor(CountOf(i)));
  }
  painter.setRenderHint(QPainter::Antialiasing, true);
  auto knob = [&](double at, const QColor& color, double grow) {
    QRectF box(bar.box.left() + at - kKnob / 2.0, bar.box.top() - grow, kKnob, bar.box.height() + 2.0 * grow);
    painter.setPen(QPen(option.palette.color(QPalette::Window), 1.0));
    painter.setBrush(color);
    painter.drawRoundedRect(box.adjusted(-0.5, 0, 0.5, 0), 1.5, 1.5);
  };
  bool isHot = option.state & (QStyle::State_MouseOver | QStyle::State_Selected);
  if (hasSeenKnob && isHot && bar.seen < bar.left) knob(bar.seen, countColor(CountOf::Visible), 2.0);
  knob(bar.left, themeColor(themeOf(option.palette), "white"), isHot ? 4.0 : 2.5);
}

void paintBarRuler(QPainter& painter, QRect cell, const BarScale& scale) {
  QRectF groove = countBarBox(cell);
  QFontMetrics metrics(painter.font());
  double free = -1e9;  // where the last word ends
  auto tick = [&](double place, const QString& text) {
    double x = groove.left() + groove.width() * place, width = metrics.horizontalAdvance(text);
    painter.drawLine(QPointF(x, cell.bottom() - 3), QPointF(x, cell.bottom()));
    double left = std::clamp(x - width / 2.0, double(cell.left()), cell.right() - width);
    if (left < free) return;
    painter.drawText(QRectF(left, cell.top(), width + 1.0, cell.height() - 3), Qt::AlignLeft | Qt::AlignVCenter, text);
    free = left + width + 4.0;
  };
  if (scale.isPercent) {
    for (int percent : {0, 50, 100})
      tick(percent / 100.0, percent == 100 ? QObject::tr("100 %") : QString::number(percent));
    return;
  }
  tick(0.0, "0");
  const char* units[] = {"", "k", "M", "G"};
  for (int power = 0; std::pow(10.0, power) <= scale.most; ++power)
    tick(scale.place(std::pow(10.0, power), scale.most),
         QLocale().toString(std::pow(10.0, power % 3), 'f', 0) + units[std::min(3, power / 3)]);
}

}  // namespace velum::gui
