#include "velum/session/picture/FinishPictures.h"

#include <algorithm>

#include "velum/gpu/Context.h"
#include "velum/render/Renderer.h"
#include "velum/scene/Finishes.h"
#include "velum/session/picture/Picture.h"
#include "velum/session/picture/PresetPictures.h"

namespace velum::session {

namespace {
constexpr double kLineScale = 5.0;
}

scene::Scene finishScene(const scene::Scene& scene, const Shared<Volume>& small, const std::string& finish) {
  scene::Scene shown;
  shown.unit = scene.unit;
  shown.volume.data = small;
  shown.volume.transfer = scene::currentTransfer(scene.volume);
  glm::dvec2 window = scene::effectiveWindow(scene.volume);
  shown.volume.windowLevel = window.x, shown.volume.windowWidth = window.y;
  shown.lighting = scene.lighting;
  shown.lighting.shadow = shown.lighting.occlusion = 0;
  shown.background = scene.background;
  shown.background.transparent = false;
  shown.rayCast = scene.rayCast;
  shown.rayCast.samplesPerPixel = 2;
  shown.camera = scene.camera;
  for (const scene::Cut& cut : scene.cuts)
    if (!scene::isMembrane(cut)) shown.cuts.push_back(cut);
  shown.surfaces = scene.surfaces;
  shown.showBounds = false;
  shown.finish.spheres = scene.finish.spheres;
  scene::applyFinish(shown, finish);
  // As a detail of a large picture would be: in one so small nothing would be seen of lines.
  shown.finish.contourWidth *= kLineScale;
  shown.finish.hatchWidth *= kLineScale;
  return shown;
}

void drawFinishPictures(const scene::Scene& scene, const std::vector<std::string>& finishes, glm::ivec2 size,
                        const std::function<void(const std::string&, const Image&)>& done, Progress& progress) {
  if (!scene.volume.data) return;
  const Volume& volume = *scene.volume.data;
  int channel = std::clamp(scene.volume.channel, 0, volume.channels - 1);
  int timeStep = std::clamp(scene.volume.timeStep, 0, volume.timeSteps - 1);
  Shared<Volume> small(reduceVolume(volume, channel, timeStep, kPreviewVoxels, progress));
  auto context = gpu::Context::create(gpu::ContextKind::Auto);
  render::Renderer renderer(*context);
  PictureOptions options;
  options.size = size;
  for (std::size_t i = 0; i < finishes.size(); ++i) {
    progress.report(double(i) / double(finishes.size()), finishes[i]);
    done(finishes[i],
         drawPicture(renderer, finishScene(scene, small, finishes[i]), options, context->limits(), progress));
  }
}

}  // namespace velum::session
