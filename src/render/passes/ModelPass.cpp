#include "render/passes/ModelPass.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "gpu/GpuError.h"
#include "model/FocusRows.h"
#include "model/InstanceRows.h"
#include "model/Levels.h"
#include "scene/Shown.h"
#include "shared/bindings.h"

namespace velum::render {

namespace {

constexpr std::uint32_t kSoftwareLooks = 1u << 17, kHardwareLooks = 1u << 22;  // instances at a time
constexpr std::uint32_t kMostInstances = 1u << 27;  // over all copies: what numbers have room for
constexpr std::uint32_t kMostListed = 1u << 21;     // 32 MB of draws a view

model::InstancePrograms::Need needOf(const FrameData& data) {
  const Frame& frame = data.frame;
  model::InstancePrograms::Need need;
  need.hasMembranes = (data.params.flags & shared::kFlagMembranes) != 0;
  need.hasFocus = !model::focusRows(frame.scene).empty();
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
  Key key{layer.data.id(), levels.id(), {-modelOrigin(data), angstromOf(data)}};
  if (!mKey || !(*mKey == key)) {
    mKey.reset();
    mSet = {};
    mSet = model::InstanceSet(*layer.data, *levels, key.placement);
    mKey = key;
  }
  writeRows(data);
  mNeed = needOf(data);
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
  std::uint64_t count = scene::instanceCount(layer);
  // A copy's instances are buffers' texels, two each.
  std::uint64_t most = kMostInstances;
  if (layer.data->instances.size() > mMostTexels / 2) most = mMostTexels / 2;
  if (count > most)
    throw gpu::GpuError(
        fmt::format("{} instances are too many for this driver; {} are the most: take fewer copies", count, most));
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
  mTypeTexels.bindSampler(shared::kTypeUnit);
  mTypeSpareTexels.bindSampler(shared::kTypeSpareUnit);
}

}  // namespace velum::render
