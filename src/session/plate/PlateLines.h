#pragma once
#include <vector>

#include "core/Image.h"
#include "core/Task.h"
#include "render/Renderer.h"
#include "scene/SceneFwd.h"
#include "vector/Drawing.h"

namespace velum::session {

/// The layers of pixels from which tracedLines() traces what the finish of a scene asks for.
render::Layers plateLayers(const scene::Scene& scene);

/// The lines that the finish of a scene draws, from the layers of its picture: "hatching", "contours" and "cut lines";
/// a layer is empty where the finish has none of it. @param image  with plateLayers()  @param unlit  the same picture
/// without lit spheres, whose tones the strokes follow  @throw Cancelled. Any thread.
std::vector<vector::Layer> tracedLines(const Image& image, const Image& unlit, const scene::Scene& scene,
                                       Progress& progress);

}  // namespace velum::session
