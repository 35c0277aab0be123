#include "session/picture/FinishPictures.h"

#include "scene/Finishes.h"
#include "session/picture/SmallPictures.h"

namespace velum::session {

namespace {
constexpr double kLineScale = 5.0;
}

scene::Scene finishScene(const scene::Scene& scene, const Shared<Volume>& small, const std::string& finish) {
  scene::Scene shown = smallScene(scene, small);
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
  Shared<Volume> small = smallVolume(scene.volume, progress);
  if (!small) return;
  auto sceneOf = [&](const std::string& finish) { return finishScene(scene, small, finish); };
  drawSmallPictures(finishes, size, sceneOf, done, progress);
}

}  // namespace velum::session
