#include "render/passes/ModelPass.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <span>

#include "gpu/GpuError.h"
#include "model/CopyBlocks.h"
#include "model/FocusRows.h"
#include "model/InstanceRows.h"
#include "model/Levels.h"
#include "render/passes/InstanceViews.h"
#include "scene/Crowd.h"
#include "shared/bindings.h"

namespace velum::render {

namespace {

constexpr std::uint32_t kSoftwareLooks = 1u << 17, kHardwareLooks = 1u << 22;  // instances at a time
constexpr std::uint32_t kMostListed = 1u << 21;                                // 32 MB of draws a view

model::InstancePrograms::Need needOf(const FrameData& data) {
  const Frame& frame = data.frame;
  model::InstancePrograms::Need need;
  need.hasMembranes = (data.params.flags & shared::kFlagMembranes) != 0;
  need.hasFocus = !model::focusRows(frame.scene).empty();
  need.isCrowd = scene::isCrowd(frame.scene.model);
  need.hasGhosts = scene::hasGhosts(frame.scene.model);
  // Whether a frame asks what becomes of instances, rather than only draws what is left of them.
  bool wantsStates = frame.countsInstances || need.hasGhosts || need.hasFocus;
  need.by = wantsStates ? model::CullBy::States : need.hasMembranes ? model::CullBy::Membranes : model::CullBy::Cuts;
  return need;
}

}  // namespace

void ModelPass::prepare(FrameData& data) {
  const scene::ModelLayer& layer = data.frame.scene.model;
  if (!isModelDrawn(data.frame.scene)) {
    mKey.reset();
    mSet = {};
    return;
  }
  checkCount(layer);
  Shared<LevelSet> levels = levelsOf(layer);
  mNeed = needOf(data);
  Key key{layer.data.id(), levels.id(), {-modelOrigin(data), angstromOf(data)}, mNeed.isCrowd};
  if (!mKey || !(*mKey == key)) {
    mKey.reset();
    mSet = {};
    mSet = model::InstanceSet(*layer.data, *levels, key.placement, key.isCrowd);
    mKey = key;
  }
  writeRows(data);
  placeCopies(data);
}

/// Gives slots to copies: to all, or, in a crowd, to those that are near.
void ModelPass::placeCopies(const FrameData& data) {
  const scene::ModelLayer& layer = data.frame.scene.model;
  mRoom = {std::uint32_t(layer.data->instances.size()), scene::copyCount(layer), 0};
  std::vector<std::uint32_t> copies;
  shared::InstanceView view = eyeViewOf(data, 0);
  if (mNeed.isCrowd) {
    mRoom.wholes = mRoom.slots;
    mRoom.slots = scene::numberedCopies(layer);
    view.copySphere = mSet.whole().sphere;
    view.size = data.frame.windowSize;
    copies = model::nearCopies(view, mSet.whole().error, std::size_t(mRoom.slots));
  } else {
    copies.resize(std::size_t(mRoom.slots));
    std::iota(copies.begin(), copies.end(), 0u);
  }
  mCopies.place(view, copies, mNeed.isCrowd);
}

shared::InstanceView ModelPass::eyeView(const FrameData& data, int sample) const {
  shared::InstanceView view = eyeViewOf(data, sample);
  view.copies = mCopies.used();
  view.stateWords = int((mRoom.count() + 31) / 32);
  if (!mNeed.isCrowd) return view;
  view.firstWhole = mRoom.firstWhole();
  view.wholeMolecule = mSet.whole().molecule;
  view.copySphere = mSet.whole().sphere;
  view.showsInside = view.cutCount > 0 || mHidesTypes ? 1 : 0;
  return view;
}

void ModelPass::compile(const FrameData&) {
  if (isDrawn()) mPrograms.compile(mNeed);
}

bool ModelPass::isReady() { return !isDrawn() || mPrograms.compile(mNeed); }

std::uint32_t ModelPass::atATime() const { return mIsSoftware ? kSoftwareLooks : kHardwareLooks; }

std::uint32_t ModelPass::listRoom() const {
  return std::min(kMostListed, std::uint32_t(std::min<std::size_t>(mMostTexels, 1u << 30) / shared::kDrawRooms));
}

void ModelPass::checkCount(const scene::ModelLayer& layer) const {
  // A copy's instances are buffers' texels, two each.
  std::uint64_t count = layer.data->instances.size();
  std::uint64_t most = std::min<std::uint64_t>(scene::kMostNumbered, mMostTexels / 2);
  if (count > most)
    throw gpu::GpuError(fmt::format(
        "{} instances are too many for this driver; {} are the most: leave out what completes the model", count, most));
}

Shared<LevelSet> ModelPass::levelsOf(const scene::ModelLayer& layer) {
  if (layer.levels) return layer.levels;
  if (!mOwnLevels || mOwnLevelsOf != layer.data.id()) {
    Progress progress;
    mOwnLevels = Shared<LevelSet>(model::computeLevels(*layer.data, progress));
    mOwnLevelsOf = layer.data.id();
  }
  return mOwnLevels;
}

void ModelPass::writeRows(const FrameData& data) {
  auto types = model::makeTypeRows(data.frame.scene.model);
  mHidesTypes =
      std::any_of(types.begin(), types.end(), [](const auto& type) { return type.color.a == shared::kTypeHidden; });
  types.resize(std::max<std::size_t>(1, types.size()));
  mTypes = gpu::Buffer("types", std::span<const shared::TypeRow>(types));
  mTypeTexels = gpu::Texture::makeOfBuffer("types", gpu::Format::Rgba32f, mTypes);
  mSpareRows = model::makeTypeSpareRows(data.frame.scene);
  mSpareRows.resize(std::max<std::size_t>(1, mSpareRows.size()));
  mTypeSpares = gpu::Buffer("spares of types", std::span<const shared::TypeSpareRow>(mSpareRows));
  mTypeSpareTexels = gpu::Texture::makeOfBuffer("spares of types", gpu::Format::Rgba32f, mTypeSpares);
}

void ModelPass::bind(const FrameData&) const {
  if (!isDrawn()) return;
  mSet.bind();
  mCopies.bind();
  mTypeTexels.bindSampler(shared::kTypeUnit);
  mTypeSpareTexels.bindSampler(shared::kTypeSpareUnit);
}

}  // namespace velum::render
