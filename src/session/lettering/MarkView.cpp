#include "session/lettering/MarkView.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/Scene.h"

namespace velum::session {

MarkView::MarkView(const scene::Scene& scene, const ViewSpace& space) : mScene(scene), mSpace(space) {
  if (isSection()) mStep = std::max(scene::sectionStep(scene), 1e-12);
}

std::optional<std::vector<glm::dvec2>> MarkView::pixels(const std::vector<glm::dvec3>& places) const {
  std::vector<glm::dvec2> out;
  for (const glm::dvec3& place : places) {
    auto at = mSpace.pixelFromWorld(place);
    if (!at) return std::nullopt;
    out.push_back(*at);
  }
  return out;
}

double MarkView::height(glm::dvec3 world) const {
  return isSection() ? scene::heightOverSection(*mSpace.section(), world) : 0.0;
}

double MarkView::away(const scene::Mark& mark) const {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  bool isPair = mark.points.size() == 2;
  if (isPair && mark.kind == scene::MarkKind::Circle)
    return std::max(0.0, std::abs(height(mark.points[0])) - glm::distance(mark.points[0], mark.points[1]));
  bool isBox = isPair && mark.kind == scene::MarkKind::Box;
  for (const glm::dvec3& point : isBox ? boxCorners(mScene, mark) : mark.points)
    low = std::min(low, height(point)), high = std::max(high, height(point));
  return isBox ? std::max({0.0, low, -high}) : std::max(high, -low);
}

double MarkView::opacityOf(const scene::Mark& mark) const {
  if (!mark.visible || (mark.timeStep >= 0 && mark.timeStep != mScene.volume.timeStep)) return 0.0;
  if (!isSection() || mark.points.empty()) return mark.opacity;
  return mark.opacity * std::clamp(1.5 - away(mark) / mStep, 0.0, 1.0);
}

std::vector<glm::dvec3> boxCorners(const scene::Scene& scene, const scene::Mark& mark) {
  glm::dmat3 axes = scene.volume.data ? direction(*scene.volume.data) : glm::dmat3(1.0);
  glm::dvec3 way = glm::inverse(axes) * (mark.points[1] - mark.points[0]);
  std::vector<glm::dvec3> corners;
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 part(corner & 1 ? way.x : 0.0, corner & 2 ? way.y : 0.0, corner & 4 ? way.z : 0.0);
    corners.push_back(mark.points[0] + axes * part);
  }
  return corners;
}

}  // namespace velum::session
