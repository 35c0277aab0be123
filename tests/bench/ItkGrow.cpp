#include "ItkGrow.h"

#include <algorithm>

#include "growByItk.h"

namespace velum::bench {

Timing growWithItk(const Volume& volume, glm::ivec3 seed, double low, double high) {
  ItkGrown grown = growByItk(volume, seed, low, high);
  auto isIn = [](std::uint8_t voxel) { return voxel != 0; };
  return {grown.ms, std::size_t(std::count_if(grown.voxels.begin(), grown.voxels.end(), isIn))};
}

}  // namespace velum::bench
