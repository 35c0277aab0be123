#pragma once
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/BrickCache.h"
#include "render/section/SectionRow.h"

namespace velum::render {

/// The voxels that a section shows of a volume that knows finer levels: of the level whose voxels are about as large as
/// the section's pixels. Cost: the bricks that the section goes through.
class SectionBricks {
 public:
  /// @param volume    with finer levels; must outlive this object, as the plane
  /// @param channels  those that are shown
  /// @param waits     reads bricks that are not in memory, on all cores; else they are left out: missing()
  /// @throw InputError when a brick cannot be read
  SectionBricks(const Volume& volume, std::vector<int> channels, int timeStep, const scene::SectionPlane& plane,
                glm::ivec2 size, bool waits);

  /// True when a finer level than the volume's own is shown.
  bool isFiner() const { return mLevel < mOwnLevel; }
  const std::vector<BrickAddress>& missing() const { return mMissing; }

  /// Overwrites the samples of a row for which there are voxels: out[x] = raw * scale + offset. Any thread.
  void sampleRow(int y, int channel, bool interpolate, double scale, double offset, float* out) const;

 private:
  struct Held {
    BrickCache::Brick bytes;
    BrickBox box;
  };
  std::uint64_t keyOf(glm::ivec3 brick, int channelBrick) const;
  void collect(int y, std::vector<std::uint64_t>& keys) const;
  const Held* heldAt(glm::ivec3 brick, int channelBrick) const;

  const Volume& mVolume;
  int mTimeStep, mOwnLevel, mLevel;
  glm::ivec3 mDims{1}, mBrickSize{1}, mGrid{1};
  glm::ivec2 mSize;
  std::optional<GridPath> mPath;
  std::unordered_map<std::uint64_t, Held> mHeld;
  std::vector<BrickAddress> mMissing;
};

}  // namespace velum::render
