#include "session/measure/Measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "scene/Mark.h"
#include "scene/Scene.h"
#include "session/measure/Follow.h"
#include "session/measure/Left.h"
#include "session/measure/Region.h"
#include "session/measure/SurfaceWay.h"
#include "session/measure/ValueQuantities.h"
#include "session/measure/Values.h"

namespace velum::session {

namespace {

using scene::MarkKind;

double wayAlong(const std::vector<glm::dvec3>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i - 1], points[i]);
  return length;
}

/// Of a polygon, also where its points lie in no plane: that of its shadow where it is largest.
double areaWithin(const std::vector<glm::dvec3>& points) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 2; i < points.size(); ++i) sum += glm::cross(points[i - 1] - points[0], points[i] - points[0]);
  return 0.5 * glm::length(sum);
}

Quantity angleAt(const Telling& telling, const std::vector<glm::dvec3>& points) {
  glm::dvec3 a = points[0] - points[1], b = points[2] - points[1];
  double degrees = glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
  return angleQuantity(telling, degrees, std::min(glm::length(a), glm::length(b)));
}

Measured only(const Quantity& quantity) {
  Measured measured;
  measured.text = quantityText(quantity);
  measured.quantities = {quantity};
  return measured;
}

Measured refusal(std::string problem) {
  Measured measured;
  measured.problem = std::move(problem);
  return measured;
}

Measured measureAlongSurface(const scene::Scene& scene, const scene::Mark& mark, Progress& progress) {
  Measured measured;
  double length = 0.0;
  for (std::size_t i = 1; i < mark.points.size(); ++i) {
    SurfaceWay found = wayOverSurface(scene, mark.points[i - 1], mark.points[i], progress);
    if (!found.problem.empty()) return refusal(found.problem);
    length += found.way.length;
    auto& points = found.way.points;
    measured.way.insert(measured.way.end(), points.begin() + (i > 1 ? 1 : 0), points.end());
  }
  measured.quantities = {lengthQuantity(tellingOf(scene), length)};
  measured.text = quantityText(measured.quantities.front());
  return measured;
}

Measured measureBallOrBox(const scene::Scene& scene, const scene::Mark& mark, Progress& progress) {
  if (!scene.volume.data) return refusal("there is no volume whose values could be measured");
  bool isBall = mark.kind == MarkKind::Circle;
  double radius = glm::distance(mark.points[0], mark.points[1]);
  StructureValues values = isBall ? valuesInBall(scene, mark.points[0], radius, mark.normal, progress)
                                  : valuesInBox(scene, mark.points[0], mark.points[1], progress);
  if (values.voxels == 0) return refusal("it holds no voxel that has a value");
  Measured measured;
  addValues(measured, *scene.volume.data, values);
  if (isBall && mark.normal != glm::dvec3(0.0))
    measured.quantities.push_back(areaQuantity(tellingOf(scene), glm::pi<double>() * radius * radius));
  return measured;
}

Measured measureProfile(const scene::Scene& scene, const scene::Mark& mark, Progress& progress) {
  if (!scene.volume.data) return refusal("there is no volume whose values could be measured");
  Measured measured;
  measured.profile = profileAlong(scene, mark.points[0], mark.points[1], progress);
  double least = 1e300, most = -1e300;
  for (const ProfileSample& sample : measured.profile)
    if (std::isfinite(sample.value)) least = std::min(least, sample.value), most = std::max(most, sample.value);
  if (least > most) return refusal("it meets no voxel that has a value");
  auto valueOf = [&](const char* name, double value) {
    return valueQuantity(*scene.volume.data, name, value, {least, most});
  };
  Quantity length = lengthQuantity(tellingOf(scene), glm::distance(mark.points[0], mark.points[1]));
  measured.quantities = {length, valueOf("least", least), valueOf("most", most)};
  measured.text = fmt::format("{}\n{} to {}", quantityText(length), bareText(measured.quantities[1]),
                              quantityText(measured.quantities[2]));
  return measured;
}

Measured measureRegion(const scene::Scene& scene, const scene::Mark& mark, Progress& progress) {
  auto all = measureLeft(scene, mark.structure, progress);
  auto found = all.find(mark.structure);
  if (mark.structure == 0 || found == all.end())
    return refusal(fmt::format("there is no structure {} that has voxels", mark.structure));
  return measureStructure(scene, mark.structure, found->second, progress);
}

}  // namespace

const Quantity* findQuantity(const Measured& measured, std::string_view name) {
  for (const Quantity& quantity : measured.quantities)
    if (quantity.name == name) return &quantity;
  return nullptr;
}

bool isMeasuredAtOnce(const scene::Mark& mark) {
  switch (mark.kind) {
    case MarkKind::Distance:
    case MarkKind::Path:
      return !mark.alongSurface;
    case MarkKind::Circle:
    case MarkKind::Box:
    case MarkKind::Region:
    case MarkKind::Profile:
      return false;
    default:
      return true;
  }
}

Measured measure(const scene::Scene& scene, const scene::Mark& given, Progress& progress) {
  progress.throwIfCancelled();
  const scene::Mark mark = followed(scene, given);
  scene::MarkPoints wanted = scene::markPoints(mark.kind);
  if (mark.points.size() < wanted.least || mark.points.size() > wanted.most) return refusal("it lacks points");
  Telling telling = tellingOf(scene);
  switch (mark.kind) {
    case MarkKind::Distance:
    case MarkKind::Path:
      return mark.alongSurface ? measureAlongSurface(scene, mark, progress)
                               : only(lengthQuantity(telling, wayAlong(mark.points)));
    case MarkKind::Angle:
      if (mark.points[0] == mark.points[1] || mark.points[2] == mark.points[1])
        return refusal("one of its legs has no length");
      return only(angleAt(telling, mark.points));
    case MarkKind::Area:
      return only(areaQuantity(telling, areaWithin(mark.points)));
    case MarkKind::Circle:
    case MarkKind::Box:
      return measureBallOrBox(scene, mark, progress);
    case MarkKind::Profile:
      return measureProfile(scene, mark, progress);
    case MarkKind::Region:
      return measureRegion(scene, mark, progress);
    default:
      return {};
  }
}

}  // namespace velum::session
