#include "session/growth/GrowthWorker.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "core/Clock.h"
#include "growth/FirstDoubt.h"
#include "growth/GrowDomain.h"
#include "growth/GrowOverTime.h"
#include "growth/LabelsFor.h"
#include "growth/SmoothRegion.h"

namespace velum::session {

namespace {

/// A piece of work: the front is shown as often, and Esc is heard.
constexpr double kWorkMs = 40.0;
/// Slabs that are grown at once at first; more where they are done sooner than this.
constexpr double kFirstSlabs = 2.0, kQuickMs = 8.0;

using Steps = std::vector<scene::Growth>;

/// What has been grown so far: the labels with the steps that they hold, the last of them perhaps not to its end.
struct Progressed {
  Shared<LabelVolume> labels;
  Steps steps;
  Shared<LabelVolume> rough;   ///< the same before the last step's end; nothing where that is not known
  Shared<LabelVolume> before;  ///< without the last step; nothing where that is not known
  std::int64_t voxels = 0;     ///< of the last step
  std::optional<Leak> leak;
  GrowthFigures figures;  ///< of the last step

  /// Labels that hold all steps to their ends.
  void take(const Shared<LabelVolume>& whole) {
    labels = whole;
    rough = steps.empty() || !growth::isSmoothed(steps.back()) ? whole : Shared<LabelVolume>();
    before = {};
    voxels = 0;
  }
};

/// What is wanted: steps as they are at the time step that is shown, and as they were made.
struct Goal {
  Steps steps, made;
  std::size_t carried = 0;  ///< of the first so many nothing is shown before they are done
  bool operator==(const Goal&) const = default;
  bool isCarried(std::size_t i) const { return i < carried || steps[i].timeStep != made[i].timeStep; }
};

/// True when a step is another one that has not come so far.
bool goesOn(const scene::Growth& grown, scene::Growth wanted) {
  if (!(grown.distance <= wanted.distance)) return false;
  wanted.distance = grown.distance;
  return grown == wanted;
}

/// True when what is wanted goes on where what there is has come to.
bool isOnTheWay(const Steps& grown, const Steps& wanted) {
  if (grown.size() > wanted.size()) return false;
  if (grown.empty()) return true;
  return std::equal(grown.begin(), grown.end() - 1, wanted.begin()) &&
         (grown.back() == wanted[grown.size() - 1] || goesOn(grown.back(), wanted[grown.size() - 1]));
}

bool isOnTheWay(const Progressed& now, const Steps& wanted) {
  if (!isOnTheWay(now.steps, wanted)) return false;
  // One with others begins anew from what was there before it.
  bool isAnew = !now.steps.empty() && !now.steps.back().others.empty();
  if (isAnew && !now.before && now.steps.back() != wanted[now.steps.size() - 1]) return false;
  return now.steps.empty() || isAnew || bool(now.rough) || now.steps.back() == wanted[now.steps.size() - 1];
}

/// Beyond this depth nothing of the volume lies; 0 where a step has no plane, and grows at once.
double deepest(const Volume& volume, const scene::Growth& step) {
  growth::GrowDomain domain(volume, step.centre, step.axis, step.distance);
  return domain.isEverywhere() ? 0.0 : domain.depthRange({0, 0, 0}, volume.dims - 1).y;
}

}  // namespace

struct GrowthWorker::State {
  Shared<Volume> volume;
  Shared<LabelVolume> given;
  Goal wanted, goal;  ///< of the scene; of the work
  Progressed now;
  std::set<int> trusted, typed;  ///< structures that may leak; whose values somebody has changed
  std::string error;
  bool isWorking = false, isObsolete = false, hasNews = false;
  growth::Grower grower;  ///< Of the work, while there is one.
  growth::GrowOverTime overTime;

  void restart() {
    now.steps.clear();
    now.take(volume ? growth::labelsFor(*volume, given) : given);
  }
  /// How closely a structure is watched.
  enum class Watch { Not, Jumps, All };
  std::function<Watch(int)> watches() const;
  Progressed growSome(const Shared<Volume>& of, const Shared<LabelVolume>& ground, Progressed to, const Goal& all,
                      const std::function<Watch(int)>& watch, Progress& progress);
  double growPart(const Shared<Volume>& of, Progressed& to, const scene::Growth& step, double reached, double slabs,
                  Watch watch, Progress& progress);
  void growWhole(const Shared<Volume>& of, Progressed& to, const scene::Growth& step, Progress& progress);
  void forgetWhatIsGone(const Steps& next);
};

/// Goes on for about kWorkMs.
Progressed GrowthWorker::State::growSome(const Shared<Volume>& of, const Shared<LabelVolume>& ground, Progressed to,
                                         const Goal& all, const std::function<Watch(int)>& watch, Progress& progress) {
  auto start = Clock::now();
  double slabs = kFirstSlabs;
  while (to.steps != all.steps && slabs > 0.0 && msSince(start) < kWorkMs) {
    bool isNew = to.steps.empty() || to.steps.back() == all.steps[to.steps.size() - 1];
    std::size_t place = to.steps.size() - (isNew ? 0 : 1);
    const scene::Growth& step = all.steps[place];
    double reached = isNew ? 0.0 : to.steps.back().distance;
    if (isNew) {
      to.steps.push_back(step);
      to.rough = to.before = to.labels;
      to.voxels = 0;
      to.figures = {};
    }
    if (all.isCarried(place)) {
      to.steps.back() = step;
      to.take(overTime.labelsAt(step.timeStep, place + 1, of, ground, all.made, progress));
    } else if (!step.others.empty()) {
      growWhole(of, to, step, progress);
    } else {
      slabs = growPart(of, to, step, reached, slabs, watch(step.structure), progress);
    }
  }
  return to;
}

/// As it is now, for a thread that goes on beside.
std::function<GrowthWorker::State::Watch(int)> GrowthWorker::State::watches() const {
  return [trusted = trusted, typed = typed](int structure) {
    return trusted.count(structure) ? Watch::Not : typed.count(structure) ? Watch::Jumps : Watch::All;
  };
}

/// Before what is wanted becomes something else: whose values somebody changes means what he types, and ids of
/// structures that are gone may come back as others.
void GrowthWorker::State::forgetWhatIsGone(const Steps& next) {
  auto isGone = [&](int id) {
    return std::none_of(next.begin(), next.end(), [id](const auto& step) { return step.structure == id; });
  };
  std::erase_if(trusted, isGone);
  std::erase_if(typed, isGone);
  for (const auto& step : next)
    for (const auto& before : wanted.steps)
      if (before.structure == step.structure && (before.low != step.low || before.high != step.high))
        typed.insert(step.structure);
}

/// So many slabs more of the last step. @return how many may be next; 0: none, it leaks
double GrowthWorker::State::growPart(const Shared<Volume>& of, Progressed& to, const scene::Growth& step,
                                     double reached, double slabs, Watch watch, Progress& progress) {
  scene::Growth part = step;
  // Who gives a structure more seeds has seen what it is.
  auto isOfIt = [&](const scene::Growth& other) { return other.structure == step.structure; };
  bool isAlone = std::count_if(to.steps.begin(), to.steps.end(), isOfIt) <= 1;
  bool isFirst = isAlone && watch == Watch::All && step.distance > 0.0 && reached < growth::firstSlabEnd(*of, step);
  auto hold = [&] {
    part.distance = reached;
    to.rough = grower.grow(of, to.rough, part, {.guard = false, .begun = {}}, progress).labels;
    to.labels = growth::smoothRegion(of, to.rough, part, progress).labels;
    to.steps.back() = part;
    to.leak = Leak{step.structure, reached, 0.0};
    return 0.0;
  };
  if (isFirst && reached == 0.0 && growth::reachesTheDarkest(*of, step)) return hold();
  double next = reached + slabs * growth::slabThickness(*of);
  if (next < std::min(step.distance, deepest(*of, step))) part.distance = next;
  auto start = Clock::now();
  growth::Grown grown = grower.grow(of, to.rough, part, {.guard = watch != Watch::Not, .begun = {}}, progress);
  if (isFirst && growth::isMostOfItsPlane(*of, *grown.labels, part)) return hold();
  if (msSince(start) < kQuickMs) slabs *= 2.0;
  to.figures.slabs += grown.slabs;
  to.figures.ms += grown.ms;
  if (grown.leak) {
    to.figures.leakDepth = grown.leak->depth;
    to.figures.leakArea = grown.leak->area;
    to.figures.widestBefore = grown.leak->widestBefore;
    part.distance = std::max(reached, grown.distance);
    to.leak = Leak{step.structure, part.distance, grown.leak->area / std::max(grown.leak->widestBefore, 1e-12)};
  }
  to.labels = to.rough = grown.labels;
  to.voxels += std::int64_t(grown.voxels);
  to.steps.back() = part;
  if (grown.leak || part == step) {
    growth::Smoothed smoothed = growth::smoothRegion(of, to.rough, part, progress);
    to.labels = smoothed.labels;
    to.figures.smoothed = smoothed.voxels;
  }
  return grown.leak ? 0.0 : slabs;
}

/// With others, as far as it goes: where their border lies depends on all of it.
void GrowthWorker::State::growWhole(const Shared<Volume>& of, Progressed& to, const scene::Growth& step,
                                    Progress& progress) {
  growth::Grown grown = grower.grow(of, to.before, step, {}, progress);
  growth::Smoothed smoothed = growth::smoothRegion(of, grown.labels, step, progress, grown.others);
  to.labels = smoothed.labels;
  to.figures = {.slabs = grown.slabs, .ms = grown.ms, .smoothed = smoothed.voxels};
  to.rough = grown.labels;
  to.voxels = std::int64_t(grown.voxels);
  to.steps.back() = step;
}

GrowthWorker::GrowthWorker() : mState(std::make_unique<State>()) {}
GrowthWorker::~GrowthWorker() = default;

bool GrowthWorker::isDue() const {
  const State& s = *mState;
  return s.volume && s.error.empty() && s.now.steps != s.wanted.steps;
}

void GrowthWorker::follow(const scene::Scene& scene) {
  State& s = *mState;
  const auto& labels = scene.labels;
  bool isSameData = s.volume == scene.volume.data && (s.given == labels.given || labels.growths.empty());
  Goal wanted{growthsNow(scene), labels.growths, s.wanted.carried};
  if (isSameData && s.wanted == wanted) return;
  if (s.wanted.steps != wanted.steps) s.error.clear();
  bool isOtherTime = isSameData && !wanted.steps.empty() && !s.wanted.steps.empty() &&
                     wanted.steps.front().timeStep != s.wanted.steps.front().timeStep;
  if (isOtherTime) wanted.carried = wanted.steps.size();
  s.forgetWhatIsGone(wanted.steps);
  s.wanted = wanted;
  s.volume = scene.volume.data;
  if (!s.wanted.steps.empty()) s.given = labels.given;
  // What the scene holds already is as good as what is here: it may have been read, or come back by undo.
  if (labels.grown == s.wanted.steps && !labels.growths.empty()) {
    s.wanted.carried = 0;
    s.now.steps = labels.grown;
    if (s.now.labels != labels.data) {
      s.now.leak.reset();
      s.now.take(labels.data);
    }
    s.hasNews = false;
    s.isObsolete = s.isWorking;
    return;
  }
  if (isSameData && isOnTheWay(s.now, s.wanted.steps)) {
    // But the work may go too far.
    s.isObsolete = s.isWorking && (s.isObsolete || !isOnTheWay(s.goal.steps, s.wanted.steps));
    return;
  }
  s.isObsolete = s.isWorking;
  s.now.leak.reset();
  s.restart();
  // Without any steps the labels are what was given.
  s.hasNews = s.wanted.steps.empty() && !labels.grown.empty();
}

Worker::Work GrowthWorker::nextWork() {
  State& s = *mState;
  if (s.isWorking || s.hasNews || !isDue()) return {};
  s.isWorking = true;
  s.isObsolete = false;
  s.goal = s.wanted;
  if (!s.now.labels) s.restart();
  return [this, volume = s.volume, given = s.given, from = s.now, goal = s.wanted,
          watch = s.watches()](Progress& progress) -> Finish {
    Progressed to = mState->growSome(volume, given, from, goal, watch, progress);
    return [this, to = std::move(to)] {
      State& now = *mState;
      if (now.isObsolete) return;
      now.now = to;
      now.hasNews = to.steps.size() >= std::min(now.wanted.carried, now.wanted.steps.size());
      if (now.hasNews) now.wanted.carried = 0;
    };
  };
}

bool GrowthWorker::wantsCancel() const { return mState->isObsolete; }

void GrowthWorker::endWork(const Finish& finish, const std::string& error) {
  State& s = *mState;
  s.isWorking = false;
  if (finish)
    finish();
  else if (!error.empty() && !s.isObsolete)
    s.error = error;
  s.isObsolete = false;
}

bool GrowthWorker::hasRests() const { return mState->hasNews; }

void GrowthWorker::complete(scene::Scene& scene) {
  State& s = *mState;
  s.hasNews = false;
  auto& labels = scene.labels;
  labels.data = s.wanted.steps.empty() ? s.given : s.now.labels;
  labels.grown = s.now.steps;
  scene::completeStructures(labels);
  if (s.now.leak && !s.now.steps.empty() && s.now.steps.back().structure == s.now.leak->structure)
    holdGrowth(scene, *s.now.leak);
}

GrowthStatus GrowthWorker::status() const {
  const State& s = *mState;
  int structure = s.now.steps.empty() ? 0 : s.now.steps.back().structure;
  return {isDue(), structure, s.now.voxels, s.now.leak, s.error, s.now.figures};
}

std::optional<Leak> GrowthWorker::stop() const {
  const State& s = *mState;
  if (!isDue()) return std::nullopt;
  if (s.now.steps.empty()) return Leak{s.wanted.steps.back().structure, 0.0, 0.0};
  return Leak{s.now.steps.back().structure, s.now.steps.back().distance, 0.0};
}

void GrowthWorker::acceptLeak() { mState->now.leak.reset(); }

void GrowthWorker::takeTypedRange(int structure) { mState->typed.insert(structure); }

void GrowthWorker::trust(int structure) {
  mState->trusted.insert(structure);
  mState->now.leak.reset();
}

}  // namespace velum::session
