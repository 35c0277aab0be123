#include "render/passes/GhostPass.h"

#include <algorithm>
#include <vector>

#include "render/WorkQueue.h"
#include "render/passes/InstanceViews.h"
#include "shared/bindings.h"

namespace velum::render {

void GhostPass::prepare(FrameData& data) {
  const scene::ModelLayer& model = data.frame.scene.model;
  mIsOn = isModelDrawn(data.frame.scene) && scene::hasGhosts(model) && !data.cuts.empty();
  if (!mIsOn) return;
  if (!mShade) mShade = gpu::Program({"render/ghosts.comp"});
  mTarget.resize(data.frame.windowSize, mModel.instanceRoom(), mModel.listRoom());
  if (!mSums || glm::ivec2(mSums.size()) != data.frame.windowSize)
    mSums = gpu::Texture::make2d("ghosts", gpu::Format::Rgba32f, data.frame.windowSize);
}

void GhostPass::addSteps(const FrameData& data, int sample, WorkQueue& queue) {
  if (!mIsOn) return;
  mDraw.addDepths(mTarget, mModel.eyeView(data, sample), model::CullBy::Ghosts, queue);
  mDraw.addOwners(mTarget, false, queue);
  if (sample == 0) mDraw.add(queue, [this] { mTarget.noteSeen(mModel.programs()); });
  queue.add(*this, [this, &data] { shade(data); });
}

void GhostPass::shade(const FrameData& data) {
  mTarget.bindView(shared::kInstanceViewBinding);
  mTarget.bindOwners();
  mTarget.bindDepths(shared::kDepthUnit);
  mGbuffer.bindSamplers();
  if (mSamples == 0) mSums.clear();
  mSums.bindImage(shared::kGhostImage, gpu::Access::ReadWrite);
  mShade.set(0, float(data.frame.scene.model.ghostOpacity));
  glm::ivec4 drawn = drawnRect(data);
  mShade.set(1, glm::ivec2(drawn));
  gpu::dispatch(mShade, {(drawn.z + 7) / 8, (drawn.w + 7) / 8, 1});
  gpu::barrier();
  ++mSamples;
}

void GhostPass::appendLayer(Image& image) const {
  std::size_t count = std::size_t(image.width) * std::size_t(image.height), before = image.channels.size();
  std::vector<glm::vec4> sums(count, glm::vec4(0.0f));
  if (mSamples > 0) mSums.read(sums.data(), count * sizeof(sums[0]));
  for (const char* name : {"ghosts.R", "ghosts.G", "ghosts.B", "ghosts.A"}) image.channels.emplace_back(name);
  std::vector<float> pixels;
  pixels.reserve(count * image.channels.size());
  for (std::size_t i = 0; i < count; ++i) {
    const float* own = &image.pixels[i * before];
    pixels.insert(pixels.end(), own, own + before);
    glm::vec4 sum = sums[i];
    for (int c = 0; c < 3; ++c) pixels.push_back(sum.a > 0.0f ? sum[c] / sum.a : 0.0f);
    pixels.push_back(mSamples > 0 ? sum.a / float(mSamples) : 0.0f);
  }
  image.pixels = std::move(pixels);
}

}  // namespace velum::render
