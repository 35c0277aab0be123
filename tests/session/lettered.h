#pragma once
#include <string>
#include <vector>

#include "makeModel.h"
#include "makeVolume.h"
#include "scene/Scene.h"
#include "session/command/Command.h"
#include "session/lettering/Legend.h"

namespace velum::session {

/// Five types, of which the picture shows the more the higher their number is.
inline scene::Scene lettered(glm::vec3 ground) {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker{.types = 5}.make());
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 1.5);
  scene.background.top = scene.background.bottom = ground;
  scene.lettering.legend = scene.lettering.scaleBar = true;
  return scene;
}

/// On a white ground, so that glows are white and nothing else is, over a volume of ten time steps.
inline scene::Scene captioned(std::vector<scene::Caption> captions) {
  scene::Scene scene = lettered(glm::vec3(1.0f));
  Volume volume = makeVolume({4, 4, 4}, SampleType::UInt8, [](glm::ivec3 v) { return v.x; });
  volume.timeSteps = 10;
  volume.timeStepSeconds = 0.06;
  volume.isSpacingKnown = true;
  scene.volume.data = Shared<Volume>(std::move(volume));
  scene.lettering.legend = scene.lettering.scaleBar = false;
  scene.lettering.captions = std::move(captions);
  return scene;
}
inline const TypePixels kPixels{{1000, 2100, 3300, 4600, 6000}, 1000000};

inline std::vector<std::string> namesOf(const scene::Scene& scene, const TypePixels& pixels = kPixels) {
  std::vector<std::string> names;
  for (const LegendEntry& entry : legendEntries(scene, pixels)) names.push_back(entry.name);
  return names;
}

inline scene::Scene after(const scene::Scene& scene, const Call& call) {
  Progress progress;
  return editOf(scene, call, progress).after;
}

}  // namespace velum::session
