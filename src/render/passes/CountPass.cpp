#include "render/passes/CountPass.h"

#include "render/Renderer.h"
#include "render/WorkQueue.h"

namespace velum::render {

namespace {

constexpr std::size_t kRemembered = 8;  // more pictures than can be on their way

}  // namespace

void CountPass::addSteps(const FrameData& data, int sample, WorkQueue& queue) {
  if (sample != 0 || !data.frame.countsInstances || !mModel.hasStates() || mModel.need().isCrowd) return;
  queue.add(*this, [this, &data] {
    const scene::ModelLayer& model = data.frame.scene.model;
    model::InstanceStates& states = mStates.states();
    states.noteShown(mModel.programs(), mGbuffer.ids(), firstModelInstance(data.frame.scene));
    mCount = std::uint64_t(model.data->instances.size()) * std::uint64_t(model.copies);
    std::size_t words = std::size_t(states.words()) * 3;
    auto start = [&] {
      if (mPictureSizes.size() == kRemembered) mPictureSizes.erase(mPictureSizes.begin());
      mPictureSizes.push_back(data.frame.pictureSize);
      return mReadback.start(states.bits(), 0, words);
    };
    // Whoever draws faster than anything arrives has the last one arrive all the same.
    if (!start() && mReadback.finish()) start();
  });
}

std::optional<InstanceBits> CountPass::take(bool waits) {
  auto arrived = waits ? mReadback.finish() : mReadback.poll();
  std::size_t words = std::size_t((mCount + 31) / 32);
  if (!arrived || arrived->values.size() != 3 * words) return std::nullopt;
  auto age = std::size_t(arrived->age);
  InstanceBits bits{mCount, {}, {}, glm::ivec2(0)};
  if (age < mPictureSizes.size()) bits.pictureSize = mPictureSizes[mPictureSizes.size() - 1 - age];
  auto from = arrived->values.begin();
  bits.removed.assign(from, from + std::ptrdiff_t(words));
  for (std::size_t i = 0; i < words; ++i) bits.removed[i] |= arrived->values[words + i];
  bits.shown.assign(from + std::ptrdiff_t(2 * words), arrived->values.end());
  return bits;
}

}  // namespace velum::render
