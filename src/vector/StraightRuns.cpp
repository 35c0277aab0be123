#include "vector/StraightRuns.h"

#include <algorithm>
#include <cmath>

namespace velum::vector {

namespace {

// The middles of the edges of pixels lie about a straight border within half a pixel, evenly: 0.29 is the root of their
// mean square. A run may bend a little.
constexpr double kRunSquare = 0.16;
constexpr double kRunEnd = 1.05;
constexpr int kLeastRun = 3;

// Corners turn by more than this, and two lines are so much nearer to the points than a bow is.
constexpr double kLeastTurn = 0.45;
constexpr double kSharpTurn = 1.75;
constexpr double kCornerGain = 0.55;
constexpr int kCornerLook = 24;  // points on each side
constexpr int kLeastCorner = 4;  // points of each of its sides
constexpr double kCornerReach = 0.5;

bool isRun(const LineFits& fits, std::span<const glm::dvec2> points, int first, int end) {
  FittedLine line = fits.line(first, end);
  if (line.meanSquare() > kRunSquare) return false;
  for (int i : {first, (first + end) / 2, end - 1})
    if (std::abs(offsetOf(line.middle, points[std::size_t(i)])) > kRunEnd) return false;
  return true;
}

double squaresOf(const LineFits& fits, int first, int end) { return fits.line(first, end).squares; }

double turnBetween(glm::dvec2 a, glm::dvec2 b) { return std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b)); }

}  // namespace

int longestRun(const LineFits& fits, std::span<const glm::dvec2> points, int first, int end) {
  int good = std::min(first + kLeastRun, end), step = kLeastRun;
  while (good < end && isRun(fits, points, first, std::min(good + step, end))) {
    good = std::min(good + step, end);
    step *= 2;
  }
  for (; step > 0; step /= 2)
    if (good + step <= end && isRun(fits, points, first, good + step)) good += step;
  return good;
}

void settleRuns(const LineFits& fits, std::span<StraightRun> runs) {
  constexpr int kReach = 6;
  for (std::size_t i = 1; i < runs.size(); ++i) {
    StraightRun &a = runs[i - 1], &b = runs[i];
    int best = a.end;
    double least = squaresOf(fits, a.first, a.end) + squaresOf(fits, b.first, b.end);
    for (int at = std::max(a.first + 2, a.end - kReach); at <= std::min(b.end - 2, a.end + kReach); ++at) {
      double squares = squaresOf(fits, a.first, at) + squaresOf(fits, at, b.end);
      if (squares >= least - 1e-9) continue;
      least = squares;
      best = at;
    }
    a.end = b.first = best;
  }
}

std::vector<StraightRun> findRuns(const LineFits& fits, std::span<const glm::dvec2> points, int first, int end) {
  std::vector<StraightRun> runs;
  for (int at = first; at < end;) {
    int next = longestRun(fits, points, at, end);
    runs.push_back({at, next});
    at = next;
  }
  if (runs.size() > 1 && runs.back().length() < kLeastRun) {  // what is left over shares with the run before it
    StraightRun &a = runs[runs.size() - 2], &b = runs.back();
    a.end = b.first = std::max(a.first + 1, b.end - std::max(kLeastRun, (b.end - a.first) / 2));
  }
  for (int round = 0; round < 2; ++round) settleRuns(fits, runs);
  return runs;
}

std::optional<glm::dvec2> findCorner(const LineFits& fits, std::span<const glm::dvec2> points,
                                     const StraightRun& before, const StraightRun& after, glm::dvec2 middle) {
  if (before.length() < kLeastCorner || after.length() < kLeastCorner) return {};
  int first = std::max(before.first, before.end - kCornerLook), end = std::min(after.end, after.first + kCornerLook);
  FittedLine a = fits.line(first, before.end), b = fits.line(after.first, end);
  double turn = std::abs(turnBetween(a.middle.direction, b.middle.direction));
  if (turn < kLeastTurn) return {};
  if (turn < kSharpTurn) {
    Tangent about{middle, glm::normalize(a.middle.direction + b.middle.direction)};
    auto bow = fitLocalCurve(points.subspan(std::size_t(first), std::size_t(end - first)), about, 2);
    if (bow && a.squares + b.squares > kCornerGain * bow->meanSquare * (end - first)) return {};
  }
  auto crossing = crossingOf(a.middle, b.middle);
  if (!crossing) return middle;
  double off = glm::distance(*crossing, middle);
  return off <= kCornerReach ? *crossing : middle + (*crossing - middle) * (kCornerReach / off);
}

}  // namespace velum::vector
