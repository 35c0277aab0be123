#include "session/model/HandleSolver.h"

#include <algorithm>

#include "core/Error.h"
#include "session/model/Dial.h"
#include "session/model/TargetSolver.h"
#include "session/model/TypesAt.h"

namespace velum::session {

namespace {

/// The share of all types of a path in some cuts.
void setShares(scene::Scene& scene, const std::vector<int>& cuts, const TypeNumbers& types, double share) {
  for (std::uint32_t type : types)
    setDial(scene, cuts, pathOf(*scene.model.data, scene.model.data->types[type]), DialField::Share, share);
}

}  // namespace

HandleSolver::HandleSolver(const scene::Scene& scene, std::string_view path, const render::SheetIndices& sheets,
                           double aspect)
    : mSheets(sheets), mAspect(aspect) {
  if (!scene.model.data) throw InputError("there is no model: open one first");
  TypesAt place = typesAt(*scene.model.data, path);
  mPath = place.path;
  for (const scene::Cut& cut : scene.cuts)
    if (cut.enabled) (cut.shape == scene::CutShape::Everywhere ? mEverywhere : mRegions).push_back(cut.id);
  mBelow = scene;
  scene::Scene above = scene;
  setShares(above, mEverywhere, place.types, 1.0);
  setShares(mBelow, mRegions, place.types, 0.0);
  if (!mRegions.empty()) mInRegions.emplace(above, mRegions, mPath, sheets, aspect);
  if (mEverywhere.empty()) mEverywhere = {addCutEverywhere(mBelow)};
  if (mRegions.empty()) mOfRest.emplace(mBelow, mEverywhere, mPath, sheets, aspect);
}

CountRange HandleSolver::range() const {
  CountRange range = mInRegions ? mInRegions->range() : mOfRest->range();
  if (mInRegions) range.least = 0;
  return range;
}

Solved HandleSolver::solve(double wanted) {
  mIsBelow = !mInRegions || wanted < double(mInRegions->range().least);
  if (!mIsBelow) return mInRegions->solve(wanted);
  if (!mOfRest) mOfRest.emplace(mBelow, mEverywhere, mPath, mSheets, mAspect);
  return mOfRest->solve(wanted);
}

}  // namespace velum::session
