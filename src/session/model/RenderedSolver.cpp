#include "session/model/RenderedSolver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/Error.h"
#include "session/model/Dial.h"
#include "session/model/TypesAt.h"

namespace velum::session {

struct RenderedSolver::Impl {
  scene::Scene scene;
  std::vector<int> cuts;
  TypesAt place;
  render::SheetIndices sheets;
  double aspect;
  DialField field;
  std::vector<Dial> dials;
  CountRange range;

  std::string words(std::uint64_t wanted, std::uint64_t reached) const;
};

std::string RenderedSolver::Impl::words(std::uint64_t wanted, std::uint64_t reached) const {
  std::string drawn =
      fmt::format("{} of {} {} drawn", countText(reached), countText(range.total), shortName(place.path));
  if (wanted == reached) return drawn;
  if (range.most == 0) {
    std::vector<bool> shown = visibleTypes(scene.model);
    bool isShown = std::any_of(place.types.begin(), place.types.end(), [&](auto type) { return shown[type]; });
    if (!isShown || !scene.model.visible) return fmt::format("{} is not shown", shortName(place.path));
  }
  if (cuts.empty()) return drawn + ": no cut is on whose share could be set";
  if (wanted < range.least) return drawn + ", not fewer: these lie outside of the cuts";
  if (wanted > range.most) return drawn + ", not more: other cuts take the rest, or these spare none of it";
  return fmt::format("{}, the nearest to {}: several come and go at once", drawn, countText(wanted));
}

std::vector<int> enabledCuts(const scene::Scene& scene) {
  std::vector<int> ids;
  for (const scene::Cut& cut : scene.cuts)
    if (cut.enabled) ids.push_back(cut.id);
  return ids;
}

RenderedSolver::RenderedSolver(const scene::Scene& scene, std::vector<int> cuts, std::string_view path,
                               const render::SheetIndices& sheets, double aspect, DialField field) {
  if (!scene.model.data) throw InputError("there is no model: open one first");
  std::vector<int> enabled = enabledCuts(scene);
  std::erase_if(cuts, [&](int cut) { return std::find(enabled.begin(), enabled.end(), cut) == enabled.end(); });
  mImpl = std::make_unique<Impl>(
      Impl{scene, std::move(cuts), typesAt(*scene.model.data, path), sheets, aspect, field, {}, {}});
  mImpl->dials = makeDials(scene, mImpl->cuts, mImpl->place.types, field, sheets, aspect);
  mImpl->range = rangeOf(mImpl->dials);
}

RenderedSolver::~RenderedSolver() = default;
RenderedSolver::RenderedSolver(RenderedSolver&&) noexcept = default;
RenderedSolver& RenderedSolver::operator=(RenderedSolver&&) noexcept = default;

const std::string& RenderedSolver::path() const { return mImpl->place.path; }

CountRange RenderedSolver::range() const { return mImpl->range; }

Solved RenderedSolver::solve(double wanted) const {
  Solved solved{mImpl->scene, std::uint64_t(std::llround(std::clamp(wanted, 0.0, double(mImpl->range.total)))), 0, {}};
  std::uint64_t inRange = std::clamp(solved.wanted, mImpl->range.least, mImpl->range.most);
  solved.reached = turnDials(solved.scene, mImpl->cuts, mImpl->dials, mImpl->field, inRange - mImpl->range.least,
                             mImpl->sheets, mImpl->aspect);
  solved.words = mImpl->words(solved.wanted, solved.reached);
  return solved;
}

Solved solveRendered(const scene::Scene& scene, const std::vector<int>& cuts, std::string_view path, double wanted,
                     const render::SheetIndices& sheets, double aspect) {
  return RenderedSolver(scene, cuts, path, sheets, aspect).solve(wanted);
}

}  // namespace velum::session
