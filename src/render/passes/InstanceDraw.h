#pragma once
#include <array>
#include <cstdint>
#include <utility>

#include "model/InstanceStates.h"
#include "model/InstanceTarget.h"
#include "render/WorkQueue.h"
#include "render/passes/DrawPace.h"
#include "render/passes/ModelPass.h"
#include "render/passes/Pass.h"

namespace velum::render {

/// Draws instances into targets, in steps of a pass: finds which copies, bundles and instances may show, and draws them
/// list by list. Software drivers get the lists piece by piece and are asked how much there is to do; other drivers are
/// not waited for, and start groups that find nothing to do. GL thread.
class InstanceDraw {
 public:
  using Phase = model::CullPhase;
  /// @param pass  the pass that the steps belong to: it must forward its took() to this object
  InstanceDraw(Pass& pass, ModelPass& model, const model::InstanceStates& states)
      : mPass(pass), mModel(model), mStates(states) {}
  /// Whether copies that a view has as wholes are drawn: none of them is a ghost.
  static bool hasWholes(const shared::InstanceView& view, model::CullBy by);
  /// To be called before any step of a frame is added.
  void restart() { mPace.restart(); }
  void took(double ms) { mPace.took(ms); }

  /// Adds work of the pass that draws nothing.
  void add(WorkQueue& queue, WorkQueue::Run run);
  /// Adds steps that draw the depths of instances as a view sees them: of what was seen before, then of what these do
  /// not hide.
  void addDepths(model::InstanceTarget& target, const shared::InstanceView& view, model::CullBy by, WorkQueue& queue);
  /// Adds steps that find which instance is in each pixel, when all depths are drawn.
  /// @param hasWholes  copies were drawn as wholes, see hasWholes()
  void addOwners(model::InstanceTarget& target, bool hasWholes, WorkQueue& queue);

 private:
  void addWholeRound(model::InstanceTarget& target, model::CullBy by, std::pair<int, int> blocks, WorkQueue& queue);
  model::InstanceTarget::Draws drawsOf(Phase phase) const;
  void addRound(model::InstanceTarget& target, model::CullBy by, std::pair<int, int> copies, WorkQueue& queue);
  void addPhase(model::InstanceTarget& target, model::CullBy by, Phase phase, WorkQueue& queue);
  void addPyramid(model::InstanceTarget& target, WorkQueue& queue);
  bool listNext(model::InstanceTarget& target, int copies);
  bool drawNext(model::InstanceTarget& target, model::CullBy by, Phase phase);
  void cullNext(model::InstanceTarget& target, model::CullBy by, Phase phase);

  Pass& mPass;
  ModelPass& mModel;
  const model::InstanceStates& mStates;
  DrawPace mPace;
  /// How far a round has come: copies whose bundles are listed.
  struct Round {
    int copies = -1;  ///< That are listed, or blocks; below 0: not known yet.
    int next = 0;
  } mRound;
  /// How far a phase has come. Items are what InstanceTarget::itemsOf() counts.
  struct Place {
    std::uint32_t items = 0, culled = 0, listEnd = 0;
    bool isKnown = false;   ///< `items` are.
    bool isListed = false;  ///< The list is complete, and is being drawn.
    std::array<std::uint32_t, 4> groups{};
    int kind = 0;  ///< Of draws.
    std::uint32_t next = 0;
  } mPlace;
};

}  // namespace velum::render
