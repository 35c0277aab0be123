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

/// Draws instances into targets, in steps of a pass: culls instances, some at a time, and draws the resulting lists,
/// which software drivers get piece by piece. GL thread.
class InstanceDraw {
 public:
  using Phase = model::CullPhase;
  /// @param pass  the pass that the steps belong to: it must forward its took() to this object
  InstanceDraw(Pass& pass, ModelPass& model, const model::InstanceStates& states)
      : mPass(pass), mModel(model), mStates(states) {}
  /// To be called before any step of a frame is added.
  void restart() { mPace.restart(); }
  void took(double ms) { mPace.took(ms); }

  /// Adds work of the pass that draws nothing.
  void add(WorkQueue& queue, WorkQueue::Run run);
  /// Adds steps that find which instances are drawn in a phase, and at which level of detail.
  void addCull(model::InstanceTarget& target, model::CullBy by, Phase phase, WorkQueue& queue);
  /// Adds steps that draw the depths of a phase's instances or, when all depths are known, which instance is in each
  /// pixel.
  void addDraws(model::InstanceTarget& target, Phase phase, bool owners, WorkQueue& queue);
  void addPyramid(model::InstanceTarget& target, WorkQueue& queue);

 private:
  bool drawNext(model::InstanceTarget& target, Phase phase, bool owners);

  Pass& mPass;
  ModelPass& mModel;
  const model::InstanceStates& mStates;
  DrawPace mPace;
  /// How far drawing in pieces has come.
  struct Place {
    std::array<std::uint32_t, 4> groups{};
    int list = 0;
    std::uint32_t next = 0;
    bool isKnown = false;
  } mPlace;
};

}  // namespace velum::render
