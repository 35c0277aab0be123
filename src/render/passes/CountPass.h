#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "gpu/Readback.h"
#include "render/Counts.h"
#include "render/FrameData.h"
#include "render/Gbuffer.h"
#include "render/passes/ModelPass.h"
#include "render/passes/Pass.h"
#include "render/passes/StatePass.h"

namespace velum::render {

/// What became of the instances of a frame, on its way to the processor ([VE] 3). Limited by a look at each pixel and
/// by three bits an instance that are read back; whoever counts does so there. GL thread.
class CountPass : public Pass {
 public:
  CountPass(const Gbuffer& gbuffer, ModelPass& model, StatePass& states)
      : Pass("Counts"), mGbuffer(gbuffer), mModel(model), mStates(states) {}
  void prepare(FrameData&) override {}
  /// After the pixels of the first sample are known.
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;

  /// The newest that have arrived. @param waits  for those that are on their way
  std::optional<InstanceBits> take(bool waits);

 private:
  const Gbuffer& mGbuffer;
  ModelPass& mModel;
  StatePass& mStates;
  gpu::Readback<std::uint32_t> mReadback{"states of instances"};
  std::uint64_t mCount = 0;               ///< Instances that the last bits are of.
  std::vector<glm::ivec2> mPictureSizes;  ///< Of the pictures that bits were last asked of, the newest last.
};

}  // namespace velum::render
