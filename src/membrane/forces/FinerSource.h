#pragma once
#include <optional>

#include "core/Task.h"
#include "membrane/forces/Kernels.h"
#include "membrane/forces/PotentialSource.h"
#include "scene/SceneFwd.h"

namespace velum::membrane {

/// A box of voxels of a finer level of a streamed volume, around all that the sheet of a membrane can reach.
struct FinerBox {
  int level = 0;
  VoxelBox box;
  bool holdsValues = false;  ///< the field asks for values of the volume; else its voxels are not read
  bool operator==(const FinerBox&) const = default;
};

/// The most voxels that such a box may have: 512^3, or what half of the budget of bricks holds (core/Memory.h), with
/// what is made of each voxel.
double finerVoxelBudget(SampleType type);

/// The box of the finest level that keeps to the budget. Nothing where the volume is in memory as a whole, where a
/// finer level than the one in memory is too large, where the frame lies beside the data, and where types of a model
/// are protected, which have a grid of their own. Depends on the scene alone, not on what was there before.
std::optional<FinerBox> finerBoxOf(const PotentialSource& source, const scene::Cut& cut);

/// The source in this box, without a model. Reads bricks, on all cores. @throw InputError when one cannot be read;
/// Cancelled
PotentialSource finerSource(const PotentialSource& source, const FinerBox& box, Progress& progress);

}  // namespace velum::membrane
