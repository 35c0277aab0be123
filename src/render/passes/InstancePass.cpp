#include "render/passes/InstancePass.h"

#include <algorithm>
#include <utility>

#include "render/passes/InstanceViews.h"

namespace velum::render {

void InstancePass::prepare(FrameData& data) {
  if (!mModel.isDrawn()) return;
  const scene::ModelLayer& model = data.frame.scene.model;
  mDraw.restart();
  if (std::exchange(mSeenOf, model.data.id()) != model.data.id()) mEye.forget();
  mEye.resize(data.frame.windowSize, mModel.instanceRoom(), mModel.listRoom());
}

void InstancePass::compile(const FrameData&) {
  if (mModel.isDrawn()) mShading.compile();
}

void InstancePass::addSteps(const FrameData& data, int sample, WorkQueue& queue) {
  if (!mModel.isDrawn()) return;
  const scene::Lighting& lighting = data.frame.scene.lighting;
  shared::InstanceView view = mModel.eyeView(data, sample);
  // The light finds no more in the next samples.
  bool hasShadows = lighting.shaded && lighting.shadow > 0 && !data.frame.isPreview;
  if (sample == 0 && hasShadows) addLight(lightViewOf(data, view), queue);
  mDraw.addDepths(mEye, view, mModel.need().by, queue);
  mDraw.addOwners(mEye, InstanceDraw::hasWholes(view, mModel.need().by), queue);
  if (sample == 0) mDraw.add(queue, [this] { mEye.noteSeen(mModel.programs()); });
  mShading.addSteps(data, sample, {mEye, hasShadows ? &mLight : nullptr, hasShadows ? mLightTexel : 0.0f}, mDraw,
                    queue);
}

void InstancePass::addLight(const shared::InstanceView& view, WorkQueue& queue) {
  mLight.resize(glm::ivec2(view.pictureSize), mModel.instanceRoom(), mModel.listRoom());
  mLightTexel = 2.0f * glm::length(glm::vec3(view.up)) / view.pictureSize.x;
  mDraw.addDepths(mLight, view, mModel.need().by, queue);
}

}  // namespace velum::render
