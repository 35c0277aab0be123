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

/// Draws colour, light and ids of the instances that a target has found; rays stop at them. GL thread.
class InstanceShading {
 public:
  /// @param surfaces  the pass into whose target the instances are drawn
  explicit InstanceShading(const SurfacePass& surfaces) : mSurfaces(surfaces) {}
  void compile();
  bool isReady() const { return mOpenness.isReady() && mShade.isReady(); }

  /// The programs of another one, see FrameWork::takePrograms().
  void takePrograms(InstanceShading& other) {
    std::swap(mOpenness, other.mOpenness);
    std::swap(mShade, other.mShade);
  }

  /// The eye's view, with the nearest instances, and the light's view, with how far the light comes.
  struct Views {
    const model::InstanceTarget& eye;
    const model::InstanceTarget* light;  ///< nullptr: there are no shadows
    float lightTexel;                    ///< length of a pixel of the light's view
  };
  /// @param draw  draws instances; the steps belong to its pass
  void addSteps(const FrameData& data, int sample, Views views, InstanceDraw& draw, WorkQueue& queue);

 private:
  void addStrips(const gpu::Program& program, glm::ivec4 rect, bool isSoftware, Views views, InstanceDraw& draw,
                 WorkQueue& queue);
  void bind(const Views& views) const;

  const SurfacePass& mSurfaces;
  gpu::Program mOpenness, mShade;
  gpu::Texture mOpen;  ///< Openness, light and depth at one pixel of a few.
  gpu::UniformBuffer<shared::InstanceShade> mParams{"shade of instances"};
};

}  // namespace velum::render
