#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/Task.h"
#include "core/Volume.h"

namespace velum {

/// One level of a source: the same data in voxels of some size.
struct VoxelLevel {
  glm::ivec3 dims{0};              ///< voxels along x, y, z
  glm::ivec3 brickSize{1};         ///< voxels of a brick, along x, y, z; bricks at the far borders may be smaller
  int brickChannels = 1;           ///< channels that a brick holds together
  int brickTimeSteps = 1;          ///< time steps that a brick holds together
  glm::dmat4 worldFromVoxel{1.0};  ///< as Volume::worldFromVoxel, in the unit of the source's head
  bool operator==(const VoxelLevel&) const = default;
};

/// Which brick is meant. A brick is what is read at once.
struct BrickAddress {
  int level = 0;
  glm::ivec3 brick{0};  ///< its place among the level's bricks, along x, y, z
  int channel = 0;      ///< its place among the bricks along the channels
  int timeStep = 0;     ///< its place among the bricks along time
  bool operator==(const BrickAddress&) const = default;
};

/// The samples that a brick holds.
struct BrickBox {
  glm::ivec3 origin{0}, size{0};  ///< voxels of its level
  int channel = 0, channels = 1;  ///< first channel, and how many
  int timeStep = 0, timeSteps = 1;
};

/// Where samples are put: `first` takes that of the lowest voxel, channel and time step, and each step to the next one
/// along an axis is so many bytes.
struct SampleTarget {
  std::byte* first = nullptr;
  std::ptrdiff_t x = 0, y = 0, z = 0, channel = 0, timeStep = 0;
};

/// Voxels that need not be in memory: levels of detail, the finest first, each of them in bricks that are read one by
/// one. Level 0 gives the name to all: type, channels, time steps and unit are the same in each.
class VoxelSource {
 public:
  virtual ~VoxelSource() = default;
  VoxelSource(const VoxelSource&) = delete;
  VoxelSource& operator=(const VoxelSource&) = delete;

  /// All that is known of the data but its voxels, with the dims and the place of the finest level. Its range is {0, 0}
  /// where the source does not know it. Only a source in memory has its voxels there, too.
  virtual const Volume& head() const = 0;
  /// The finest first; never empty.
  const std::vector<VoxelLevel>& levels() const { return mLevels; }
  /// The values between which each channel is to be shown, as the file gives them: empty, or one a channel.
  const std::vector<glm::dvec2>& channelWindows() const { return mChannelWindows; }

  /// Reads a brick, which may take long. Samples that the source lacks get its fill value.
  /// @param address  inside bricksOf() and the level's counts along channels and time; not checked
  /// @param target   takes all samples of boxOf(*this, address), in machine byte order
  /// @throw InputError when the brick cannot be read. Any thread, several at a time.
  virtual void read(const BrickAddress& address, const SampleTarget& target) const = 0;

  /// Smallest and largest value of a brick, where they are known without reading it. Any thread.
  virtual std::optional<glm::dvec2> range(const BrickAddress& address) const;

  /// What tells these voxels from others without reading them: of files, their sizes and when they were changed. Empty
  /// where nothing does.
  virtual std::string identity() const { return {}; }

 protected:
  VoxelSource() = default;
  std::vector<VoxelLevel> mLevels;
  std::vector<glm::dvec2> mChannelWindows;
};

/// How many bricks a level has along x, y, z; and along channels and time.
glm::ivec3 bricksOf(const VoxelLevel& level);
int channelBricksOf(const VoxelSource& source, int level);
int timeBricksOf(const VoxelSource& source, int level);

/// What a brick holds.
BrickBox boxOf(const VoxelSource& source, const BrickAddress& address);

/// Copies samples of `sampleBytes` (1, 2, 4 or 8) from one layout to another.
/// @param from  nothing is written to what it points to
void copySamples(const BrickBox& box, std::size_t sampleBytes, const SampleTarget& from, const SampleTarget& to);

/// Bytes of all voxels, channels and time steps of a level, as a Volume holds them. A double, for a level may have more
/// than any whole number of ours.
double levelBytes(const VoxelSource& source, int level);

/// The finest level that needs no more than so many bytes; none where the coarsest is larger.
std::optional<int> levelWithin(const VoxelSource& source, double bytes);

/// Reads a whole level on all cores. @throw InputError when a brick cannot be read; Cancelled
Volume readLevel(const VoxelSource& source, int level, Progress& progress);

/// A volume in memory as a source: one level, cut into bricks that are not copied before they are read.
class VolumeSource : public VoxelSource {
 public:
  explicit VolumeSource(Shared<Volume> volume);
  /// @param volume  must outlive the source
  explicit VolumeSource(const Volume& volume);
  explicit VolumeSource(Volume&&) = delete;
  const Volume& head() const override { return *mVolume; }
  void read(const BrickAddress& address, const SampleTarget& target) const override;

 private:
  Shared<Volume> mKept;
  const Volume* mVolume;
};

}  // namespace velum
