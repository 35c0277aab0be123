#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/Image.h"
#include "core/Model.h"
#include "core/Shared.h"
#include "core/Task.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// Small pictures are of so many instances at most: of a larger model the middle is shown.
constexpr std::size_t kPreviewInstances = 400000;

/// The instances of a model around its middle, so many at most: a ball, in which the model is as dense as it is. Types
/// and molecules stay in their places, so that its colours and its levels of detail do.
/// @return the model itself where it is small enough
Shared<Model> middleOfModel(const Shared<Model>& model, std::size_t mostInstances);

/// The scene with one of the looks of models, of the model alone and seen whole. @param aspect  width / height
scene::Scene modelLookScene(const scene::Scene& scene, const Shared<Model>& small, const std::string& look,
                            double aspect);

/// Draws a picture for each look, small ones.
/// @throw GpuError without a driver
void drawModelPictures(const scene::Scene& scene, const std::vector<std::string>& looks, glm::ivec2 size,
                       const std::function<void(const std::string&, const Image&)>& done, Progress& progress);

}  // namespace velum::session
