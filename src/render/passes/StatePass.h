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

/// What becomes of each instance, where a frame asks (ModelPass::hasStates()): by cuts, then as it hides what one of
/// them keeps in view. Does not depend on where in a pixel its ray goes: once a frame.
class StatePass : public Pass {
 public:
  explicit StatePass(ModelPass& model) : Pass("States"), mModel(model) {}
  void prepare(FrameData& data) override;
  /// For the first sample only. They are named by what is done, as each takes its own time.
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;

  model::InstanceStates& states() { return mStates; }
  const model::InstanceStates& states() const { return mStates; }

 private:
  void addFocus(const FrameData& data, const model::FocusRow& row, WorkQueue& queue);
  /// Looks at instances, a part a step. @param name  a literal
  template <class Look>
  void addLooks(const char* name, const std::vector<model::InstancePart>& parts, Look look, WorkQueue& queue);

  ModelPass& mModel;
  model::InstanceStates mStates;
  gpu::UniformBuffer<shared::InstanceView> mView{"view of states"};
};

}  // namespace velum::render
