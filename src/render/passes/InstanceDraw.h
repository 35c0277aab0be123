#pragma once
#include <array>
#include <cstdint>

#include "model/InstanceStates.h"
#include "model/InstanceTarget.h"
#include "render/WorkQueue.h"
#include "render/passes/DrawPace.h"
#include "render/passes/ModelPass.h"
#include "render/passes/Pass.h"

namespace velum::render {

/// Draws instances into targets, in steps of a pass: culls them, some at a time, and draws the lists that come of it,
/// of which software drivers are handed piece by piece. GL thread.
class InstanceDraw {
 public:
  using Phase = model::CullPhase;
  /// @param pass  whose steps they are: it hands on what they took
  InstanceDraw(Pass& pass, ModelPass& model, const model::InstanceStates& states)
      : mPass(pass), mModel(model), mStates(states) {}
  /// Before any step of a frame is added.
  void restart() { mPace.restart(); }
  void took(double ms) { mPace.took(ms); }

  /// Work of the pass that is no draw.
  void add(WorkQueue& queue, WorkQueue::Run run);
  /// Which instances are drawn in a phase, and how finely.
  void addCull(model::InstanceTarget& target, model::CullBy by, Phase phase, WorkQueue& queue);
  /// Depths of what is drawn in a phase; or who is in each pixel, when all depths are known.
  void addDraws(model::InstanceTarget& target, Phase phase, bool owners, WorkQueue& queue);
  void addPyramid(model::InstanceTarget& target, WorkQueue& queue);

 private:
  bool drawNext(model::InstanceTarget& target, Phase phase, bool owners);

  Pass& mPass;
  ModelPass& mModel;
  const model::InstanceStates& mStates;
  DrawPace mPace;
  /// Where drawing in pieces is.
  struct Place {
    std::array<std::uint32_t, 4> groups{};
    int list = 0;
    std::uint32_t next = 0;
    bool isKnown = false;
  } mPlace;
};

}  // namespace velum::render
