#include "velum/session/growth/GrowthPlayer.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "velum/core/Clock.h"
#include "velum/extrusion/GrowDomain.h"
#include "velum/extrusion/Grower.h"
#include "velum/extrusion/LabelsFor.h"

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
  std::int64_t voxels = 0;  ///< of the last step
  std::optional<Leak> leak;
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

/// Beyond this depth nothing of the volume lies.
double deepest(const Volume& volume, const scene::Growth& step) {
  extrusion::GrowDomain domain(volume, step.centre, step.axis, step.distance);
  return domain.isEverywhere() ? scene::Growth::kEndless : domain.depthRange({0, 0, 0}, volume.dims - 1).y;
}

}  // namespace

struct GrowthPlayer::State {
  Shared<Volume> volume;
  Shared<LabelVolume> given;
  Steps wanted, goal;  ///< of the scene; of the work
  Progressed now;
  std::set<int> trusted;
  std::string error;
  bool isWorking = false, isObsolete = false, hasNews = false;
  extrusion::Grower grower;  ///< Of the work, while there is one.

  void restart() { now = {volume ? extrusion::labelsFor(*volume, given) : given, {}, 0, now.leak}; }
  Progressed growSome(const Shared<Volume>& of, Progressed from, const Steps& all, const std::set<int>& unguarded,
                      Progress& progress);
};

/// Goes on for about kWorkMs.
Progressed GrowthPlayer::State::growSome(const Shared<Volume>& of, Progressed from, const Steps& all,
                                         const std::set<int>& unguarded, Progress& progress) {
  auto start = Clock::now();
  double slabs = kFirstSlabs;
  while (from.steps != all && msSince(start) < kWorkMs) {
    bool isNew = from.steps.empty() || from.steps.back() == all[from.steps.size() - 1];
    const scene::Growth& step = all[from.steps.size() - (isNew ? 0 : 1)];
    double reached = isNew ? 0.0 : from.steps.back().distance;
    scene::Growth part = step;
    double next = reached + slabs * extrusion::slabThickness(*of);
    if (next < std::min(step.distance, deepest(*of, step))) part.distance = next;
    auto partStart = Clock::now();
    extrusion::Grown grown = grower.grow(of, from.labels, part, {.guard = !unguarded.count(step.structure)}, progress);
    if (msSince(partStart) < kQuickMs) slabs *= 2.0;
    from.labels = grown.labels;
    from.voxels = (isNew ? 0 : from.voxels) + std::int64_t(grown.voxels);
    if (isNew) from.steps.push_back(part);
    from.steps.back().distance = part.distance;
    if (!grown.leak) continue;
    from.steps.back().distance = std::max(reached, grown.distance);
    from.leak =
        Leak{step.structure, from.steps.back().distance, grown.leak->area / std::max(grown.leak->widestBefore, 1e-12)};
    break;
  }
  return from;
}

GrowthPlayer::GrowthPlayer() : mState(std::make_unique<State>()) {}
GrowthPlayer::~GrowthPlayer() = default;

bool GrowthPlayer::isDue() const {
  const State& s = *mState;
  return s.volume && s.error.empty() && s.now.steps != s.wanted;
}

void GrowthPlayer::follow(const scene::Scene& scene) {
  State& s = *mState;
  const auto& labels = scene.labels;
  bool isSameData = s.volume == scene.volume.data && (s.given == labels.given || labels.growths.empty());
  if (isSameData && s.wanted == labels.growths) return;
  if (s.wanted != labels.growths) s.error.clear();
  s.wanted = labels.growths;
  s.volume = scene.volume.data;
  if (!s.wanted.empty()) s.given = labels.given;
  // What the scene holds already is as good as what is here: it may have been read, or come back by undo.
  if (labels.grown == labels.growths && !labels.growths.empty()) {
    if (s.now.labels != labels.data) s.now = {labels.data, labels.grown, 0, {}};
    s.now.steps = labels.grown;
    s.hasNews = false;
    s.isObsolete = s.isWorking;
    return;
  }
  if (isSameData && isOnTheWay(s.now.steps, s.wanted)) {
    // But the work may go too far.
    s.isObsolete = s.isWorking && (s.isObsolete || !isOnTheWay(s.goal, s.wanted));
    return;
  }
  s.isObsolete = s.isWorking;
  s.now.leak.reset();
  s.restart();
  // Without any steps the labels are what was given.
  s.hasNews = s.wanted.empty() && !labels.grown.empty();
}

Player::Work GrowthPlayer::nextWork() {
  State& s = *mState;
  if (s.isWorking || s.hasNews || !isDue()) return {};
  s.isWorking = true;
  s.isObsolete = false;
  s.goal = s.wanted;
  if (!s.now.labels) s.restart();
  return [this, volume = s.volume, from = s.now, all = s.wanted, trusted = s.trusted](Progress& progress) -> Finish {
    Progressed to = mState->growSome(volume, from, all, trusted, progress);
    return [this, to = std::move(to)] {
      if (mState->isObsolete) return;
      mState->now = to;
      mState->hasNews = true;
    };
  };
}

bool GrowthPlayer::wantsCancel() const { return mState->isObsolete; }

void GrowthPlayer::endWork(const Finish& finish, const std::string& error) {
  State& s = *mState;
  s.isWorking = false;
  if (finish)
    finish();
  else if (!error.empty() && !s.isObsolete)
    s.error = error;
  s.isObsolete = false;
}

bool GrowthPlayer::hasRests() const { return mState->hasNews; }

void GrowthPlayer::complete(scene::Scene& scene) {
  State& s = *mState;
  s.hasNews = false;
  auto& labels = scene.labels;
  labels.data = s.wanted.empty() ? s.given : s.now.labels;
  labels.grown = s.now.steps;
  scene::completeStructures(labels);
  if (s.now.leak && !s.now.steps.empty() && s.now.steps.back().structure == s.now.leak->structure)
    holdGrowth(scene, *s.now.leak);
}

GrowthStatus GrowthPlayer::status() const {
  const State& s = *mState;
  int structure = s.now.steps.empty() ? 0 : s.now.steps.back().structure;
  return {isDue(), structure, s.now.voxels, s.now.leak, s.error};
}

std::optional<Leak> GrowthPlayer::stop() const {
  const State& s = *mState;
  if (!isDue()) return std::nullopt;
  if (s.now.steps.empty()) return Leak{s.wanted.back().structure, 0.0, 0.0};
  return Leak{s.now.steps.back().structure, s.now.steps.back().distance, 0.0};
}

void GrowthPlayer::acceptLeak() { mState->now.leak.reset(); }

void GrowthPlayer::trust(int structure) {
  mState->trusted.insert(structure);
  mState->now.leak.reset();
}

}  // namespace velum::session
