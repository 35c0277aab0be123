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

/// The most instances of which a small picture is drawn: of a larger model the middle is shown.
constexpr std::size_t kPreviewInstances = 400000;

/// How much of a pixel shapes may be off by in a small picture, see scene::ModelLayer::detail.
constexpr double kPreviewDetail = 2.0;

/// The instances of a model around its middle, at most so many: a ball that is as dense as the model. Types and
/// molecules keep their places in the lists, so that colours and levels of detail still fit.
/// @return the model itself where it is small enough
Shared<Model> middleOfModel(const Shared<Model>& model, std::size_t mostInstances);

/// The scene with a look for models: the model alone, seen whole. @param aspect  width / height
scene::Scene modelLookScene(const scene::Scene& scene, const Shared<Model>& small, const std::string& look,
                            double aspect);

/// Draws a small picture for each look.
/// @throw GpuError without a driver
void drawModelPictures(const scene::Scene& scene, const std::vector<std::string>& looks, glm::ivec2 size,
                       const std::function<void(const std::string&, const Image&)>& done, Progress& progress);

}  // namespace velum::session
