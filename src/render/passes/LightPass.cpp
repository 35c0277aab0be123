#include "render/passes/LightPass.h"

#include <algorithm>
#include <cstring>

#include "render/WorkQueue.h"

namespace velum::render {

namespace {

constexpr int kLevels = 4;  // of means of the extinction: shadows look at 4 cells at once, openness at up to 8
constexpr int kLayers = 4;  // of cells a step
constexpr int kSoftwareCells = 96, kHardwareCells = 160;  // at most, along the longest edge
constexpr double kFinestCell = 0.5;                       // voxel: what is finer shows nothing that is there

bool hasLight(const scene::Lighting& lighting) {
  return lighting.shaded && (lighting.shadow > 0 || lighting.occlusion > 0);
}

DataVariant variantOf(const FrameData& data) {
  DataVariant variant = dataVariantOf(data);
  variant.flags = lightFlagsOf(variant.flags);
  // They look at the coarse level alone.
  if (variant.bricks != BrickUse::None) variant.bricks = BrickUse::BySample;
  return variant;
}

}  // namespace

LightPass::CutWords LightPass::wordsOf(shared::CutData cut) {
  cut.kind.y = 0;
  cut.face = glm::vec4(0.0f);
  cut.sheet.w = 0;
  cut.inlay.x = 0;
  CutWords words;
  std::memcpy(words.data(), &cut, sizeof(cut));
  return words;
}

LightPass::Key LightPass::keyOf(const FrameData& data, glm::ivec3 cells) {
  const shared::FrameParams& p = data.params;
  Key key;
  key.variant = variantOf(data);
  key.flags = lightFlagsOf(p.flags);
  key.volume = data.volumeKey;
  key.labels = data.labelKey;
  key.sceneFromTex = p.sceneFromTex;
  key.labelFromScene = p.labelFromScene;
  key.cells = cells;
  for (const auto& cut : data.cuts) key.cuts.push_back(wordsOf(cut));
  key.sheets = data.sheetSources;
  for (const auto& row : data.structures) key.opacities.push_back(row.color.a);
  key.spares = data.spares;
  if (key.variant.mode == scene::RenderMode::Iso) key.isoValue = p.isoValue;
  key.extinctionSums = data.table.extinctionSums;
  key.extinctionUnit = p.extinctionUnit;
  key.tablePerTexel = p.tablePerTexel;
  key.tableOffset = p.tableOffset;
  key.unlabelledOpacity = p.unlabelledOpacity;
  key.voxelsPerLength = p.voxelsPerLength;
  return key;
}

LightPass::Light LightPass::lightOf(const FrameData& data) {
  const auto& lighting = data.frame.scene.lighting;
  return {glm::vec3(data.params.keyLight), lighting.shadow > 0, lighting.occlusion > 0, lighting.occlusionRadius};
}

/// As many cells as the box of the data has room for.
void LightPass::resize(const FrameData& data) {
  glm::dmat3 axes(data.grid.worldFromTex);
  glm::dvec3 edges(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
  int longest = data.isSoftware ? kSoftwareCells : kHardwareCells;
  glm::dvec3 voxel = edges / glm::dvec3(data.grid.dims);
  mCell = std::max(std::max(edges.x, std::max(edges.y, edges.z)) / longest,
                   kFinestCell * std::min(voxel.x, std::min(voxel.y, voxel.z)));
  glm::ivec3 size = glm::clamp(glm::ivec3(edges / mCell + 0.5), glm::ivec3(1), glm::ivec3(longest));
  if (size == mSize) return;
  mSize = size;
  mExtinction = gpu::Texture::make3d("light extinction", gpu::Format::R32f, size, gpu::Filter::Linear,
                                     std::min(kLevels, gpu::levelCountOf(size)));
  mLight = gpu::Texture::make3d("light grid", gpu::Format::Rg8, size);
  mKey.reset();
}

void LightPass::prepare(FrameData& data) {
  resize(data);
  data.params.lightGrid = glm::vec4(glm::vec3(mSize), 0.0f);
  data.params.lightCell = float(mCell);
  if (!data.frame.isPreview || !hasLight(data.frame.scene.lighting)) return;
  if (mKey && mLit && *mKey == keyOf(data, mSize))
    data.params.keyLight = glm::vec4(mLit->direction, 0.0f);
  else
    data.params.flags &= ~shared::kFlagLightGrid;
}

void LightPass::compile(const FrameData& data) {
  mExtinctionProgram = nullptr;
  if (data.frame.isPreview || !hasLight(data.frame.scene.lighting)) return;
  if (!mLightProgram) mLightProgram = gpu::Program({"render/light_grid.comp"});
  if (!mMeansProgram) mMeansProgram = gpu::Program({"render/light_means.comp"});
  DataVariant variant = variantOf(data);
  mExtinctionProgram = &mExtinctionPrograms.find(
      variant, [&] { return gpu::Program({"render/light_extinction.comp"}, definesOf(variant)); });
}

bool LightPass::isReady() {
  return !mExtinctionProgram || (mExtinctionProgram->isReady() && mLightProgram.isReady() && mMeansProgram.isReady());
}

void LightPass::addSteps(const FrameData& data, int, WorkQueue& queue) {
  if (!hasLight(data.frame.scene.lighting) || data.frame.isPreview) return;
  Key key = keyOf(data, mSize);
  Light light = lightOf(data);
  auto sameOptions = [&](const std::optional<Light>& known) {
    return known && known->isShadowed == light.isShadowed && known->isOccluded == light.isOccluded &&
           known->radius == light.radius;
  };
  bool sameMaterial = mKey && *mKey == key;
  // A camera that comes nearer moves the light by rounding errors.
  if (sameMaterial && sameOptions(mLit) && glm::length(light.direction - mLit->direction) < 1e-6f) return;
  bool keepsOpenness = sameMaterial && sameOptions(mOpen);
  // A frame that is given up half way leaves a grid that serves nobody.
  mLit.reset();
  if (!keepsOpenness) mOpen.reset();
  if (!sameMaterial) {
    mKey.reset();
    addExtinctionSteps(queue);
  }
  addLightSteps(data, keepsOpenness, queue);
  queue.add(*this, [this, key, light] {
    mKey = key;
    mLit = mOpen = light;
  });
}

void LightPass::addExtinctionSteps(WorkQueue& queue) {
  for (int z = 0; z < mSize.z; z += kLayers)
    queue.add(*this, [this, z] {
      mExtinctionProgram->set(0, z);
      mExtinction.bindImage(shared::kLightImage, gpu::Access::Write);
      gpu::dispatch(*mExtinctionProgram, (glm::ivec3(mSize.x, mSize.y, std::min(mSize.z - z, kLayers)) + 3) / 4);
      gpu::barrier();
    });
  for (int level = 1; level < mExtinction.levelCount(); ++level)
    queue.add(*this, [this, level] {
      mMeansProgram.set(0, level);
      mExtinction.bindSampler(shared::kLightExtinctionUnit);
      mExtinction.bindImage(shared::kLightImage, gpu::Access::Write, level);
      gpu::dispatch(mMeansProgram, (mExtinction.size(level) + 3) / 4);
      gpu::barrier();
    });
}

void LightPass::addLightSteps(const FrameData& data, bool keepsOpenness, WorkQueue& queue) {
  glm::dmat3 texFromDirection(glm::inverse(glm::dmat3(glm::mat3(data.params.sceneFromTex))));
  glm::vec3 keyTex(texFromDirection * glm::dvec3(glm::vec3(data.params.keyLight)) * mCell);
  glm::dmat3 edges(data.grid.worldFromTex);
  glm::vec3 cellTex;
  double diameter = 0;
  for (int axis = 0; axis < 3; ++axis) {
    cellTex[axis] = float(mCell / glm::length(edges[axis]));
    diameter = std::max(diameter, glm::length(edges[axis]));
  }
  double reachCells = data.frame.scene.lighting.occlusionRadius * diameter / mCell;
  for (int z = 0; z < mSize.z; z += kLayers)
    queue.add(*this, [this, z, keyTex, cellTex, reachCells, keepsOpenness] {
      mLightProgram.set(0, z);
      mLightProgram.set(1, keepsOpenness ? 1 : 0);
      mLightProgram.set(2, glm::vec4(keyTex, 0.0f));
      mLightProgram.set(3, glm::vec4(cellTex, 0.0f));
      mLightProgram.set(4, float(reachCells));
      mExtinction.bindSampler(shared::kLightExtinctionUnit);
      mLight.bindImage(shared::kLightImage, gpu::Access::ReadWrite);
      gpu::dispatch(mLightProgram, (glm::ivec3(mSize.x, mSize.y, std::min(mSize.z - z, kLayers)) + 3) / 4);
      gpu::barrier();
    });
}

void LightPass::bind(const FrameData&) const { mLight.bindSampler(shared::kLightUnit); }

}  // namespace velum::render
