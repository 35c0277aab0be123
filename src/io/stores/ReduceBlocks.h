#pragma once
#include <cstddef>
#include <glm/glm.hpp>

#include "core/Volume.h"

namespace velum::io {

/// What stands for a block of samples.
enum class Reduction {
  Mean,     ///< rounded to the nearest whole number, halves to the even one; NaN count only where all are
  Majority  ///< the most frequent one; of equally frequent ones the smallest that is not 0: thin things stay. For
            ///< ids, whose bits are compared
};

/// Makes one sample of each block of 1 or 2 along each axis. Samples lie x fastest, without gaps.
/// @param fromSize  of the finer samples: size * factor, or one less along an axis, where the last ones count twice
/// @param factor    1 or 2 along each axis
void reduceBlocks(SampleType type, Reduction reduction, const std::byte* from, glm::ivec3 fromSize, glm::ivec3 size,
                  glm::ivec3 factor, std::byte* to);

}  // namespace velum::io
