#include "render/passes/SkipPass.h"

#include <algorithm>
#include <array>
#include <bit>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>

#include "core/Parallel.h"
#include "render/WorkQueue.h"
#include "scene/Shown.h"

namespace velum::render {

namespace {

std::uint64_t bitOf(int id) { return std::uint64_t(1) << (id % 64); }

/// Into 0..1.
float clamped(float x) { return x > 0.0f ? std::min(x, 1.0f) : 0.0f; }

}  // namespace

SkipPass::Key SkipPass::keyOf(const FrameData& data) {
  const scene::Scene& scene = data.frame.scene;
  Key key;
  key.volume = data.volumeKey;
  if (data.volume) key.cellRanges = data.volume->cellsRevision;
  key.labelCells = data.labelCellsRevision;
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
  for (const auto& cut : scene::enabledOf(scene.cuts))
    for (const auto& spare : cut.spares)
      if (spare.distance > 0.0) key.spared |= bitOf(spare.structure);
  if (data.spares.hasDepths && data.cuts.size() < kFewCuts) {
    key.cuts = data.cuts;
    key.sceneFromTex = data.params.sceneFromTex;
    key.deepest.assign(64 * key.cuts.size(), 0.0f);
    for (std::size_t id = 0; id < data.spares.rowOf.size(); ++id)
      for (std::size_t cut = 0; cut < key.cuts.size(); ++cut) {
        float& deepest = key.deepest[id % 64 * key.cuts.size() + cut];
        deepest = std::max(deepest, data.spares.depthOf(std::uint32_t(id), cut));
      }
  }
  if (data.labelUse == LabelUse::None) return key;
  (data.labelUse == LabelUse::OverVolume && scene.labels.unlabelled > 0 ? key.visible : key.hidden) |= bitOf(0);
  for (const auto& info : scene.labels.data->table)
    (std::size_t(info.id) >= data.structures.size() || data.structures[std::size_t(info.id)].color.a > 0.0f
         ? key.visible
         : key.hidden) |= bitOf(info.id);
  for (std::size_t id = 0; id < data.sets.of.size(); ++id)
    if (data.sets.of[id] & (StructureSets::kSolid | StructureSets::kVeil)) key.solid |= bitOf(int(id));
  return key;
}

/// True when a cell of these values, smallest and largest, may show something, labels aside.
bool SkipPass::hasContent(const Key& key, glm::vec2 texels) {
  if (key.content == Content::Labels) return true;
  glm::vec2 x = texels * key.tablePerTexel + key.tableOffset;
  float low = std::min(x.x, x.y), high = std::max(x.x, x.y);
  if (key.content == Content::Iso) return low <= key.isoValue && high >= key.isoValue;
  // The transfer function is not zero somewhere between two table positions: its running sum differs.
  constexpr int kLast = shared::kTransferSize - 1;
  int a = std::max(int(clamped(low) * float(kLast) - 0.01f), 0);
  int b = std::min(int(clamped(high) * float(kLast) + 0.01f) + 1, kLast + 1);
  return key.extinctionSums[std::size_t(a)] != key.extinctionSums[std::size_t(b)];
}

/// The same of what cuts spare, or borders on what is hidden: where it ends there is a surface in the middle of
/// material.
bool SkipPass::hasEnds(const Key& key, glm::vec2 texels) {
  if (key.content != Content::Iso) return hasContent(key, texels);
  glm::vec2 x = texels * key.tablePerTexel + key.tableOffset;
  return std::max(x.x, x.y) >= key.isoValue;
}

/// False where no cut removes any of a ball, or cuts remove all of it whichever of the ids it is of.
bool SkipPass::maySpare(const Key& key, std::uint64_t ids, const Ball& ball) {
  if (key.cuts.empty()) return true;
  std::array<float, kFewCuts> distances{};
  bool isAsked = false;  // some of it may be removed
  for (std::size_t cut = 0; cut < key.cuts.size(); ++cut) {
    bool isSheet = key.cuts[cut].kind.x == shared::kCutMembrane;
    distances[cut] = isSheet ? 0.0f : shared::shapeDistance(key.cuts[cut], ball.centre);
    isAsked = isAsked || distances[cut] < ball.radius;
  }
  for (; isAsked && ids != 0; ids &= ids - 1) {
    const float* deepest = &key.deepest[std::size_t(std::countr_zero(ids)) * key.cuts.size()];
    shared::CutFold fold = shared::emptyFold();
    for (std::size_t cut = 0; cut < key.cuts.size(); ++cut) {
      bool removesAll = -distances[cut] - ball.radius > deepest[cut];
      fold = shared::foldAnswer(fold, shared::cutPart(key.cuts[cut]),
                                removesAll ? shared::kCutRemoves : shared::kCutKeeps);
    }
    if (shared::foldKeeps(fold)) return true;
  }
  return false;
}

SkipPass::Found SkipPass::find(const Key& key, const FrameData& data) {
  Found found{CellSet(key.cells), CellSet(key.cells)};
  auto nx = std::size_t(key.cells.x), ny = std::size_t(key.cells.y);
  glm::mat4 sceneFromCell = glm::scale(key.sceneFromTex, 1.0f / glm::vec3(data.params.cellsPerTex));
  glm::mat3 edges(sceneFromCell);
  float radius = 0.501f * glm::length(glm::vec3(glm::length(edges[0]), glm::length(edges[1]), glm::length(edges[2])));
  parallelFor(std::size_t(0), found.all.rows.size(), [&](std::size_t row) {
    for (std::size_t x = 0; x < nx; ++x) {
      std::size_t cell = row * nx + x;
      std::uint64_t ids = data.labelCells ? data.labelCells->sets()[cell] : bitOf(0);
      bool isShown = !data.labelCells || (ids & key.visible) != 0;
      glm::vec2 texels = data.volume ? data.volume->cellRanges[cell] : glm::vec2(0.0f);
      std::uint64_t bit = std::uint64_t(1) << x;
      bool isSolid = (ids & key.solid) != 0;
      bool hasValues = ids & key.hidden ? hasEnds(key, texels) : hasContent(key, texels);
      if (isShown && (isSolid || hasValues)) found.all.rows[row] |= bit;
      if (!isShown || !(ids & key.spared) || !(isSolid || hasEnds(key, texels))) continue;
      glm::vec3 middle = glm::vec3(x, row % ny, row / ny) + 0.5f;
      Ball ball{glm::vec3(sceneFromCell * glm::vec4(middle, 1.0f)), radius};
      if (maySpare(key, ids & key.spared, ball)) found.spared.rows[row] |= bit;
    }
  });
  return found;
}

void SkipPass::prepare(FrameData& data) {
  glm::ivec3 size = skipMapSize(data.grid.cells.size);
  if (mMap && mMap.size() == size) return;
  mMap = gpu::Texture::make3d("skip map", gpu::Format::Rg8ui, size, gpu::Filter::Nearest);
  mKey.reset();
  mFound = {};
}

void SkipPass::addSteps(const FrameData& data, int, WorkQueue& queue) {
  Key key = keyOf(data);
  if (mKey == key) return;
  queue.add(*this, [this, key, &data] {
    Found found = find(key, data);
    if (found != mFound) mMap.write({0, 0, 0}, mMap.size(), makeSkipMap(found.all, found.spared).data());
    mFound = std::move(found);
    mKey = key;
  });
}

std::function<bool(glm::vec2)> SkipPass::whatShows() const {
  // Who is solid shows whatever the values.
  if (!mKey || mKey->solid != 0) return [](glm::vec2) { return true; };
  auto key = std::make_shared<const Key>(*mKey);
  bool bordersOnHidden = key->hidden != 0 || key->spared != 0;
  return [key, bordersOnHidden](glm::vec2 texels) {
    return bordersOnHidden ? hasEnds(*key, texels) : hasContent(*key, texels);
  };
}

void SkipPass::bind(const FrameData&) const { mMap.bindSampler(shared::kSkipUnit); }

}  // namespace velum::render
