#pragma once
#include <glm/glm.hpp>

#include "scene/SceneFwd.h"

namespace velum::session {

/// A view along an axis gives a direction along it, without the noise of the sines.
glm::dvec3 cleaned(glm::dvec3 v);

/// The box about the data of a scene.
struct DataBox {
  glm::dvec3 middle, edges;
};
DataBox dataOf(const scene::Scene& scene);

glm::dvec3 towardsEye(const scene::Scene& scene);

/// What a new cut is fitted to.
struct NewCut {
  const scene::Scene& scene;
  DataBox data;
  glm::dvec3 toEye;   ///< unit
  glm::dvec3 atSide;  ///< the crosshair, where it was put somewhere; else where a closed shape of a third of the data
                      ///< opens what faces the eye
  double third;       ///< of the shortest edge of the data
  double through;     ///< from the side of the data that faces the eye to the other
};
NewCut newCutIn(const scene::Scene& scene);

/// Edges of the frame of a new membrane: of the rest plane, and the reach that is tried first.
glm::dvec3 frameSize(double width, double height);

/// A rest plane as wide and high as the data, along those of its axes that face the eye; through the cut's centre.
void hangMembrane(scene::Cut& cut, const NewCut& at);

}  // namespace velum::session
