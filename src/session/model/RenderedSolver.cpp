#include "session/model/RenderedSolver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/Counts.h"
#include "core/Error.h"
#include "scene/Shown.h"
#include "session/model/CutKinds.h"
#include "session/model/TargetSolver.h"
#include "session/model/TypesAt.h"

namespace velum::session {

namespace {

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
  Solved solve(std::uint64_t wanted) const;

  scene::Scene scene;
  std::vector<int> cuts;
  TypesAt place;
  render::SheetIndices sheets;
  double aspect;
  DialField field;
  std::vector<TypeDial> dials;
  CountRange range;
};

namespace {

/// Something within the compartment whose number a hand has set.
struct Held {
  std::string path;
  std::uint64_t drawn = 0;
};

/// What is drawn of the things within a compartment whose numbers hands have set. @param others  the compartment's
/// types; without those of the things afterwards
std::vector<Held> takeHeld(const scene::Scene& scene, const std::string& path, TypeNumbers& others,
                           const render::SheetIndices& sheets, double aspect) {
  std::vector<Held> held;
  for (const std::string& within : heldWithin(scene, path)) {
    TypeNumbers types;
    for (std::uint32_t type : others) {
      std::string of = pathOf(*scene.model.data, scene.model.data->types[type]);
      if (of == within || isWithin(of, within)) types.push_back(type);
    }
    if (types.empty()) continue;  // a number of another model
    std::erase_if(others, [&](auto type) { return std::binary_search(types.begin(), types.end(), type); });
    held.push_back({within, countRendered(scene, types, sheets, aspect)});
  }
  return held;
}

std::uint64_t drawnOf(const std::vector<Held>& held) {
  std::uint64_t sum = 0;
  for (const Held& one : held) sum += one.drawn;
  return sum;
}

/// What became of numbers that hands had set. @param drawn  what is drawn of them now
std::string heldWords(const scene::Scene& scene, const std::vector<Held>& held, std::uint64_t drawn) {
  if (held.empty()) return {};
  bool isOne = held.size() == 1;
  std::string what =
      isOne ? fmt::format("the number of {}", nameAt(scene, held[0].path)) : fmt::format("{} numbers", held.size());
  if (drawn < drawnOf(held))
    return fmt::format("; {} set by hand {} down, to {}", what, isOne ? "goes" : "go", countText(drawn));
  return fmt::format("; {} set by hand {}", what, isOne ? "stays" : "stay");
}

}  // namespace

struct RenderedSolver::Impl {
  TypesAt place;
  TypesAt others;  ///< the place without the types whose numbers are held
  std::vector<Held> held;
  std::function<RenderedSolver(const scene::Scene&, const std::string&)> again;  ///< for another path
  std::unique_ptr<Part> regions;                    ///< of cuts with regions, or that were named; null: there are none
  std::unique_ptr<Part> rest;                       ///< of what these leave at least
  std::function<std::unique_ptr<Part>()> makeRest;  ///< where it is wanted; none: it is not

  const Part& first() const { return regions ? *regions : *rest; }
  CountRange range() const;
  CountRange wholeRange() const;
  Solved solveOthers(std::uint64_t wanted);
  void lowerHeld(Solved& solved, std::uint64_t wanted) const;
  std::string words(const Solved& solved, std::uint64_t drawn) const;
};

/// Of what is not held.
CountRange RenderedSolver::Impl::range() const {
  CountRange range = first().range;
  if (regions && makeRest) range.least = 0;
  return range;
}

/// With what is held, which may go down to nothing, too.
CountRange RenderedSolver::Impl::wholeRange() const {
  const scene::ModelLayer& layer = first().scene.model;
  CountRange all = range();
  for (const Held& one : held) {
    all.most += one.drawn;
    for (std::uint32_t type : typesAt(*layer.data, one.path).types)
      all.total += std::uint64_t(layer.data->types[type].instanceCount) * std::uint64_t(scene::copyCount(layer));
  }
  return all;
}

Solved RenderedSolver::Impl::solveOthers(std::uint64_t wanted) {
  bool isOfRest = !regions || (makeRest && wanted < regions->range.least);
  if (!isOfRest) return regions->solve(wanted);
  if (!rest) rest = makeRest();
  return rest->solve(wanted);
}

/// Lets the held numbers share out what is wanted, which is less than they have together.
void RenderedSolver::Impl::lowerHeld(Solved& solved, std::uint64_t wanted) const {
  std::vector<std::uint64_t> numbers;
  for (const Held& one : held) numbers.push_back(one.drawn);
  std::vector<std::uint64_t> parts = apportion(numbers, wanted);
  for (std::size_t i = 0; i < held.size(); ++i) {
    Solved lower = again(solved.scene, held[i].path).solve(double(parts[i]));
    solved.scene = std::move(lower.scene);
    solved.reached += lower.reached;
    holdDrawn(solved.scene, held[i].path, double(lower.reached));
  }
}

std::string RenderedSolver::Impl::words(const Solved& solved, std::uint64_t drawn) const {
  const scene::Scene& scene = first().scene;
  CountRange all = wholeRange();
  std::string left =
      fmt::format("{} of {} {} drawn", countText(solved.reached), countText(all.total), nameAt(scene, place.path));
  if (solved.wanted != solved.reached && all.most == 0) {
    std::vector<bool> shown = visibleTypes(scene.model);
    bool isShown = std::any_of(place.types.begin(), place.types.end(), [&](auto type) { return shown[type]; });
    if (!isShown || !scene.model.visible) return fmt::format("{} is not shown", nameAt(scene, place.path));
  }
  DialReasons reasons{"no cut is on whose share could be set", "these lie outside of the cuts",
                      held.empty() ? "other cuts take the rest, or these spare none of it"
                                   : "other cuts take the rest, or numbers set by hand hold it back"};
  return wordsFor(solved, all, left, countText(solved.wanted), reasons) + heldWords(scene, held, drawn);
}

Solved RenderedSolver::Part::solve(std::uint64_t wanted) const {
  Solved solved{scene, cuts, wanted, 0, {}};
  std::uint64_t inRange = std::clamp(solved.wanted, range.least, range.most);
  solved.reached = turnDials(solved.scene, cuts, dials, field, inRange - range.least, sheets, aspect);
  return solved;
}

std::vector<int> enabledCuts(const scene::Scene& scene) {
  std::vector<int> ids;
  for (const scene::Cut& cut : scene.cuts)
    if (cut.enabled) ids.push_back(cut.id);
  return ids;
}

RenderedSolver::RenderedSolver(const scene::Scene& scene, std::vector<int> cuts, std::string_view path,
                               const render::SheetIndices& sheets, double aspect, DialField field)
    : mImpl(std::make_unique<Impl>()) {
  Impl& my = *mImpl;
  my.place = my.others = placeIn(scene, path);
  my.held = takeHeld(scene, my.place.path, my.others.types, sheets, aspect);
  my.again = [=](const scene::Scene& of, const std::string& other) {
    return RenderedSolver(of, cuts, other, sheets, aspect, field);
  };
  std::vector<int> enabled = enabledCuts(scene);
  std::erase_if(cuts, [&](int cut) { return std::find(enabled.begin(), enabled.end(), cut) == enabled.end(); });
  my.regions = std::make_unique<Part>(scene, std::move(cuts), my.others, sheets, aspect, field);
}

RenderedSolver RenderedSolver::ofAllCuts(const scene::Scene& scene, std::string_view path,
                                         const render::SheetIndices& sheets, double aspect) {
  auto impl = std::make_unique<Impl>();
  impl->place = impl->others = placeIn(scene, path);
  impl->held = takeHeld(scene, impl->place.path, impl->others.types, sheets, aspect);
  impl->again = [=](const scene::Scene& of, const std::string& other) { return ofAllCuts(of, other, sheets, aspect); };
  const TypesAt& place = impl->others;
  CutKinds kinds = cutKinds(scene, enabledCuts(scene));
  if (!kinds.regions.empty())
    impl->regions = std::make_unique<Part>(withAllEverywhere(scene, kinds, place.types), kinds.regions, place, sheets,
                                           aspect, DialField::Share);
  scene::Scene below = withNoneInRegions(scene, kinds, place.types);
  if (kinds.everywhere.empty()) kinds.everywhere = {addCutEverywhere(below)};
  impl->makeRest = [below = std::move(below), everywhere = kinds.everywhere, place, sheets, aspect] {
    return std::make_unique<Part>(below, everywhere, place, sheets, aspect, DialField::Share);
  };
  if (kinds.regions.empty()) impl->rest = impl->makeRest();
  return RenderedSolver(std::move(impl));
}

RenderedSolver::RenderedSolver(std::unique_ptr<Impl> impl) : mImpl(std::move(impl)) {}
RenderedSolver::~RenderedSolver() = default;
RenderedSolver::RenderedSolver(RenderedSolver&&) noexcept = default;
RenderedSolver& RenderedSolver::operator=(RenderedSolver&&) noexcept = default;

const std::string& RenderedSolver::path() const { return mImpl->place.path; }

CountRange RenderedSolver::range() const { return mImpl->wholeRange(); }

Solved RenderedSolver::solve(double wanted) const {
  constexpr double kMost = 1e15;
  auto number = std::uint64_t(std::llround(std::clamp(wanted, 0.0, kMost)));
  std::uint64_t held = drawnOf(mImpl->held);
  Solved solved = mImpl->solveOthers(number > held ? number - held : 0);
  solved.wanted = number;
  std::uint64_t others = solved.reached;
  if (number < held)
    mImpl->lowerHeld(solved, number);
  else
    solved.reached += held;
  solved.words = mImpl->words(solved, solved.reached - others);
  return solved;
}

Solved solveRendered(const scene::Scene& scene, const std::vector<int>& cuts, std::string_view path, double wanted,
                     const render::SheetIndices& sheets, double aspect) {
  return RenderedSolver(scene, cuts, path, sheets, aspect).solve(wanted);
}

}  // namespace velum::session
