#pragma once
#include <optional>

#include "core/LabelVolume.h"
#include "core/Shared.h"

namespace velum {

/// Labels in voxels twice as long along each axis: each has the id that most of its eight have; of those that as many
/// have, one that is not 0, so that what is thin stays. Follows edits: only bricks whose ids have changed are made
/// anew. Works on all cores; one thread at a time.
class HalvedLabels {
 public:
  /// Cost: the voxels of the bricks that have changed, and the number of bricks.
  const Shared<LabelVolume>& update(const Shared<LabelVolume>& fine);

 private:
  std::optional<Shared<LabelVolume>> mFine, mHalved;
};

}  // namespace velum
