#pragma once
#include <vector>

#include "core/LabelCover.h"

namespace velum {

/// The values of volumes at some voxels of the labels whose borders they are; of streamed volumes they are read once,
/// for a box of voxels.
class BorderValues {
 public:
  /// @param first, end  the box of voxels that are asked for
  BorderValues(glm::ivec3 first, glm::ivec3 end) : mFirst(glm::max(first, glm::ivec3(0))), mEnd(end) {}

  /// NaN where a brick cannot be read: whoever grew in it was told.
  float at(const ValueBorder& border, glm::ivec3 voxel);

 private:
  struct Part {
    const ValueBorder* border;
    Volume values;
  };
  const Volume& partOf(const ValueBorder& border);
  glm::ivec3 mFirst, mEnd;
  std::vector<Part> mParts;
};

}  // namespace velum
