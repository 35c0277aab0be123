#include "SkipPass.h"

#include "WorkQueue.h"

namespace velum::render {

namespace {

void add(glm::uvec2& set, int id) { (id % 64 < 32 ? set.x : set.y) |= 1u << (id % 32); }

}  // namespace

SkipPass::SkipPass() : Pass("Skip"), mOccupancy({"render/occupancy.comp"}), mDistance({"render/skip_distance.comp"}) {}

SkipPass::Key SkipPass::keyOf(const FrameData& data) {
  const scene::Scene& scene = data.frame.scene;
  Key key;
  key.volume = data.volumeKey;
  key.labels = data.labelKey;
  key.cells = data.grid.cells.size;
  if (data.labelUse == LabelUse::Alone) {
    key.content = Content::Labels;
  } else {
    key.tablePerTexel = data.params.tablePerTexel;
    key.tableOffset = data.params.tableOffset;
    bool isIso = data.volume && scene.rayCast.mode == scene::RenderMode::Iso;
    key.content = isIso ? Content::Iso : Content::Opacity;
    if (isIso)
      key.isoValue = data.params.isoValue;
    else
      key.extinctionSums = data.table.extinctionSums;
  }
  for (const auto& cut : scene.cuts)
    for (const auto& spare : cut.spares)
      if (cut.enabled && spare.distance > 0.0 && spare.share > 0.0) add(key.spared, spare.structure);
  if (data.labelUse == LabelUse::None) return key;
  if (data.labelUse == LabelUse::OverVolume && scene.labels.unlabelled > 0) add(key.visible, 0);
  for (const auto& info : scene.labels.data->table)
    if (std::size_t(info.id) >= data.structures.size() || data.structures[std::size_t(info.id)].color.a > 0.0f)
      add(key.visible, info.id);
  return key;
}

void SkipPass::prepare(FrameData& data) {
  glm::ivec3 cells = data.grid.cells.size;
  if (mMap[0] && mMap[0].size() == cells) return;
  for (auto& map : mMap) map = gpu::Texture::make3d("skip map", gpu::Format::Rg8ui, cells, gpu::Filter::Nearest);
  mKey.reset();
}

void SkipPass::addSteps(const FrameData& data, int, WorkQueue& queue) {
  Key key = keyOf(data);
  if (mKey == key) return;
  queue.add(*this, [this, key] {
    run(key);
    mKey = key;
  });
}

void SkipPass::run(const Key& key) {
  glm::ivec3 groups = (key.cells + 3) / 4;
  mOccupancy.set(0, glm::ivec4(static_cast<int>(key.content), key.labels.id != 0 ? 1 : 0, 0, 0));
  mOccupancy.set(1, glm::ivec4(glm::ivec2(key.visible), glm::ivec2(key.spared)));
  mMap[0].bindImage(0, gpu::Access::Write);
  gpu::dispatch(mOccupancy, groups);
  // x: 0 -> 1, y: 1 -> 0, z: 0 -> 1.
  for (int axis = 0; axis < 3; ++axis) {
    gpu::barrier();
    mMap[axis & 1].bindImage(0, gpu::Access::Read);
    mMap[1 - (axis & 1)].bindImage(1, gpu::Access::Write);
    mDistance.set(0, glm::ivec4(axis == 0, axis == 1, axis == 2, 0));
    gpu::dispatch(mDistance, groups);
  }
  gpu::barrier();
}

void SkipPass::bind(const FrameData&) const { mMap[1].bindSampler(shared::kSkipUnit); }

}  // namespace velum::render
