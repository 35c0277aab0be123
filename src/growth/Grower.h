#pragma once
#include <list>
#include <optional>

#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "core/Task.h"
#include "core/Volume.h"
#include "growth/RegionGrow.h"
#include "scene/Growth.h"

namespace velum::growth {

struct GrowOptions {
  bool guard = false;  ///< growing stops before a slab in which the region leaks; ignored for a step that has others
  /// The step also begins at the voxels that its structure has in these labels, where they may join
  Shared<LabelVolume> begun;
  /// The step's others also begin at the voxels with label 1 in these: the Grown::others that belong to `begun`.
  Shared<LabelVolume> othersBegun = {};
};

/// Where and why the guard has stopped a step.
struct Leak {
  double depth = 0.0;                     ///< depth at which the leaking slab ends
  double area = 0.0, widestBefore = 0.0;  ///< width of that slab, and the width expected of it; scene's unit, squared
};

/// The result of a step.
struct Grown {
  Shared<LabelVolume> labels;  ///< labels after the step; the same payload as before where nothing joined
  VoxelBox box;                ///< around the voxels that changed
  std::size_t voxels = 0;      ///< how many voxels joined
  int slabs = 0;
  double ms = 0.0;
  double distance = 0.0;  ///< depth down to which it has grown: the step's, or the last one before the leak
  std::optional<Leak> leak;
  /// Label 1 on the voxels that the step would have taken but for its others, and that went to these; empty where no
  /// voxel did.
  Shared<LabelVolume> others;
};

/// Does growing steps one after the other, except for their ends (smoothRegion()). The result depends only on the
/// volume, the labels before the step, the step and the options; what a Grower keeps between steps only saves time. One
/// thread at a time; a step works on all cores.
///
/// A step with others (places that are not of the structure) is always done as a whole, whatever was grown of it
/// before: the border between the two kinds of seeds depends on the whole region. Such a step is not guarded, for a
/// user who names others has seen where the region leaks.
class Grower {
 public:
  /// @param before  labels before the step, on the grid of the volume's finest level, see labelsFor()
  /// @throw Cancelled, or InputError when a brick cannot be read; then no labels have changed
  /// @throw ArgumentError when the labels are on another grid, or the step's channel, plane or structure makes no sense
  Grown grow(const Shared<Volume>& volume, const Shared<LabelVolume>& before, const scene::Growth& step,
             const GrowOptions& options, Progress& progress);

 private:
  struct Kept {
    Shared<Volume> volume;
    int structure;
    RegionGrow region;
    std::optional<scene::Growth> last;  ///< the step that the region has done whole
    bool hasDone(const scene::Growth& step) const;
  };
  void divide(const Shared<Volume>& volume, const Shared<LabelVolume>& before, const scene::Growth& step,
              const GrowOptions& options, Grown& grown, Progress& progress) const;
  std::list<Kept>::iterator keep(const Shared<Volume>& volume, const Shared<LabelVolume>& labels,
                                 const scene::Growth& step);
  std::list<Kept> mKept;  ///< the one used most recently comes first
};

}  // namespace velum::growth
