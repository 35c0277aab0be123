#include "session/plate/Plate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/FileName.h"
#include "core/ImageChannels.h"
#include "core/Memory.h"
#include "render/RenderPicture.h"
#include "scene/Finishes.h"
#include "session/document/Open.h"
#include "session/lettering/Lettering.h"
#include "session/model/TrueLevels.h"
#include "session/plate/ModelLines.h"
#include "session/plate/PlateLines.h"
#include "vector/WritePdf.h"
#include "vector/WriteSvg.h"

namespace velum::session {

namespace {

constexpr double kUsualDpi = 300.0, kInch = 25.4;  // mm
constexpr double kUnseen = 1e-6;

vector::Layer plateLayer(std::string name, Image image) {
  glm::dvec2 size(image.width, image.height);
  return {std::move(name), {vector::Plate{Shared<Image>(std::move(image)), {0, 0}, size}}};
}

/// What is behind the picture: the scene's paper or background, with nothing before it. One rectangle where it has one
/// colour.
vector::Layer paperLayer(render::Renderer& renderer, render::Frame frame, int window, Progress& progress) {
  frame.scene.volume.visible = frame.scene.labels.visible = frame.scene.model.visible = false;
  frame.scene.surfaces.clear();
  frame.scene.cuts.clear();
  frame.scene.showBounds = false;
  frame.scene.background.transparent = false;
  Image image = channelsOf(render::renderPicture(renderer, frame, {}, window, progress), {"R", "G", "B"});
  const std::vector<float>& pixels = image.pixels;
  bool isPlain = true;
  for (std::size_t i = 3; i < pixels.size() && isPlain; ++i) isPlain = pixels[i] == pixels[i % 3];
  if (!isPlain) return plateLayer("paper", std::move(image));
  vector::Fill fill{glm::vec3(pixels[0], pixels[1], pixels[2]), 1.0};
  glm::dvec2 size(frame.pictureSize);
  return {"paper", {vector::Shape{"paper", {vector::rectangle({0, 0}, size, 0.0)}, {}, fill}}};
}

void addLayers(vector::Drawing& drawing, std::vector<vector::Layer> layers) {
  for (vector::Layer& layer : layers)
    if (!layer.items.empty()) drawing.layers.push_back(std::move(layer));
}

}  // namespace

double plateDpi(const scene::Scene& scene, const PictureOptions& options) {
  if (options.dpi > 0.0) return options.dpi;
  double width = scene.lettering.pageWidth;
  return width > 0.0 ? options.size.x / width * kInch : kUsualDpi;
}

vector::Drawing drawPlate(render::Renderer& renderer, const scene::Scene& scene, const PictureOptions& options,
                          const gpu::Limits& limits, Progress& progress) {
  render::Frame frame;
  frame.scene = sceneForPicture(scene, options);
  TrueLevels().give(frame.scene.model, progress);
  frame.pictureSize = options.size;
  frame.brickBytes = memoryBudget().gpuBrickBytes;
  int window = std::min(4096, limits.texture2d);
  vector::Drawing drawing{glm::dvec2(options.size), plateDpi(scene, options), {}, {}};
  if (!frame.scene.background.transparent) drawing.layers.push_back(paperLayer(renderer, frame, window, progress));
  // What becomes lines is not drawn in pixels, too.
  scene::Scene lined = frame.scene;
  bool isForModel = scene::drawsModelAlone(lined);
  frame.scene.finish.hatching = 0.0;
  // A finish calms specks of models: it is there, and draws nothing.
  bool isCalmed = isForModel && (lined.finish.contours > 0.0 || lined.finish.hatching > 0.0);
  frame.scene.finish.contours = isCalmed ? kUnseen : 0.0;
  frame.scene.finish.paper = scene::Paper::None;
  frame.scene.background.transparent = true;
  Image image =
      render::renderPicture(renderer, frame, withLetteringLayers(plateLayers(lined), lined), window, progress);
  drawing.layers.push_back(plateLayer("plate", channelsOf(image, {"R", "G", "B", "A"})));
  Image unlit;
  bool hasSpheres = lined.finish.hatching > 0.0 && lined.finish.litSphere > 0.0;
  if (hasSpheres) {
    frame.scene.finish.litSphere = 0.0;
    unlit = render::renderPicture(renderer, frame, {}, window, progress);
  }
  Image lines;
  if (isForModel) {
    frame.scene = sceneOfLines(std::move(frame.scene));
    lines = render::renderPicture(renderer, frame, {.lines = true}, window, progress);
  }
  addLayers(drawing, tracedLines({image, hasSpheres ? unlit : image, lines}, lined, progress));
  addLayers(drawing, layersOf(letteringBlocks(lined, options.size, seenIn(image, lined, progress))));
  return drawing;
}

vector::Drawing drawSectionPlate(const scene::Scene& scene, scene::SectionKind kind, const PictureOptions& options,
                                 Progress& progress) {
  scene::SectionPlane plane = scene::makeSectionPlane(scene, kind, glm::dvec2(options.size));
  render::SectionImage section = render::drawSection(sceneForPicture(scene, options), plane);
  vector::Drawing drawing{glm::dvec2(options.size), plateDpi(scene, options), {}, {}};
  std::vector<std::string> color{"R", "G", "B"};
  if (options.transparent) color.push_back("A");
  drawing.layers.push_back(plateLayer("plate", channelsOf(imageOf(section), color)));
  scene::Scene lettered = sceneForPicture(scene, options);
  Seen seen = seenInSection(section, plane, lettered, progress);
  addLayers(drawing, layersOf(letteringBlocks(lettered, kind, options.size, seen)));
  return drawing;
}

void savePlate(const vector::Drawing& drawing, const scene::Scene& scene, const PictureOptions& options,
               const std::filesystem::path& path) {
  std::string text = sceneTextFor(sceneForPicture(scene, options), path);
  if (lowerExtension(path) == ".svg") return vector::writeSvg(drawing, path, text);
  vector::writePdf(drawing, path, text);
}

}  // namespace velum::session
