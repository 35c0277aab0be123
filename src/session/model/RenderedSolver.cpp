#include "session/model/RenderedSolver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/Counts.h"
#include "core/Error.h"
#include "session/model/TargetSolver.h"
#include "session/model/TypesAt.h"

namespace velum::session {

namespace {

/// The share of all types of a path in some cuts.
void setShares(scene::Scene& scene, const std::vector<int>& cuts, const TypeNumbers& types, double share) {
  for (std::uint32_t type : types)
    setDial(scene, cuts, pathOf(*scene.model.data, scene.model.data->types[type]), DialField::Share, share);
}

TypesAt placeIn(const scene::Scene& scene, std::string_view path) {
  if (!scene.model.data) throw InputError("there is no model: open one first");
  return typesAt(*scene.model.data, path);
}

}  // namespace

/// Some cuts and what their shares do.
struct RenderedSolver::Part {
  Part(const scene::Scene& of, std::vector<int> setCuts, const TypesAt& where, const render::SheetIndices& sheetsOf,
       double aspectOf, DialField fieldOf)
      : scene(of), cuts(std::move(setCuts)), place(where), sheets(sheetsOf), aspect(aspectOf), field(fieldOf) {
    dials = makeDials(scene, cuts, place.types, field, sheets, aspect);
    range = rangeOf(dials);
  }
  Solved solve(double wanted) const;
  std::string words(const Solved& solved) const;

  scene::Scene scene;
  std::vector<int> cuts;
  TypesAt place;
  render::SheetIndices sheets;
  double aspect;
  DialField field;
  std::vector<TypeDial> dials;
  CountRange range;
};

struct RenderedSolver::Impl {
  TypesAt place;
  std::unique_ptr<Part> regions;                    ///< of cuts with regions, or that were named; null: there are none
  std::unique_ptr<Part> rest;                       ///< of what these leave at least
  std::function<std::unique_ptr<Part>()> makeRest;  ///< where it is wanted; none: it is not
};

std::string RenderedSolver::Part::words(const Solved& solved) const {
  std::string drawn =
      fmt::format("{} of {} {} drawn", countText(solved.reached), countText(range.total), shortName(place.path));
  if (solved.wanted != solved.reached && range.most == 0) {
    std::vector<bool> shown = visibleTypes(scene.model);
    bool isShown = std::any_of(place.types.begin(), place.types.end(), [&](auto type) { return shown[type]; });
    if (!isShown || !scene.model.visible) return fmt::format("{} is not shown", shortName(place.path));
  }
  return wordsFor(solved, range, drawn, countText(solved.wanted),
                  {"no cut is on whose share could be set", "these lie outside of the cuts",
                   "other cuts take the rest, or these spare none of it"});
}

Solved RenderedSolver::Part::solve(double wanted) const {
  Solved solved{scene, cuts, std::uint64_t(std::llround(std::clamp(wanted, 0.0, double(range.total)))), 0, {}};
  std::uint64_t inRange = std::clamp(solved.wanted, range.least, range.most);
  solved.reached = turnDials(solved.scene, cuts, dials, field, inRange - range.least, sheets, aspect);
  solved.words = words(solved);
  return solved;
}

std::vector<int> enabledCuts(const scene::Scene& scene) {
  std::vector<int> ids;
  for (const scene::Cut& cut : scene.cuts)
    if (cut.enabled) ids.push_back(cut.id);
  return ids;
}

RenderedSolver::RenderedSolver(const scene::Scene& scene, std::vector<int> cuts, std::string_view path,
                               const render::SheetIndices& sheets, double aspect, DialField field) {
  TypesAt place = placeIn(scene, path);
  std::vector<int> enabled = enabledCuts(scene);
  std::erase_if(cuts, [&](int cut) { return std::find(enabled.begin(), enabled.end(), cut) == enabled.end(); });
  auto part = std::make_unique<Part>(scene, std::move(cuts), place, sheets, aspect, field);
  mImpl = std::make_unique<Impl>(Impl{std::move(place), std::move(part), nullptr, {}});
}

RenderedSolver RenderedSolver::ofAllCuts(const scene::Scene& scene, std::string_view path,
                                         const render::SheetIndices& sheets, double aspect) {
  auto impl = std::make_unique<Impl>(Impl{placeIn(scene, path), nullptr, nullptr, {}});
  const TypesAt& place = impl->place;
  std::vector<int> regions, everywhere;
  for (const scene::Cut& cut : scene.cuts)
    if (cut.enabled) (cut.shape == scene::CutShape::Everywhere ? everywhere : regions).push_back(cut.id);
  scene::Scene above = scene, below = scene;  // with nothing left in the regions, and a cut everywhere
  setShares(above, everywhere, place.types, 1.0);
  setShares(below, regions, place.types, 0.0);
  if (!regions.empty()) impl->regions = std::make_unique<Part>(above, regions, place, sheets, aspect, DialField::Share);
  if (everywhere.empty()) everywhere = {addCutEverywhere(below)};
  impl->makeRest = [below = std::move(below), everywhere, place, sheets, aspect] {
    return std::make_unique<Part>(below, everywhere, place, sheets, aspect, DialField::Share);
  };
  if (regions.empty()) impl->rest = impl->makeRest();
  return RenderedSolver(std::move(impl));
}

RenderedSolver::RenderedSolver(std::unique_ptr<Impl> impl) : mImpl(std::move(impl)) {}
RenderedSolver::~RenderedSolver() = default;
RenderedSolver::RenderedSolver(RenderedSolver&&) noexcept = default;
RenderedSolver& RenderedSolver::operator=(RenderedSolver&&) noexcept = default;

const std::string& RenderedSolver::path() const { return mImpl->place.path; }

CountRange RenderedSolver::range() const {
  CountRange range = (mImpl->regions ? mImpl->regions : mImpl->rest)->range;
  if (mImpl->regions && mImpl->makeRest) range.least = 0;
  return range;
}

Solved RenderedSolver::solve(double wanted) const {
  bool isOfRest = !mImpl->regions || (mImpl->makeRest && wanted < double(mImpl->regions->range.least));
  if (!isOfRest) return mImpl->regions->solve(wanted);
  if (!mImpl->rest) mImpl->rest = mImpl->makeRest();
  return mImpl->rest->solve(wanted);
}

Solved solveRendered(const scene::Scene& scene, const std::vector<int>& cuts, std::string_view path, double wanted,
                     const render::SheetIndices& sheets, double aspect) {
  return RenderedSolver(scene, cuts, path, sheets, aspect).solve(wanted);
}

}  // namespace velum::session
