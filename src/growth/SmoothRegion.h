#pragma once
#include <cstddef>

#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "core/Task.h"
#include "core/Volume.h"
#include "scene/Growth.h"

namespace velum::growth {

/// The largest radius of a closing, in voxels: it takes some 0.4 s in 256^3 voxels, and four times as long for twice
/// the radius.
constexpr double kMostClosingVoxels = 16.0;

/// True when a step has an end (a closing, or holes to fill) that is still to be done after it has grown.
bool isSmoothed(const scene::Growth& step);

struct Smoothed {
  Shared<LabelVolume> labels;  ///< the same as before where nothing joined
  std::size_t voxels = 0;      ///< how many voxels joined
};

/// The end of a step: the grown structure is closed and its holes are filled, whatever the values of the voxels that
/// join. Only voxels join that the step might have taken by their owner, its plane and its barriers.
///
/// Closing adds the voxels that no ball of the radius can reach without touching the structure. A hole is made of
/// voxels that are not joined by faces to the border of the volume through voxels of the step's domain outside the
/// structure. So a hollow structure counts as closed where the cut or the distance ends it, and marrow is a hole of its
/// bone.
/// @param others  Grown::others of the step: voxels with label 1 there do not join either
/// @throw Cancelled; InputError when a brick cannot be read, or the structure reaches too far for the memory
Smoothed smoothRegion(const Shared<Volume>& volume, const Shared<LabelVolume>& labels, const scene::Growth& step,
                      const Progress& progress, const Shared<LabelVolume>& others = {});

}  // namespace velum::growth
