#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "session/model/RenderedSolver.h"

namespace velum::session {

/// What the handle of a bar sets where nobody says which cuts: what lies in the regions of cuts goes first and comes
/// back last, and only below what lies outside of all of them a cut that is everywhere thins the rest. It is added
/// where there is none. So one motion goes from all to none of a type, whatever cuts there are. Costs and threads: as
/// RenderedSolver, of which it is two.
class HandleSolver {
 public:
  /// @throw InputError as of RenderedSolver
  HandleSolver(const scene::Scene& scene, std::string_view path, const render::SheetIndices& sheets = {},
               double aspect = render::kUsualAspect);

  const std::string& path() const { return mPath; }
  CountRange range() const;
  Solved solve(double wanted);
  /// The cuts that the last solve() has set.
  const std::vector<int>& cuts() const { return mIsBelow ? mEverywhere : mRegions; }

 private:
  std::string mPath;
  render::SheetIndices mSheets;
  double mAspect;
  std::vector<int> mRegions, mEverywhere;
  scene::Scene mBelow;  ///< with nothing left in the regions, and a cut everywhere
  std::optional<RenderedSolver> mInRegions, mOfRest;
  bool mIsBelow = false;
};

}  // namespace velum::session
