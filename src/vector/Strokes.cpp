#include "vector/Strokes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "vector/CubicFit.h"

namespace velum::vector {

namespace {

constexpr double kStep = 1.0 / 16.0, kFineStep = 1.0 / 64.0, kFine = 1.0 / 8.0;

/// The next width of a pen that has a width, in classes. @param last  0: none
double widthClass(double width, double last) {
  double step = width < kFine ? kFineStep : kStep;
  if (width < 0.5 * kFineStep) return 0.0;
  bool isKept = last > 0.0 && std::abs(width - last) < 0.75 * step;
  return isKept ? last : std::round(width / step) * step;
}

/// The part of a curve between two places on it.
Curve partOf(glm::dvec2 from, const Curve& curve, double low, double high) {
  auto cut = [](glm::dvec2 start, const Curve& whole, double t) {  // the part before t
    glm::dvec2 a = glm::mix(start, whole.control1, t), b = glm::mix(whole.control1, whole.control2, t);
    glm::dvec2 c = glm::mix(whole.control2, whole.end, t), ab = glm::mix(a, b, t), bc = glm::mix(b, c, t);
    return Curve{a, ab, glm::mix(ab, bc, t)};
  };
  Curve before = cut(from, curve, high);
  Curve back{before.control2, before.control1, from};  // walked backwards, of which the beginning is wanted
  Curve part = cut(before.end, back, high > 0.0 ? 1.0 - low / high : 0.0);
  return {part.control2, part.control1, before.end};
}

glm::dvec2 unitOf(glm::dvec2 way) {
  double length = glm::length(way);
  return length > 1e-9 ? way / length : glm::dvec2(0.0);
}

void turnRound(Outline& line) {
  Outline back{line.curves.back().end, {}, line.isClosed};
  for (std::size_t i = line.curves.size(); i-- > 0;) {
    const Curve& curve = line.curves[i];
    back.curves.push_back({curve.control2, curve.control1, i > 0 ? line.curves[i - 1].end : line.start});
  }
  line = std::move(back);
}

/// Follows strokes over the places where they end.
class StrokeJoiner {
 public:
  explicit StrokeJoiner(std::vector<Stroke> strokes) : mStrokes(std::move(strokes)), mIsDone(mStrokes.size()) {
    for (std::size_t i = 0; i < mStrokes.size(); ++i)
      if (!mStrokes[i].line.isClosed)
        for (bool isEnd : {false, true}) mEnds[keyOf(i, isEnd)].push_back(2 * i + (isEnd ? 1u : 0u));
  }

  std::vector<Stroke> joined() {
    std::vector<Stroke> out;
    // From ends first; what is left goes round.
    for (bool isRound : {false, true})
      for (std::size_t i = 0; i < mStrokes.size(); ++i) {
        if (mIsDone[i]) continue;
        if (mStrokes[i].line.isClosed || isRound || nextOf(2 * i) < 0)
          out.push_back(follow(2 * i));
        else if (nextOf(2 * i + 1) < 0)
          out.push_back(follow(2 * i + 1));
      }
    return out;
  }

 private:
  using Key = std::tuple<long long, long long, int, double>;
  Key keyOf(std::size_t i, bool isEnd) const {
    const Stroke& stroke = mStrokes[i];
    glm::dvec2 place = isEnd ? stroke.line.curves.back().end : stroke.line.start;
    return {std::llround(place.x * 1024.0), std::llround(place.y * 1024.0), stroke.id, stroke.strength};
  }
  /// The end of another stroke, or of the same one, that meets an end alone; -1: none.
  long long nextOf(std::size_t end) const {
    const auto& there = mEnds.at(keyOf(end / 2, end % 2 == 1));
    return there.size() == 2 ? static_cast<long long>(there[there[0] == end ? 1 : 0]) : -1;
  }
  /// @param from  the end at which the walk begins
  Stroke follow(std::size_t from) {
    Stroke out = take(from);
    if (out.line.isClosed) return out;
    for (std::size_t at = from;;) {
      long long next = nextOf(at ^ 1u);
      if (next < 0) return out;
      at = std::size_t(next);
      if (mIsDone[at / 2]) break;
      Stroke more = take(at);
      out.line.curves.insert(out.line.curves.end(), more.line.curves.begin(), more.line.curves.end());
    }
    out.line.isClosed = true;
    out.line.curves.back().end = out.line.start;
    return out;
  }
  Stroke take(std::size_t from) {
    mIsDone[from / 2] = true;
    Stroke stroke = std::move(mStrokes[from / 2]);
    mStrokes[from / 2].line = {stroke.line.start, {{{}, {}, stroke.line.curves.back().end}}, stroke.line.isClosed};
    if (from % 2 == 1) turnRound(stroke.line);
    return stroke;
  }

  std::vector<Stroke> mStrokes;
  std::vector<bool> mIsDone;
  std::map<Key, std::vector<std::size_t>> mEnds;
};

}  // namespace

void appendStrokes(const Outline& line, double apart, const PressureAt& pressureAt, std::vector<Stroke>& strokes) {
  glm::dvec2 from = line.start;
  Pressure last;
  double lastClass = 0.0;
  std::size_t before = strokes.size();
  bool isOne = true;
  for (const Curve& curve : line.curves) {
    int steps = std::max(1, int(glm::distance(from, curve.end) / apart));
    double begin = 0.0;
    auto close = [&](double t) {
      if (lastClass > 0.0 && t > begin) strokes.back().line.curves.push_back(partOf(from, curve, begin, t));
      begin = t;
    };
    for (int i = 0; i < steps; ++i) {
      double middle = (i + 0.5) / steps, t = double(i) / steps;
      Pressure here = pressureAt(placeOn(from, curve, middle), unitOf(wayOn(from, curve, middle)));
      double width = widthClass(here.width, here.id == last.id ? lastClass : 0.0);
      if (width == lastClass && (here.id == last.id || width <= 0.0)) continue;
      close(t);
      isOne = isOne && &curve == &line.curves.front() && i == 0;
      if (width > 0.0) strokes.push_back({{t > 0.0 ? placeOn(from, curve, t) : from, {}, false}, width, here.id});
      last = here;
      lastClass = width;
    }
    close(1.0);
    from = curve.end;
  }
  if (isOne && strokes.size() == before + 1) strokes.back().line.isClosed = line.isClosed;
}

std::vector<Stroke> joinedStrokes(std::vector<Stroke> strokes) { return StrokeJoiner(std::move(strokes)).joined(); }

void moveAcross(Outline& line, const std::function<double(glm::dvec2, glm::dvec2)>& offAt) {
  constexpr double kSharpest = 0.4;  // the cosine of half a turn: corners are not moved farther out
  std::size_t count = line.curves.size();
  std::vector<glm::dvec2> places{line.start}, into{glm::dvec2(0.0)}, out;
  for (const Curve& curve : line.curves) {
    glm::dvec2 from = places.back();
    out.push_back(unitOf(wayOn(from, curve, 0.02)));
    into.push_back(unitOf(wayOn(from, curve, 0.98)));
    places.push_back(curve.end);
  }
  out.emplace_back(0.0);
  if (line.isClosed) {
    into.front() = into.back();
    out.back() = out.front();
  }
  std::vector<glm::dvec2> moved;
  for (std::size_t i = 0; i <= count; ++i) {
    glm::dvec2 way = unitOf(into[i] + out[i]), beside = out[i] == glm::dvec2(0.0) ? into[i] : out[i];
    double off = offAt(places[i], way) / std::max(kSharpest, glm::dot(way, beside));
    moved.push_back(places[i] + off * glm::dvec2(-way.y, way.x));
  }
  line.start = moved.front();
  for (std::size_t i = 0; i < count; ++i) {
    Curve& curve = line.curves[i];
    double chord = glm::distance(places[i], places[i + 1]);
    double grown = chord > 1e-9 ? std::clamp(glm::distance(moved[i], moved[i + 1]) / chord, 0.5, 2.0) : 1.0;
    curve = {moved[i] + grown * (curve.control1 - places[i]), moved[i + 1] + grown * (curve.control2 - places[i + 1]),
             moved[i + 1]};
  }
}

}  // namespace velum::vector
