#pragma once
#include "gpu/Buffer.h"
#include "gpu/Program.h"
#include "gpu/Texture.h"
#include "model/InstanceTarget.h"
#include "render/FrameData.h"
#include "render/passes/InstanceDraw.h"
#include "render/passes/SurfacePass.h"
#include "shared/instance.h"

namespace velum::render {

/// Colour, light and ids of the instances that a target has found, for rays to stop at. GL thread.
class InstanceShading {
 public:
  /// @param surfaces  into whose target they are drawn
  explicit InstanceShading(const SurfacePass& surfaces) : mSurfaces(surfaces) {}
  void compile();
  bool isReady() const { return mOpenness.isReady() && mShade.isReady(); }

  /// Who is nearest to the eye, and how far the light comes.
  struct Views {
    const model::InstanceTarget& eye;
    const model::InstanceTarget* light;  ///< nullptr: nothing throws shadows
    float lightTexel;                    ///< length of one of its pixels
  };
  /// @param draw  whose pass the steps are of
  void addSteps(const FrameData& data, int sample, Views views, InstanceDraw& draw, WorkQueue& queue);

 private:
  void addStrips(const gpu::Program& program, glm::ivec2 size, bool isSoftware, Views views, InstanceDraw& draw,
                 WorkQueue& queue);
  void bind(const Views& views) const;

  const SurfacePass& mSurfaces;
  gpu::Program mOpenness, mShade;
  gpu::Texture mOpen;  ///< Openness, light and depth at one pixel of a few.
  gpu::UniformBuffer<shared::InstanceShade> mParams{"shade of instances"};
};

}  // namespace velum::render
