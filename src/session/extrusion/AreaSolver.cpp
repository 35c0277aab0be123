#include "session/extrusion/AreaSolver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "session/extrusion/Extrusion.h"
#include "session/structure/StructureAreas.h"
#include "session/structure/StructureEdit.h"

namespace velum::session {

namespace {

/// A length from one number to before another, as few digits as tell floats there apart, off both where that goes.
double lengthBetween(float from, float before) {
  double width = std::isinf(before) ? 0.1 * from + 1e-3 : double(before) - from;
  double middle = from + 0.5 * width;
  for (double step = std::pow(10.0, std::ceil(std::log10(width))); step > 1e-9 * width; step *= 0.1) {
    double rounded = std::round(middle / step) * step;
    bool isOff = std::abs(rounded - middle) <= 0.25 * width;
    if (isOff && float(rounded) >= from && float(rounded) < before) return rounded;
  }
  return from > 0.0f ? from : std::numeric_limits<float>::min();
}

}  // namespace

std::vector<int> cutsToPullFrom(const scene::Scene& scene) {
  std::vector<int> ids;
  for (const scene::Cut& cut : scene.cuts)
    if (canPullFrom(cut) && cut.shape != scene::CutShape::Everywhere) ids.push_back(cut.id);
  return ids;
}

AreaSolver::AreaSolver(const scene::Scene& scene, std::vector<int> cuts, int structure,
                       const std::vector<render::StructureHit>& hits)
    : mScene(scene), mCuts(std::move(cuts)), mStructure(structure) {
  bool isShown = isStructureShown(scene, structure);
  for (const render::StructureHit& hit : hits) {
    if (hit.structure != structure) continue;
    ++mRange.total;
    if (!isShown || hit.depth >= render::kLeftNever) continue;
    if (hit.depth == render::kLeftAlways)
      ++mRange.least;
    else
      mDepths.push_back(hit.depth);
  }
  std::sort(mDepths.begin(), mDepths.end());
  mRange.most = mRange.least + mDepths.size();
}

std::string AreaSolver::words(std::uint64_t wanted, std::uint64_t reached) const {
  std::string name = structureName(mScene, mStructure);
  if (!isStructureShown(mScene, mStructure)) return name + " is not shown";
  if (mRange.total == 0) return name + " lies beside the picture";
  std::string left = fmt::format("{} is left on {} of {} pixels", name, reached, mRange.total);
  if (wanted == reached) return left;
  if (mCuts.empty()) return left + ": no cut is on out of which it could stand";
  if (wanted < mRange.least) return left + ", not fewer: there no cut out of which it stands removes it";
  if (wanted > mRange.most) return left + ", not more: other cuts remove the rest";
  return fmt::format("{}, the nearest to {}: several come and go at once", left, wanted);
}

SolvedArea AreaSolver::solve(double wanted) const {
  SolvedArea solved{mScene, 0.0, std::uint64_t(std::llround(std::clamp(wanted, 0.0, double(mRange.total)))), 0, {}};
  std::size_t count = std::size_t(std::clamp(solved.wanted, mRange.least, mRange.most) - mRange.least);
  if (count > 0 && count < mDepths.size() && mDepths[count - 1] == mDepths[count]) {
    // Those that come and go together: all of them or none, whichever is nearer.
    auto [first, last] = std::equal_range(mDepths.begin(), mDepths.end(), mDepths[count]);
    auto before = std::size_t(first - mDepths.begin()), upTo = std::size_t(last - mDepths.begin());
    count = count - before <= upTo - count ? before : upTo;
  }
  if (count > 0)
    solved.distance = lengthBetween(mDepths[count - 1],
                                    count < mDepths.size() ? mDepths[count] : std::numeric_limits<float>::infinity());
  for (int id : mCuts)
    if (scene::Cut* cut = scene::findCut(solved.scene, id)) setExtrusion(*cut, mStructure, solved.distance);
  solved.reached = mRange.least + count;
  solved.words = words(solved.wanted, solved.reached);
  return solved;
}

}  // namespace velum::session
