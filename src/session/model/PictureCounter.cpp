#include "session/model/PictureCounter.h"

#include <algorithm>

#include "render/RenderPicture.h"
#include "scene/Crowd.h"
#include "scene/ModelLooks.h"

namespace velum::session {

scene::Scene PictureCounter::bareScene(const scene::Scene& scene) {
  scene::Scene bare = scene;
  bare.model.detail = scene::shapeDetail(scene);  // the shapes of the picture that it counts for
  bare.rayCast.samplesPerPixel = 1;
  bare.lighting.shaded = false;
  bare.finish = {};
  bare.model.ghosts = scene::Ghosts::None;
  for (scene::TypeLook& look : bare.model.types) look.ghosts.reset();
  mLevels.give(bare.model, mProgress);
  return bare;
}

const render::InstanceBits& PictureCounter::count(const scene::Scene& scene) {
  scene::refuseCrowd(scene.model, "counts");
  render::Frame frame;
  frame.scene = bareScene(scene);
  if (mBits.count > 0 && frame.scene == mLast) return mBits;
  const scene::ModelLayer& model = scene.model;
  render::InstanceBits all;
  if (model.data) all.count = scene::instanceCount(model);
  std::size_t words = std::size_t((all.count + 31) / 32);
  all.removed.assign(words, ~0u), all.shown.assign(words, 0u);
  frame.pictureSize = mSize;
  frame.countsInstances = true;
  bool isDrawn = model.visible && all.count > 0;
  for (int y = 0; y < mSize.y && isDrawn; y += mLargestWindow)
    for (int x = 0; x < mSize.x; x += mLargestWindow) {
      frame.windowOrigin = {x, y};
      frame.windowSize = glm::min(mSize - frame.windowOrigin, glm::ivec2(mLargestWindow));
      mRenderer.render(frame, mProgress);
      auto bits = mRenderer.bits(true);
      if (!bits || bits->count != all.count) continue;
      all.removed = std::move(bits->removed);
      for (std::size_t i = 0; i < words; ++i) all.shown[i] |= bits->shown[i];
    }
  mLast = std::move(frame.scene);
  mBits = std::move(all);
  return mBits;
}

Image PictureCounter::types(const scene::Scene& scene) {
  render::Layers layers;
  layers.instance = layers.type = true;
  return draw(scene, layers);
}

Image PictureCounter::structures(const scene::Scene& scene) {
  render::Layers layers;
  layers.structure = layers.instance = true;
  return draw(scene, layers);
}

Image PictureCounter::draw(const scene::Scene& scene, const render::Layers& layers) {
  render::Frame frame;
  frame.scene = bareScene(scene);
  frame.pictureSize = mSize;
  return render::renderPicture(mRenderer, frame, layers, mLargestWindow, mProgress);
}

}  // namespace velum::session
