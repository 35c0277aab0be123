#include "session/lettering/Lettering.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "scene/Project.h"
#include "scene/Scene.h"
#include "scene/SectionPlane.h"
#include "scene/Units.h"
#include "session/lettering/LetteringLayout.h"
#include "session/lettering/MarkLayout.h"
#include "session/lettering/SeenSection.h"
#include "session/section/SectionTool.h"

namespace velum::session {

namespace {

constexpr double kLongestBar = 0.22;  // of the picture's width

/// The bar for a picture of that width. @param perPixel  length of a pixel, scene units
std::optional<ScaleBar> barOf(const scene::Scene& scene, double perPixel, int width) {
  const auto& volume = scene.volume.data;
  if (!scene::hasData(scene) || (volume && !volume->isSpacingKnown)) return std::nullopt;
  double most = perPixel * kLongestBar * width;
  if (!std::isfinite(most) || most <= 0.0) return std::nullopt;
  double length = rulerLength(most);
  return ScaleBar{length, length / perPixel, scene::roundLengthText(length, scene.unit)};
}

bool hasLettering(const scene::Lettering& lettering) {
  return lettering.legend || lettering.scaleBar || lettering.timeStamp || !lettering.captions.empty() ||
         !lettering.marks.empty() || lettering.names;
}

void keepFree(FreePlaces& places, const Seen& seen) {
  for (const Rectangle& taken : seen.taken) places.add(taken.low, taken.high - taken.low, 0.0);
}

/// What always stands there goes before what comes and goes, so that it keeps its place.
LaidLettering layAll(LetteringLayout& layout, const MarkView& view, glm::vec3 ground,
                     const std::optional<ScaleBar>& bar, const std::vector<LegendEntry>& entries, const Seen& seen) {
  const scene::Scene& scene = view.scene();
  keepFree(layout.places(), seen);
  if (bar) layout.addScaleBar(*bar);
  auto stamp = scene.lettering.timeStamp ? timeStampOf(scene) : std::nullopt;
  if (stamp) layout.addTimeStamp(*stamp);
  layout.addLegend(entries);
  layout.addCaptions();
  MarkLayout marks(view, seen.measured, seen.names.places, ground, seen.leastEm, layout.places());
  for (const scene::Mark& mark : scene.lettering.marks) marks.add(mark);
  LaidNames names = layNames(scene, {glm::ivec2(view.space().size()), ground, 0.0}, seen.names, seen.measured,
                             layout.places(), seen.namesBefore, seen.between);
  LaidLettering all{{}, std::move(names.places), marks.words()};
  all.words.insert(all.words.end(), names.words.begin(), names.words.end());
  all.blocks = std::move(marks).blocks();
  std::ranges::move(names.blocks, std::back_inserter(all.blocks));
  std::ranges::move(std::move(layout).blocks(), std::back_inserter(all.blocks));
  return all;
}

}  // namespace

std::optional<ScaleBar> scaleBarOf(const scene::Scene& scene, glm::ivec2 size) {
  return barOf(scene, scene::lengthPerPixel(scene.camera, glm::dvec2(size), scene.camera.target), size.x);
}

std::optional<ScaleBar> scaleBarOf(const scene::Scene& scene, scene::SectionKind kind, glm::ivec2 size) {
  return barOf(scene, scene::makeSectionPlane(scene, kind, glm::dvec2(size)).lengthPerPixel, size.x);
}

std::map<int, Measured> measuredMarks(const scene::Scene& scene, Progress& progress) {
  std::map<int, Measured> all;
  for (const scene::Mark& mark : scene.lettering.marks)
    if (mark.visible && !isMeasuredAtOnce(mark)) all.emplace(mark.id, measure(scene, mark, progress));
  return all;
}

render::Layers withLetteringLayers(render::Layers layers, const scene::Scene& scene) {
  bool hasPlaces = needsSeenPlaces(scene.lettering), hasNames = hasPlaces || needsSeenNames(scene.lettering);
  layers.type = layers.type || (scene.model.data && (scene.lettering.legend || hasNames));
  layers.structure = layers.structure || hasNames;
  layers.instance = layers.instance || hasNames;
  layers.depth = layers.depth || hasPlaces;
  return layers;
}

scene::Scene measuredScene(scene::Scene scene) {
  scene.camera = {};
  scene.sections = {};
  scene.lighting = {};
  scene.finish = {};
  scene.background = {};
  scene.timeline = {};
  std::vector<scene::Mark> marks = std::move(scene.lettering.marks);
  scene.lettering = {};
  for (scene::Mark& mark : marks)
    if (mark.visible && !isMeasuredAtOnce(mark)) scene.lettering.marks.push_back(std::move(mark));
  return scene;
}

Seen seenIn(const Image& image, const scene::Scene& scene, Progress& progress, const Seen* known) {
  const NamesBetween* between = known ? known->between : nullptr;
  Seen seen;
  if (scene.lettering.legend && scene.model.data) seen.pixels = countPixels(image, scene.model.data->types.size());
  seen.measured = known ? known->measured : measuredMarks(scene, progress);
  if (needsSeenNames(scene.lettering))
    seen.names = between ? seenNear(scene, image, between->near) : seenNames(scene, image);
  if (needsSeenPlaces(scene.lettering)) seen.names.places = seenPlaces(scene, ImageMap(scene, image).map());
  seen.between = between;
  return seen;
}

Seen seenInSection(const render::SectionImage& section, const scene::SectionPlane& plane, const scene::Scene& scene,
                   Progress& progress, const Seen* known) {
  const NamesBetween* between = known ? known->between : nullptr;
  Seen seen;
  seen.measured = known ? known->measured : measuredMarks(scene, progress);
  if (needsSeenNames(scene.lettering)) {
    Image image = seenOfSection(section, plane, scene.background.bottom);
    seen.names = between ? seenNear(scene, image, between->near) : seenNames(scene, image);
  }
  seen.between = between;
  return seen;
}

LaidLettering layLettering(const scene::Scene& scene, glm::ivec2 size, const Seen& seen) {
  if (!hasLettering(scene.lettering)) return {};
  LetteringLayout layout(scene, size);
  MarkView view(scene, ViewSpace(scene.camera, glm::dvec2(size)));
  auto bar = scene.lettering.scaleBar ? scaleBarOf(scene, size) : std::nullopt;
  return layAll(layout, view, groundOf(scene, scene::CaptionPlace::Centre), bar,
                scene.lettering.legend ? legendEntries(scene, seen.pixels) : std::vector<LegendEntry>(), seen);
}

LaidLettering layLettering(const scene::Scene& scene, scene::SectionKind kind, glm::ivec2 size, const Seen& seen) {
  if (!hasLettering(scene.lettering)) return {};
  // Beyond the data's end a section shows the background's lower colour.
  LetteringLayout layout(scene, size, scene.background.bottom);
  MarkView view(scene, ViewSpace(scene::makeSectionPlane(scene, kind, glm::dvec2(size))));
  auto bar = scene.lettering.scaleBar ? scaleBarOf(scene, kind, size) : std::nullopt;
  return layAll(layout, view, scene.background.bottom, bar, {}, seen);
}

LaidLettering layMarks(const scene::Scene& scene, const ViewSpace& space, const Seen& seen) {
  if (scene.lettering.marks.empty() && seen.names.names.empty()) return {};
  FreePlaces places(space.size());
  keepFree(places, seen);
  MarkView view(scene, space);
  glm::vec3 ground = space.section() ? scene.background.bottom : groundOf(scene, scene::CaptionPlace::Centre);
  MarkLayout marks(view, seen.measured, seen.names.places, ground, seen.leastEm, places);
  for (const scene::Mark& mark : scene.lettering.marks) marks.add(mark);
  LaidNames names = layNames(scene, {glm::ivec2(space.size()), ground, seen.leastEm}, seen.names, seen.measured, places,
                             seen.namesBefore, seen.between);
  LaidLettering laid{{}, std::move(names.places), marks.words()};
  laid.blocks = std::move(marks).blocks();
  std::ranges::move(names.blocks, std::back_inserter(laid.blocks));
  laid.words.insert(laid.words.end(), names.words.begin(), names.words.end());
  return laid;
}

}  // namespace velum::session
