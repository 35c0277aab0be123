#pragma once
#include <string>

#include "scene/SceneFwd.h"

/// A model beside data of another scale: a virion beside a head.
namespace velum::session {

/// How many times longer the longest edge of all other data is than the model's; 1 where there is no other.
double othersByModel(const scene::Scene& scene);
/// True where a model is too small to be seen beside what else is in the scene, or so large that the rest is.
bool isOutOfScale(const scene::Scene& scene);
/// "virion is 1e+06 times smaller than the other data, and not seen beside them"; empty where they fit each other.
std::string scaleWords(const scene::Scene& scene);
/// Enlarges the model, or makes it smaller, to a third of the other data's longest edge, and puts it beside these, to
/// the camera's right. Does nothing where there is no other data.
void bringModelToSize(scene::Scene& scene);

}  // namespace velum::session
