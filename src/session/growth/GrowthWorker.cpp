#include "session/growth/GrowthWorker.h"

#include <algorithm>
#include <functional>
#include <set>

#include "growth/LabelsFor.h"
#include "session/growth/GrowInParts.h"

namespace velum::session {

struct GrowthWorker::State {
  Shared<Volume> volume;
  Shared<LabelVolume> given;
  Goal wanted, goal;  ///< of the scene; of the work
  Progressed now;
  std::set<int> trusted, typed;  ///< structures that may leak; whose values somebody has changed
  std::string error;
  bool isWorking = false, isObsolete = false, hasNews = false;
  GrowInParts grower;  ///< Of the work, while there is one.

  void restart() {
    now.steps.clear();
    now.take(volume ? growth::labelsFor(*volume, given) : given);
  }
  std::function<Watch(int)> watches() const;
  void forgetWhatIsGone(const Steps& next);
};

/// How each structure is watched, as it is now: a copy for a thread that goes on beside.
std::function<Watch(int)> GrowthWorker::State::watches() const {
  return [trusted = trusted, typed = typed](int structure) {
    return trusted.count(structure) ? Watch::Not : typed.count(structure) ? Watch::Jumps : Watch::All;
  };
}

/// To be called before `wanted` changes. Somebody who changes the values of a structure means what he types, and ids of
/// structures that are gone may come back as other structures.
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
    Progressed to = mState->grower.growSome(volume, given, from, goal, watch, progress);
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
