#include "gui/membrane/StrengthCanvas.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "gui/kit/Words.h"
#include "scene/Scene.h"
#include "scene/json/FieldFacts.h"

namespace velum::gui {

namespace {

constexpr int kPlotHeight = 120;
constexpr double kReach = 8.0;  // pixels
constexpr double kSmallShare = 0.05;

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

StrengthCanvas::StrengthCanvas(QWidget* parent) : CurveCanvas(kPlotHeight, 0, parent) {}

void StrengthCanvas::setCurve(const StrengthCurve& curve) {
  if (curve == mCurve) return;
  mCurve = curve;
  if (mSelected >= int(mCurve.size())) mSelected = -1;
  update();
}

void StrengthCanvas::setHistogram(const Histogram& histogram, session::AxisView view) {
  CurveCanvas::setHistogram(histogram);
  setAxis(view.high > view.low ? view : session::AxisView{view.low, view.low + 1.0});
}

QPointF StrengthCanvas::placeOf(scene::StrengthPoint point) const {
  QRectF p = plot();
  return {std::clamp(xOf(point.value), p.left(), p.right()),
          p.center().y() - heightOf(point.strength) * p.height() / 2};
}

scene::StrengthPoint StrengthCanvas::pointAt(QPointF place) const {
  QRectF p = plot();
  double share = std::clamp((place.x() - p.left()) / p.width(), 0.0, 1.0);
  double height = std::clamp((p.center().y() - place.y()) / (p.height() / 2), -1.0, 1.0);
  if (std::abs(height) < kSmallShare) height = 0.0;  // the line of no force is easy to hit
  return {view().low + share * (view().high - view().low), strengthOf(height)};
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
  update();
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
  setHover(event->position());
  if (mDragging) moveSelected(pointAt(event->position()), mStart, true);
  setCursor(mDragging || hit(event->position()) >= 0 ? Qt::SizeAllCursor : Qt::CrossCursor);
  update();
}

void StrengthCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !mDragging) return;
  mDragging = false;
  emit settled();
}

bool StrengthCanvas::isOwnKey(int key) const {
  return key == Qt::Key_PageDown || key == Qt::Key_PageUp || key == Qt::Key_Insert || key == Qt::Key_Delete;
}

void StrengthCanvas::step(int sideways, int up, bool wide) {
  if (mSelected < 0) return;
  scene::StrengthPoint point = mCurve[std::size_t(mSelected)];
  point.value += sideways * (view().high - view().low) / (wide ? 20.0 : 200.0);
  point.strength += up * (wide ? 100.0 : 10.0);
  moveSelected(point, mCurve, true);
  update();
}

/// Round and round.
void StrengthCanvas::selectNext(int by) {
  int count = int(mCurve.size());
  if (count > 0) mSelected = ((mSelected < 0 ? 0 : mSelected + by) + count) % count;
  update();
}

void StrengthCanvas::addBeside() {
  addAt(plot().center());
  emit settled();
  update();
}

void StrengthCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintGround(painter, [&] { paintPlot(painter); });
  for (std::size_t i = 0; i < mCurve.size(); ++i) {
    double strength = mCurve[i].strength;
    paintPoint(painter, placeOf(mCurve[i]),
               strength > 0   ? kKeepColor
               : strength < 0 ? kDrawColor
                              : palette().color(QPalette::Base),
               int(i) == mSelected);
  }
  paintAxis(painter, false);
}

void StrengthCanvas::paintPlot(QPainter& painter) const {
  QRectF p = plot();
  double zero = p.center().y();
  paintBars(painter, 0.9, true);
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
  painter.setFont(smallFont(font()));
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(p, Qt::AlignLeft | Qt::AlignTop, tr("protects"));
  painter.drawText(p, Qt::AlignLeft | Qt::AlignBottom, tr("draws the sheet"));
  std::optional<scene::StrengthPoint> shown;
  if (mSelected >= 0 && mSelected < int(mCurve.size())) shown = mCurve[std::size_t(mSelected)];
  if (hover()) shown = pointAt(*hover());
  if (!shown) return;
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(p, Qt::AlignRight | Qt::AlignTop,
                   QString("%1 %2   %3")
                       .arg(localNumber(session::axisNumber(shown->value, view())), unit())
                       .arg(shown->strength, 0, 'f', 0));
}

}  // namespace velum::gui
