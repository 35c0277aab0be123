#include "session/lettering/FreePlaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace velum::session {

namespace {

constexpr double kRounding = 1e-6;  // pixels
constexpr double kSideways = 4.0;   // so much longer is the way to a place beside the wanted one

}  // namespace

bool FreePlaces::isFree(glm::dvec2 at, glm::dvec2 size, double margin, double gap) const {
  if (glm::any(glm::lessThan(at, glm::dvec2(margin - kRounding)))) return false;
  if (glm::any(glm::greaterThan(at + size, mPicture - margin + kRounding))) return false;
  return std::none_of(mTaken.begin(), mTaken.end(), [&](const Taken& taken) {
    double away = std::max(gap, taken.gap) - kRounding;
    return glm::all(glm::lessThan(at, taken.high + away)) && glm::all(glm::greaterThan(at + size, taken.low - away));
  });
}

std::optional<glm::dvec2> FreePlaces::take(glm::dvec2 size, glm::dvec2 wanted, double margin, double gap) {
  // The nearest free place touches what keeps it from the wanted one: another part, or the margin.
  glm::dvec2 last = mPicture - margin - size;
  std::vector<double> xs{wanted.x, margin, last.x}, ys{wanted.y, margin, last.y};
  for (const Taken& taken : mTaken) {
    glm::dvec2 away(std::max(gap, taken.gap)), before = taken.low - away - size, behind = taken.high + away;
    xs.insert(xs.end(), {before.x, behind.x});
    ys.insert(ys.end(), {before.y, behind.y});
  }
  std::optional<glm::dvec2> best;
  double least = std::numeric_limits<double>::infinity();
  for (double y : ys)
    for (double x : xs) {
      double way = std::abs(y - wanted.y) + kSideways * std::abs(x - wanted.x);
      if (way >= least || !isFree({x, y}, size, margin, gap)) continue;
      least = way;
      best = {x, y};
    }
  if (best) mTaken.push_back({*best, *best + size, gap});
  return best;
}

}  // namespace velum::session
