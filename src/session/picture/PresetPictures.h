#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/Image.h"
#include "core/Shared.h"
#include "core/Task.h"
#include "core/Volume.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// One channel of one time step of a volume with at most `mostAlong` voxels along its longest side: means of blocks.
/// Keeps place, unit, modality and range. O(voxels), all cores. @throw Cancelled
Volume reduceVolume(const Volume& volume, int channel, int timeStep, int mostAlong, const Progress& progress);

/// Voxels along the longest side of the small volume from which previews are drawn.
constexpr int kPreviewVoxels = 96;

/// A scene that shows a preset on the small copy of a volume: seen from the front, no cuts, no labels, no shadows.
/// @param scene  with the whole volume, to which the preset is fitted  @param aspect  width / height
scene::Scene presetScene(const scene::Scene& scene, const Shared<Volume>& small, const std::string& preset,
                         double aspect);

/// Draws presets on the scene's volume, one after another, in a headless GL context of the function's own. Any thread
/// in which no context of ours is current.
/// @param done  called with the name of a preset and its picture (R, G, B), from this thread
/// @throw Cancelled, gpu::GpuError
void drawPresetPictures(const scene::Scene& scene, const std::vector<std::string>& presets, glm::ivec2 size,
                        const std::function<void(const std::string&, const Image&)>& done, Progress& progress);

}  // namespace velum::session
