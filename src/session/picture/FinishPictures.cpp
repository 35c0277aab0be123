#include "session/picture/FinishPictures.h"

#include <algorithm>

#include "scene/Finishes.h"
#include "session/picture/ModelPictures.h"
#include "session/picture/SmallPictures.h"

namespace velum::session {

namespace {

constexpr double kLineScale = 5.0;

void setFinish(scene::Scene& shown, const scene::Scene& scene, const std::string& finish) {
  shown.finish.spheres = scene.finish.spheres;
  scene::applyFinish(shown, finish);
  // As a detail of a large picture would be: in one so small nothing would be seen of lines.
  shown.finish.contourWidth *= kLineScale;
  shown.finish.hatchWidth *= kLineScale;
}

void addCuts(scene::Scene& shown, const scene::Scene& scene) {
  for (const scene::Cut& cut : scene.cuts)
    if (!scene::isMembrane(cut)) shown.cuts.push_back(cut);
}

}  // namespace

scene::Scene finishScene(const scene::Scene& scene, const Shared<Volume>& small, const std::string& finish) {
  scene::Scene shown = smallScene(scene, small);
  shown.rayCast = scene.rayCast;
  shown.rayCast.samplesPerPixel = 2;
  shown.camera = scene.camera;
  addCuts(shown, scene);
  shown.surfaces = scene.surfaces;
  shown.showBounds = false;
  setFinish(shown, scene, finish);
  return shown;
}

scene::Scene finishModelScene(const scene::Scene& scene, const Shared<Model>& small, const std::string& finish,
                              double aspect) {
  scene::Scene shown;
  shown.unit = scene.unit;
  shown.lighting = scene.lighting;
  shown.background = scene.background;
  shown.background.transparent = false;
  shown.rayCast.samplesPerPixel = 2;
  shown.showBounds = false;
  bool isWhole = small == scene.model.data;
  shown.model = scene.model;
  shown.model.data = small;
  shown.model.copies = isWhole ? scene.model.copies : 1;
  shown.model.visible = true;
  shown.model.detail = std::max(scene.model.detail, kPreviewDetail);
  if (isWhole) addCuts(shown, scene);
  shown.camera = isWhole ? scene.camera : scene::frameCamera(shown, scene::defaultView(shown), aspect);
  setFinish(shown, scene, finish);
  return shown;
}

void drawFinishPictures(const scene::Scene& scene, const std::vector<std::string>& finishes, glm::ivec2 size,
                        const std::function<void(const std::string&, const Image&)>& done, Progress& progress) {
  Shared<Volume> volume = smallVolume(scene.volume, progress);
  if (!volume && !scene.model.data) return;
  Shared<Model> model = volume ? Shared<Model>() : middleOfModel(scene.model.data, kPreviewInstances);
  auto sceneOf = [&](const std::string& finish) {
    return volume ? finishScene(scene, volume, finish)
                  : finishModelScene(scene, model, finish, double(size.x) / size.y);
  };
  drawSmallPictures(finishes, size, sceneOf, done, progress);
}

}  // namespace velum::session
