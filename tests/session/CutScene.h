#pragma once
#include "cutShapes.h"
#include "scene/Scene.h"

namespace velum::session {

/// A scene that is a box of 100 x 200 x 300 mm with voxels of 10 mm, seen from an oblique side.
inline scene::Scene boxScene(glm::dvec2 size) {
  scene::Scene scene;
  Volume volume;
  volume.dims = {10, 20, 30};
  for (int i = 0; i < 3; ++i) volume.worldFromVoxel[i][i] = 10.0;
  volume.voxels.resize(6000);
  scene.volume.data = Shared<Volume>(std::move(volume));
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, size.x / size.y);
  return scene;
}

/// A tilted and turned cut inside the box.
inline scene::Cut tiltedCut(scene::CutShape shape) {
  scene::Cut cut;
  cut.shape = shape;
  if (scene::isMembrane(cut)) cut.membrane.emplace();
  cut.centre = {45, 95, 145};
  cut.axis = {1, 2, -3};
  cut.spinDeg = 25;
  cut.size = {60, 40, 90};
  return cut;
}

}  // namespace velum::session
