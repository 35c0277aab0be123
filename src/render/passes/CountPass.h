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

/// Finds what became of the instances of a frame and reads the result back to the processor ([VE] 3), where callers
/// count. Cost: a look at each pixel, and three bits read back for each instance. GL thread.
class CountPass : public Pass {
 public:
  CountPass(const Gbuffer& gbuffer, ModelPass& model, StatePass& states)
      : Pass("Counts"), mGbuffer(gbuffer), mModel(model), mStates(states) {}
  void prepare(FrameData&) override {}
  /// Must come after the steps that draw the pixels of the first sample.
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;

  /// The newest bits that have arrived. @param waits  waits for bits that are on their way
  std::optional<InstanceBits> take(bool waits);

 private:
  const Gbuffer& mGbuffer;
  ModelPass& mModel;
  StatePass& mStates;
  gpu::Readback<std::uint32_t> mReadback{"states of instances"};
  std::uint64_t mCount = 0;  ///< Number of instances in the bits asked for last.
  /// Sizes of the pictures whose bits were asked for last, the newest at the end.
  std::vector<glm::ivec2> mPictureSizes;
};

}  // namespace velum::render
