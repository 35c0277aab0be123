#pragma once
#include <string>
#include <vector>

#include "makeModel.h"
#include "makeVolume.h"
#include "scene/Scene.h"
#include "session/command/Command.h"
#include "session/lettering/Legend.h"
#include "session/lettering/LetteringBlock.h"

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

inline const vector::Words& firstWords(const LetteringBlock& block) {
  return std::get<vector::Words>(block.items.at(0));
}

/// The pixels of a block without its glow, also where they are beyond the picture.
inline vector::Raster rasterOf(const LetteringBlock& block, glm::ivec2 size) {
  constexpr int kBeyond = 200;
  std::vector<vector::Item> items = block.items;
  for (vector::Item& item : items) {
    if (auto* words = std::get_if<vector::Words>(&item)) words->start += kBeyond;
    if (auto* shape = std::get_if<vector::Shape>(&item))
      for (vector::Outline& outline : shape->outlines) {
        outline.start += kBeyond;
        for (vector::Curve& curve : outline.curves)
          curve.control1 += kBeyond, curve.control2 += kBeyond, curve.end += kBeyond;
      }
  }
  vector::Raster raster = vector::rasterOf(items, size + 2 * kBeyond);
  raster.corner -= kBeyond;
  return raster;
}

inline scene::Scene after(const scene::Scene& scene, const Call& call) {
  Progress progress;
  return editOf(scene, call, progress).after;
}

}  // namespace velum::session
