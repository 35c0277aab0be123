#pragma once
#include <algorithm>
#include <glm/glm.hpp>

#include "core/Image.h"
#include "core/Task.h"
#include "gpu/Context.h"
#include "render/Counts.h"
#include "render/Renderer.h"
#include "scene/Scene.h"
#include "session/model/TrueLevels.h"

namespace velum::session {

/// Draws pictures of scenes, of any size, to find out which instances of models and which structures show in them.
/// Draws only the first sample of each picture, membranes with the shapes that the scene holds, and leaves out light,
/// finish and ghosts, as these do not change what shows. GL thread.
class PictureCounter {
 public:
  /// @param renderer, progress  must outlive the counter  @param size  of the pictures, pixels
  PictureCounter(render::Renderer& renderer, glm::ivec2 size, const gpu::Limits& limits, Progress& progress)
      : mRenderer(renderer), mSize(size), mLargestWindow(std::min(4096, limits.texture2d)), mProgress(progress) {}

  glm::ivec2 size() const { return mSize; }
  double aspect() const { return double(mSize.x) / mSize.y; }
  /// What became of each instance: removed by cuts or not, shown in the picture or not; all are removed where the model
  /// is not drawn. The counter owns the result, which holds until the next call. @throw Cancelled, gpu::GpuError
  const render::InstanceBits& count(const scene::Scene& scene);
  /// A picture with the layers type and instance (render::Layers), for whatHides(). @throw Cancelled, gpu::GpuError
  Image types(const scene::Scene& scene);
  /// A picture with the layers structure and instance, for structureAreas(). @throw Cancelled, gpu::GpuError
  Image structures(const scene::Scene& scene);

 private:
  scene::Scene bareScene(const scene::Scene& scene);
  Image draw(const scene::Scene& scene, const render::Layers& layers);

  render::Renderer& mRenderer;
  glm::ivec2 mSize;
  int mLargestWindow;
  Progress& mProgress;
  TrueLevels mLevels;
  scene::Scene mLast;
  render::InstanceBits mBits;
};

}  // namespace velum::session
