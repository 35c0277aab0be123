#pragma once
#include <vector>

#include "core/Volume.h"
#include "scene/Scene.h"

namespace velum::bench {

/// A brain of made data whose bricks are computed when they are read. @param size  voxels along its longest axis
Volume openBrain(int size, Progress& progress);
/// Its cells, or what else is bright, in tissue that one can see through.
scene::Scene brightScene(Volume volume, double aspect);

double largest(const std::vector<double>& values);

}  // namespace velum::bench
