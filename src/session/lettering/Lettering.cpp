#include "session/lettering/Lettering.h"

#include <cmath>

#include "scene/Project.h"
#include "scene/Scene.h"
#include "scene/SectionPlane.h"
#include "scene/Units.h"
#include "session/lettering/LetteringLayout.h"
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
  return lettering.legend || lettering.scaleBar || lettering.timeStamp || !lettering.captions.empty();
}

/// What always stands there goes before what comes and goes, so that it keeps its place.
std::vector<Mark> marksOf(LetteringLayout& layout, const scene::Scene& scene, const std::optional<ScaleBar>& bar,
                          const std::vector<LegendEntry>& entries) {
  if (bar) layout.addScaleBar(*bar);
  auto stamp = scene.lettering.timeStamp ? timeStampOf(scene) : std::nullopt;
  if (stamp) layout.addTimeStamp(*stamp);
  layout.addLegend(entries);
  layout.addCaptions();
  return std::move(layout).marks();
}

}  // namespace

std::optional<ScaleBar> scaleBarOf(const scene::Scene& scene, glm::ivec2 size) {
  return barOf(scene, scene::lengthPerPixel(scene.camera, glm::dvec2(size), scene.camera.target), size.x);
}

std::optional<ScaleBar> scaleBarOf(const scene::Scene& scene, scene::SectionKind kind, glm::ivec2 size) {
  return barOf(scene, scene::makeSectionPlane(scene, kind, glm::dvec2(size)).lengthPerPixel, size.x);
}

std::vector<Mark> letteringMarks(const scene::Scene& scene, glm::ivec2 size, const TypePixels& pixels) {
  if (!hasLettering(scene.lettering)) return {};
  LetteringLayout layout(scene, size);
  auto bar = scene.lettering.scaleBar ? scaleBarOf(scene, size) : std::nullopt;
  return marksOf(layout, scene, bar,
                 scene.lettering.legend ? legendEntries(scene, pixels) : std::vector<LegendEntry>());
}

std::vector<Mark> letteringMarks(const scene::Scene& scene, scene::SectionKind kind, glm::ivec2 size) {
  if (!hasLettering(scene.lettering)) return {};
  // Beyond the data's end a section shows the background's lower colour.
  LetteringLayout layout(scene, size, scene.background.bottom);
  auto bar = scene.lettering.scaleBar ? scaleBarOf(scene, kind, size) : std::nullopt;
  return marksOf(layout, scene, bar, {});
}

}  // namespace velum::session
