#pragma once
#include <glm/glm.hpp>

#include "scene/Camera.h"
#include "scene/SceneFwd.h"

namespace velum::scene {

/// True when a scene holds a model and nothing else.
bool isModelAlone(const Scene& scene);

/// A camera so near that all instances of a model just fit: it fills its box as little as a ball does. Projection and
/// field of view are the scene's.
/// @param axes  columns: right, up, towards the eye
Camera frameModel(const Scene& scene, const glm::dmat3& axes, double aspect);

/// The side from which a model shows most of its shape: columns as those of frameModel(). What is long lies in the
/// picture, along its longer edge, and what is flat faces the eye: of the whole, and, as much as of that, of all
/// compartments with what is in them, but for what is round, and for so few instances that their shape is chance. What
/// is round stays as it lies, seen obliquely. Some ms for each 100'000 instances.
glm::dmat3 bestSide(const Scene& scene, double aspect);

}  // namespace velum::scene
