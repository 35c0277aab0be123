#pragma once
#include <glm/glm.hpp>

#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "core/Units.h"
#include "core/Volume.h"
#include "scene/ModelLayer.h"
#include "scene/SceneFwd.h"

namespace velum::membrane {

/// The data that a potential is made from: a volume, labels and a model, which may lie on other grids than the volume.
struct PotentialSource {
  Shared<Volume> volume;
  int timeStep = 0, channel = 0;
  Shared<LabelVolume> labels;
  scene::ModelLayer model;
  scene::ModelFrame frame;  ///< how the model lies in the world
  LengthUnit unit = LengthUnit::Millimetre;
  int level = 0;                   ///< of a streamed volume: the level that `volume` is, or is a part of
  glm::ivec3 dims{0};              ///< of the potential's grid
  glm::ivec3 volumeFrom{0};        ///< where the volume's first voxel is in this grid
  glm::dmat4 worldFromVoxel{1.0};  ///< of this grid
  Shared<LabelVolume> types;       ///< the model's types by their numbers, from 1; made when a field asks for them
};

/// The sources of a scene, and the grid: the volume's, or that of the labels where there is no volume, with more voxels
/// around it where a model reaches out of it; in a scene with only a model that of its types.
PotentialSource sourceOf(const scene::Scene& scene);
/// False where there is no model, and where it reaches so far out of the other data that the grid does not hold it.
bool holdsModel(const PotentialSource& source);

}  // namespace velum::membrane
