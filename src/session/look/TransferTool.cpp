#include "session/look/TransferTool.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/Vectors.h"

namespace velum::session {

namespace {

int tickCount(AxisView view, double step) {
  return int(std::floor(view.high / step + 1e-9) - std::ceil(view.low / step - 1e-9)) + 1;
}

/// The smallest of 1, 2 and 5 times a power of ten of which at most `most` multiples lie on the axis.
double roundStep(AxisView view, int most) {
  double power = std::pow(10.0, std::floor(std::log10((view.high - view.low) / std::max(1, most))));
  for (double factor : {1.0, 2.0, 5.0, 10.0})
    if (tickCount(view, power * factor) <= most) return power * factor;
  return power * 20.0;
}

template <class Point>
int insertSorted(std::vector<Point>& points, const Point& point) {
  auto place =
      std::upper_bound(points.begin(), points.end(), point.value, [](double v, const Point& p) { return v < p.value; });
  auto index = place - points.begin();
  points.insert(place, point);
  return int(index);
}

template <class Point>
double between(const std::vector<Point>& points, int index, double value) {
  auto i = std::size_t(index);
  if (i > 0) value = std::max(value, points[i - 1].value);
  if (i + 1 < points.size()) value = std::min(value, points[i + 1].value);
  return value;
}

template <class Point>
bool removeAt(std::vector<Point>& points, int index) {
  if (index < 0 || std::size_t(index) >= points.size() || points.size() < 2) return false;
  points.erase(points.begin() + index);
  return true;
}

}  // namespace

AxisView zoomAxis(AxisView view, double about, double factor, AxisView whole) {
  double most = whole.high - whole.low, width = view.high - view.low;
  double wanted = std::clamp(width * factor, most * 1e-5, most);
  double share = std::clamp((about - view.low) / width, 0.0, 1.0);
  double low = std::clamp(about - share * wanted, whole.low, whole.high - wanted);
  return {low, low + wanted};
}

AxisView panAxis(AxisView view, double by, AxisView whole) {
  double width = view.high - view.low;
  double low = std::clamp(view.low + by, whole.low, std::max(whole.low, whole.high - width));
  return {low, low + width};
}

std::vector<double> axisTicks(AxisView view, int most) {
  std::vector<double> ticks;
  double step = roundStep(view, most);
  if (!(step > 0) || !std::isfinite(step)) return ticks;
  double first = std::ceil(view.low / step - 1e-9);
  for (int i = 0; i < std::min(most, tickCount(view, step)); ++i)
    ticks.push_back(first + i == 0 ? 0.0 : (first + i) * step);
  return ticks;
}

std::string axisNumber(double value, AxisView view) {
  double width = view.high - view.low;
  if (std::abs(value) >= 1e6 || width < 1e-4) return fmt::format("{:.4g}", value);
  int decimals = std::clamp(int(std::ceil(2.0 - std::log10(width))), 0, 6);
  std::string text = fmt::format("{:.{}f}", value, decimals);
  return text == "-0" ? "0" : text;
}

int addPoint(Curve& curve, double value, double opacity) {
  return insertSorted(curve, scene::OpacityPoint{value, std::clamp(opacity, 0.0, 1.0)});
}

void movePoint(Curve& curve, int index, double value, double opacity) {
  if (index < 0 || std::size_t(index) >= curve.size()) return;
  curve[std::size_t(index)] = {between(curve, index, value), std::clamp(opacity, 0.0, 1.0)};
}

bool removePoint(Curve& curve, int index) { return removeAt(curve, index); }

int addStop(Stops& stops, double value) {
  return insertSorted(stops, scene::ColorPoint{value, glm::vec3(scene::colorAt(stops, value))});
}

void moveStop(Stops& stops, int index, double value) {
  if (index < 0 || std::size_t(index) >= stops.size()) return;
  stops[std::size_t(index)].value = between(stops, index, value);
}

bool removeStop(Stops& stops, int index) { return removeAt(stops, index); }

void shiftTransfer(scene::TransferFunction& transfer, double by) {
  for (auto& point : transfer.opacities) point.value += by;
  for (auto& stop : transfer.colors) stop.value += by;
}

void stretchTransfer(scene::TransferFunction& transfer, double about, double factor) {
  for (auto& point : transfer.opacities) point.value = about + (point.value - about) * factor;
  for (auto& stop : transfer.colors) stop.value = about + (stop.value - about) * factor;
}

void scaleOpacity(scene::TransferFunction& transfer, double factor) {
  for (auto& point : transfer.opacities) point.opacity = std::clamp(point.opacity * factor, 0.0, 1.0);
}

double middleOf(const scene::TransferFunction& transfer) {
  const Curve& curve = transfer.opacities;
  return curve.empty() ? 0.0 : 0.5 * (curve.front().value + curve.back().value);
}

double xOf(const CurveFrame& frame, double value) {
  return frame.topLeft.x + (value - frame.view.low) / (frame.view.high - frame.view.low) * frame.size.x;
}
double valueAtX(const CurveFrame& frame, double x) {
  return frame.view.low + (x - frame.topLeft.x) / frame.size.x * (frame.view.high - frame.view.low);
}
double yOf(const CurveFrame& frame, double opacity) {
  return frame.topLeft.y + (1.0 - std::pow(std::clamp(opacity, 0.0, 1.0), frame.power)) * frame.size.y;
}
double opacityAtY(const CurveFrame& frame, double y) {
  double height = std::clamp(1.0 - (y - frame.topLeft.y) / frame.size.y, 0.0, 1.0);
  return std::pow(height, 1.0 / frame.power);
}

CurveHit hitCurve(const CurveFrame& frame, const Curve& curve, glm::dvec2 pixel, double reach) {
  CurveHit hit;
  double nearest = reach;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    double distance = glm::length(pixel - glm::dvec2(xOf(frame, curve[i].value), yOf(frame, curve[i].opacity)));
    if (distance <= nearest) nearest = distance, hit = {CurveHit::Part::Point, int(i)};
  }
  if (hit.index >= 0 || curve.empty()) return hit;
  glm::dvec2 last = frame.topLeft + frame.size;
  if (pixel.x < frame.topLeft.x || pixel.x > last.x || pixel.y < frame.topLeft.y - reach || pixel.y > last.y + reach)
    return hit;
  auto line = outlineOf(frame, curve);
  for (std::size_t i = 1; i < line.size(); ++i)
    if (distanceToSegment(pixel, line[i - 1], line[i]) <= reach) return {CurveHit::Part::Line, -1};
  double height = yOf(frame, scene::opacityAt(curve, valueAtX(frame, pixel.x)));
  return {pixel.y > height ? CurveHit::Part::Area : CurveHit::Part::Nothing, -1};
}

int hitStop(const CurveFrame& frame, const Stops& stops, double x, double reach) {
  int found = -1;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    double distance = std::abs(xOf(frame, stops[i].value) - x);
    if (distance <= reach) reach = distance, found = int(i);
  }
  return found;
}

std::vector<glm::dvec2> outlineOf(const CurveFrame& frame, const Curve& curve) {
  // Where the curve bends, its ends, and every other pixel between, as a line is none in the bent heights.
  std::vector<double> values;
  for (double x = 0; x < frame.size.x; x += 2.0) values.push_back(valueAtX(frame, frame.topLeft.x + x));
  values.push_back(frame.view.high);
  std::vector<glm::dvec2> line;
  std::size_t next = 0;
  while (next < curve.size() && curve[next].value < frame.view.low) ++next;
  for (double value : values) {
    for (; next < curve.size() && curve[next].value <= value; ++next)
      line.push_back({xOf(frame, curve[next].value), yOf(frame, curve[next].opacity)});
    line.push_back({xOf(frame, value), yOf(frame, scene::opacityAt(curve, value))});
  }
  return line;
}

}  // namespace velum::session
