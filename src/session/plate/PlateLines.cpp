#include "session/plate/PlateLines.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <span>
#include <string>
#include <tuple>

#include "core/ImageChannels.h"
#include "scene/Project.h"
#include "scene/Scene.h"
#include "scene/SectionPlane.h"
#include "session/structure/StructureEdit.h"
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
  SeenPixels(const Image& image, const scene::Scene& scene)
      : mImage(image), mScene(scene), size(image.width, image.height) {
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
        auto [found, isNew] = known.try_emplace(parts ? key : std::tuple(0, 0), int(names.size()) + 1);
        if (isNew) names.push_back(parts ? nameOf(std::get<0>(key), int(at(type, -1.0f))) : "");
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
  std::string nameOf(int structure, int type) const {
    if (structure > 0 && type < 0) return structureName(mScene, structure);
    if (type < 0 || !mScene.model.data || std::size_t(type) >= mScene.model.data->types.size()) return {};
    const Model& model = *mScene.model.data;
    return scene::shownName(mScene.model, pathOf(model, model.types[std::size_t(type)]),
                            model.types[std::size_t(type)].name);
  }

  const Image& mImage;
  const scene::Scene& mScene;

 public:
  glm::ivec2 size;
  std::vector<int> ids;            ///< of regions, from 1; 0: nothing
  std::vector<std::string> names;  ///< of regions, by id - 1
  std::vector<int> faces;          ///< of cuts, from 1
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

/// The outlines of regions, those of one name together. @param names  by id - 1
std::vector<vector::Item> outlinesOf(const SeenPixels& seen, std::span<const int> ids,
                                     const std::vector<std::string>& names, const vector::Pen& pen,
                                     Progress& progress) {
  vector::RegionMap map = vector::traceRegions({seen.size, ids, {}}, {}, progress);
  std::map<std::string, vector::Shape> byName;
  auto shapeOf = [&](int id) -> vector::Shape& {
    const std::string& name = names[std::size_t(id) - 1];
    return byName.try_emplace(name, vector::Shape{name, {}, pen, {}}).first->second;
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
  for (auto& [name, shape] : byName) items.emplace_back(std::move(shape));
  return items;
}

/// Strokes of one region and one width together. @param widthOf  of a stroke, pixels
template <class Width>
std::vector<vector::Item> strokesOf(const SeenPixels& seen, std::vector<vector::Stroke> strokes, vector::Pen pen,
                                    const Width& widthOf) {
  std::map<std::pair<std::string, double>, vector::Shape> shapes;
  for (vector::Stroke& stroke : strokes) {
    std::string name = stroke.id > 0 ? seen.names[std::size_t(stroke.id) - 1] : "";
    pen.width = widthOf(stroke.strength);
    vector::Shape& shape = shapes.try_emplace({name, pen.width}, vector::Shape{name, {}, pen, {}}).first->second;
    shape.outlines.push_back(std::move(stroke.line));
  }
  std::vector<vector::Item> items;
  for (auto& [key, shape] : shapes) items.emplace_back(std::move(shape));
  return items;
}

}  // namespace

render::Layers plateLayers(const scene::Scene& scene) {
  render::Layers layers;
  bool hasLines = scene.finish.contours > 0.0 || scene.finish.hatching > 0.0;
  layers.depth = layers.structure = layers.instance = layers.normal = hasLines;
  layers.face = hasLines && !scene.cuts.empty();
  layers.type = bool(scene.model.data) && hasLines;
  return layers;
}

std::vector<vector::Layer> tracedLines(const Image& image, const Image& unlit, const scene::Scene& scene,
                                       Progress& progress) {
  const scene::Finish& finish = scene.finish;
  if (finish.contours <= 0.0 && finish.hatching <= 0.0) return {};
  progress.report(0.8, "Tracing lines");
  SeenPixels seen(image, scene);
  vector::View view = viewOf(scene.camera);
  std::vector<vector::Layer> layers;
  if (finish.hatching > 0.0) {
    double spacing = std::max(kFinestHatching, pixelsOf(finish.hatchWidth, seen));
    vector::Pen pen{finish.contourColor, 1.0, finish.hatching, {}};
    auto strokes = vector::traceHatching(seen.surfaces(), view, tonesOf(unlit), {spacing, true}, progress);
    layers.push_back({"hatching", strokesOf(seen, std::move(strokes), pen,
                                            [&](double share) { return std::max(0.3, share * spacing); })});
  }
  if (finish.contours <= 0.0) return layers;
  double width = pixelsOf(finish.contourWidth, seen);
  vector::Pen pen{finish.contourColor, width, finish.contours, {}};
  vector::StepOptions steps{finish.contourSteps, finish.contourCreases, width, stepLengthOf(scene)};
  vector::Layer contours{"contours", strokesOf(seen, vector::traceSteps(seen.surfaces(), view, steps, progress), pen,
                                               [&](double share) { return width * std::max(kThinnest, share); })};
  std::ranges::move(outlinesOf(seen, seen.ids, seen.names, pen, progress), std::back_inserter(contours.items));
  layers.push_back(std::move(contours));
  std::vector<std::string> cuts;
  for (const scene::Cut& cut : scene.cuts) cuts.push_back(cut.name);
  if (!cuts.empty()) layers.push_back({"cut lines", outlinesOf(seen, seen.faces, cuts, pen, progress)});
  return layers;
}

}  // namespace velum::session
