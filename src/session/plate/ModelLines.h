#pragma once
#include <vector>

#include "core/Image.h"
#include "core/Task.h"
#include "scene/SceneFwd.h"
#include "vector/Drawing.h"

namespace velum::session {

/// The contours that the finish of a scene draws of its model. @param image  with render::Layers::lines
/// @throw Cancelled. Any thread.
std::vector<vector::Item> modelContours(const Image& image, const scene::Scene& scene, Progress& progress);

}  // namespace velum::session
