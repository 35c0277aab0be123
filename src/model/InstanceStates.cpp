#include "model/InstanceStates.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "model/FocusRows.h"
#include "shared/bindings.h"
#include "shared/instance.h"

namespace velum::model {

namespace {

constexpr int kRowsAtATime = 512;

}  // namespace

void InstanceStates::resize(const InstanceRoom& instances) {
  std::uint32_t count = instances.count();
  if (mBits && count == mCount) return;
  mCount = count;
  mBits =
      gpu::Buffer("states of instances", std::max<std::size_t>(1, std::size_t(words())) * 3 * sizeof(std::uint32_t));
}

void InstanceStates::begin() { mBits.clear(); }

void InstanceStates::bind() const { mBits.bindStorage(shared::kStateBinding); }

void InstanceStates::look(const gpu::Program& program, const InstancePart& part) const {
  bind();
  program.set(0, int(part.first));
  program.set(1, int(part.end));
  program.set(2, part.firstCopy);
  gpu::dispatch(program, {int((part.end - part.first + 63) / 64), part.copies, 1});
  gpu::barrier();
}

void InstanceStates::clip(InstancePrograms& programs, bool hasMembranes, const InstancePart& part) {
  look(programs.clip(hasMembranes), part);
}

void InstanceStates::beginFocus(const shared::FocusView& view) {
  if (!mView) {
    mView = gpu::Buffer("view of a focus", sizeof(view));
    mReach = gpu::Buffer("longest distance in a mask", 4 * sizeof(std::uint32_t));
  }
  mView.write(0, sizeof(view), &view);
  if (view.size != mSize) {
    mSize = view.size;
    std::size_t bytes = std::size_t(mSize.x) * std::size_t(mSize.y) * sizeof(std::uint32_t);
    mMask = gpu::Buffer("mask of a focus", bytes);
    mMaskTexels = gpu::Texture::makeOfBuffer("mask of a focus", gpu::Format::R32ui, mMask);
    for (int i = 0; i < 2; ++i) {
      mSeeds[i] = gpu::Buffer("seeds of a mask", bytes);
      mSeedTexels[i] = gpu::Texture::makeOfBuffer("seeds of a mask", gpu::Format::R32ui, mSeeds[i]);
    }
  }
  mMask.fill(view.guidesDepth != 0 ? shared::kNoDepth : 0u);
  mReach.clear();
}

void InstanceStates::drawFocus(InstancePrograms& programs, bool hasMembranes, const InstancePart& part) {
  mView.bindUniform(shared::kFocusViewBinding);
  mMask.bindStorage(shared::kMaskBinding);
  mReach.bindStorage(shared::kReachBinding);
  mMaskTexels.bindSampler(shared::kMaskUnit);
  mSeedTexels[0].bindSampler(shared::kSeedUnit);
  look(programs.focus(hasMembranes, false), part);
}

void InstanceStates::flood(InstancePrograms& programs) {
  const gpu::Program& program = programs.flood();
  mView.bindUniform(shared::kFocusViewBinding);
  mReach.bindStorage(shared::kReachBinding);
  mMaskTexels.bindSampler(shared::kMaskUnit);
  auto run = [&](int step, bool isLast) {
    mSeeds[1].bindStorage(shared::kSeedBinding);
    mSeedTexels[0].bindSampler(shared::kSeedUnit);
    program.set(0, step);
    program.set(1, isLast ? 1 : 0);
    gpu::dispatch(program, {(mSize.x + 7) / 8, (mSize.y + 7) / 8, 1});
    gpu::barrier();
    std::swap(mSeeds[0], mSeeds[1]);
    std::swap(mSeedTexels[0], mSeedTexels[1]);
  };
  run(0, false);  // twice, into both: later on nobody but the mask's own pixels writes
  std::vector<int> steps = floodSteps(mSize);
  for (std::size_t i = 0; i < steps.size(); ++i) run(steps[i], i + 1 == steps.size());
}

void InstanceStates::clear(InstancePrograms& programs, bool hasMembranes, const InstancePart& part) {
  mView.bindUniform(shared::kFocusViewBinding);
  mMask.bindStorage(shared::kMaskBinding);
  mReach.bindStorage(shared::kReachBinding);
  mMaskTexels.bindSampler(shared::kMaskUnit);
  mSeedTexels[0].bindSampler(shared::kSeedUnit);
  look(programs.focus(hasMembranes, true), part);
}

void InstanceStates::noteShown(InstancePrograms& programs, const gpu::Texture& ids, std::uint32_t first) {
  const gpu::Program& program = programs.shown();
  bind();
  ids.bindSampler(shared::kPictureIdUnit);
  program.set(0, int(first));
  program.set(1, 2 * words());
  glm::ivec2 size(ids.size());
  for (int row = 0; row < size.y; row += kRowsAtATime) {
    program.set(2, row);
    gpu::dispatch(program, {(size.x + 7) / 8, (std::min(kRowsAtATime, size.y - row) + 7) / 8, 1});
  }
  gpu::barrier();
}

}  // namespace velum::model
