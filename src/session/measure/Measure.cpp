#include "session/measure/Measure.h"

#include <algorithm>
#include <cmath>

#include "scene/Mark.h"
#include "scene/Scene.h"

namespace velum::session {

namespace {

using scene::Mark;
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

}  // namespace

const Quantity* findQuantity(const Measured& measured, std::string_view name) {
  for (const Quantity& quantity : measured.quantities)
    if (quantity.name == name) return &quantity;
  return nullptr;
}

bool isMeasuredAtOnce(const Mark& mark) {
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

Measured measure(const scene::Scene& scene, const Mark& mark, Progress& progress) {
  progress.throwIfCancelled();
  scene::MarkPoints wanted = scene::markPoints(mark.kind);
  if (mark.points.size() < wanted.least || mark.points.size() > wanted.most) return refusal("it lacks points");
  Telling telling = tellingOf(scene);
  switch (mark.kind) {
    case MarkKind::Distance:
    case MarkKind::Path:
      return only(lengthQuantity(telling, wayAlong(mark.points)));
    case MarkKind::Angle:
      return only(angleAt(telling, mark.points));
    case MarkKind::Area:
      return only(areaQuantity(telling, areaWithin(mark.points)));
    default:
      return {};
  }
}

}  // namespace velum::session
