#include "session/lettering/MarkView.h"

#include <algorithm>
#include <cmath>

#include "scene/Scene.h"
#include "session/mark/MarkHands.h"

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

double MarkView::opacityOf(const scene::Mark& mark) const {
  return isShown(mScene, mark) ? mark.opacity * markShare(mSpace, mark, mStep) : 0.0;
}

bool MarkView::goesThrough(const scene::Mark& mark) const { return session::goesThrough(mSpace, mark, mStep); }

std::vector<std::vector<glm::dvec2>> MarkView::lines(const scene::Mark& mark) const {
  return markLines(mSpace, mark, mStep);
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
