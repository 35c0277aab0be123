#include "vector/FitCurves.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "vector/HoldCurves.h"
#include "vector/LineFit.h"
#include "vector/SettleCurves.h"
#include "vector/StraightRuns.h"

namespace velum::vector {

namespace {

// The middles of longer runs know their direction well enough.
constexpr int kMostLook = 150;
// Turn of a curve, radians: a quarter of a circle and a little.
constexpr double kMostTurnOfCurve = 1.9;

/// Where curves may meet.
struct Joint {
  double index = 0.0;  // among the points; between two of them at corners
  CurveEnd end;
  double turned = 0.0;  // turn of the line from its beginning, without signs; a corner is no turn
  bool isCorner = false;
};

double turnOf(glm::dvec2 a, glm::dvec2 b) { return std::abs(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b))); }

/// Finds joints of a track along its straight runs.
class JointFinder {
 public:
  JointFinder(const Track& track) : mTrack(track), mFits(track.points) {}
  const LineFits& fits() const { return mFits; }

  /// The corner where a run follows another one.
  std::optional<Joint> cornerAt(const StraightRun& before, const StraightRun& after, int pointAfter) const {
    StraightRun next{pointAfter, pointAfter + after.length()};
    auto corner = findCorner(mFits, mTrack.points, before, next, mTrack.fence[std::size_t(pointAfter)]);
    if (!corner) return {};
    return Joint{pointAfter - 0.5, {*corner, {}}, 0.0, true};
  }

  /// A joint in the middle of a run. @param first, end  points between the corners around it
  Joint middleOf(const StraightRun& run, int first, int end) const {
    int middle = (run.first + run.end - 1) / 2;
    Tangent about = mFits.line(run.first, run.end).middle;
    about.place += about.direction * alongOf(about, mTrack.points[std::size_t(middle)]);
    Joint joint{double(middle), {about.place, about.direction}, 0.0, false};
    constexpr std::array<double, 5> kReaches{0.5, 0.75, 1.1, 1.6, 2.2};
    for (double reach : kReaches) {
      int wide = std::min(int(reach * run.length() + 1.0), kMostLook);
      int from = std::max(first, middle - wide), to = std::min(end, middle + wide + 1);
      auto points = std::span(mTrack.points).subspan(std::size_t(from), std::size_t(to - from));
      if (points.size() < 6) continue;
      auto curve = fitLocalCurve(points, about, reach > 0.6 && points.size() > 11 ? 3 : 2);
      if (!curve || curve->meanSquare > kJointSquare || curve->largest > kJointLargest || curve->bend > kJointBend) {
        if (reach > 0.6) break;
        continue;
      }
      joint.end = {curve->tangent.place, curve->tangent.direction};
    }
    return joint;
  }

 private:
  const Track& mTrack;
  LineFits mFits;
};

/// Fits the curves from joint to joint, over as many joints as may be.
class CurveFitter {
 public:
  CurveFitter(const Track& track, const LineFits& fits, const Nearness& nearness)
      : mTrack(track), mFits(fits), mNearness(nearness) {}

  Outline fit(const std::vector<Joint>& joints, bool isClosed) {
    mOutline = {joints.front().end.place, {}, isClosed};
    for (std::size_t from = 0; from + 1 < joints.size();) {
      std::size_t good = from, step = 1;
      std::optional<Curve> best;
      auto reaches = [&](std::size_t to) {
        if (!mayJoin(joints, from, to)) return false;
        auto curve = between(joints[from], joints[to]);
        if (curve) best = curve;
        return bool(curve);
      };
      while (reaches(good + step)) {
        good += step;
        step *= 2;
      }
      while (step > 1) {
        step /= 2;
        if (reaches(good + step)) good += step;
      }
      if (good == from) {
        divide(joints[from], joints[from + 1]);
        good = from + 1;
      } else {
        append(*best, joints[from], joints[good]);
      }
      from = good;
    }
    if (!isClosed || joints.front().isCorner) mPieces.back().isSmoothAfter = false;
    settleCurves(mTrack, mPieces, mOutline);
    if (mNearness.held > 0.0) holdCurves(mTrack, mFits, mPieces, mOutline, mNearness.held);
    return std::move(mOutline);
  }

 private:
  static int firstAfter(const Joint& joint) { return int(std::floor(joint.index)) + 1; }
  static int lastBefore(const Joint& joint) { return int(std::ceil(joint.index)); }

  void append(const Curve& curve, const Joint& from, const Joint& to) {
    mOutline.curves.push_back(curve);
    int first = firstAfter(from);
    mPieces.push_back({first, std::max(first, lastBefore(to)), !to.isCorner && bool(to.end.direction),
                       !from.end.direction, !to.end.direction});
  }

  bool mayJoin(const std::vector<Joint>& joints, std::size_t from, std::size_t to) const {
    if (to >= joints.size()) return false;
    for (std::size_t i = from + 1; i < to; ++i)
      if (joints[i].isCorner) return false;
    return to == from + 1 || joints[to].turned - joints[from].turned <= kMostTurnOfCurve;
  }

  std::optional<Curve> between(const Joint& from, const Joint& to) const {
    return fitCubic(mTrack, firstAfter(from), std::max(firstAfter(from), lastBefore(to)), from.end, to.end, mNearness);
  }

  /// Curves for what one is not near to: a joint more in the middle, or where there are few points, whatever joins
  /// them.
  void divide(const Joint& from, const Joint& to) {
    if (auto curve = between(from, to)) {
      append(*curve, from, to);
      return;
    }
    int first = firstAfter(from), end = lastBefore(to);
    if (end - first < 3) {
      append(simple(from.end, to.end), from, to);
      return;
    }
    int middle = (first + end - 1) / 2;
    Tangent there = jointAt(mTrack, mFits, middle, first, end);
    Joint joint{double(middle), {there.place, there.direction}, 0.0, false};
    divide(from, joint);
    divide(joint, to);
  }

  /// A curve that keeps to the directions of its ends.
  static Curve simple(const CurveEnd& from, const CurveEnd& to) {
    double third = glm::distance(from.place, to.place) / 3.0;
    glm::dvec2 chord = glm::mix(from.place, to.place, 1.0 / 3.0) - from.place;
    glm::dvec2 out = from.direction ? *from.direction * third : chord,
               in = to.direction ? *to.direction * third : chord;
    return {from.place + out, to.place - in, to.place};
  }

  const Track& mTrack;
  const LineFits& mFits;
  Nearness mNearness;
  Outline mOutline;
  std::vector<FittedPiece> mPieces;
};

/// Says of each joint how far the line has turned up to there.
void sumTurns(std::vector<Joint>& joints) {
  double turned = 0.0;
  glm::dvec2 last(0.0);  // none: no turn
  for (Joint& joint : joints) {
    glm::dvec2 direction = joint.end.direction.value_or(joint.isCorner ? glm::dvec2(0.0) : last);
    turned += turnOf(last, direction);
    last = direction;
    joint.turned = turned;
  }
}

/// A closed track four times round, so that whatever lies around a point is beside it.
Track unrolled(const Track& track) {
  Track out;
  for (int turn = 0; turn < 4; ++turn) {
    out.points.insert(out.points.end(), track.points.begin(), track.points.end());
    out.fence.insert(out.fence.end(), track.fence.begin(), track.fence.end() - 1);
  }
  out.fence.push_back(track.fence.back());
  return out;
}

/// Runs once round a closed track, from a point on that is the end of a run.
std::vector<StraightRun> runsAround(const LineFits& fits, std::span<const glm::dvec2> points, int around) {
  int start = findRuns(fits, points, 0, around).front().end;
  std::vector<StraightRun> runs = findRuns(fits, points, start, start + around);
  // Where the first begins is settled, too, once it is between two others.
  auto half = std::ptrdiff_t(runs.size() / 2);
  std::rotate(runs.begin(), runs.begin() + half, runs.end());
  for (auto& run : std::span(runs).subspan(runs.size() - std::size_t(half))) {
    run.first += around;
    run.end += around;
  }
  settleRuns(fits, runs);
  return runs;
}

Joint shifted(Joint joint, int by) {
  joint.index += by;
  return joint;
}

}  // namespace

Outline fitCurves(const Track& track, const CurveEnd& from, const CurveEnd& to, const Nearness& nearness) {
  JointFinder finder(track);
  int count = int(track.points.size());
  std::vector<StraightRun> runs = findRuns(finder.fits(), track.points, 0, count);
  std::vector<std::optional<Joint>> corners(runs.size() + 1);
  for (std::size_t i = 1; i < runs.size(); ++i) corners[i] = finder.cornerAt(runs[i - 1], runs[i], runs[i].first);
  std::vector<Joint> joints{{-0.5, from, 0.0, false}};
  int firstPoint = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (corners[i]) {
      joints.push_back(*corners[i]);
      firstPoint = runs[i].first;
    }
    bool isBetweenEnds = (i == 0 || corners[i]) && (i + 1 == runs.size() || corners[i + 1]);
    if (isBetweenEnds) continue;
    std::size_t next = i + 1;
    while (next < runs.size() && !corners[next]) ++next;
    joints.push_back(finder.middleOf(runs[i], firstPoint, next < runs.size() ? runs[next].first : count));
  }
  joints.push_back({count - 0.5, to, 0.0, false});
  sumTurns(joints);
  return CurveFitter(track, finder.fits(), nearness).fit(joints, false);
}

Outline fitClosedCurves(const Track& closed, const Nearness& nearness) {
  Track track = unrolled(closed);
  int around = int(closed.points.size());
  JointFinder finder(track);
  std::vector<StraightRun> runs = runsAround(finder.fits(), track.points, around);
  std::vector<std::optional<Joint>> corners;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    int by = i > 0 ? 0 : around;
    auto corner = finder.cornerAt(i > 0 ? runs[i - 1] : runs.back(), runs[i], runs[i].first + by);
    corners.push_back(corner ? std::optional(shifted(*corner, -by)) : corner);
  }
  // The line begins at a corner, or in the middle of the longest run.
  std::size_t begin = 0;
  for (std::size_t i = 1; i < runs.size(); ++i) {
    bool isLonger = runs[i].length() > runs[begin].length();
    if (bool(corners[i]) > bool(corners[begin]) || (bool(corners[i]) == bool(corners[begin]) && isLonger)) begin = i;
  }
  std::vector<Joint> joints;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    std::size_t i = (begin + k) % runs.size();
    int by = begin + k < runs.size() ? 0 : around;
    if (corners[i]) joints.push_back(shifted(*corners[i], by));
    if (corners[i] && corners[(i + 1) % runs.size()]) continue;
    std::size_t back = 0, on = 1;
    while (back < runs.size() && !corners[(i + runs.size() - back) % runs.size()]) ++back;
    while (on < runs.size() && !corners[(i + on) % runs.size()]) ++on;
    auto firstOf = [&](std::ptrdiff_t run) {
      auto n = std::ptrdiff_t(runs.size());
      std::ptrdiff_t turns = run < 0 ? -1 : run / n;
      return runs[std::size_t(run - turns * n)].first + int(turns) * around;
    };
    auto here = std::ptrdiff_t(i);
    joints.push_back(shifted(finder.middleOf(runs[i], std::max(0, firstOf(here - std::ptrdiff_t(back))),
                                             std::min(4 * around, firstOf(here + std::ptrdiff_t(on)))),
                             by));
  }
  joints.push_back(shifted(joints.front(), around));
  sumTurns(joints);
  return CurveFitter(track, finder.fits(), nearness).fit(joints, true);
}

}  // namespace velum::vector
