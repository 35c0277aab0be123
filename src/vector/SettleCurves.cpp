#include "vector/SettleCurves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "vector/LineFit.h"

namespace velum::vector {

namespace {

constexpr int kRounds = 2;
constexpr int kMostPoints = 400;          // of a curve that are asked
constexpr std::size_t kLeastPoints = 14;  // of two curves; fewer do not say how they bend
constexpr double kFarOff = 0.44;          // pixels: from there a point counts for twice as much, and soon for far more
constexpr double kMostStep = 0.5;         // of a joint across the line

/// Two curves and the joint between them, in its own terms.
struct JointShape {
  glm::dvec2 start, startWay;  // of the first curve; its way is unit
  glm::dvec2 place, way;       // of the joint
  glm::dvec2 end, endWay;      // of the second curve
  std::array<double, 4> handles;

  Curve before() const { return {start + handles[0] * startWay, place - handles[1] * way, place}; }
  Curve after() const { return {place + handles[2] * way, end - handles[3] * endWay, end}; }
};

/// What may change: the joint across, its turn, and the four handles.
constexpr std::size_t kUnknowns = 6;
using Unknowns = std::array<double, kUnknowns>;

JointShape moved(const JointShape& shape, const Unknowns& by, double share) {
  JointShape out = shape;
  glm::dvec2 across(-shape.way.y, shape.way.x);
  out.place += share * std::clamp(by[0], -kMostStep, kMostStep) * across;
  out.way = glm::normalize(shape.way + share * std::clamp(by[1], -0.3, 0.3) * across);
  for (std::size_t i = 0; i < 4; ++i)
    out.handles[i] = std::clamp(shape.handles[i] + share * by[i + 2], 0.6 * shape.handles[i], 1.5 * shape.handles[i]);
  return out;
}

/// A point of the track beside one of the curves.
struct Beside {
  glm::dvec2 point;
  double t;
  bool isAfter;
};

double weightOf(double off) {
  double far = off / kFarOff, square = far * far;
  return 1.0 + square * square * square * square;
}

class JointSettler {
 public:
  JointSettler(const Track& track, const FittedPiece& before, const FittedPiece& after, JointShape shape)
      : mShape(std::move(shape)) {
    add(track, before, mShape.start, mShape.before(), false);
    add(track, after, mShape.place, mShape.after(), true);
  }

  JointShape settled() {
    double cost = costOf(mShape);
    for (int round = 0; round < 2 && mPoints.size() >= kLeastPoints; ++round) {
      Unknowns by{};
      if (!step(by)) break;
      JointShape next = moved(mShape, by, 1.0);
      double better = costOf(next);
      if (better >= cost) {
        next = moved(mShape, by, 0.4);
        better = costOf(next);
      }
      if (better >= cost) break;
      mShape = next;
      cost = better;
    }
    return mShape;
  }

 private:
  void add(const Track& track, const FittedPiece& piece, glm::dvec2 from, const Curve& curve, bool isAfter) {
    int count = piece.end - piece.first, stride = std::max(1, count / kMostPoints);
    for (int i = piece.first; i < piece.end; i += stride) {
      double t = (i - piece.first + 0.5) / count;
      glm::dvec2 point = track.points[std::size_t(i)];
      for (int k = 0; k < 4; ++k) t = nearer(from, curve, point, t);
      mPoints.push_back({point, t, isAfter});
    }
  }

  double costOf(const JointShape& shape) {
    Curve before = shape.before(), after = shape.after();
    double cost = 0.0;
    for (Beside& beside : mPoints) {
      const Curve& curve = beside.isAfter ? after : before;
      glm::dvec2 from = beside.isAfter ? shape.place : shape.start;
      double t = nearer(from, curve, beside.point, beside.t);
      double off = glm::distance(placeOn(from, curve, t), beside.point), far = off / kFarOff;
      cost += off * off * (1.0 + std::pow(far, 8.0) * 0.2);
    }
    return cost;
  }

  /// A step of Gauss and Newton's.
  bool step(Unknowns& by) {
    std::array<double, kUnknowns * kUnknowns> matrix{};
    Curve before = mShape.before(), after = mShape.after();
    glm::dvec2 across(-mShape.way.y, mShape.way.x);
    for (Beside& beside : mPoints) {
      const Curve& curve = beside.isAfter ? after : before;
      glm::dvec2 from = beside.isAfter ? mShape.place : mShape.start;
      double t = beside.t = nearer(from, curve, beside.point, beside.t), s = 1.0 - t;
      glm::dvec2 way = wayOn(from, curve, t);
      double length = glm::length(way);
      if (length < 1e-9) continue;
      glm::dvec2 normal = glm::dvec2(-way.y, way.x) / length;
      double off = glm::dot(normal, beside.point - placeOn(from, curve, t)), weight = weightOf(off);
      double b0 = s * s * s, b1 = 3.0 * s * s * t, b2 = 3.0 * s * t * t, b3 = t * t * t;
      double sideways = glm::dot(normal, across), along = glm::dot(normal, mShape.way);
      Unknowns row{};
      if (beside.isAfter)
        row = {(b0 + b1) * sideways, b1 * mShape.handles[2] * sideways,    0.0, 0.0,
               b1 * along,           -b2 * glm::dot(normal, mShape.endWay)};
      else
        row = {(b2 + b3) * sideways,
               -b2 * mShape.handles[1] * sideways,
               b1 * glm::dot(normal, mShape.startWay),
               -b2 * along,
               0.0,
               0.0};
      for (std::size_t i = 0; i < kUnknowns; ++i) {
        for (std::size_t j = 0; j < kUnknowns; ++j) matrix[i * kUnknowns + j] += weight * row[i] * row[j];
        by[i] += weight * row[i] * off;
      }
    }
    for (std::size_t i = 0; i < kUnknowns; ++i) matrix[i * kUnknowns + i] += 1e-3 * (1.0 + matrix[i * kUnknowns + i]);
    return solveEquations(matrix, by);
  }

  JointShape mShape;
  std::vector<Beside> mPoints;
};

/// The unit way of a handle; nothing where it has no length.
std::optional<glm::dvec2> wayOfHandle(glm::dvec2 from, glm::dvec2 to) {
  double length = glm::distance(from, to);
  if (length < 1e-6) return {};
  return (to - from) / length;
}

}  // namespace

void settleCurves(const Track& track, std::span<const FittedPiece> pieces, Outline& line) {
  std::size_t count = line.curves.size();
  auto startOf = [&](std::size_t i) -> glm::dvec2 { return i > 0 ? line.curves[i - 1].end : line.start; };
  for (int round = 0; round < kRounds; ++round)
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t next = (i + 1) % count;
      if (!pieces[i].isSmoothAfter || next == i) continue;
      Curve &a = line.curves[i], &b = line.curves[next];
      glm::dvec2 start = startOf(i);
      auto startWay = wayOfHandle(start, a.control1), way = wayOfHandle(a.control2, b.control1);
      auto endWay = wayOfHandle(b.control2, b.end);
      if (!startWay || !way || !endWay) continue;
      std::array<double, 4> handles{glm::distance(start, a.control1), glm::distance(a.control2, a.end),
                                    glm::distance(a.end, b.control1), glm::distance(b.control2, b.end)};
      JointShape shape{start, *startWay, a.end, *way, b.end, *endWay, handles};
      shape = JointSettler(track, pieces[i], pieces[next], shape).settled();
      a = shape.before();
      b = shape.after();
      if (next == 0) line.start = a.end;
    }
}

}  // namespace velum::vector
