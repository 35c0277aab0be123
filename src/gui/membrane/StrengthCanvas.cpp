#include "gui/membrane/StrengthCanvas.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "scene/Scene.h"
#include "scene/json/FieldFacts.h"

namespace velum::gui {

namespace {

constexpr int kMargin = 9, kPlotHeight = 120, kAxisHeight = 18;
constexpr double kReach = 8.0;  // pixels
constexpr double kSmallShare = 0.05;

QColor faded(QColor color, double alpha) {
  color.setAlphaF(float(alpha));
  return color;
}

/// Heights by the root, so that the weak forces that are often enough have room.
double heightOf(double strength) { return std::copysign(std::sqrt(std::abs(strength) / mostStrength()), strength); }
double strengthOf(double height) {
  return std::clamp(std::copysign(height * height, height), -1.0, 1.0) * mostStrength();
}

}  // namespace

double mostStrength() {
  static const double kMost = scene::fieldFacts("cuts.N.membrane.field.byValue.N.strength").range.max;
  return kMost;
}

StrengthCanvas::StrengthCanvas(QWidget* parent) : QWidget(parent) {
  setFixedHeight(kMargin + kPlotHeight + kAxisHeight);
  setMinimumWidth(200);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QRectF StrengthCanvas::plot() const {
  return QRectF(kMargin, kMargin, std::max(1, width() - 2 * kMargin), kPlotHeight);
}

void StrengthCanvas::setCurve(const StrengthCurve& curve) {
  if (curve == mCurve) return;
  mCurve = curve;
  if (mSelected >= int(mCurve.size())) mSelected = -1;
  update();
}

void StrengthCanvas::setHistogram(const Histogram& histogram, session::AxisView view) {
  mHistogram = histogram;
  mView = view.high > view.low ? view : session::AxisView{view.low, view.low + 1.0};
  update();
}

void StrengthCanvas::setUnit(const QString& unit) {
  mUnit = unit;
  update();
}

QPointF StrengthCanvas::placeOf(scene::StrengthPoint point) const {
  QRectF p = plot();
  double share = (point.value - mView.low) / (mView.high - mView.low);
  return {p.left() + std::clamp(share, 0.0, 1.0) * p.width(),
          p.center().y() - heightOf(point.strength) * p.height() / 2};
}

scene::StrengthPoint StrengthCanvas::pointAt(QPointF place) const {
  QRectF p = plot();
  double share = std::clamp((place.x() - p.left()) / p.width(), 0.0, 1.0);
  double height = std::clamp((p.center().y() - place.y()) / (p.height() / 2), -1.0, 1.0);
  if (std::abs(height) < kSmallShare) height = 0.0;  // the line of no force is easy to hit
  return {mView.low + share * (mView.high - mView.low), strengthOf(height)};
}

int StrengthCanvas::hit(QPointF place) const {
  int found = -1;
  double nearest = kReach;
  for (std::size_t i = 0; i < mCurve.size(); ++i) {
    QPointF away = placeOf(mCurve[i]) - place;
    double distance = std::hypot(away.x(), away.y());
    if (distance > nearest) continue;
    nearest = distance;
    found = int(i);
  }
  return found;
}

void StrengthCanvas::addAt(QPointF place) {
  scene::StrengthPoint point = pointAt(place);
  StrengthCurve next = mCurve;
  auto at = std::upper_bound(next.begin(), next.end(), point.value,
                             [](double value, const auto& p) { return value < p.value; });
  mSelected = int(at - next.begin());
  next.insert(at, point);
  emit edited(tr("Add force point"), next, true);
  mStart = next;
}

void StrengthCanvas::removeSelected() {
  if (mSelected < 0) return;
  StrengthCurve next = mCurve;
  next.erase(next.begin() + mSelected);
  mSelected = -1;
  emit edited(tr("Remove force point"), next, false);
}

/// As far as its neighbours let it.
void StrengthCanvas::moveSelected(scene::StrengthPoint to, const StrengthCurve& start, bool merge) {
  if (mSelected < 0 || mSelected >= int(start.size())) return;
  auto i = std::size_t(mSelected);
  StrengthCurve next = start;
  if (i > 0) to.value = std::max(to.value, next[i - 1].value);
  if (i + 1 < next.size()) to.value = std::min(to.value, next[i + 1].value);
  next[i] = {to.value, std::clamp(to.strength, -mostStrength(), mostStrength())};
  emit edited(tr("Move force point"), next, merge);
}

void StrengthCanvas::mousePressEvent(QMouseEvent* event) {
  if (mDragging) return;
  int index = hit(event->position());
  if (event->button() == Qt::RightButton) {
    mSelected = index;
    return removeSelected();
  }
  if (event->button() != Qt::LeftButton) return;
  mDragging = true;
  mStart = mCurve;
  mSelected = index;
  if (index < 0) addAt(event->position());
  update();
}

void StrengthCanvas::mouseMoveEvent(QMouseEvent* event) {
  mHover = event->position();
  if (mDragging) moveSelected(pointAt(event->position()), mStart, true);
  setCursor(mDragging || hit(event->position()) >= 0 ? Qt::SizeAllCursor : Qt::CrossCursor);
  update();
}

void StrengthCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !mDragging) return;
  mDragging = false;
  emit settled();
}

void StrengthCanvas::leaveEvent(QEvent*) {
  mHover.reset();
  update();
}

/// Its keys come before commands that have the same.
bool StrengthCanvas::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    constexpr int kKeys[] = {Qt::Key_PageDown, Qt::Key_PageUp, Qt::Key_Insert, Qt::Key_Delete};
    int key = static_cast<QKeyEvent*>(event)->key();
    if (std::find(std::begin(kKeys), std::end(kKeys), key) != std::end(kKeys)) event->accept();
  }
  return QWidget::event(event);
}

/// PgUp and PgDn go from point to point, arrows move it, Ins adds one, Del removes it.
void StrengthCanvas::keyPressEvent(QKeyEvent* event) {
  int count = int(mCurve.size());
  double step = (mView.high - mView.low) / ((event->modifiers() & Qt::ShiftModifier) ? 20.0 : 200.0);
  double force = (event->modifiers() & Qt::ShiftModifier) ? 100.0 : 10.0;
  auto move = [&](double value, double strength) {
    if (mSelected < 0) return;
    scene::StrengthPoint point = mCurve[std::size_t(mSelected)];
    moveSelected({point.value + value, point.strength + strength}, mCurve, true);
  };
  switch (event->key()) {
    case Qt::Key_PageDown:
    case Qt::Key_PageUp:
      if (count > 0)
        mSelected = ((mSelected < 0 ? 0 : mSelected + (event->key() == Qt::Key_PageDown ? 1 : -1)) + count) % count;
      break;
    case Qt::Key_Left:
      move(-step, 0);
      break;
    case Qt::Key_Right:
      move(step, 0);
      break;
    case Qt::Key_Up:
      move(0, force);
      break;
    case Qt::Key_Down:
      move(0, -force);
      break;
    case Qt::Key_Insert:
      addAt(plot().center());
      emit settled();
      break;
    case Qt::Key_Delete:
      removeSelected();
      break;
    default:
      return QWidget::keyPressEvent(event);
  }
  update();
}

void StrengthCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath ground;
  ground.addRoundedRect(plot().adjusted(-3, -3, 3, 3), 5, 5);
  painter.fillPath(ground, palette().color(QPalette::Base));
  painter.save();
  painter.setClipPath(ground);
  paintPlot(painter);
  painter.restore();
  if (hasFocus()) {
    painter.setPen(QPen(faded(palette().color(QPalette::Link), 0.7), 1.0));
    painter.drawPath(ground);
  }
  for (std::size_t i = 0; i < mCurve.size(); ++i) {
    QPointF place = placeOf(mCurve[i]);
    if (int(i) == mSelected) {
      painter.setPen(QPen(palette().color(QPalette::Link), 2.0));
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(place, 7.5, 7.5);
    }
    painter.setPen(QPen(palette().color(QPalette::Text), 1.3));
    painter.setBrush(mCurve[i].strength > 0   ? kKeepColor
                     : mCurve[i].strength < 0 ? kDrawColor
                                              : palette().color(QPalette::Base));
    painter.drawEllipse(place, 4.5, 4.5);
  }
  paintAxis(painter);
}

void StrengthCanvas::paintPlot(QPainter& painter) const {
  QRectF p = plot();
  double zero = p.center().y(), bottom = p.bottom() + 3;
  int columns = std::max(1, int(p.width()));
  auto heights = session::histogramHeights(mHistogram, mView, columns, true);
  QPainterPath bars(QPointF(p.left(), bottom));
  for (int i = 0; i < columns; ++i)
    bars.lineTo(p.left() + i + 0.5, bottom - heights[std::size_t(i)] * 0.9 * p.height());
  bars.lineTo(p.right(), bottom);
  painter.fillPath(bars, faded(palette().color(QPalette::PlaceholderText), 0.30));
  painter.setPen(faded(palette().color(QPalette::Text), 0.45));
  painter.drawLine(QPointF(p.left() - 3, std::round(zero) + 0.5), QPointF(p.right() + 3, std::round(zero) + 0.5));
  if (!mCurve.empty()) {
    QPainterPath line(QPointF(placeOf(mCurve.front()).x(), zero));
    for (const auto& point : mCurve) line.lineTo(placeOf(point));
    line.lineTo(placeOf(mCurve.back()).x(), zero);
    for (bool above : {true, false}) {
      painter.save();
      painter.setClipRect(above ? QRectF(0, 0, width(), zero) : QRectF(0, zero, width(), height()), Qt::IntersectClip);
      painter.fillPath(line, faded(above ? kKeepColor : kDrawColor, 0.28));
      painter.restore();
    }
    painter.setPen(QPen(palette().color(QPalette::Text), 1.4));
    painter.drawPath(line);
  }
  QFont small = font();
  small.setPointSizeF(font().pointSizeF() * 0.82);
  painter.setFont(small);
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(p, Qt::AlignLeft | Qt::AlignTop, tr("protects"));
  painter.drawText(p, Qt::AlignLeft | Qt::AlignBottom, tr("draws the sheet"));
  std::optional<scene::StrengthPoint> shown;
  if (mSelected >= 0 && mSelected < int(mCurve.size())) shown = mCurve[std::size_t(mSelected)];
  if (mHover) shown = pointAt(*mHover);
  if (!shown) return;
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(p, Qt::AlignRight | Qt::AlignTop,
                   QString("%1 %2   %3")
                       .arg(QString::fromStdString(session::axisNumber(shown->value, mView)), mUnit)
                       .arg(shown->strength, 0, 'f', 0));
}

void StrengthCanvas::paintAxis(QPainter& painter) const {
  QRectF p = plot();
  QFont small = font();
  small.setPointSizeF(font().pointSizeF() * 0.82);
  painter.setFont(small);
  painter.setPen(palette().color(QPalette::PlaceholderText));
  QFontMetricsF metrics(small);
  double free = -1e9;
  for (double tick : session::axisTicks(mView, std::clamp(int(p.width() / 50), 2, 8))) {
    QString text = QString::fromStdString(session::axisNumber(tick, mView));
    double wide = metrics.horizontalAdvance(text), x = placeOf({tick, 0}).x();
    double left = std::clamp(x - 0.5 * wide, 1.0, width() - wide - 1.0);
    if (left < free) continue;
    painter.drawText(QPointF(left, height() - 3), text);
    free = left + wide + 6;
  }
}

}  // namespace velum::gui
