#pragma once
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "FrameSetup.h"
#include "passes/LightPass.h"
#include "passes/SkipPass.h"
#include "passes/SurfacePass.h"
#include "upload/CutSheets.h"
#include "upload/LabelUpload.h"
#include "upload/VolumeUpload.h"
#include "velum/gpu/Framebuffer.h"
#include "velum/render/Renderer.h"

namespace velum::render {

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

/// What the renderer keeps between frames, and the work of the frame in hand. RendererSetup.cpp fills it for a frame,
/// Renderer.cpp draws and reads.
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
    std::vector<scene::ChannelLook> looks;  ///< Of the channels that are mixed: then their looks are in the texels.
    bool operator==(const VolumeKey&) const = default;
  } volumeKey, uploadKey;
  std::optional<GpuVolume> whole;
  std::unique_ptr<VolumeUpload> upload;
  VolumeKey quickKey;
  std::optional<GpuVolume> quick;  ///< A small copy of a volume, for previews until the whole is there.
  GpuVolume* volume = nullptr;     ///< The one that the frame draws.
  LabelUpload labels{context.limits()};
  std::map<std::string, gpu::Program> rayPrograms;
  std::map<std::string, LightPass> lightPasses;
  std::optional<SkipPass> skip;
  std::optional<SurfacePass> surfaces;
  std::optional<gpu::Program> resolveProgram;
  LightPass* light = nullptr;
  std::optional<scene::Scene> skipScene;  ///< What the skip map was made for.
  /// All that the light grid's material depends on.
  struct MaterialKey {
    scene::Scene scene;
    std::map<int, FrameSheet> sheets;
    bool operator==(const MaterialKey&) const = default;
  };
  std::optional<MaterialKey> extinctionKey;  ///< What the light grid's material was made for.
  glm::dvec3 lightDirection{0.0};
  glm::dvec4 lightOptions{0.0};
  bool hasOpenness = false;  ///< The light grid's openness is complete for extinctionKey and lightOptions.
  // What a frame binds.
  gpu::UniformBuffer<shared::FrameParams> frameBlock;
  FrameGrid grid;
  shared::FrameParams params{};
  gpu::Texture transferTexture, extinctionTexture, gradientTable, noise, emptyVolume, emptyLabels;
  gpu::Buffer cutBuffer, structureBuffer, exemptBuffer, emptyCells;
  CutSheets sheets;
  gpu::Program* rayProgram = nullptr;
  // Pictures.
  gpu::Texture sum, hits, picture;
  gpu::Framebuffer pictureTarget;
  int currentSample = 0;  ///< The sample being drawn.
  int rowsDone = 0;       ///< Rows of it that are complete.
  glm::ivec3 part{0};     ///< First and past the last row of the strip of tiles in work, and the columns done of it.
  int tileSize = firstTileSize();  ///< Pixels along an edge.
  double longestTileMs = 0;        ///< Of the pictures since it was chosen.
  // What was shown before this frame had anything to show.
  gpu::Texture stale;
  gpu::Framebuffer staleTarget;

  VolumeKey volumeKeyOf(const scene::VolumeLayer& layer) const;
  void begin(const Frame& next);
  void addUploadSteps();
  void addLightSteps();
  void keepLight();
  MaterialKey materialKeyOf(const Frame& frame) const;
  GpuVolume* drawnVolume();
  int firstTileSize() const { return context.limits().isSoftware ? 64 : 512; }
  void adaptTileSize();
  void addTileSteps();
  void castTile(glm::ivec4 rect);
  Hit hitAt(glm::ivec2 pixel, glm::vec4 texel) const;
  void setup();
  void prepareGrid();
  void writeTables(const TransferTable& table);
  void prepareParams(const TransferTable& table);
  void choosePrograms();
  void updateSkipMap();
  void bindAll();
  void resizePictures(glm::ivec2 size);
  void resolve();
  int lightCells() const { return context.limits().isSoftware ? 96 : 160; }
};

}  // namespace velum::render
