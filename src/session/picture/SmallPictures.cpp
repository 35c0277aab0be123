#include "session/picture/SmallPictures.h"

#include <algorithm>

#include "gpu/Context.h"
#include "render/Renderer.h"
#include "scene/Shown.h"
#include "session/picture/Picture.h"
#include "session/picture/PresetPictures.h"

namespace velum::session {

scene::Scene smallScene(const scene::Scene& look, const Shared<Volume>& small) {
  scene::Scene shown;
  shown.unit = look.unit;
  shown.volume.data = small;
  shown.volume.transfer = scene::currentTransfer(look.volume);
  glm::dvec2 window = scene::effectiveWindow(look.volume);
  shown.volume.windowLevel = window.x, shown.volume.windowWidth = window.y;
  shown.lighting = look.lighting;
  shown.lighting.shadow = shown.lighting.occlusion = 0;
  shown.background = look.background;
  shown.background.transparent = false;
  return shown;
}

Shared<Volume> smallVolume(const scene::VolumeLayer& layer, Progress& progress) {
  if (!layer.data) return {};
  int channel = scene::shownChannel(layer), timeStep = scene::shownTimeStep(layer);
  return Shared<Volume>(reduceVolume(*layer.data, channel, timeStep, kPreviewVoxels, progress));
}

void drawSmallPictures(const std::vector<std::string>& names, glm::ivec2 size,
                       const std::function<scene::Scene(const std::string& name)>& sceneOf,
                       const std::function<void(const std::string&, const Image&)>& done, Progress& progress) {
  auto context = gpu::Context::create(gpu::ContextKind::Auto);
  render::Renderer renderer(*context);
  PictureOptions options;
  options.size = size;
  for (std::size_t i = 0; i < names.size(); ++i) {
    progress.report(double(i) / double(names.size()), names[i]);
    done(names[i], drawPicture(renderer, sceneOf(names[i]), options, context->limits(), progress));
  }
}

}  // namespace velum::session
