#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/VoxelSource.h"
#include "io/read/FileBytes.h"
#include "io/read/Payload.h"
#include "scene/Source.h"

namespace velum::io {

/// Voxels that lie in files as they are, in one level. Its bricks are of whole rows, and of several planes where these
/// are small, so that a brick is one stretch of a file.
class RawSource : public VoxelSource {
 public:
  /// @param unread  of raw samples of at most 32 bits, or doubles; its files are there
  explicit RawSource(UnreadVolume unread);

  const Volume& head() const override { return mUnread.head; }
  void read(const BrickAddress& address, const SampleTarget& target) const override;
  std::string identity() const override;

 private:
  void readAt(std::uint64_t at, std::span<std::byte> to) const;

  UnreadVolume mUnread;
  std::uint64_t mPartBytes = 0;
  /// Bytes from a sample to the next one along an axis.
  struct Steps {
    std::uint64_t x = 0, y = 0, z = 0, channel = 0, timeStep = 0;
  } mSteps;
  std::vector<std::unique_ptr<FileBytes>> mFiles;  ///< of the parts; empty where there are too many to be held open
};

/// A source of samples that lie in files as they are; null for others, which can only be read whole.
/// @param source  its spacing is applied. @throw InputError
std::unique_ptr<VoxelSource> openSamples(UnreadVolume unread, const scene::Source& source);

/// What a brick has where the format leaves the choice: enough that a disk is not kept waiting.
inline constexpr std::size_t kSlabBytes = 1 << 20;
/// Rows of a brick of whole rows of one plane: all, or a multiple of @p unit.
int rowsOfBrick(glm::ivec3 dims, int unit, std::size_t voxelBytes);
/// Planes of a brick: a power of two, so that bricks do not lie across the shards of a store.
int planesOfBrick(int planes, std::size_t planeBytes);

}  // namespace velum::io
