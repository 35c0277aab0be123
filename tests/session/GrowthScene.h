#pragma once
#include "scene/Scene.h"

namespace velum::session {

/// A cube of voxels of 1 mm, and a plane through its middle that removes what has a smaller y.
/// @param valueOf  of a voxel at a time step
template <class ValueOf>
scene::Scene growthScene(int edge, int steps, const ValueOf& valueOf) {
  Volume volume;
  volume.dims = glm::ivec3(edge);
  volume.timeSteps = steps;
  volume.type = SampleType::UInt8;
  for (int t = 0; t < steps; ++t)
    for (int z = 0; z < edge; ++z)
      for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x) volume.voxels.push_back(std::byte(valueOf(glm::ivec3(x, y, z), t)));
  volume.range = {0, 200};
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(std::move(volume));
  scene.volume.transfer.opacities = {{60, 0}, {80, 1}, {255, 1}};
  scene::Cut cut;
  cut.centre = {0.5 * (edge - 1), 0.5 * edge, 0.5 * (edge - 1)};
  cut.axis = {0, -1, 0};
  scene::addCut(scene, cut);
  return scene;
}

}  // namespace velum::session
