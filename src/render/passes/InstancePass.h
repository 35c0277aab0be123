#pragma once
#include <cstdint>

#include "model/InstanceTarget.h"
#include "render/FrameData.h"
#include "render/passes/InstanceDraw.h"
#include "render/passes/InstanceShading.h"
#include "render/passes/ModelPass.h"
#include "render/passes/Pass.h"
#include "render/passes/StatePass.h"
#include "render/passes/SurfacePass.h"

namespace velum::render {

/// Draws the instances of a model, at which rays stop: finds the nearest instance in each pixel
/// (model::InstanceTarget), then draws its colour, light and ids into the surfaces' target. Every instance is tested
/// against the cuts in every sample of every frame. Only the set of instances seen last is kept, and it changes no
/// picture.
class InstancePass : public Pass {
 public:
  InstancePass(ModelPass& model, const StatePass& states, const SurfacePass& surfaces)
      : Pass("Instances"), mModel(model), mDraw(*this, model, states.states()), mShading(surfaces) {}
  void prepare(FrameData& data) override;
  void compile(const FrameData& data) override;
  bool isReady() override { return !mModel.isDrawn() || mShading.isReady(); }
  void addSteps(const FrameData& data, int sample, WorkQueue& queue) override;
  void took(double ms) override { mDraw.took(ms); }

  /// The programs of another one, see FrameWork::takePrograms().
  void takePrograms(InstancePass& other) { mShading.takePrograms(other.mShading); }
  /// For other passes that draw instances: their draws are steps of this pass.
  InstanceDraw& draw() { return mDraw; }

 private:
  void addLight(const shared::InstanceView& view, WorkQueue& queue);

  ModelPass& mModel;
  InstanceDraw mDraw;
  InstanceShading mShading;
  std::uint64_t mSeenOf = 0;  ///< The model whose instances were seen last.
  model::InstanceTarget mEye{"eye's view of instances", true}, mLight{"light's view of instances", false};
  float mLightTexel = 0.0f;  ///< Length of a pixel of the light's view.
};

}  // namespace velum::render
