#pragma once
#include <vector>

#include "gpu/Buffer.h"
#include "model/InstanceStates.h"
#include "render/FrameData.h"
#include "render/passes/ModelPass.h"
#include "render/passes/Pass.h"
#include "shared/instance.h"

namespace velum::model {
struct FocusRow;
}

namespace velum::render {

/// Finds what becomes of each instance, where a frame needs that (ModelPass::hasStates()): first by the cuts, then
/// whether the instance hides something that a cut keeps in view. The result is the same for all samples of a pixel, so
/// this is done once a frame.
class StatePass : public Pass {
 public:
  explicit StatePass(ModelPass& model) : Pass("States"), mModel(model) {}
  void prepare(FrameData& data) override;
  /// Adds steps for the first sample only. The steps have names of their own, as their times differ.
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;

  model::InstanceStates& states() { return mStates; }
  const model::InstanceStates& states() const { return mStates; }

 private:
  void addFocus(const FrameData& data, const model::FocusRow& row, WorkQueue& queue);
  /// Adds steps that look at instances, one part a step. @param name  a string literal
  template <class Look>
  void addLooks(const char* name, const std::vector<model::InstancePart>& parts, Look look, WorkQueue& queue);

  ModelPass& mModel;
  model::InstanceStates mStates;
  gpu::UniformBuffer<shared::InstanceView> mView{"view of states"};
};

}  // namespace velum::render
