#pragma once
#include <glm/glm.hpp>

#include "scene/SceneFwd.h"

namespace velum::session {

/// A direction without the noise of the sines: components next to 0 become 0, so that a view along an axis gives a
/// direction along the axis.
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
  glm::dvec3 atSide;  ///< the crosshair, where somebody has put it somewhere; else the place where a closed shape of a
                      ///< third of the data opens the side of the data that faces the eye
  double third;       ///< a third of the shortest edge of the data
  double through;     ///< depth of the data along the line of sight, from the side that faces the eye to the other
};
NewCut newCutIn(const scene::Scene& scene);

/// Edges of the frame of a new membrane: width and height of the rest plane, and the reach that is tried first.
glm::dvec3 frameSize(double width, double height);

/// Gives a membrane a rest plane as wide and high as the data, along the data's axes that face the eye, through the
/// cut's centre.
void hangMembrane(scene::Cut& cut, const NewCut& at);

}  // namespace velum::session
