#pragma once
#include "core/Image.h"
#include "gpu/Program.h"
#include "gpu/Texture.h"
#include "model/InstanceTarget.h"
#include "render/FrameData.h"
#include "render/Gbuffer.h"
#include "render/passes/InstanceDraw.h"
#include "render/passes/ModelPass.h"
#include "render/passes/Pass.h"

namespace velum::render {

/// Ghosts of the instances that cuts have removed ([VE] 8.3): drawn like other instances into a target of their own,
/// left out where the picture is nearer, and summed over the samples. ResolvePass lays them over the picture. Costs
/// nothing where there are none. GL thread.
class GhostPass : public Pass {
 public:
  /// @param draw  draws instances into targets; the ghosts are found in steps of its pass
  GhostPass(const Gbuffer& gbuffer, ModelPass& model, InstanceDraw& draw)
      : Pass("Ghosts"), mGbuffer(gbuffer), mModel(model), mDraw(draw) {}
  void prepare(FrameData& data) override;
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;
  /// Begins the next picture: nothing of it is there yet.
  void restart() { mSamples = 0; }

  /// The programs of another one, see FrameWork::takePrograms().
  void takePrograms(GhostPass& other) { std::swap(mShade, other.mShade); }

  /// How many samples are in the sums; 0: there are no ghosts.
  int samples() const { return mSamples; }
  /// Binds the sums: kGhostUnit.
  void bindResults() const { mSums.bindSampler(shared::kGhostUnit); }
  /// Appends "ghosts.R/G/B/A" to an image of the window, straight alpha. Waits for the GPU.
  void appendLayer(Image& image) const;

 private:
  void shade(const FrameData& data);

  const Gbuffer& mGbuffer;
  ModelPass& mModel;
  InstanceDraw& mDraw;
  model::InstanceTarget mTarget{"ghosts of instances", true};
  gpu::Program mShade;
  gpu::Texture mSums;  ///< Premultiplied.
  bool mIsOn = false;
  int mSamples = 0;
};

}  // namespace velum::render
