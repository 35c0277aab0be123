#pragma once
#include <vector>

#include "core/Image.h"
#include "core/Task.h"
#include "render/Renderer.h"
#include "scene/SceneFwd.h"
#include "vector/Drawing.h"

namespace velum::session {

/// The layers of the picture of a plate from which tracedLines() traces.
render::Layers plateLayers(const scene::Scene& scene);

/// A scene as it is drawn to know the lines of its model alone, in one sample: with render::Layers::lines.
scene::Scene sceneOfLines(scene::Scene scene);

/// Pictures of a scene from which its lines are traced.
struct PlateImages {
  const Image& picture;  ///< with plateLayers()
  const Image& unlit;    ///< without lit spheres, whose tones the strokes follow
  const Image& lines;    ///< of sceneOfLines(); empty where a model is not all that is seen
};

/// The lines that the finish of a scene draws, from its pictures: "hatching", "contours" and "cut lines". Where the
/// finish has no contours the last two are hidden, of a strength of 1, unless they would be more than two megabytes.
/// @throw Cancelled. Any thread.
std::vector<vector::Layer> tracedLines(const PlateImages& images, scene::Scene scene, Progress& progress);

}  // namespace velum::session
