#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/Image.h"
#include "core/Model.h"
#include "core/Shared.h"
#include "core/Task.h"
#include "core/Volume.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// A scene that shows a finish on a small copy of a scene's volume: as the scene is seen now, without labels, sheets
/// and shadows.
scene::Scene finishScene(const scene::Scene& scene, const Shared<Volume>& small, const std::string& finish);

/// A scene that shows a finish on a scene's model, in the colours and the light that it has: as it is seen now, with
/// its cuts but without sheets; of a model so large that `small` is its middle alone, all of that. @param aspect  width
/// / height
scene::Scene finishModelScene(const scene::Scene& scene, const Shared<Model>& small, const std::string& finish,
                              double aspect);

/// Draws finishes on the scene's volume, or, where there is none, on its model, one after another, in a headless GL
/// context of the function's own. Any thread in which no context of ours is current.
/// @param done  called with the name of a finish and its picture (R, G, B), from this thread
/// @throw Cancelled, gpu::GpuError
void drawFinishPictures(const scene::Scene& scene, const std::vector<std::string>& finishes, glm::ivec2 size,
                        const std::function<void(const std::string&, const Image&)>& done, Progress& progress);

}  // namespace velum::session
