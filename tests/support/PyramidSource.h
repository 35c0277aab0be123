#pragma once
#include <algorithm>
#include <atomic>
#include <functional>
#include <set>

#include "core/BrickCache.h"
#include "core/Error.h"

namespace velum {

/// A volume with coarser levels of it, each of means of 2 x 2 x 2 voxels of the one before, in bricks.
class PyramidSource : public VoxelSource {
 public:
  /// @param volume  one time step
  PyramidSource(Volume volume, int levels, glm::ivec3 brickSize) {
    mVolumes.push_back(std::move(volume));
    while (int(mVolumes.size()) < levels) mVolumes.push_back(halved(mVolumes.back()));
    for (const Volume& v : mVolumes)
      mLevels.push_back({v.dims, glm::min(brickSize, v.dims), v.channels, 1, v.worldFromVoxel});
  }
  const Volume& head() const override { return mVolumes.front(); }
  const Volume& level(int i) const { return mVolumes[std::size_t(i)]; }
  void read(const BrickAddress& address, const SampleTarget& target) const override {
    ++reads;
    if (whenRead) whenRead();
    if (damaged && address.level == 0) throw InputError("brick is damaged");
    BrickBox box = boxOf(*this, address);
    const Volume& v = mVolumes[std::size_t(address.level)];
    std::size_t sample = sampleSize(v.type);
    for (int z = 0; z < box.size.z; ++z)
      for (int y = 0; y < box.size.y; ++y)
        for (int x = 0; x < box.size.x; ++x)
          for (int c = 0; c < box.channels; ++c) {
            glm::ivec3 p = box.origin + glm::ivec3(x, y, z);
            std::size_t at = ((std::size_t(p.z) * std::size_t(v.dims.y) + std::size_t(p.y)) * std::size_t(v.dims.x) +
                              std::size_t(p.x)) *
                                 std::size_t(v.channels) +
                             std::size_t(box.channel + c);
            std::copy_n(v.voxels.data() + at * sample, sample,
                        target.first + x * target.x + y * target.y + z * target.z + c * target.channel);
          }
  }

  mutable std::atomic<int> reads{0};
  bool damaged = false;            ///< the finest level cannot be read
  std::function<void()> whenRead;  ///< called at each read, if anything

 private:
  static Volume halved(const Volume& fine) {
    Volume out = fine;
    out.dims = (fine.dims + 1) / 2;
    out.voxels.assign(voxelCount(out) * sampleSize(out.type) * std::size_t(out.channels), std::byte(0));
    glm::dmat4 fineFromCoarse(1.0);
    for (int axis = 0; axis < 3; ++axis) fineFromCoarse[axis][axis] = 2.0, fineFromCoarse[3][axis] = 0.5;
    out.worldFromVoxel = fine.worldFromVoxel * fineFromCoarse;
    visitSamples(fine, [&](auto* samples) {
      using Sample = std::remove_cv_t<std::remove_pointer_t<decltype(samples)>>;
      auto* to = reinterpret_cast<Sample*>(out.voxels.data());
      for (int z = 0; z < out.dims.z; ++z)
        for (int y = 0; y < out.dims.y; ++y)
          for (int x = 0; x < out.dims.x; ++x)
            for (int c = 0; c < out.channels; ++c) {
              double sum = 0;
              int count = 0;
              for (int i = 0; i < 8; ++i) {
                glm::ivec3 p(2 * x + (i & 1), 2 * y + (i >> 1 & 1), 2 * z + (i >> 2));
                if (glm::any(glm::greaterThanEqual(p, fine.dims))) continue;
                sum += double(samples[((std::size_t(p.z) * std::size_t(fine.dims.y) + std::size_t(p.y)) *
                                           std::size_t(fine.dims.x) +
                                       std::size_t(p.x)) *
                                          std::size_t(fine.channels) +
                                      std::size_t(c)]);
                ++count;
              }
              double mean = sum / count;
              *to++ = std::is_integral_v<Sample> ? Sample(std::floor(mean + 0.5)) : Sample(mean);
            }
    });
    return out;
  }
  std::vector<Volume> mVolumes;
};

/// The volume of a level that knows the finer ones, as a reader makes it.
inline Volume streamedVolume(std::shared_ptr<const PyramidSource> source, int level,
                             std::size_t cacheBytes = 1u << 28) {
  Volume volume = source->level(level);
  volume.finer = std::make_shared<FinerLevels>(FinerLevels{std::make_shared<BrickCache>(source, cacheBytes), level});
  return volume;
}

}  // namespace velum
