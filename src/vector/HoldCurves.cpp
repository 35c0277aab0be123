#include "vector/HoldCurves.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace velum::vector {

namespace {

constexpr int kMostAround = 150;    // points on either side of a joint
constexpr double kGrace = 0.02;     // pixels
constexpr int kLeastHeld = 5;       // points; fewer are gone through
constexpr double kFarJoint = 0.45;  // of a joint that is put in, from the middle of its pixel's edge

/// Makes the line anew, curve by curve.
class CurveHolder {
 public:
  CurveHolder(const Track& track, const LineFits& fits, std::span<const FittedPiece> pieces, double most)
      : mTrack(track), mFits(fits), mPieces(pieces), mMost(most) {}

  Outline held(Outline line) {
    for (std::size_t i = 0; i < line.curves.size(); ++i) holdJoint(line, i);
    mLine = {line.start, {}, line.isClosed};
    glm::dvec2 from = line.start;
    for (std::size_t i = 0; i < line.curves.size(); ++i) {
      const Curve& curve = line.curves[i];
      const FittedPiece& piece = mPieces[i];
      if (liesWithin(mTrack, piece.first, piece.end, from, curve, mMost + kGrace))
        mLine.curves.push_back(curve);
      else
        holdBetween(piece.first, piece.end, {from, wayOf(from, curve.control1, piece.isFreeBefore)},
                    {curve.end, wayOf(curve.control2, curve.end, piece.isFreeAfter)});
      from = curve.end;
    }
    return std::move(mLine);
  }

 private:
  /// Moves the end of a curve, and the handles about it, to the edge of the pixel that it stands for.
  void holdJoint(Outline& line, std::size_t i) const {
    bool isLast = i + 1 == line.curves.size();
    if (isLast && !line.isClosed) return;
    Curve &curve = line.curves[i], &next = line.curves[isLast ? 0 : i + 1];
    auto at = std::size_t(mPieces[i].end);
    bool isOnPoint = mPieces[i].isSmoothAfter && at < mTrack.points.size();
    glm::dvec2 by = (isOnPoint ? mTrack.points[at] : mTrack.fence[at]) - curve.end;
    double off = glm::length(by);
    if (off <= mMost) return;
    by *= 1.0 - mMost / off;
    curve.end += by;
    curve.control2 += by;
    next.control1 += by;
    if (isLast) line.start += by;
  }

  static std::optional<glm::dvec2> wayOf(glm::dvec2 from, glm::dvec2 to, bool isFree) {
    double length = glm::distance(from, to);
    if (isFree || length < 1e-6) return {};
    return (to - from) / length;
  }

  void holdBetween(int first, int end, const CurveEnd& from, const CurveEnd& to) {
    if (auto curve = holdCubic(mTrack, first, end, from, to, mMost + kGrace)) {
      mLine.curves.push_back(*curve);
      return;
    }
    if (end - first < kLeastHeld) {
      goThroughMiddles(first, end, from, to);
      return;
    }
    int middle = (first + end - 1) / 2;
    Tangent joint = jointAt(mTrack, mFits, middle, first, end);
    glm::dvec2 off = joint.place - mTrack.points[std::size_t(middle)];
    double far = glm::length(off);
    if (far > kFarJoint) joint.place -= off * (1.0 - kFarJoint / far);
    holdBetween(first, middle, from, {joint.place, joint.direction});
    holdBetween(middle + 1, end, {joint.place, joint.direction}, to);
  }

  /// Through the middles of the edges of pixels, smoothly.
  void goThroughMiddles(int first, int end, const CurveEnd& from, const CurveEnd& to) {
    std::vector<glm::dvec2> places{from.place};
    places.insert(places.end(), mTrack.points.begin() + first, mTrack.points.begin() + end);
    places.push_back(to.place);
    std::size_t last = places.size() - 1;
    auto wayAt = [&](std::size_t i, double length) {
      if (i == 0 && from.direction) return *from.direction * length;
      if (i == last && to.direction) return *to.direction * length;
      glm::dvec2 way = places[std::min(i + 1, last)] - places[i > 0 ? i - 1 : 0];
      return way * (length / std::max(glm::length(way), 1e-9));
    };
    for (std::size_t i = 0; i < last; ++i) {
      double third = glm::distance(places[i], places[i + 1]) / 3.0;
      mLine.curves.push_back({places[i] + wayAt(i, third), places[i + 1] - wayAt(i + 1, third), places[i + 1]});
    }
  }

  const Track& mTrack;
  const LineFits& mFits;
  std::span<const FittedPiece> mPieces;
  double mMost;
  Outline mLine;
};

}  // namespace

Tangent jointAt(const Track& track, const LineFits& fits, int point, int first, int end) {
  glm::dvec2 place = track.points[std::size_t(point)];
  auto lineBeside = [&](int low, int high) {
    Tangent line = fits.line(low, high).middle;
    line.place += line.direction * alongOf(line, place);
    return line;
  };
  for (int wide = kMostAround; wide > 3; wide /= 2) {
    int low = std::max(first, point - wide), high = std::min(end, point + wide + 1);
    if (high - low < 8 || high - low <= wide) continue;
    auto around = std::span(track.points).subspan(std::size_t(low), std::size_t(high - low));
    auto curve = fitLocalCurve(around, lineBeside(low, high), 3);
    if (curve && curve->meanSquare < kJointSquare && curve->largest < kJointLargest && curve->bend < kJointBend)
      return curve->tangent;
  }
  return lineBeside(std::max(first, point - 3), std::min(end, point + 4));
}

void holdCurves(const Track& track, const LineFits& fits, std::span<const FittedPiece> pieces, Outline& line,
                double most) {
  line = CurveHolder(track, fits, pieces, most).held(std::move(line));
}

}  // namespace velum::vector
