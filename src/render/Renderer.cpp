#include "velum/render/Renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <optional>

#include "BlueNoise.h"
#include "FrameSetup.h"
#include "TransferTable.h"
#include "VolumeUpload.h"
#include "passes/LightPass.h"
#include "passes/SkipPass.h"
#include "passes/SurfacePass.h"
#include "velum/gpu/Framebuffer.h"
#include "velum/gpu/Scope.h"

namespace velum::render {

namespace {

using Clock = std::chrono::steady_clock;
double msSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

constexpr int kQuickTexels = 96;  // along the longest side: under 30 ms on two cores

/// One piece of a frame's work, meant to take well under 50 ms; returns false when it wants to be called again.
struct Step {
  const char* pass;
  std::function<bool()> run;
};

/// What one ray met, from the texel that the ray caster writes.
struct Hit {
  bool found = false;
  glm::vec3 scenePoint{0.0f}, normal{0.0f};
  float distance = std::numeric_limits<float>::infinity();  ///< mm along the ray
  int structure = 0;
};

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
  for (auto& point : key.volume.transfer.colors) point.color = {};
  for (auto& structure : key.labels.structures) structure.color = {};
  for (auto& cut : key.cuts) cut.name.clear();
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

struct Renderer::Impl {
  explicit Impl(gpu::Context& c) : context(c), frameBlock("frame") {}

  gpu::Context& context;
  // The frame and its work.
  std::optional<Frame> wanted;  ///< As the caller gave it.
  Frame frame;                  ///< With the window filled in.
  std::deque<Step> steps;
  std::size_t stepCount = 0;
  Stats stats;
  std::map<std::string, double> passMs;
  // What frames are made from, kept while it fits.
  struct VolumeKey {
    std::uint64_t id = 0;
    int channel = 0, frame = 0;
    bool operator==(const VolumeKey&) const = default;
  } volumeKey, uploadKey;
  std::optional<GpuVolume> whole;
  std::unique_ptr<VolumeUpload> upload;
  VolumeKey quickKey;
  std::optional<GpuVolume> quick;  ///< A small copy of a volume, for previews until the whole is there.
  GpuVolume* volume = nullptr;     ///< The one that the frame draws.
  struct LabelKey {
    std::uint64_t id = 0, volume = 0;
    glm::ivec3 dims{0};  ///< of the grid
    bool operator==(const LabelKey&) const = default;
  } labelKey;
  std::optional<GpuLabels> labels;
  std::map<std::string, gpu::Program> rayPrograms;
  std::map<std::string, LightPass> lightPasses;
  std::optional<SkipPass> skip;
  std::optional<SurfacePass> surfaces;
  std::optional<gpu::Program> resolveProgram;
  LightPass* light = nullptr;
  std::optional<scene::Scene> skipScene;        ///< What the skip map was made for.
  std::optional<scene::Scene> extinctionScene;  ///< What the light grid's material was made for.
  glm::dvec3 lightDirection{0.0};
  glm::dvec4 lightOptions{0.0};
  bool hasOpenness = false;  ///< The light grid's openness is complete for extinctionScene and lightOptions.
  // What a frame binds.
  gpu::UniformBuffer<shared::FrameParams> frameBlock;
  FrameGrid grid;
  shared::FrameParams params{};
  gpu::Texture transferTexture, extinctionTexture, gradientTable, noise, emptyVolume, emptyLabels;
  gpu::Buffer cutBuffer, structureBuffer, exemptBuffer, emptyCells;
  gpu::Program* rayProgram = nullptr;
  // Pictures.
  gpu::Texture sum, hits, picture;
  gpu::Framebuffer pictureTarget;
  int currentSample = 0;  ///< The sample being drawn.
  int rowsDone = 0;       ///< Rows of it that are complete.
  // What was shown before this frame had anything to show.
  gpu::Texture stale;
  gpu::Framebuffer staleTarget;

  void begin(const Frame& next);
  void addUploadSteps();
  void addLightSteps();
  void keepLight();
  GpuVolume* drawnVolume();
  void addTileSteps();
  void castTile(glm::ivec4 rect);
  Hit hitAt(glm::ivec2 pixel, glm::vec4 texel) const;
  void setup();
  void bindAll();
  void resizePictures(glm::ivec2 size);
  void resolve();
  int lightCells() const { return context.limits().isSoftware ? 96 : 160; }
  glm::mat4 sceneFromTex() const {
    glm::dmat4 m = grid.worldFromTex;
    m[3] -= glm::dvec4(sceneOrigin(grid), 0.0);
    return glm::mat4(m);
  }
};

Renderer::Renderer(gpu::Context& context) : mImpl(std::make_unique<Impl>(context)) {
  mImpl->stats.renderer = context.limits().renderer;
}
Renderer::~Renderer() = default;

const Stats& Renderer::stats() const { return mImpl->stats; }

double Renderer::fractionDone() const {
  const Impl& m = *mImpl;
  return m.stepCount ? 1.0 - double(m.steps.size()) / double(m.stepCount) : 1.0;
}

void Renderer::clear() {
  gpu::Context& context = mImpl->context;
  Stats stats = mImpl->stats;
  mImpl = std::make_unique<Impl>(context);
  mImpl->stats = stats;
}

void Renderer::Impl::begin(const Frame& next) {
  wanted = next;
  frame = next;
  if (frame.windowSize == glm::ivec2(0)) frame.windowSize = frame.pictureSize;
  frame.windowSize = glm::max(frame.windowSize, glm::ivec2(1));
  frame.pictureSize = glm::max(frame.pictureSize, glm::ivec2(1));
  steps.clear();
  passMs.clear();
  stats.frameMs = 0;
  stats.longestStepMs = 0;
  stats.samples = 0;
  currentSample = 0;
  rowsDone = 0;
  addUploadSteps();
  steps.push_back({"Setup", [this] {
                     setup();
                     addLightSteps();
                     addTileSteps();
                     stepCount = steps.size();
                     return true;
                   }});
  stepCount = steps.size();
}

void Renderer::Impl::addUploadSteps() {
  const auto& layer = frame.scene.volume;
  stats.reduction.clear();
  if (layer.data && layer.visible) {
    VolumeKey key{layer.data.id(), layer.channel, layer.frame};
    bool hasWhole = whole && key == volumeKey;
    if (!hasWhole && frame.isPreview) {
      if (quick && key == quickKey) return;
      volume = nullptr;
      quick.reset();
      steps.push_back({"Upload", [this, key] {
                         const auto& shown = frame.scene.volume;
                         VolumeUpload copy(shown.data, shown.channel, shown.frame, context.limits(), kQuickTexels);
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
        upload = std::make_unique<VolumeUpload>(layer.data, layer.channel, layer.frame, context.limits());
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

/// Fills everything small that the passes read: grid, tables, cuts, structures, frame parameters, skip map.
void Renderer::Impl::setup() {
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
  if (mode != 0) {
    LabelKey key{scene.labels.data.id(), hasVolume ? scene.volume.data.id() : 0, grid.dims};
    if (!labels || !(key == labelKey)) {
      labels.reset();
      labels = uploadLabels(*scene.labels.data, grid.cells, grid.dims, grid.worldFromTex, context.limits());
      labelKey = key;
    }
  }
  // Tables.
  TransferTable table = makeTransferTable(scene);
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
  auto cutData = makeCutData(scene, sceneOrigin(grid));
  auto rows = makeStructureRows(scene.labels);
  int words = 0;
  auto mask = makeExemptMask(scene, rows.size(), words);
  params = makeFrameParams(frame, grid, table);
  params.counts.x = int(cutData.size());
  if (!cutData.empty()) params.flags.x |= shared::kFlagCuts;
  if (frame.isPreview && (params.flags.x & shared::kFlagLightGrid)) keepLight();
  params.counts.y = words;
  params.counts.z = int(rows.size());
  if (!mask.empty() && mode != 0) params.flags.x |= shared::kFlagExemptions;
  if (cutData.empty()) cutData.emplace_back();
  if (mask.empty()) mask.push_back(0);
  cutBuffer = gpu::Buffer("cuts", std::span<const shared::CutData>(cutData));
  structureBuffer = gpu::Buffer("structures", std::span<const shared::StructureRow>(rows));
  exemptBuffer = gpu::Buffer("exemptions", std::span<const std::uint32_t>(mask));
  // Light grid size, needed by the parameters.
  int color = hasVolume && volume->isColor ? 1 : 0;
  int rayMode = hasVolume ? static_cast<int>(scene.rayCast.mode) : 0;
  int gradients = hasVolume && volume->gradient ? 1 : 0;
  std::string lightVariant = fmt::format("{}{}{}", rayMode, mode, color);
  std::string variant = fmt::format("{}{}", lightVariant, gradients);
  gpu::Defines defines{{"MODE", std::to_string(rayMode)},
                       {"LABELS", std::to_string(mode)},
                       {"COLOR", std::to_string(color)},
                       {"GRADIENTS", std::to_string(gradients)}};
  if (context.limits().isSoftware) {
    variant += fmt::format(" {}", params.flags.x);
    defines.push_back({"FLAGS", fmt::format("{}u", params.flags.x)});
  }
  if (!rayPrograms.contains(variant)) rayPrograms.emplace(variant, gpu::Program({"render/ray_cast.comp"}, defines));
  rayProgram = &rayPrograms.at(variant);
  if (!lightPasses.contains(lightVariant))
    lightPasses.emplace(std::piecewise_construct, std::forward_as_tuple(lightVariant),
                        std::forward_as_tuple(mode, color, rayMode));
  if (light != &lightPasses.at(lightVariant)) extinctionScene.reset();
  light = &lightPasses.at(lightVariant);
  glm::dmat3 edges(grid.worldFromTex);
  glm::ivec3 before = light->size();
  light->resize({glm::length(edges[0]), glm::length(edges[1]), glm::length(edges[2])}, lightCells());
  if (light->size() != before) extinctionScene.reset();
  params.lightGrid = glm::vec4(glm::vec3(light->size()), float(light->cellMm()));
  resizePictures(frame.windowSize);
  if (!skip) skip.emplace();
  if (!surfaces) surfaces.emplace();
  frameBlock.set(params);
  bindAll();
  // Empty space.
  SkipOptions options;
  options.content = mode == 2      ? SkipOptions::Content::Labels
                    : rayMode == 2 ? SkipOptions::Content::Iso
                                   : SkipOptions::Content::Opacity;
  options.hasLabels = mode != 0;
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
  (mode != 0 ? labels->texture : emptyLabels).bindSampler(shared::kLabelUnit);
  noise.bindSampler(shared::kNoiseUnit);
  light->map().bindSampler(shared::kLightUnit);
  if (skip->map()) skip->map().bindSampler(shared::kSkipUnit);
  cutBuffer.bindStorage(shared::kCutBinding);
  structureBuffer.bindStorage(shared::kStructureBinding);
  exemptBuffer.bindStorage(shared::kExemptBinding);
  (hasVolume ? volume->cellRange : emptyCells).bindStorage(shared::kCellBinding);
  (mode != 0 ? labels->cellLabels : emptyCells).bindStorage(shared::kCellLabelBinding);
}

/// The light stays where it stood in the world when the light grid was made; without a grid that fits there is none.
void Renderer::Impl::keepLight() {
  bool fits = extinctionScene && lightDirection != glm::dvec3(0.0) && *extinctionScene == materialKey(frame.scene);
  if (fits)
    params.key = glm::vec4(glm::vec3(lightDirection), params.key.w);
  else
    params.flags.x &= ~shared::kFlagLightGrid;
}

GpuVolume* Renderer::Impl::drawnVolume() {
  const auto& layer = frame.scene.volume;
  if (!layer.data || !layer.visible) return nullptr;
  VolumeKey key{layer.data.id(), layer.channel, layer.frame};
  if (whole && key == volumeKey) return &*whole;
  return quick && key == quickKey ? &*quick : nullptr;
}

void Renderer::Impl::addLightSteps() {
  const auto& lighting = frame.scene.lighting;
  if (!lighting.shaded || (lighting.shadow <= 0 && lighting.occlusion <= 0) || frame.isPreview) return;
  scene::Scene key = materialKey(frame.scene);
  glm::dvec3 direction(glm::vec3(params.key));
  glm::dvec4 options(lighting.shadow > 0, lighting.occlusion > 0, lighting.occlusionRadius, 0);
  bool sameMaterial = extinctionScene && *extinctionScene == key;
  bool sameLight = sameMaterial && glm::length(direction - lightDirection) < 1e-6 && options == lightOptions;
  if (sameLight) return;
  bool keepOpenness = sameMaterial && hasOpenness && options == lightOptions;
  hasOpenness = keepOpenness;
  lightDirection = glm::dvec3(0.0);  // a frame that is given up half way leaves a grid that serves no direction
  constexpr int kLayers = 4;
  glm::mat4 fromTex = sceneFromTex();
  if (!sameMaterial) {
    extinctionScene.reset();
    for (int z = 0; z < light->size().z; z += kLayers)
      steps.push_back({"Light", [this, z, fromTex] {
                         light->extinction(z, std::min(light->size().z, z + kLayers), fromTex);
                         return true;
                       }});
  }
  glm::dmat3 texFromDirection(glm::inverse(glm::dmat3(glm::mat3(fromTex))));
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
                     extinctionScene = key;
                     hasOpenness = true;
                     lightDirection = direction;
                     lightOptions = options;
                     return true;
                   }});
}

void Renderer::Impl::castTile(glm::ivec4 rect) {
  sum.bindImage(0, gpu::Access::ReadWrite);
  hits.bindImage(1, gpu::Access::Write);
  glm::ivec2 groups = (glm::ivec2(rect.z, rect.w) + shared::kTileGroup - 1) / shared::kTileGroup;
  // Near the golden section of their number, and with no common factor: any run of groups is spread over the tile.
  int count = groups.x * groups.y, stride = std::max(1, int(0.618 * count));
  while (std::gcd(stride, count) != 1) ++stride;
  rayProgram->set(0, rect);
  rayProgram->set(1, glm::ivec4(frame.windowOrigin, stride, 0));
  gpu::dispatch(*rayProgram, glm::ivec3(groups, 1));
  gpu::barrier();
}

void Renderer::Impl::addTileSteps() {
  const int tile = context.limits().isSoftware ? 64 : 512;
  glm::ivec2 size = frame.windowSize;
  // Where neither the volume's box nor a surface can be, rays have nothing to do.
  glm::ivec4 covered = frame.scene.surfaces.empty() ? coveredRect(params, frame) : glm::ivec4(0, 0, size);
  for (int sample = 0; sample < std::max(1, frame.scene.rayCast.samplesPerPixel); ++sample) {
    steps.push_back({"Surfaces", [this, sample, size] {
                       currentSample = sample;
                       rowsDone = 0;
                       if (sample == 0) sum.clear(), hits.clear();
                       setSample(params, frame, sample);
                       frameBlock.set(params);
                       surfaces->draw(frame.scene, sceneOrigin(grid), grid.worldFromTex, size);
                       surfaces->bind();
                       return true;
                     }});
    for (int y = covered.y; y < covered.y + covered.w; y += tile)
      for (int x = covered.x; x < covered.x + covered.z; x += tile) {
        glm::ivec4 rect(x, y, std::min(tile, covered.x + covered.z - x), std::min(tile, covered.y + covered.w - y));
        bool lastOfRow = x + tile >= covered.x + covered.z;
        steps.push_back({"RayCast", [this, rect, lastOfRow] {
                           castTile(rect);
                           if (lastOfRow) rowsDone = rect.y + rect.w;
                           return true;
                         }});
      }
    steps.push_back({"RayCast", [this, sample] {
                       stats.samples = sample + 1;
                       return true;
                     }});
  }
}

void Renderer::Impl::resizePictures(glm::ivec2 size) {
  if (sum && glm::ivec2(sum.size()) == size) return;
  sum = gpu::Texture::make2d("sum of samples", gpu::Format::Rgba32f, size);
  hits = gpu::Texture::make2d("distance, normal, structure", gpu::Format::Rgba32f, size);
  picture = gpu::Texture::make2d("picture", gpu::Format::Rgba8, size, gpu::Filter::Linear);
  pictureTarget = gpu::Framebuffer("picture", {&picture});
  sum.clear();
}

bool Renderer::work(const Frame& frame, double budgetMs) {
  Impl& m = *mImpl;
  auto start = Clock::now();
  if (!m.wanted || !(*m.wanted == frame)) m.begin(frame);
  if (m.steps.empty()) return true;
  if (m.rayProgram && m.steps.front().pass[0] != 'U' && m.steps.front().pass[0] != 'S') {
    m.bindAll();
    m.surfaces->bind();
  }
  do {
    auto stepStart = Clock::now();
    Step step = m.steps.front();
    gpu::Scope scope(nullptr, step.pass);
    bool done = step.run();
    gpu::finish();
    double ms = msSince(stepStart);
    m.passMs[step.pass] += ms;
    if (std::string_view(step.pass) == "Upload")
      m.stats.uploadMs += ms;
    else
      m.stats.frameMs += ms;
    m.stats.longestStepMs = std::max(m.stats.longestStepMs, ms);
    if (done) m.steps.pop_front();
  } while (!m.steps.empty() && msSince(start) < budgetMs);
  if (m.steps.empty()) m.stats.passesMs = m.passMs;
  return m.steps.empty();
}

void Renderer::render(const Frame& frame, Progress& progress) {
  while (!work(frame, 100.0)) progress.report(fractionDone(), "rendering");
}

void Renderer::Impl::resolve() {
  if (!resolveProgram) resolveProgram.emplace(gpu::Program({"render/resolve.comp"}));
  const auto& background = frame.scene.background;
  frameBlock.bind(shared::kFrameBinding);
  sum.bindImage(0, gpu::Access::Read);
  picture.bindImage(1, gpu::Access::Write);
  bool complete = steps.empty();
  resolveProgram->set(
      0, glm::ivec4(frame.windowOrigin, complete ? stats.samples : currentSample, complete ? 0 : rowsDone));
  float backdrop = background.transparent ? 0.0f : 1.0f;
  resolveProgram->set(1, glm::vec4(background.top, backdrop));
  resolveProgram->set(2, glm::vec4(background.bottom, backdrop));
  gpu::dispatch(*resolveProgram, {(frame.windowSize.x + 7) / 8, (frame.windowSize.y + 7) / 8, 1});
  gpu::barrier();
}

void Renderer::present(unsigned framebuffer, glm::ivec2 size) {
  Impl& m = *mImpl;
  if (!m.sum || !m.rayProgram) return;
  m.resolve();
  gpu::present(m.pictureTarget, framebuffer, size);
}

/// @param pixel  of the window
Hit Renderer::Impl::hitAt(glm::ivec2 pixel, glm::vec4 texel) const {
  Hit hit;
  if (texel.w < 0.5f) return hit;
  hit.found = true;
  hit.distance = texel.x;
  hit.scenePoint = pointOnRay(params, pixel + frame.windowOrigin, hit.distance);
  // Octahedral: the square's corners are the lower half, folded out.
  glm::vec3 n(texel.y, texel.z, 1.0f - std::abs(texel.y) - std::abs(texel.z));
  if (n.z < 0) {
    glm::vec2 folded = 1.0f - glm::abs(glm::vec2(n.y, n.x));
    n.x = std::copysign(folded.x, n.x);
    n.y = std::copysign(folded.y, n.y);
  }
  hit.normal = glm::normalize(n);
  hit.structure = int(texel.w - 0.5f);
  return hit;
}

Image Renderer::read(const Layers& layers) {
  Impl& m = *mImpl;
  Image image;
  if (!m.sum) return image;
  m.resolve();
  glm::ivec2 size = m.frame.windowSize;
  image.width = size.x;
  image.height = size.y;
  image.channels = {"R", "G", "B", "A"};
  if (layers.position) image.channels.insert(image.channels.end(), {"position.X", "position.Y", "position.Z"});
  if (layers.normal) image.channels.insert(image.channels.end(), {"normal.X", "normal.Y", "normal.Z"});
  if (layers.depth) image.channels.push_back("Z");
  if (layers.structure) image.channels.push_back("id");
  std::size_t count = std::size_t(size.x) * std::size_t(size.y), channels = image.channels.size();
  image.pixels.resize(count * channels);
  std::vector<glm::u8vec4> color(count);
  std::vector<glm::vec4> hits(count);
  m.picture.read(color.data(), count * sizeof(color[0]));
  if (channels > 4) m.hits.read(hits.data(), count * sizeof(hits[0]));
  glm::dvec3 origin = sceneOrigin(m.grid);
  for (std::size_t i = 0; i < count; ++i) {
    float* out = &image.pixels[i * channels];
    float alpha = float(color[i].a) / 255.0f;
    for (int c = 0; c < 3; ++c) *out++ = alpha > 0.0f ? std::min(1.0f, float(color[i][c]) / 255.0f / alpha) : 0.0f;
    *out++ = alpha;
    if (channels == 4) continue;
    Hit hit = m.hitAt({int(i) % size.x, int(i) / size.x}, hits[i]);
    if (layers.position)
      for (int c = 0; c < 3; ++c) *out++ = hit.found ? float(double(hit.scenePoint[c]) + origin[c]) : 0.0f;
    if (layers.normal)
      for (int c = 0; c < 3; ++c) *out++ = hit.normal[c];
    if (layers.depth) *out++ = hit.distance;
    if (layers.structure) *out++ = float(hit.structure);
  }
  return image;
}

Pick Renderer::pick(glm::ivec2 pixel) const {
  const Impl& m = *mImpl;
  Pick pick;
  if (!m.hits || pixel.x < 0 || pixel.y < 0 || pixel.x >= m.frame.windowSize.x || pixel.y >= m.frame.windowSize.y)
    return pick;
  glm::vec4 texel;
  m.hits.read({pixel, 0}, {1, 1, 1}, &texel, sizeof(texel));
  Hit hit = m.hitAt(pixel, texel);
  if (!hit.found) return pick;
  pick.hit = true;
  pick.worldMm = glm::dvec3(hit.scenePoint) + sceneOrigin(m.grid);
  pick.normal = hit.normal;
  pick.structure = hit.structure;
  if (const auto& data = m.frame.scene.volume.data) {
    glm::dvec3 voxel(glm::inverse(data->worldFromVoxel) * glm::dvec4(pick.worldMm, 1.0));
    glm::ivec3 nearest = glm::clamp(glm::ivec3(glm::floor(voxel + 0.5)), glm::ivec3(0), data->dims - 1);
    pick.value = valueAt(*data, nearest, m.frame.scene.volume.channel, m.frame.scene.volume.frame);
  }
  return pick;
}

Image renderPicture(Renderer& renderer, const Frame& frame, const Layers& layers, int largestWindow,
                    Progress& progress) {
  Image whole;
  glm::ivec2 size = frame.pictureSize;
  int columns = (size.x + largestWindow - 1) / largestWindow, rows = (size.y + largestWindow - 1) / largestWindow;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      Frame part = frame;
      part.windowOrigin = glm::ivec2(column, row) * largestWindow;
      part.windowSize = glm::min(size - part.windowOrigin, glm::ivec2(largestWindow));
      renderer.render(part, progress);
      Image image = renderer.read(layers);
      if (columns * rows == 1) return image;
      if (whole.pixels.empty()) {
        whole = {size.x, size.y, image.channels, {}};
        whole.pixels.resize(std::size_t(size.x) * std::size_t(size.y) * image.channels.size());
      }
      std::size_t rowFloats = std::size_t(image.width) * image.channels.size();
      for (int y = 0; y < image.height; ++y)
        std::copy_n(image.pixels.begin() + std::ptrdiff_t(std::size_t(y) * rowFloats), rowFloats,
                    whole.pixels.begin() + std::ptrdiff_t((std::size_t(y + part.windowOrigin.y) * std::size_t(size.x) +
                                                           std::size_t(part.windowOrigin.x)) *
                                                          image.channels.size()));
    }
  return whole;
}

}  // namespace velum::render
