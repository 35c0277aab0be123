#include "vector/CubicFit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/Vectors.h"
#include "vector/LineFit.h"

namespace velum::vector {

namespace {

constexpr int kMostAsked = 64;  // points that decide what a curve is like; all decide whether it is near
constexpr int kRounds = 4;      // of fitting, and finding the points' places on the curve
constexpr int kMostHeld = 600;
constexpr int kHoldRounds = 24;

/// A point and where on the curve it is.
struct Asked {
  glm::dvec2 point;
  int index;
  double t;
  double weight = 1.0;
};

struct Derivatives {
  glm::dvec2 first, second;
};
Derivatives derivativesOn(glm::dvec2 from, const Curve& curve, double t) {
  glm::dvec2 a = curve.control1 - from, b = curve.control2 - curve.control1, c = curve.end - curve.control2;
  double s = 1.0 - t;
  return {3.0 * (s * s * a + 2.0 * s * t * b + t * t * c), 6.0 * (s * (b - a) + t * (c - b))};
}

/// What is sought: handles, each along one direction or in both axes.
class Handles {
 public:
  Handles(const CurveEnd& from, const CurveEnd& to, double length) : mFrom(from), mTo(to), mThird(length / 3.0) {
    add(from, true, 1.0);
    add(to, false, -1.0);
  }

  /// The curve of least squares for points at their places. A little weight holds the handles of what few points say.
  std::optional<Curve> fit(std::span<const Asked> asked) const {
    std::array<double, 16> matrix{};
    std::array<double, 4> answer{};
    auto n = std::size_t(mCount);
    for (std::size_t i = 0; i < n; ++i) {
      matrix[i * n + i] = kHold;
      answer[i] = kHold * mUsual[i];
    }
    for (const Asked& a : asked) {
      double t = a.t, s = 1.0 - t;
      double near = 3.0 * s * s * t, far = 3.0 * s * t * t;
      glm::dvec2 rest = a.point - (s * s * s + near) * mFrom.place - (far + t * t * t) * mTo.place;
      for (std::size_t i = 0; i < n; ++i) {
        double own = a.weight * (mIsFirst[i] ? near : far);
        for (std::size_t j = 0; j < n; ++j)
          matrix[i * n + j] += own * (mIsFirst[j] ? near : far) * glm::dot(mWays[i], mWays[j]);
        answer[i] += own * glm::dot(mWays[i], rest);
      }
    }
    if (!solveEquations(std::span(matrix).first(n * n), std::span(answer).first(n))) return {};
    Curve curve{mFrom.place, mTo.place, mTo.place};
    for (std::size_t i = 0; i < n; ++i) (mIsFirst[i] ? curve.control1 : curve.control2) += answer[i] * mWays[i];
    return curve;
  }

 private:
  static constexpr double kHold = 1e-3;

  void add(const CurveEnd& end, bool isFirst, double sign) {
    auto append = [&](glm::dvec2 way, double usual) {
      auto i = std::size_t(mCount++);
      mWays[i] = way;
      mIsFirst[i] = isFirst;
      mUsual[i] = usual;
    };
    if (end.direction) {
      append(sign * *end.direction, mThird);
      return;
    }
    glm::dvec2 chord = (mTo.place - mFrom.place) * (sign / 3.0);
    append({1.0, 0.0}, chord.x);
    append({0.0, 1.0}, chord.y);
  }

  CurveEnd mFrom, mTo;
  double mThird;
  int mCount = 0;
  std::array<glm::dvec2, 4> mWays{};
  std::array<bool, 4> mIsFirst{};
  std::array<double, 4> mUsual{};
};

/// Points by their share of the way along the track.
std::vector<Asked> askedOf(const Track& track, int first, int end, const CurveEnd& from, const CurveEnd& to, int most,
                           double& length) {
  std::vector<Asked> asked;
  int stride = std::max(1, (end - first) / most);
  length = 0.0;
  glm::dvec2 last = from.place;
  for (int i = first; i < end; ++i) {
    glm::dvec2 point = track.points[std::size_t(i)];
    length += glm::distance(last, point);
    last = point;
    if ((i - first) % stride == 0) asked.push_back({point, i, length});
  }
  length += glm::distance(last, to.place);
  for (Asked& a : asked) a.t /= std::max(length, 1e-9);
  return asked;
}

bool isNearFence(const Track& track, int index, glm::dvec2 place, double most) {
  for (int i = std::max(0, index - 1); i <= std::min(index + 1, int(track.points.size()) - 1); ++i)
    if (distanceToSegment(place, track.fence[std::size_t(i)], track.fence[std::size_t(i) + 1]) <= most) return true;
  return false;
}

/// Whether a curve is near all points, which follow each other along it.
bool isNear(const Track& track, int first, int end, glm::dvec2 from, const Curve& curve, std::span<const Asked> asked,
            const Nearness& nearness) {
  double squares = 0.0, before = -0.05;
  std::size_t next = 0;
  for (int i = first; i < end; ++i) {
    while (next + 1 < asked.size() && asked[next + 1].index <= i) ++next;
    double t = asked[next].t;
    if (next + 1 < asked.size())
      t = glm::mix(t, asked[next + 1].t, double(i - asked[next].index) / (asked[next + 1].index - asked[next].index));
    glm::dvec2 point = track.points[std::size_t(i)];
    for (int step = 0; step < 2; ++step) t = nearer(from, curve, point, t);
    glm::dvec2 place = placeOn(from, curve, t);
    double distance = glm::distance(place, point);
    squares += distance * distance;
    if (distance > nearness.point || t < before - 0.1 || !isNearFence(track, i, place, nearness.fence)) return false;
    before = t;
  }
  return squares <= nearness.mean * nearness.mean * (end - first);
}

/// Handles that point forward and are no longer than the way.
bool isSimple(const CurveEnd& from, const Curve& curve, const CurveEnd& to, double length) {
  glm::dvec2 first = curve.control1 - from.place, last = to.place - curve.control2, chord = to.place - from.place;
  glm::dvec2 forwards = from.direction.value_or(chord), on = to.direction.value_or(chord);
  return glm::dot(first, forwards) > 0.0 && glm::dot(last, on) > 0.0 && glm::length(first) <= length &&
         glm::length(last) <= length && glm::length(first) + glm::length(last) <= 1.4 * length;
}

}  // namespace

glm::dvec2 placeOn(glm::dvec2 from, const Curve& curve, double t) {
  double s = 1.0 - t;
  return s * s * s * from + 3.0 * s * s * t * curve.control1 + 3.0 * s * t * t * curve.control2 + t * t * t * curve.end;
}

glm::dvec2 wayOn(glm::dvec2 from, const Curve& curve, double t) { return derivativesOn(from, curve, t).first; }

double nearer(glm::dvec2 from, const Curve& curve, glm::dvec2 point, double t) {
  glm::dvec2 way = placeOn(from, curve, t) - point;
  auto [first, second] = derivativesOn(from, curve, t);
  double slope = glm::dot(first, first) + glm::dot(way, second);
  double step = slope > 1e-9 ? glm::dot(way, first) / slope : 0.0;
  return std::clamp(t - std::clamp(step, -0.2, 0.2), 0.0, 1.0);
}

std::optional<Curve> fitCubic(const Track& track, int first, int end, const CurveEnd& from, const CurveEnd& to,
                              const Nearness& nearness) {
  double length = 0.0;
  std::vector<Asked> asked = askedOf(track, first, end, from, to, kMostAsked, length);
  if (!from.direction && !to.direction) {
    Curve line = straight(from.place, to.place);
    Nearness nearAsLine = nearness;
    nearAsLine.mean = std::min(nearness.mean, 0.38);  // what lies about a straight line by half a pixel has 0.29
    if (isNear(track, first, end, from.place, line, asked, nearAsLine)) return line;
  }
  Handles handles(from, to, length);
  std::optional<Curve> curve;
  for (int round = 0; round < kRounds; ++round) {
    curve = handles.fit(asked);
    if (!curve) return {};
    for (Asked& a : asked) a.t = nearer(from.place, *curve, a.point, a.t);
  }
  if (!isSimple(from, *curve, to, length) || !isNear(track, first, end, from.place, *curve, asked, nearness)) return {};
  return curve;
}

bool liesWithin(const Track& track, int first, int end, glm::dvec2 from, const Curve& curve, double most) {
  constexpr double kPerPixel = 20.0;
  int low = std::max(first - 1, 0), high = std::min(end + 1, int(track.points.size()));
  double length = glm::distance(from, curve.control1) + glm::distance(curve.control1, curve.control2) +
                  glm::distance(curve.control2, curve.end);
  int steps = std::max(6, int(kPerPixel * length)), at = low;
  for (int i = 0; i <= steps; ++i) {
    glm::dvec2 place = placeOn(from, curve, double(i) / steps);
    double least = 1e9;
    int nearest = at;
    for (int k = std::max(low, at - 3); k < std::min(high, at + 6); ++k) {
      double off = distanceToSegment(place, track.fence[std::size_t(k)], track.fence[std::size_t(k) + 1]);
      if (off >= least) continue;
      least = off;
      nearest = k;
    }
    at = nearest;
    if (least > most) return false;
  }
  return true;
}

std::optional<Curve> holdCubic(const Track& track, int first, int end, const CurveEnd& from, const CurveEnd& to,
                               double most) {
  double length = 0.0;
  std::vector<Asked> asked = askedOf(track, first, end, from, to, kMostHeld, length);
  if (asked.empty()) return {};
  Handles handles(from, to, length);
  for (int round = 0; round < kHoldRounds; ++round) {
    std::optional<Curve> curve = handles.fit(asked);
    if (!curve) return {};
    double sum = 0.0;
    for (Asked& a : asked) {
      a.t = nearer(from.place, *curve, a.point, a.t);
      sum += glm::distance(placeOn(from.place, *curve, a.t), a.point);
    }
    bool isWell = round > 1 && isSimple(from, *curve, to, length);
    if (isWell && liesWithin(track, first, end, from.place, *curve, most)) return curve;
    double mean = std::max(sum / double(asked.size()), 1e-6), weights = 0.0;
    for (Asked& a : asked) {
      a.weight *= 0.3 + glm::distance(placeOn(from.place, *curve, a.t), a.point) / mean;
      weights += a.weight;
    }
    for (Asked& a : asked) a.weight *= double(asked.size()) / weights;
  }
  return {};
}

}  // namespace velum::vector
