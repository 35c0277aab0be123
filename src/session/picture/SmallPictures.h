#pragma once
#include <functional>
#include <string>
#include <vector>

#include "core/Image.h"
#include "core/Task.h"
#include "scene/Scene.h"

/// Pictures by which something is chosen, drawn in the background.
namespace velum::session {

/// The volume that is shown, made small; none where there is none.
Shared<Volume> smallVolume(const scene::VolumeLayer& layer, Progress& progress);

/// What they begin with: a volume alone, in the light and before the background that it has, without shadows.
scene::Scene smallScene(const scene::Scene& look, const Shared<Volume>& small);

/// Draws a scene for each name.
/// @throw GpuError without a driver
void drawSmallPictures(const std::vector<std::string>& names, glm::ivec2 size,
                       const std::function<scene::Scene(const std::string& name)>& sceneOf,
                       const std::function<void(const std::string&, const Image&)>& done, Progress& progress);

}  // namespace velum::session
