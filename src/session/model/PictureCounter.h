#pragma once
#include <algorithm>
#include <glm/glm.hpp>

#include "core/Image.h"
#include "core/Task.h"
#include "gpu/Context.h"
#include "render/Counts.h"
#include "render/Renderer.h"
#include "scene/Scene.h"

namespace velum::session {

/// Draws scenes, of any size, to know what of their models and structures shows: the first sample of each picture,
/// membranes as their shapes are, without light, finish and ghosts, which change nothing of it. GL thread.
class PictureCounter {
 public:
  /// @param renderer, progress  outlive it
  PictureCounter(render::Renderer& renderer, glm::ivec2 size, const gpu::Limits& limits, Progress& progress)
      : mRenderer(renderer), mSize(size), mLargestWindow(std::min(4096, limits.texture2d)), mProgress(progress) {}

  glm::ivec2 size() const { return mSize; }
  double aspect() const { return double(mSize.x) / mSize.y; }
  /// What became of the instances; all are removed where the model is not drawn. @throw Cancelled, gpu::GpuError
  const render::InstanceBits& count(const scene::Scene& scene);
  /// Types and instances (render::Layers), for whatHides(). @throw Cancelled, gpu::GpuError
  Image types(const scene::Scene& scene);
  /// Structures and instances, for structureAreas(). @throw Cancelled, gpu::GpuError
  Image structures(const scene::Scene& scene);

 private:
  Image draw(const scene::Scene& scene, const render::Layers& layers);

  render::Renderer& mRenderer;
  glm::ivec2 mSize;
  int mLargestWindow;
  Progress& mProgress;
  scene::Scene mLast;
  render::InstanceBits mBits;
};

}  // namespace velum::session
