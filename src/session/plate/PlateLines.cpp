#include "session/plate/PlateLines.h"
#include "scene/Finishes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "core/ImageChannels.h"
#include "scene/Finishes.h"
#include "scene/Project.h"
#include "scene/SectionPlane.h"
#include "session/plate/ModelLines.h"
#include "session/plate/Owners.h"
#include "vector/TraceHatching.h"
#include "vector/TraceRegions.h"
#include "vector/TraceSteps.h"

namespace velum::session {

namespace {

constexpr double kRowsOfFinish = 1000.0;  // of the picture whose pixels the finish's lengths are in
constexpr double kStepVoxels = 2.5;       // a jump of depth that has a line
constexpr double kStepOfModel = 20.0;     // the same, of molecules, angstrom
constexpr double kThinnest = 0.35;        // of a line, for strokes that hardly count
constexpr double kFinestHatching = 3.0;   // pixels

/// What a picture shows, channel by channel.
class SeenPixels {
 public:
  SeenPixels(const Image& image, const scene::Scene& scene) : mImage(image), size(image.width, image.height) {
    std::size_t channels = image.channels.size();
    std::map<std::tuple<int, int>, int> known;
    const int alpha = of("A"), depth = of("Z"), id = of("id"), instance = of("instance"), type = of("type"),
              face = of("face"), normal = of("normal.X");
    for (std::size_t i = 0; i < image.pixels.size(); i += channels) {
      const float* pixel = &image.pixels[i];
      auto at = [&](int channel, float none) { return channel < 0 ? none : pixel[channel]; };
      bool isSeen = std::isfinite(pixel[depth]);
      int& region = ids.emplace_back(0);
      if (isSeen) {
        auto key = std::tuple(int(at(id, 0.0f)), int(at(instance, 0.0f)));
        bool parts = scene.finish.contourStructures > 0.0;
        auto [found, isNew] = known.try_emplace(parts ? key : std::tuple(0, 0), int(owners.size()) + 1);
        if (isNew) owners.push_back(parts ? ownerOf(scene, std::get<0>(key), int(at(type, -1.0f))) : Owner{});
        region = found->second;
      }
      faces.push_back(isSeen ? int(at(face, 0.0f)) : 0);
      distances.push_back(isSeen ? pixel[depth] : std::numeric_limits<float>::infinity());
      normals.emplace_back(normal < 0 ? glm::vec3(0, 0, 1)
                                      : glm::vec3(pixel[normal], pixel[normal + 1], pixel[normal + 2]));
      opacities.push_back(at(alpha, 1.0f));
    }
  }
  vector::SurfaceMap surfaces() const { return {size, ids, distances, normals, opacities}; }

 private:
  int of(const char* channel) const { return channelIndex(mImage, channel); }

  const Image& mImage;

 public:
  glm::ivec2 size;
  std::vector<int> ids;       ///< of regions, from 1; 0: nothing
  std::vector<Owner> owners;  ///< of regions, by id - 1
  std::vector<int> faces;     ///< of cuts, from 1
  std::vector<float> distances, opacities;
  std::vector<glm::vec3> normals;
};

std::vector<float> tonesOf(const Image& image) {
  const int red = channelIndex(image, "R"), green = channelIndex(image, "G"), blue = channelIndex(image, "B");
  std::vector<float> tones;
  for (std::size_t i = 0; i < image.pixels.size(); i += image.channels.size())
    tones.push_back(0.30f * image.pixels[i + std::size_t(red)] + 0.59f * image.pixels[i + std::size_t(green)] +
                    0.11f * image.pixels[i + std::size_t(blue)]);
  return tones;
}

vector::View viewOf(const scene::Camera& camera) {
  scene::CameraBasis basis = scene::cameraBasis(camera);
  return {camera.projection == scene::Projection::Orthographic, basis.right, basis.up, basis.forward,
          scene::halfPictureHeight(camera)};
}

double stepLengthOf(const scene::Scene& scene) {
  if (scene.volume.data || scene.labels.data) return kStepVoxels * scene::sectionStep(scene);
  return kStepOfModel * unitsPer(LengthUnit::Angstrom, scene.unit);
}

double pixelsOf(double length, const SeenPixels& seen) { return length * seen.size.y / kRowsOfFinish; }

/// The outlines of regions, those of one owner together. @param owners  by id - 1
std::vector<vector::Item> outlinesOf(const SeenPixels& seen, std::span<const int> ids, std::span<const Owner> owners,
                                     const vector::Pen& pen, Progress& progress) {
  vector::RegionMap map = vector::traceRegions({seen.size, ids, {}}, {}, progress);
  std::map<Owner, vector::Shape> byOwner;
  auto shapeOf = [&](int id) -> vector::Shape& {
    const Owner& owner = owners[std::size_t(id) - 1];
    return byOwner.try_emplace(owner, vector::Shape{owner.name, {}, pen, {}, owner.group}).first->second;
  };
  // What goes beyond the picture has no line along the picture's edge, and is open there.
  std::set<int> beyond;
  for (const vector::Border& border : map.borders)
    for (int id : {border.left, border.right})
      if (id > 0 && (border.left == vector::kOutside || border.right == vector::kOutside)) beyond.insert(id);
  for (const vector::Border& border : map.borders)
    for (int id : {border.left, border.right})
      if (beyond.contains(id) && border.left != vector::kOutside && border.right != vector::kOutside)
        shapeOf(id).outlines.push_back(border.line);
  for (vector::Region& region : map.regions)
    if (!beyond.contains(region.id))
      std::ranges::move(region.outlines, std::back_inserter(shapeOf(region.id).outlines));
  std::vector<vector::Item> items;
  for (auto& [owner, shape] : byOwner) items.emplace_back(std::move(shape));
  return items;
}

std::vector<vector::Item> hatchingOf(const SeenPixels& seen, const Image& unlit, const scene::Scene& scene,
                                     Progress& progress) {
  const scene::Finish& finish = scene.finish;
  double spacing = std::max(kFinestHatching, pixelsOf(finish.hatchWidth, seen));
  vector::Pen pen{finish.contourColor, 1.0, finish.hatching, {}};
  auto strokes =
      vector::traceHatching(seen.surfaces(), viewOf(scene.camera), tonesOf(unlit), {spacing, true}, progress);
  return itemsOf(std::move(strokes), seen.owners, pen, spacing, 0.3);
}

std::vector<vector::Item> contoursOf(const SeenPixels& seen, const scene::Scene& scene, const vector::Pen& pen,
                                     Progress& progress) {
  const scene::Finish& finish = scene.finish;
  vector::StepOptions steps{finish.contourSteps, finish.contourCreases, pen.width, stepLengthOf(scene)};
  auto strokes = vector::traceSteps(seen.surfaces(), viewOf(scene.camera), steps, progress);
  std::vector<vector::Item> items = itemsOf(std::move(strokes), seen.owners, pen, pen.width, kThinnest * pen.width);
  std::ranges::move(outlinesOf(seen, seen.ids, seen.owners, pen, progress), std::back_inserter(items));
  // Those of a compartment, a structure or a type lie together.
  std::ranges::stable_sort(items, {}, [](const vector::Item& item) {
    const auto& shape = std::get<vector::Shape>(item);
    return std::pair(shape.group, shape.name);
  });
  return items;
}

/// Whether what nobody sees is small enough to be there all the same.
bool isSmall(const vector::Layer& layer) {
  constexpr std::size_t kMostCurves = 40'000;  // of some 40 bytes each in an SVG
  std::size_t curves = 0;
  for (const vector::Item& item : layer.items)
    for (const vector::Outline& outline : std::get<vector::Shape>(item).outlines) curves += outline.curves.size();
  return curves <= kMostCurves;
}

}  // namespace

render::Layers plateLayers(const scene::Scene& scene) {
  render::Layers layers;
  bool isForModel = scene::drawsModelAlone(scene), hasLines = !isForModel || scene.finish.hatching > 0.0;
  layers.depth = layers.structure = layers.instance = layers.normal = hasLines;
  layers.face = hasLines && !scene.cuts.empty();
  layers.type = bool(scene.model.data) && hasLines;
  return layers;
}

scene::Scene sceneOfLines(scene::Scene scene) {
  scene.finish.contours = 1.0;
  scene.finish.hatching = scene.finish.litSphere = 0.0;
  scene.rayCast.samplesPerPixel = 1;
  return scene;
}

std::vector<vector::Layer> tracedLines(const PlateImages& images, scene::Scene scene, Progress& progress) {
  progress.report(0.8, "Tracing lines");
  bool isForModel = scene::drawsModelAlone(scene), isHidden = scene.finish.contours <= 0.0;
  if (isHidden) scene.finish.contours = 1.0;
  const scene::Finish& finish = scene.finish;
  std::optional<SeenPixels> seen;
  if (!isForModel || finish.hatching > 0.0) seen.emplace(images.picture, scene);
  std::vector<vector::Layer> layers;
  if (finish.hatching > 0.0) layers.push_back({"hatching", hatchingOf(*seen, images.unlit, scene, progress)});
  if (isForModel) {
    layers.push_back({"contours", modelContours(images.lines, scene, progress), isHidden});
  } else {
    vector::Pen pen{finish.contourColor, pixelsOf(finish.contourWidth, *seen), finish.contours, {}};
    layers.push_back({"contours", contoursOf(*seen, scene, pen, progress), isHidden});
    std::vector<Owner> cuts;
    for (const scene::Cut& cut : scene.cuts) cuts.push_back({"", cut.name});
    if (!cuts.empty()) layers.push_back({"cut lines", outlinesOf(*seen, seen->faces, cuts, pen, progress), isHidden});
  }
  std::erase_if(layers, [](const vector::Layer& layer) { return layer.isHidden && !isSmall(layer); });
  return layers;
}

}  // namespace velum::session
