#include "render/passes/InstancePass.h"

#include <algorithm>
#include <utility>

#include "render/passes/InstanceViews.h"
#include "scene/Shown.h"

namespace velum::render {

using Phase = model::CullPhase;

void InstancePass::prepare(FrameData& data) {
  if (!mModel.isDrawn()) return;
  const scene::ModelLayer& model = data.frame.scene.model;
  mDraw.restart();
  if (std::exchange(mSeenOf, model.data.id()) != model.data.id()) mEye.forget();
  mEye.resize(data.frame.windowSize, std::uint32_t(model.data->instances.size()), scene::copyCount(model));
}

void InstancePass::compile(const FrameData&) {
  if (mModel.isDrawn()) mShading.compile();
}

void InstancePass::addSteps(const FrameData& data, int sample, WorkQueue& queue) {
  if (!mModel.isDrawn()) return;
  const scene::Lighting& lighting = data.frame.scene.lighting;
  shared::InstanceView view = eyeViewOf(data, sample);
  // The light finds no more in the next samples.
  bool hasShadows = lighting.shaded && lighting.shadow > 0 && !data.frame.isPreview;
  if (sample == 0 && hasShadows) addLight(lightViewOf(data, view), queue);
  addEye(view, queue);
  if (sample == 0) mDraw.add(queue, [this] { mEye.noteSeen(mModel.programs()); });
  mShading.addSteps(data, sample, {mEye, hasShadows ? &mLight : nullptr, hasShadows ? mLightTexel : 0.0f}, mDraw,
                    queue);
}

void InstancePass::addLight(const shared::InstanceView& view, WorkQueue& queue) {
  mLight.resize(glm::ivec2(view.pictureSize), std::uint32_t(view.instanceCount), view.copies);
  mLightTexel = 2.0f * glm::length(glm::vec3(view.up)) / view.pictureSize.x;
  mDraw.add(queue, [this, view] { mLight.begin(view); });
  mDraw.addCull(mLight, mModel.need().by, Phase::All, queue);
  mDraw.addDraws(mLight, Phase::All, false, queue);
}

/// Depths of what was seen before, then of what these do not hide; then who is at the depths.
void InstancePass::addEye(const shared::InstanceView& view, WorkQueue& queue) {
  mDraw.add(queue, [this, view] { mEye.begin(view); });
  for (Phase phase : {Phase::SeenBefore, Phase::Others}) {
    mDraw.addCull(mEye, mModel.need().by, phase, queue);
    mDraw.addDraws(mEye, phase, false, queue);
    mDraw.addPyramid(mEye, queue);
  }
  for (Phase phase : {Phase::SeenBefore, Phase::Others}) mDraw.addDraws(mEye, phase, true, queue);
}

}  // namespace velum::render
