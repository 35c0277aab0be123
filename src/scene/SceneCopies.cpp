#include "scene/Scene.h"

/// What the compiler makes of a scene: here once, and not in every file that copies one.
namespace velum::scene {

Scene::Scene() = default;
Scene::Scene(const Scene&) = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(const Scene&) = default;
Scene& Scene::operator=(Scene&&) noexcept = default;
Scene::~Scene() = default;
bool Scene::operator==(const Scene&) const = default;

}  // namespace velum::scene
