#pragma once
#include <cstddef>

#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "core/Task.h"
#include "core/Volume.h"
#include "scene/Growth.h"

namespace velum::growth {

/// A closing goes no further than so many voxels: some 0.4 s in 256^3, and four times that for twice the radius.
constexpr double kMostClosingVoxels = 16.0;

/// True when a step is not done when it has grown.
bool isSmoothed(const scene::Growth& step);

struct Smoothed {
  Shared<LabelVolume> labels;  ///< the same as before where nothing joined
  std::size_t voxels = 0;      ///< that joined
};

/// The end of a step: what it has grown is closed, and its holes are filled, whatever values lie there. Only voxels
/// join that the step might have taken by their owner, its plane and its barriers.
///
/// Closed is what no ball of the radius can reach that lies beside the structure. A hole is what is not joined by faces
/// to the border of the volume through voxels of the step's domain that are not the structure's: where the cut and the
/// distance end it a hollow structure counts as closed, so that marrow is a hole of its bone.
/// @param others  Grown::others of the step: what has label 1 there does not join either  @throw Cancelled
Smoothed smoothRegion(const Shared<Volume>& volume, const Shared<LabelVolume>& labels, const scene::Growth& step,
                      const Progress& progress, const Shared<LabelVolume>& others = {});

}  // namespace velum::growth
