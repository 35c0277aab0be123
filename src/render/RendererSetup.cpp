#include <fmt/format.h>

#include <algorithm>

#include "RendererImpl.h"
#include "upload/BlueNoise.h"
#include "upload/TransferTable.h"

namespace velum::render {

namespace {

constexpr int kQuickTexels = 96;  // along the longest side: under 30 ms on two cores

/// Which label shading a scene needs: the LABELS switch of the shaders.
int labelsMode(const scene::Scene& scene) {
  if (!scene.labels.data || !scene.labels.visible) return 0;
  return scene.volume.data && scene.volume.visible ? 1 : 2;
}

/// A scene reduced to what its material depends on, colours left out.
scene::Scene materialKey(const scene::Scene& scene) {
  scene::Scene key = scene;
  key.camera = {};
  key.background = {};
  key.surfaces.clear();
  key.showBounds = false;
  key.rayCast = {};
  key.rayCast.mode = scene.rayCast.mode;
  key.rayCast.isoValue = scene.rayCast.isoValue;
  key.lighting = {};
  key.slices = {};
  for (auto& point : key.volume.transfer.colors) point.color = {};
  for (auto& structure : key.labels.structures) structure.color = {};
  for (auto& cut : key.cuts) {
    cut.name.clear();
    if (!cut.membrane) continue;
    cut.membrane = scene::drawnMembrane(std::move(*cut.membrane));
    cut.membrane->look = {};
    cut.membrane->sliceOpacity = 0;
  }
  return key;
}

/// A scene reduced to what its skip map depends on: of the cuts, only which structures they spare.
scene::Scene skipKey(const scene::Scene& scene) {
  scene::Scene key = materialKey(scene);
  for (auto& cut : key.cuts) {
    scene::Cut spares;
    spares.enabled = cut.enabled;
    spares.exempt = cut.exempt;
    cut = spares;
  }
  return key;
}

}  // namespace

Renderer::Impl::VolumeKey Renderer::Impl::volumeKeyOf(const scene::VolumeLayer& layer) const {
  VolumeKey key{layer.data.id(), layer.channel, layer.frame, {}};
  if (!scene::mixesChannels(layer)) return key;
  key.channel = 0;
  key.looks = layer.channels;
  for (auto& look : key.looks) {
    look.name.clear();
    look.color = {};
    look.windowLevel = look.windowWidth = 0;
    if (!look.visible) look.transfer = {};
  }
  return key;
}

void Renderer::Impl::addUploadSteps() {
  const auto& layer = frame.scene.volume;
  stats.reduction.clear();
  if (layer.data && layer.visible) {
    VolumeKey key = volumeKeyOf(layer);
    bool hasWhole = whole && key == volumeKey;
    if (!hasWhole && frame.isPreview) {
      if (quick && key == quickKey) return;
      volume = nullptr;
      quick.reset();
      steps.push_back({"Upload", [this, key] {
                         VolumeUpload copy(frame.scene.volume, context.limits(), kQuickTexels);
                         while (!copy.step()) {
                         }
                         quick = copy.take();
                         quickKey = key;
                         return true;
                       }});
    } else if (!hasWhole) {
      if (!upload || !(key == uploadKey)) {
        volume = nullptr;
        whole.reset();
        upload.reset();
        upload = std::make_unique<VolumeUpload>(layer, context.limits());
        uploadKey = key;
      }
      stats.uploadMs = 0;
      steps.push_back({"Upload", [this] {
                         if (!upload->step()) return false;
                         whole = upload->take();
                         volumeKey = uploadKey;
                         upload.reset();
                         return true;
                       }});
    }
  }
}

/// Which volume is drawn, the grid that stands for it, and its labels over that grid.
void Renderer::Impl::prepareGrid() {
  const scene::Scene& scene = frame.scene;
  GpuVolume* drawn = drawnVolume();
  if (drawn != volume) skipScene.reset();
  volume = drawn;
  bool hasVolume = volume != nullptr;
  int mode = labelsMode(scene);
  grid = FrameGrid{};
  if (hasVolume) {
    grid = {volume->dims,       volume->cells,       volume->worldFromTex,
            volume->valueScale, volume->valueOffset, volume->gradientScale};
    if (volume == &*whole) stats.reduction = volume->reduction;
  } else if (mode == 2) {
    grid.dims = scene.labels.data->dims();
    grid.cells = cellGridFor(grid.dims);
    glm::dmat4 voxelFromTex(1.0);
    for (int axis = 0; axis < 3; ++axis) voxelFromTex[axis][axis] = grid.dims[axis], voxelFromTex[3][axis] = -0.5;
    grid.worldFromTex = scene.labels.data->worldFromVoxel() * voxelFromTex;
  } else {
    grid.cells = {4, glm::ivec3(1)};
    scene::Bounds bounds = scene::computeBounds(scene);
    for (int axis = 0; axis < 3; ++axis)
      grid.worldFromTex[axis][axis] = std::max(1e-6, bounds.max[axis] - bounds.min[axis]),
      grid.worldFromTex[3][axis] = bounds.min[axis];
  }
  stats.labelBytes = 0;
  if (mode != 0) {
    labels.update(scene.labels.data, {grid.cells, grid.dims, grid.worldFromTex});
    stats.labelBytes = labels.bytesSent();
  }
}

void Renderer::Impl::writeTables(const TransferTable& table) {
  if (!transferTexture) {
    transferTexture = gpu::Texture::make2d("transfer table", gpu::Format::Rgba32ui, {shared::kTransferSize + 1, 1});
    extinctionTexture = gpu::Texture::make2d("extinction table", gpu::Format::R32ui, {shared::kTransferSize + 1, 1});
    gradientTable = gpu::Texture::make2d("gradient factors", gpu::Format::R32f, {shared::kTransferSize, 1});
  }
  transferTexture.write({0, 0, 0}, transferTexture.size(), table.sums.data());
  extinctionTexture.write({0, 0, 0}, extinctionTexture.size(), table.extinctionSums.data());
  gradientTable.write({0, 0, 0}, gradientTable.size(), table.gradientFactors.data());
  if (!noise) {
    noise = gpu::Texture::make2d("blue noise", gpu::Format::R32f, {kBlueNoiseSize, kBlueNoiseSize});
    auto values = makeBlueNoise();
    noise.write({0, 0, 0}, {kBlueNoiseSize, kBlueNoiseSize, 1}, values.data());
    emptyVolume = gpu::Texture::make3d("no volume", gpu::Format::R8, glm::ivec3(1));
    emptyVolume.clear();
    emptyLabels = gpu::Texture::make3d("no labels", gpu::Format::R8ui, glm::ivec3(1));
    emptyLabels.clear();
    emptyCells = gpu::Buffer("no cells", 16);
    emptyCells.clear();
  }
}

/// Cuts, structures and the parameters of the frame.
void Renderer::Impl::prepareParams(const TransferTable& table) {
  const scene::Scene& scene = frame.scene;
  sheets.prepare(frame);
  auto cutData = makeCutData(scene, sceneOrigin(grid), sheets.plans());
  auto rows = makeStructureRows(scene.labels);
  auto mask = makeExemptMask(scene, rows.size());
  params = makeFrameParams(frame, grid, table);
  params.cutCount = int(cutData.size());
  if (!cutData.empty()) params.flags |= shared::kFlagCuts;
  for (const scene::Cut* cut : membranesOf(scene)) {
    params.flags |= shared::kFlagMembranes;
    if (cut->membrane->use == scene::MembraneUse::Slice) params.flags |= shared::kFlagSlices;
    if (cut->membrane->look != scene::SheetLook::Hidden) params.flags |= shared::kFlagSheets;
  }
  if (params.flags & shared::kFlagSlices) {
    if (!frame.parts.front) params.flags |= shared::kFlagHideFront;
    if (!frame.parts.slice) params.flags |= shared::kFlagHideSlice;
    if (!frame.parts.behind) params.flags |= shared::kFlagHideBehind;
  }
  if (frame.isPreview && (params.flags & shared::kFlagLightGrid)) keepLight();
  params.structureCount = int(rows.size());
  if (!mask.empty() && labelsMode(scene) != 0) params.flags |= shared::kFlagExemptions;
  if (cutData.empty()) cutData.emplace_back();
  if (mask.empty()) mask.push_back(0);
  cutBuffer = gpu::Buffer("cuts", std::span<const shared::CutData>(cutData));
  structureBuffer = gpu::Buffer("structures", std::span<const shared::StructureRow>(rows));
  exemptBuffer = gpu::Buffer("exemptions", std::span<const std::uint32_t>(mask));
}

/// The programs for what the frame shows, and a light grid of the box's size.
void Renderer::Impl::choosePrograms() {
  int mode = labelsMode(frame.scene);
  int color = volume && volume->isMixed ? 2 : volume && volume->isColor ? 1 : 0;
  int rayMode = volume ? static_cast<int>(frame.scene.rayCast.mode) : 0;
  int gradients = volume && volume->gradient ? 1 : 0;
  std::uint32_t flags = params.flags;
  gpu::Defines defines{
      {"MODE", std::to_string(rayMode)}, {"LABELS", std::to_string(mode)}, {"COLOR", std::to_string(color)}};
  if (flags & shared::kFlagMembranes) defines.push_back({"MEMBRANES", "1"});
  std::string lightVariant = fmt::format("{}{}{}{}", rayMode, mode, color, flags & shared::kFlagMembranes ? "m" : "");
  std::string variant = fmt::format("{}{}", lightVariant, gradients);
  gpu::Defines lightDefines = defines;
  defines.push_back({"GRADIENTS", std::to_string(gradients)});
  if (context.limits().isSoftware) {
    // Of the light grid's, those that its shaders ask about.
    std::uint32_t lightFlags = flags & (shared::kFlagExemptions | shared::kFlagSlices);
    lightVariant += fmt::format(" {}", lightFlags);
    lightDefines.push_back({"FLAGS", fmt::format("{}u", lightFlags)});
    variant += fmt::format(" {}", flags);
    defines.push_back({"FLAGS", fmt::format("{}u", flags)});
  }
  if (!rayPrograms.contains(variant)) rayPrograms.emplace(variant, gpu::Program({"render/ray_cast.comp"}, defines));
  rayProgram = &rayPrograms.at(variant);
  if (!lightPasses.contains(lightVariant)) lightPasses.emplace(lightVariant, lightDefines);
  if (light != &lightPasses.at(lightVariant)) extinctionKey.reset();
  light = &lightPasses.at(lightVariant);
  glm::dmat3 edges(grid.worldFromTex);
  glm::ivec3 before = light->size();
  light->resize({glm::length(edges[0]), glm::length(edges[1]), glm::length(edges[2])}, lightCells());
  if (light->size() != before) extinctionKey.reset();
  params.lightGrid = glm::vec4(glm::vec3(light->size()), 0.0f);
  params.lightCell = float(light->cellMm());
}

void Renderer::Impl::updateSkipMap() {
  const scene::Scene& scene = frame.scene;
  int mode = labelsMode(scene);
  SkipOptions options;
  options.content = mode == 2                                                ? SkipOptions::Content::Labels
                    : volume && scene.rayCast.mode == scene::RenderMode::Iso ? SkipOptions::Content::Iso
                                                                             : SkipOptions::Content::Opacity;
  options.hasLabels = mode != 0;
  auto rows = makeStructureRows(scene.labels);
  auto add = [](glm::uvec2& set, int id) { (id % 64 < 32 ? set.x : set.y) |= 1u << (id % 32); };
  if (mode == 1 && scene.labels.unlabelled > 0) add(options.visible, 0);
  if (mode != 0)
    for (const auto& info : scene.labels.data->table)
      if (std::size_t(info.id) >= rows.size() || rows[info.id].color.a > 0.0f) add(options.visible, info.id);
  for (const auto& cut : scene.cuts)
    for (int id : cut.exempt)
      if (cut.enabled) add(options.spared, id);
  scene::Scene key = skipKey(scene);
  if (!skipScene || !(*skipScene == key)) skip->run(options, grid.cells.size);
  skipScene = std::move(key);
  skip->map().bindSampler(shared::kSkipUnit);
}

/// Fills everything small that the passes read: grid, tables, cuts, structures, frame parameters, skip map.
void Renderer::Impl::setup() {
  prepareGrid();
  TransferTable table = makeTransferTable(frame.scene);
  writeTables(table);
  prepareParams(table);
  choosePrograms();
  resizePictures(frame.windowSize);
  if (!skip) skip.emplace();
  if (!surfaces) surfaces.emplace();
  surfaces->useMembranes(params.flags & shared::kFlagMembranes);
  frameBlock.set(params);
  bindAll();
  updateSkipMap();
}

void Renderer::Impl::bindAll() {
  const scene::Scene& scene = frame.scene;
  bool hasVolume = volume != nullptr;
  frameBlock.bind(shared::kFrameBinding);
  (hasVolume ? volume->texture : emptyVolume).bindSampler(shared::kVolumeUnit);
  transferTexture.bindSampler(shared::kTransferUnit);
  extinctionTexture.bindSampler(shared::kExtinctionUnit);
  gradientTable.bindSampler(shared::kGradientTableUnit);
  if (hasVolume && volume->gradient) volume->gradient.bindSampler(shared::kGradientUnit);
  int mode = labelsMode(scene);
  (mode != 0 ? labels.texture() : emptyLabels).bindSampler(shared::kLabelUnit);
  noise.bindSampler(shared::kNoiseUnit);
  light->map().bindSampler(shared::kLightUnit);
  if (skip->map()) skip->map().bindSampler(shared::kSkipUnit);
  cutBuffer.bindStorage(shared::kCutBinding);
  structureBuffer.bindStorage(shared::kStructureBinding);
  exemptBuffer.bindStorage(shared::kExemptBinding);
  sheets.bind();
  (hasVolume ? volume->cellRange : emptyCells).bindStorage(shared::kCellBinding);
  (mode != 0 ? labels.cellLabels() : emptyCells).bindStorage(shared::kCellLabelBinding);
}

Renderer::Impl::MaterialKey Renderer::Impl::materialKeyOf(const Frame& of) const {
  MaterialKey key{materialKey(of.scene), of.sheets};
  // What a live sheet stands for is not looked at.
  for (auto& cut : key.scene.cuts)
    if (cut.enabled && scene::isMembrane(cut) && liveSheet(of, cut)) cut.membrane->shape = {};
  return key;
}

/// The light stays where it stood in the world when the light grid was made; without a grid that fits there is none.
void Renderer::Impl::keepLight() {
  bool fits = extinctionKey && lightDirection != glm::dvec3(0.0) && *extinctionKey == materialKeyOf(frame);
  if (fits)
    params.keyLight = glm::vec4(glm::vec3(lightDirection), 0.0f);
  else
    params.flags &= ~shared::kFlagLightGrid;
}

GpuVolume* Renderer::Impl::drawnVolume() {
  const auto& layer = frame.scene.volume;
  if (!layer.data || !layer.visible) return nullptr;
  VolumeKey key = volumeKeyOf(layer);
  if (whole && key == volumeKey) return &*whole;
  return quick && key == quickKey ? &*quick : nullptr;
}

void Renderer::Impl::addLightSteps() {
  const auto& lighting = frame.scene.lighting;
  if (!lighting.shaded || (lighting.shadow <= 0 && lighting.occlusion <= 0) || frame.isPreview) return;
  MaterialKey key = materialKeyOf(frame);
  glm::dvec3 direction(glm::vec3(params.keyLight));
  glm::dvec4 options(lighting.shadow > 0, lighting.occlusion > 0, lighting.occlusionRadius, 0);
  bool sameMaterial = extinctionKey && *extinctionKey == key;
  bool sameLight = sameMaterial && glm::length(direction - lightDirection) < 1e-6 && options == lightOptions;
  if (sameLight) return;
  bool keepOpenness = sameMaterial && hasOpenness && options == lightOptions;
  hasOpenness = keepOpenness;
  lightDirection = glm::dvec3(0.0);  // a frame that is given up half way leaves a grid that serves no direction
  constexpr int kLayers = 4;
  if (!sameMaterial) {
    extinctionKey.reset();
    for (int z = 0; z < light->size().z; z += kLayers)
      steps.push_back({"Light", [this, z] {
                         light->extinction(z, std::min(light->size().z, z + kLayers));
                         return true;
                       }});
  }
  glm::dmat3 texFromDirection(glm::inverse(glm::dmat3(glm::mat3(params.sceneFromTex))));
  glm::vec3 keyTex(texFromDirection * direction * light->cellMm());
  glm::dmat3 edges(grid.worldFromTex);
  glm::vec3 cellTex;
  double diameter = 0;
  for (int axis = 0; axis < 3; ++axis) {
    cellTex[axis] = float(light->cellMm() / glm::length(edges[axis]));
    diameter = std::max(diameter, glm::length(edges[axis]));
  }
  double reach = lighting.occlusionRadius * diameter / light->cellMm();
  for (int z = 0; z < light->size().z; z += kLayers)
    steps.push_back({"Light", [this, z, keyTex, cellTex, reach, keepOpenness] {
                       light->light(z, std::min(light->size().z, z + kLayers), keyTex, cellTex, reach, keepOpenness);
                       light->map().bindSampler(shared::kLightUnit);
                       return true;
                     }});
  steps.push_back({"Light", [this, key, direction, options] {
                     extinctionKey = key;
                     hasOpenness = true;
                     lightDirection = direction;
                     lightOptions = options;
                     return true;
                   }});
}

}  // namespace velum::render
