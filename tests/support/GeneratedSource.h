#pragma once
#include <atomic>
#include <cstring>
#include <functional>

#include "core/VoxelSource.h"

namespace velum::io {

/// Voxels that are computed when they are read, in bricks of any size: a source of any size.
template <class Sample, SampleType kType>
class GeneratedSourceOf : public VoxelSource {
 public:
  using Value = std::function<Sample(glm::ivec3)>;
  GeneratedSourceOf(glm::ivec3 dims, glm::ivec3 brick, Value value) : mValue(std::move(value)) {
    mHead.dims = dims;
    mHead.type = kType;
    mHead.name = "generated";
    mLevels = {{dims, brick, 1, 1, mHead.worldFromVoxel}};
  }
  const Volume& head() const override { return mHead; }
  void read(const BrickAddress& address, const SampleTarget& target) const override {
    if (--mReadsLeft < 0) throw InputError("generated: the source is torn away");
    BrickBox box = boxOf(*this, address);
    for (int z = 0; z < box.size.z; ++z)
      for (int y = 0; y < box.size.y; ++y)
        for (int x = 0; x < box.size.x; ++x) {
          Sample value = mValue(box.origin + glm::ivec3(x, y, z));
          std::memcpy(target.first + x * target.x + y * target.y + z * target.z, &value, sizeof(value));
        }
    ++reads;
  }

  /// After so many bricks it cannot be read any more.
  void failAfter(int count) { mReadsLeft = count; }
  mutable std::atomic<int> reads{0};

 private:
  Volume mHead;
  Value mValue;
  mutable std::atomic<int> mReadsLeft{1 << 30};
};
/// Of a scan.
using GeneratedSource = GeneratedSourceOf<std::uint16_t, SampleType::UInt16>;
/// Ids of 64 bits, as a store gives them that carries ids.
using IdSource = GeneratedSourceOf<std::uint64_t, SampleType::Float64>;

/// Numbers that look like those of a scan with noise.
inline std::uint16_t noisy(glm::ivec3 p) {
  std::uint32_t h = std::uint32_t(p.x) * 73856093u ^ std::uint32_t(p.y) * 19349663u ^ std::uint32_t(p.z) * 83492791u;
  h = (h ^ (h >> 13)) * 0x5bd1e995u;
  return std::uint16_t(1000 + 8 * ((p.x / 16 + p.y / 16 + p.z / 16) % 50) + (h >> 28));
}

}  // namespace velum::io
