#include "render/FrameData.h"

#include <algorithm>
#include <bit>
#include <span>

#include "render/FinishSetup.h"
#include "render/FrameParams.h"
#include "render/Renderer.h"
#include "render/residency/PageGrid.h"
#include "render/upload/BlueNoise.h"
#include "render/upload/CutSheets.h"
#include "scene/Shown.h"
#include "scene/Units.h"

namespace velum::render {

VolumeKey volumeKeyOf(const scene::VolumeLayer& layer) {
  VolumeKey key;
  if (!layer.data || !layer.visible) return key;
  key.id = layer.data.id();
  key.timeStep = layer.timeStep;
  key.isSmooth = layer.smooth;
  if (!scene::mixesChannels(layer)) {
    key.channel = layer.channel;
    return key;
  }
  for (const auto& look : layer.channels) key.mixed.push_back(look.visible ? look.transfer : scene::TransferFunction{});
  return key;
}

bool isDrawn(const scene::Surface& surface) { return surface.visible && surface.data; }

bool isModelDrawn(const scene::Scene& scene) {
  return scene.model.visible && scene.model.data && !scene.model.data->instances.empty();
}

std::uint32_t firstModelInstance(const scene::Scene& scene) {
  return shared::kFirstSurfaceInstance + std::uint32_t(scene.surfaces.size());
}

double angstromOf(const FrameData& data) { return scene::modelFrame(data.frame.scene).length / data.unit; }

glm::dvec3 modelOrigin(const FrameData& data) {
  return scene::modelFrame(data.frame.scene).offset - sceneOrigin(data.grid);
}

Opaque opaqueOf(const scene::Scene& scene) {
  // Beside a volume the box is the volume's.
  bool hasGrid = scene.volume.data || scene.labels.data;
  if (isModelDrawn(scene) && hasGrid) return Opaque::Anywhere;
  if (std::any_of(scene.surfaces.begin(), scene.surfaces.end(), isDrawn)) return Opaque::Anywhere;
  if (!scene.showBounds) return isModelDrawn(scene) ? Opaque::InBox : Opaque::None;
  // Outlines of cuts stand where the cuts do; planes are outlined on the box.
  bool hasShapes = std::ranges::any_of(scene::enabledOf(scene.cuts),
                                       [](const scene::Cut& cut) { return cut.shape != scene::CutShape::Plane; });
  return hasShapes ? Opaque::Anywhere : Opaque::InBox;
}

glm::ivec4 drawnRect(const FrameData& data) {
  bool isInBox = opaqueOf(data.frame.scene) != Opaque::Anywhere;
  return isInBox ? coveredRect(data.params, data.frame) : glm::ivec4(0, 0, data.frame.windowSize);
}

int samplesOf(const Frame& frame) { return std::max(1, frame.scene.rayCast.samplesPerPixel); }

Frame withSizes(const Frame& frame) {
  Frame out = frame;
  if (out.windowSize == glm::ivec2(0)) out.windowSize = out.pictureSize;
  out.windowSize = glm::max(out.windowSize, glm::ivec2(1));
  out.pictureSize = glm::max(out.pictureSize, glm::ivec2(1));
  return out;
}

namespace {

std::uint32_t membraneFlags(const Frame& frame) {
  std::uint32_t flags = 0;
  for (const scene::Cut* cut : membranesOf(frame.scene)) {
    flags |= shared::kFlagMembranes;
    if (cut->membrane->use == scene::MembraneUse::Inlay) flags |= shared::kFlagInlays;
    if (cut->membrane->look != scene::SheetLook::Hidden) flags |= shared::kFlagSheets;
  }
  if (flags & shared::kFlagInlays) {
    if (!frame.parts.front) flags |= shared::kFlagHideFront;
    if (!frame.parts.inlay) flags |= shared::kFlagHideInlay;
    if (!frame.parts.behind) flags |= shared::kFlagHideBehind;
  }
  return flags;
}

void writePlanes(const std::vector<shared::CutData>& cuts, shared::FrameParams& params) {
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    glm::mat4 rows = glm::transpose(cuts[i].localFromScene);
    params.planes[i] = rows[2];
    if (cuts[i].kind.z & shared::kCutJoined) params.planeBits.x |= 1 << i;
    if (cuts[i].halfSize.w < 0.0f) params.planeBits.y |= 1 << i;
  }
}

/// Where the volume's voxels lie in its textures.
void writeStore(const GpuVolume& volume, shared::FrameParams& params) {
  params.storeSize = glm::vec4(volume.storeSize, 0.0f);
  if (!volume.pages) return;
  params.pageGrid = glm::vec4(volume.pages->grid, float(volume.pages->firstRow));
  params.pagesPerTex = glm::vec4(glm::vec3(volume.pages->perTex), 0.0f);
  params.firstPage = glm::vec4(glm::vec3(volume.pages->first), 0.0f);
}

}  // namespace

namespace {

/// Into the rows of structures, of which there are as many as the sets know.
void writeSets(const StructureSets& sets, std::vector<shared::StructureRow>& rows) {
  if (rows.size() < sets.of.size())
    rows.resize(sets.of.size(), {glm::vec4(0.6f, 0.6f, 0.6f, 1.0f), glm::vec4(1, 0, 0, 0)});
  for (std::size_t id = 0; id < rows.size(); ++id) rows[id].look.z = float(sets.bits(std::uint16_t(id)));
}

/// Shares of what has no label, see shareTexture.
glm::vec4 sharesBeyond(const StructureSets& sets) {
  auto share = [&](std::uint8_t bit) { return sets.bits(0) & bit ? 1.0f : 0.0f; };
  return {share(StructureSets::kSpared), share(StructureSets::kSparedToo), 0.0f, share(StructureSets::kShown)};
}

}  // namespace

void completeFrameData(FrameData& data) {
  data.unit = diameterOf(data.grid);
  scene::scaleLengths(data.frame.scene, 1.0 / data.unit);
  for (int column = 0; column < 4; ++column)
    data.grid.worldFromTex[column] =
        glm::dvec4(glm::dvec3(data.grid.worldFromTex[column]) / data.unit, data.grid.worldFromTex[column].w);
  const scene::Scene& scene = data.frame.scene;
  data.table = makeTransferTable(scene);
  data.cuts = makeCutData(scene, sceneOrigin(data.grid), data.sheetPlans, 1.0 / data.unit);
  data.structures = makeStructureRows(scene.labels);
  data.spares = makeSpareTable(scene);
  data.params = makeFrameParams(data.frame, data.grid, data.table, data.unit);
  writeSets(data.sets, data.structures);
  data.params.cutCount = int(data.cuts.size());
  data.params.structureCount = int(data.structures.size());
  data.params.flags |= membraneFlags(data.frame);
  if (!data.cuts.empty()) data.params.flags |= shared::kFlagCuts;
  if (!data.cuts.empty() && data.frame.saysFaces) data.params.flags |= shared::kFlagSaysFaces;
  for (const auto& cut : data.cuts) {
    if (cut.kind.y == 1) data.params.flags |= shared::kFlagFaces;
    if (cut.kind.z & shared::kCutWalks) data.params.flags |= shared::kFlagWalks;
    if (cut.kind.z & shared::kCutJoined) data.params.flags |= shared::kFlagJoined;
  }
  if (int(data.cuts.size()) <= shared::kMostPlanes) writePlanes(data.cuts, data.params);
  if (data.volume) writeStore(*data.volume, data.params);
  bool hasLooks = scene.labels.unlabelled != 1.0;
  for (const auto& structure : scene.labels.structures) {
    if (structure.tint != 1.0) data.params.flags |= shared::kFlagTints;
    hasLooks = hasLooks || !structure.visible || structure.opacity != 1.0 || scene.labels.tint * structure.tint > 0.0;
  }
  if (hasLooks) data.params.flags |= shared::kFlagStructureLooks;
  if (!data.volume && data.labelUse == LabelUse::None) data.params.flags |= shared::kFlagNoData;
  if (needsSamples(scene.finish)) data.params.flags |= shared::kFlagFinish;
  if (data.cuts.size() >= kFewCuts) data.params.flags |= shared::kFlagCutGrid;
  if (!data.spares.isEmpty()) data.params.flags |= shared::kFlagSpares;
  if (data.sets.hidesAny() && data.labelUse == LabelUse::OverVolume) data.params.flags |= shared::kFlagHides;
  if (data.labelUse != LabelUse::None) {
    if (data.sets.hasAny(StructureSets::kSolid)) data.params.flags |= shared::kFlagSolids;
    if (data.sets.hasAny(StructureSets::kVeil)) data.params.flags |= shared::kFlagVeils;
  }
  if (data.labelUse != LabelUse::None && data.sets.onlySpared >= 0) {
    data.params.flags |= shared::kFlagOneSpared;
    data.params.spareClasses.z = data.sets.onlySpared;
  }
  data.params.sharesBeyond = sharesBeyond(data.sets);
  if (data.sets.spareClasses.size() == 2) {
    data.params.flags |= shared::kFlagSpareClasses;
    data.params.spareClasses.x = int(data.sets.spareClasses[0]);
    data.params.spareClasses.y = int(data.sets.spareClasses[1]);
  }
  if (data.frame.marksOverlaps && data.spares.hasDepths) data.params.flags |= shared::kFlagOverlaps;
  if (data.spares.hasDepths) data.params.flags |= shared::kFlagSpareDepths;
}

DataVariant dataVariantOf(const FrameData& data) {
  DataVariant variant;
  if (const GpuVolume* volume = data.volume) {
    variant.mode = data.frame.scene.rayCast.mode;
    variant.texels = volume->isMixed ? TexelKind::Mixed : volume->isColor ? TexelKind::Color : TexelKind::Value;
    variant.packing = volume->packing;
    // A group of longer steps reaches farther than what bricks have of their neighbours.
    bool isLong = data.params.step * data.params.voxelsPerLength * 4.0f > float(kGroupReach) + 1e-3f;
    if (volume->pages) variant.bricks = isLong ? BrickUse::BySample : BrickUse::ByGroup;
  }
  variant.labels = data.labelUse;
  variant.hasLabelBricks = data.labelUse != LabelUse::None && data.hasLabelBricks;
  variant.hasMembranes = (data.params.flags & shared::kFlagMembranes) != 0;
  variant.flags = data.params.flags & ~shared::kSwitches;
  bool arePlanes =
      std::all_of(data.cuts.begin(), data.cuts.end(), [](const auto& c) { return c.kind.x == shared::kCutPlane; });
  if (arePlanes && int(data.cuts.size()) <= shared::kMostPlanes) variant.planes = int(data.cuts.size());
  return variant;
}

namespace {

/// Of at least one element: a block that a shader names must be there.
template <class T>
gpu::Buffer bufferOf(const char* label, const std::vector<T>& values) {
  T none{};
  return gpu::Buffer(label, values.empty() ? std::span<const T>(&none, 1) : std::span<const T>(values));
}

/// Sums, then gradients' factors.
std::vector<glm::uvec4> transferTexels(const TransferTable& table) {
  std::vector<glm::uvec4> texels = table.sums;
  for (float factor : table.gradientFactors) texels.emplace_back(std::bit_cast<std::uint32_t>(factor), 0, 0, 0);
  return texels;
}

/// Each but the last with its next: one fetch for both.
std::vector<glm::uvec2> pairsOf(const std::vector<std::uint32_t>& values) {
  std::vector<glm::uvec2> pairs;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) pairs.emplace_back(values[i], values[i + 1]);
  return pairs;
}

}  // namespace

void FrameInputs::write(const FrameData& data) {
  if (!mNoise) mNoise = bufferOf("blue noise", makeBlueNoise());
  mTransfer = bufferOf("transfer table", transferTexels(data.table));
  mTransferTexels = gpu::Texture::makeOfBuffer("transfer table", gpu::Format::Rgba32ui, mTransfer);
  mExtinction = bufferOf("extinction table", pairsOf(data.table.extinctionSums));
  mExtinctionTexels = gpu::Texture::makeOfBuffer("extinction table", gpu::Format::Rg32ui, mExtinction);
  writeCuts(data);
  mStructures = bufferOf("structures", data.structures);
  mStructureTexels = gpu::Texture::makeOfBuffer("structures", gpu::Format::Rgba32f, mStructures);
  mSpares = bufferOf("spares", spareTexels(data.spares));
  mSpareTexels = gpu::Texture::makeOfBuffer("spares", gpu::Format::R32ui, mSpares);
  writeParams(data, 0);
}

/// A grid is made when the cuts change, not with every picture of them.
void FrameInputs::writeCuts(const FrameData& data) {
  mCuts = bufferOf("cuts", data.cuts);
  static_assert(sizeof(shared::CutData) == shared::kCutTexels * sizeof(glm::vec4));
  mCutTexels = gpu::Texture::makeOfBuffer("cuts", gpu::Format::Rgba32f, mCuts);
  bool hasGrid = (data.params.flags & shared::kFlagCutGrid) != 0, hasSpares = !data.spares.isEmpty();
  bool isMade = mGridBox == data.params.sceneFromTex && mGridHasSpares == hasSpares && mGridCuts == data.cuts;
  if (hasGrid && isMade) return;
  mGridCuts = hasGrid ? data.cuts : std::vector<shared::CutData>{};
  mGridBox = data.params.sceneFromTex;
  mGridHasSpares = hasSpares;
  mCutGrid = bufferOf("grid of cuts",
                      hasGrid ? makeCutGrid(data.cuts, mGridBox, hasSpares).texels : std::vector<std::uint32_t>{});
}

void FrameInputs::writeParams(const FrameData& data, int sample) {
  shared::FrameParams params = data.params;
  setSample(params, data.frame, sample);
  mParams.set(params);
}

void FrameInputs::bind() const {
  mParams.bind(shared::kFrameBinding);
  mTransferTexels.bindSampler(shared::kTransferUnit);
  mExtinctionTexels.bindSampler(shared::kExtinctionUnit);
  mNoise.bindUniform(shared::kNoiseBinding);
  mCuts.bindStorage(shared::kCutBinding);
  mCutTexels.bindSampler(shared::kCutUnit);
  mCutGrid.bindStorage(shared::kCutGridBinding);
  mStructureTexels.bindSampler(shared::kStructureUnit);
  mSpareTexels.bindSampler(shared::kSpareUnit);
}

}  // namespace velum::render
