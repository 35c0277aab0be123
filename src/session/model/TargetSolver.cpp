#include "session/model/TargetSolver.h"
#include "session/model/CutKinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/Error.h"
#include "scene/Shown.h"
#include "session/cut/CutEdit.h"
#include "session/model/TargetGoals.h"
#include "session/model/TypesAt.h"

namespace velum::session {

using namespace detail;

namespace {

Count apart(Count a, Count b) { return a > b ? a - b : b - a; }

}  // namespace

struct TargetSolver::Impl {
  std::vector<int> cuts;
  render::SheetIndices sheets;
  double aspect = render::kUsualAspect;
  int mostPictures = kMostPictures;
  std::vector<Goal> goals;         ///< those further down in the tree first
  std::vector<std::size_t> order;  ///< place in `goals` of each target
  scene::Scene scene;              ///< of the next picture
  bool isDone = false;
  TargetsReport best;  ///< `targets` in the order of `goals`, without words
  int lastBetter = 0;
  std::set<std::vector<Count>> tried;

  void addGoal(const scene::Scene& from, const scene::TypeTarget& target);
  void share();
  void makeTiers(Goal& goal);
  void turn();
  void turnDrawn(const Goal& goal);
  std::vector<Reached> reached(const render::InstanceBits& bits) const;
  bool keepIfBest(const std::vector<Reached>& reached);
  void learn(const render::InstanceBits& bits);
  bool leaveView(Goal& goal, Count visible, const render::InstanceBits& bits);
  Count stepOf(Goal& goal, Count visible, const render::InstanceBits& bits);
  std::string wordsOf(const Goal& goal, const TargetReport& report) const;
  bool looksAtPictures() const {
    return std::any_of(goals.begin(), goals.end(), [](const Goal& goal) { return goal.visible.has_value(); });
  }
  std::vector<Count> state() const {
    std::vector<Count> staying;
    for (const Goal& goal : goals) staying.push_back(goal.staying);
    return staying;
  }
  /// True for the only goal that is looked for in pictures: no other goal moves then.
  bool isAlone(const Goal& goal) const {
    return std::none_of(goals.begin(), goals.end(),
                        [&](const Goal& other) { return &other != &goal && other.visible && !other.rendered; });
  }
};

void TargetSolver::Impl::addGoal(const scene::Scene& from, const scene::TypeTarget& target) {
  Goal goal;
  goal.place = typesAt(*from.model.data, target.type);
  auto whole = [](double number) { return Count(std::llround(std::max(0.0, number))); };
  if (target.rendered) goal.rendered = whole(*target.rendered);
  if (target.visible) goal.visible = whole(*target.visible);
  goals.push_back(std::move(goal));
}

/// Gives each type to the nearest target above it.
void TargetSolver::Impl::share() {
  std::set<std::uint32_t> taken;
  for (Goal& goal : goals)
    for (std::uint32_t type : goal.place.types)
      if (taken.insert(type).second) goal.own.push_back(type);
}

/// The dials of a goal's shares: first those of the cuts that are everywhere, which take away last, then those of the
/// cuts with regions.
void TargetSolver::Impl::makeTiers(Goal& goal) {
  goal.tiers.clear();
  goal.all = 0;
  auto add = [&](const std::vector<int>& of, const scene::Scene& in) {
    goal.tiers.push_back(makeTier(of, makeDials(in, of, goal.own, goal.field, sheets, aspect)));
  };
  CutKinds kinds = goal.field == DialField::Share ? cutKinds(scene, cuts) : CutKinds{};
  if (!kinds.everywhere.empty()) add(kinds.everywhere, withNoneInRegions(scene, kinds, goal.own));
  if (!kinds.regions.empty()) add(kinds.regions, withAllEverywhere(scene, kinds, goal.own));
  if (goal.tiers.empty()) add(cuts, scene);
  for (const Tier& tier : goal.tiers) goal.all += tier.all;
}

/// Lets as many be drawn of a goal's own types as its number leaves for them.
void TargetSolver::Impl::turnDrawn(const Goal& goal) {
  TypeNumbers others;
  std::set_difference(goal.place.types.begin(), goal.place.types.end(), goal.own.begin(), goal.own.end(),
                      std::back_inserter(others));
  Count elsewhere = others.empty() ? 0 : countRendered(scene, others, sheets, aspect);
  Count wanted = *goal.rendered > elsewhere ? *goal.rendered - elsewhere : 0;
  CutKinds kinds = cutKinds(scene, cuts);
  auto turnBy = [&](const std::vector<int>& of, scene::Scene in, const std::vector<TypeDial>& dials) {
    Count least = rangeOf(dials).least;
    turnDials(in, of, dials, DialField::Share, wanted > least ? wanted - least : 0, sheets, aspect);
    scene = std::move(in);
  };
  if (!kinds.regions.empty()) {
    scene::Scene above = withAllEverywhere(scene, kinds, goal.own);
    std::vector<TypeDial> dials = makeDials(above, kinds.regions, goal.own, DialField::Share, sheets, aspect);
    if (kinds.everywhere.empty() || wanted >= rangeOf(dials).least)
      return turnBy(kinds.regions, std::move(above), dials);
  }
  scene::Scene below = withNoneInRegions(scene, kinds, goal.own);
  turnBy(kinds.everywhere, below, makeDials(below, kinds.everywhere, goal.own, DialField::Share, sheets, aspect));
}

/// Puts the numbers of all goals into the scene.
void TargetSolver::Impl::turn() {
  for (const Goal& goal : goals) {
    if (goal.rendered || !goal.visible) continue;
    forTiers(goal, goal.staying, [&](const Tier& tier, Count staying) {
      std::vector<Count> parts = splitAmong(tier.dials, staying);
      for (std::size_t i = 0; i < tier.dials.size(); ++i)
        setDial(scene, tier.cuts, tier.dials[i].path, goal.field, settingFor(tier.dials[i], parts[i]).number);
    });
  }
  for (const Goal& goal : goals)
    if (goal.rendered) turnDrawn(goal);
}

std::vector<Reached> TargetSolver::Impl::reached(const render::InstanceBits& bits) const {
  std::vector<Reached> out;
  for (const Goal& goal : goals) out.push_back(reachedIn(scene, goal.place.types, bits));
  return out;
}

bool TargetSolver::Impl::keepIfBest(const std::vector<Reached>& reached) {
  Count residual = 0;
  std::vector<TargetReport> reports;
  for (std::size_t i = 0; i < goals.size(); ++i) {
    const Goal& goal = goals[i];
    TargetReport report{goal.place.path,
                        goal.rendered,
                        goal.visible,
                        reached[i].rendered,
                        totalOf(scene, goal.place.types),
                        reached[i].visible,
                        true,
                        {}};
    Count off = goal.rendered ? apart(report.rendered, *goal.rendered) : 0;
    if (goal.visible && report.visible) off += apart(*report.visible, *goal.visible);
    report.isMet = off == 0;
    residual += off;
    reports.push_back(std::move(report));
  }
  bool isBetter = best.targets.empty() || residual < best.residual;
  if (isBetter) best.scene = scene, best.targets = std::move(reports), best.residual = residual;
  return isBetter;
}

/// Notes which candidates show; for candidates that are not drawn the last note stays.
void TargetSolver::Impl::learn(const render::InstanceBits& bits) {
  for (Goal& goal : goals)
    for (Tier& tier : goal.tiers)
      for (std::size_t i = 0; i < tier.showed.size(); ++i)
        for (std::size_t c = 0; c < tier.showed[i].size(); ++c)
          if (std::uint32_t instance = tier.dials[i].candidates[c].thing; !bits.isRemoved(instance))
            tier.showed[i][c] = bits.isShown(instance);
}

/// Where all instances that hide a focus are gone and still too many show, sets the share of all instances in the
/// region from now on.
/// @return true where that share is set from now on
bool TargetSolver::Impl::leaveView(Goal& goal, Count visible, const render::InstanceBits& bits) {
  if (goal.rendered || !goal.visible || goal.field != DialField::ViewShare) return false;
  if (goal.staying > 0 || visible <= *goal.visible) return false;
  Goal before = goal;
  goal.field = DialField::Share;
  makeTiers(goal);
  if (goal.all == 0) {
    goal = std::move(before);
    return false;
  }
  goal.tooFew.reset(), goal.tooMany.reset();
  for (const Tier& tier : goal.tiers)
    for (const TypeDial& dial : tier.dials)
      for (const Candidate& candidate : dial.candidates) goal.staying += !bits.isRemoved(candidate.thing);
  return true;
}

/// How many candidates of a goal are to stay in the next round.
Count TargetSolver::Impl::stepOf(Goal& goal, Count visible, const render::InstanceBits& bits) {
  Count wanted = *goal.visible, now = goal.staying;
  if (visible == wanted) return now;
  // Instances that show and about which the goal's dials do not decide.
  auto others = std::int64_t(visible);
  for (const Tier& tier : goal.tiers)
    for (const TypeDial& dial : tier.dials)
      for (const Candidate& candidate : dial.candidates) others -= bits.isShown(candidate.thing);
  Count next = stayingFor(goal, std::int64_t(wanted) - others);
  bool isUp = visible < wanted;
  if (next == now || (next > now) != isUp)
    next = isUp ? std::min(goal.all, now + (wanted - visible)) : now - std::min(now, visible - wanted);
  if (!isAlone(goal)) return next;
  // Between what showed too few and too many.
  auto& bound = isUp ? goal.tooFew : goal.tooMany;
  if (!bound || (isUp ? now > *bound : now < *bound)) bound = now;
  if (goal.tooFew && goal.tooMany && *goal.tooFew < *goal.tooMany && (next <= *goal.tooFew || next >= *goal.tooMany))
    next = (*goal.tooFew + *goal.tooMany) / 2;
  return next;
}

TargetSolver::TargetSolver(const scene::Scene& scene, std::vector<int> cuts,
                           const std::vector<scene::TypeTarget>& targets, const render::SheetIndices& sheets,
                           double aspect, int mostPictures)
    : mImpl(std::make_unique<Impl>()) {
  if (!scene.model.data) throw InputError("there is no model: open one first");
  Impl& my = *mImpl;
  my.scene = scene;
  std::vector<int> enabled = enabledCuts(scene);
  std::erase_if(cuts, [&](int cut) { return std::find(enabled.begin(), enabled.end(), cut) == enabled.end(); });
  my.cuts = std::move(cuts), my.sheets = sheets, my.aspect = aspect, my.mostPictures = mostPictures;
  for (const scene::TypeTarget& target : targets)
    if (target.rendered || target.visible) my.addGoal(scene, target);
  // Targets further down first: theirs are not among those that the targets above move.
  std::vector<std::size_t> places(my.goals.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = i;
  std::stable_sort(places.begin(), places.end(), [&](auto a, auto b) {
    auto depth = [&](std::size_t i) {
      const std::string& path = my.goals[i].place.path;
      return std::count(path.begin(), path.end(), '.') + (my.goals[i].place.isCompartment ? 0 : 1);
    };
    return depth(a) > depth(b);
  });
  std::vector<Goal> sorted;
  my.order.resize(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    my.order[places[i]] = i, sorted.push_back(std::move(my.goals[places[i]]));
  my.goals = std::move(sorted);
  my.share();
  // The first picture has all that can be had of what is to show: it tells most.
  for (Goal& goal : my.goals) {
    if (goal.rendered || !goal.visible) continue;
    if (isCleared(scene, my.cuts, goal.own)) goal.field = DialField::ViewShare;
    my.makeTiers(goal);
    if (goal.all == 0 && goal.field == DialField::ViewShare) {
      goal.field = DialField::Share;
      my.makeTiers(goal);
    }
    goal.staying = goal.all;
  }
  my.turn();
  my.tried.insert(my.state());
  my.isDone = !my.looksAtPictures();
  if (!my.isDone) return;
  std::vector<Reached> reached;
  for (const Goal& goal : my.goals)
    reached.push_back({countRendered(my.scene, goal.place.types, sheets, aspect), std::nullopt});
  my.keepIfBest(reached);
}

TargetSolver::~TargetSolver() = default;
TargetSolver::TargetSolver(TargetSolver&&) noexcept = default;
TargetSolver& TargetSolver::operator=(TargetSolver&&) noexcept = default;

const scene::Scene* TargetSolver::next() const { return mImpl->isDone ? nullptr : &mImpl->scene; }

void TargetSolver::take(const render::InstanceBits& bits) {
  Impl& my = *mImpl;
  std::vector<Reached> reached = my.reached(bits);
  ++my.best.pictures;
  if (my.keepIfBest(reached)) my.lastBetter = my.best.pictures;
  // What was not better for so long will not be.
  constexpr int kPatience = 8;
  my.isDone =
      my.best.residual == 0 || my.best.pictures >= my.mostPictures || my.best.pictures - my.lastBetter >= kPatience;
  if (my.isDone) return;
  for (std::size_t i = 0; i < my.goals.size(); ++i)
    if (reached[i].visible && my.leaveView(my.goals[i], *reached[i].visible, bits)) my.tried.clear();
  my.learn(bits);
  for (std::size_t i = 0; i < my.goals.size(); ++i)
    if (Goal& goal = my.goals[i]; goal.visible && !goal.rendered)
      goal.staying = my.stepOf(goal, *reached[i].visible, bits);
  // Where all have been before, those that are off go on by one.
  bool isNew = my.tried.insert(my.state()).second;
  for (std::size_t i = 0; i < my.goals.size() && !isNew; ++i) {
    Goal& goal = my.goals[i];
    if (!goal.visible || goal.rendered || *reached[i].visible == *goal.visible) continue;
    if (*reached[i].visible < *goal.visible && goal.staying < goal.all) ++goal.staying;
    if (*reached[i].visible > *goal.visible && goal.staying > 0) --goal.staying;
    isNew = my.tried.insert(my.state()).second;
  }
  my.isDone = !isNew;
  if (isNew) my.turn();
}

std::string TargetSolver::Impl::wordsOf(const Goal& goal, const TargetReport& report) const {
  std::string name = nameAt(scene, goal.place.path);
  std::string words;
  auto add = [&](const std::string& more) { words += (words.empty() ? "" : "; ") + more; };
  if (goal.rendered) {
    std::string drawn = fmt::format("{} of {} {} drawn", countText(report.rendered), countText(report.total), name);
    if (report.rendered < *goal.rendered && report.rendered == report.total)
      drawn += fmt::format(", not {}: there are no more", countText(*goal.rendered));
    else if (report.rendered < *goal.rendered)
      drawn += fmt::format(", not {}: {}", countText(*goal.rendered),
                           cuts.empty() ? "no cut is on whose share could be set" : "other cuts take the rest");
    if (report.rendered > *goal.rendered)
      drawn += fmt::format(", not {}: {}", countText(*goal.rendered),
                           cuts.empty() ? "no cut is on whose share could be set" : "these lie outside of the cuts");
    add(drawn);
  }
  if (goal.visible && report.visible) {
    std::string seen = fmt::format("{} of {} {} seen", countText(*report.visible), countText(report.total), name);
    Count least = leastOf(goal);
    if (goal.rendered && *report.visible != *goal.visible)
      seen += fmt::format(", not {}, as so many are drawn", countText(*goal.visible));
    else if (*report.visible < *goal.visible && report.rendered == report.total)
      seen += fmt::format(", not {}: all are drawn, and {} are behind others or outside the picture",
                          countText(*goal.visible), countText(report.rendered - *report.visible));
    else if (*report.visible < *goal.visible && report.rendered >= mostOf(goal))
      seen += fmt::format(", not {}: all {} that can be drawn are, and {} are behind others or outside the picture",
                          countText(*goal.visible), countText(report.rendered),
                          countText(report.rendered - *report.visible));
    else if (*report.visible > *goal.visible && report.rendered <= least)
      seen += fmt::format(", not {}: these lie outside of the cuts", countText(*goal.visible));
    else if (*report.visible != *goal.visible)
      seen += fmt::format(", the nearest to {} in {} pictures", countText(*goal.visible), best.pictures);
    add(seen);
  }
  return words;
}

TargetsReport TargetSolver::report() const {
  TargetsReport report = mImpl->best;
  report.targets.clear();
  if (mImpl->best.targets.empty()) {  // no picture has come yet
    report.scene = mImpl->scene;
    return report;
  }
  for (std::size_t place : mImpl->order) {
    TargetReport& target = report.targets.emplace_back(mImpl->best.targets[place]);
    target.words = mImpl->wordsOf(mImpl->goals[place], target);
  }
  return report;
}

TargetsReport solveTargets(const scene::Scene& scene, const std::vector<int>& cuts,
                           const std::vector<scene::TypeTarget>& targets, const CountPicture& picture,
                           const render::SheetIndices& sheets, double aspect, int mostPictures) {
  TargetSolver solver(scene, cuts, targets, sheets, aspect, mostPictures);
  while (const scene::Scene* next = solver.next()) solver.take(picture(*next));
  return solver.report();
}

TargetsReport solveTargets(const scene::Scene& scene, const std::vector<scene::TypeTarget>& targets,
                           const CountPicture& picture, const render::SheetIndices& sheets, double aspect,
                           int mostPictures) {
  scene::Scene from = scene;
  std::vector<int> cuts = enabledCuts(from);
  int added = 0;
  if (cutKinds(from, cuts).everywhere.empty()) cuts.push_back(added = addCutEverywhere(from));
  TargetsReport report = solveTargets(from, cuts, targets, picture, sheets, aspect, mostPictures);
  std::erase_if(report.scene.cuts, [added](const scene::Cut& cut) {
    return cut.id == added &&
           std::ranges::all_of(cut.model.spares, [](const auto& spare) { return spare.share == 1.0; });
  });
  return report;
}

Solved solveVisible(const scene::Scene& scene, const std::vector<int>& cuts, std::string_view path, double wanted,
                    const CountPicture& picture, const render::SheetIndices& sheets, double aspect) {
  if (!scene.model.data) throw InputError("there is no model: open one first");
  std::string whole = typesAt(*scene.model.data, path).path;
  std::vector<scene::TypeTarget> targets{{whole, std::nullopt, wanted}};
  for (const std::string& held : heldWithin(scene, whole)) {
    TypeNumbers types = typesAt(*scene.model.data, held).types;
    targets.push_back({held, double(countRendered(scene, types, sheets, aspect)), std::nullopt});
  }
  TargetsReport report = cuts.empty() ? solveTargets(scene, targets, picture, sheets, aspect, kMostPicturesOfOne)
                                      : solveTargets(scene, cuts, targets, picture, sheets, aspect, kMostPicturesOfOne);
  const TargetReport& of = report.targets.front();
  return {std::move(report.scene), cuts, *of.wantedVisible, *of.visible, of.words};
}

int addCutEverywhere(scene::Scene& scene) {
  scene::Cut cut = makeCut(scene, scene::CutShape::Everywhere);
  cut.name = newCutName(scene, scene::CutShape::Everywhere);
  return scene::addCut(scene, std::move(cut));
}

}  // namespace velum::session
