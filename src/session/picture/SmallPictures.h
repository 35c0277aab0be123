#pragma once
#include <functional>
#include <string>
#include <vector>

#include "core/Image.h"
#include "core/Task.h"
#include "scene/Scene.h"

/// Small pictures from which a user chooses something, drawn in the background.
namespace velum::session {

/// A small copy of the channel and time step of the volume that are shown; none where there is no volume.
Shared<Volume> smallVolume(const scene::VolumeLayer& layer, Progress& progress);

/// The scene with which such pictures begin: the volume alone, in the light and before the background that the look
/// has, without shadows.
scene::Scene smallScene(const scene::Scene& look, const Shared<Volume>& small);

/// Draws a picture for each name, of the scene that `sceneOf` gives for it.
/// @param done  called with each name and its picture, from this thread
/// @throw GpuError without a driver
void drawSmallPictures(const std::vector<std::string>& names, glm::ivec2 size,
                       const std::function<scene::Scene(const std::string& name)>& sceneOf,
                       const std::function<void(const std::string&, const Image&)>& done, Progress& progress);

}  // namespace velum::session
