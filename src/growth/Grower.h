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
  bool guard = false;         ///< stops before a slab in which the region leaks; not of a step that has others
  Shared<LabelVolume> begun;  ///< it begins at what the structure has in these, too, where that may join
  /// And its others at what has label 1 in these: Grown::others of what begun is from.
  Shared<LabelVolume> othersBegun = {};
};

/// Where a guard has stopped a step.
struct Leak {
  double depth = 0.0;                     ///< at which the slab that leaks ends
  double area = 0.0, widestBefore = 0.0;  ///< of it, and what was expected at most; the scene's unit, squared
};

/// What a step has done.
struct Grown {
  Shared<LabelVolume> labels;  ///< with it; the same as before where nothing joined
  VoxelBox box;                ///< around the voxels that changed
  std::size_t voxels = 0;      ///< that joined
  int slabs = 0;
  double ms = 0.0;
  double distance = 0.0;  ///< to which it has grown: the step's, or what is safe
  std::optional<Leak> leak;
  /// Label 1 where the step's others have it, of what it would have taken without them; nothing where they have none.
  Shared<LabelVolume> others;
};

/// Does steps of growing one after the other, but for their end, see smoothRegion(). A step's result depends on the
/// volume, the labels before it and the step alone; what a Grower keeps between steps only saves time. One thread at a
/// time; a step works on all cores.
///
/// A step with others is done whole, whatever was grown of it before: where a border between the two kinds of seeds
/// lies depends on all of the region. Nobody guards it, for who says what it is not has seen where it leaks.
class Grower {
 public:
  /// @param before  on the volume's grid, see labelsFor()
  /// @throw Cancelled, and nothing has changed
  /// @throw ArgumentError when the labels are on another grid, or the step's channel, plane or structure makes no sense
  Grown grow(const Shared<Volume>& volume, const Shared<LabelVolume>& before, const scene::Growth& step,
             const GrowOptions& options, Progress& progress);

 private:
  struct Kept {
    Shared<Volume> volume;
    int structure;
    RegionGrow region;
    std::optional<scene::Growth> last;  ///< step that it has done whole
    bool hasDone(const scene::Growth& step) const;
  };
  void divide(const Shared<Volume>& volume, const Shared<LabelVolume>& before, const scene::Growth& step,
              const GrowOptions& options, Grown& grown, Progress& progress) const;
  std::list<Kept>::iterator keep(const Shared<Volume>& volume, const Shared<LabelVolume>& labels,
                                 const scene::Growth& step);
  std::list<Kept> mKept;  ///< the last one used comes first
};

}  // namespace velum::growth
