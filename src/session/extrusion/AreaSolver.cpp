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
    ++mDial.total;
    if (!isShown || hit.depth >= render::kLeftNever) continue;
    if (hit.depth == render::kLeftAlways)
      ++mDial.always;
    else
      mDial.candidates.push_back({hit.depth, hit.pixel});
  }
  mRange += mDial;
}

std::string AreaSolver::words(const Solved& solved) const {
  std::string name = structureName(mScene, mStructure);
  if (!isStructureShown(mScene, mStructure)) return name + " is not shown";
  if (mRange.total == 0) return name + " lies beside the picture";
  return wordsFor(solved, mRange, fmt::format("{} is left on {} of {} pixels", name, solved.reached, mRange.total),
                  fmt::format("{}", solved.wanted),
                  {"no cut is on out of which it could stand", "there no cut out of which it stands removes it",
                   "other cuts remove the rest"});
}

SolvedArea AreaSolver::solve(double wanted) const {
  SolvedArea solved{{mScene, mCuts, std::uint64_t(std::llround(std::clamp(wanted, 0.0, double(mRange.total)))), 0, {}}};
  DialGap gap = gapFor(mDial, std::clamp(solved.wanted, mRange.least, mRange.most) - mRange.least);
  if (gap.staying > 0) solved.distance = lengthBetween(gap.last, gap.next);
  for (int id : mCuts)
    if (scene::Cut* cut = scene::findCut(solved.scene, id)) setExtrusion(*cut, mStructure, solved.distance);
  solved.reached = mRange.least + gap.staying;
  solved.words = words(solved);
  return solved;
}

}  // namespace velum::session
