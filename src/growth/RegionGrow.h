#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "core/Task.h"
#include "core/Volume.h"
#include "growth/GrowDomain.h"
#include "growth/GrowRule.h"

namespace velum::growth {

/// Voxels from `first` to before `end`.
struct VoxelBox {
  glm::ivec3 first{0}, end{0};
  bool isEmpty() const { return glm::any(glm::greaterThanEqual(first, end)); }
  bool operator==(const VoxelBox&) const = default;
};

/// A region that grows through voxels joined by faces, 64 voxels a word ([ACS] 4.2, Prop. 3). It grows in steps, each
/// in a domain of its own, and keeps the active front between steps. After a step it consists of all voxels that are
/// joined to the region before, or to the step's seeds, through voxels that may join and lie in the domain: the same
/// voxels however the growth was divided into steps. One thread at a time; a step works on all cores.
///
/// Differs: in [ACS] 4.2 a structure that is pushed back gives up what was grown; here a region never shrinks, for what
/// is seen of it is told by the distance that a cut spares.
class RegionGrow {
 public:
  /// Begins as the voxels that a structure has in the labels, whatever their values. @param structure  0: begins empty
  /// @throw ArgumentError when the labels are not on the grid of the volume's finest level, or there is no such channel
  /// or time step
  RegionGrow(Shared<Volume> volume, const Shared<LabelVolume>& labels, int structure, GrowRule rule);
  ~RegionGrow();
  RegionGrow(RegionGrow&&) noexcept;
  RegionGrow& operator=(RegionGrow&&) noexcept;

  /// Adds a seed: the voxel joins if it may join, even outside any domain, and its neighbours are tried, from now until
  /// forgetSeeds(). A voxel outside the volume is ignored.
  void addSeed(glm::ivec3 voxel);
  /// Each voxel that a structure has in other labels joins where it may join. @param labels  on the volume's grid
  void addSeeds(const LabelVolume& labels, int structure);
  /// From now on growth starts from the region alone; seeds that have joined are part of the region.
  void forgetSeeds();
  /// Grows by one step. Voxels that have joined before a cancel stay, and the next step goes on from there.
  /// @return voxels that joined, new seeds included
  /// @throw Cancelled; InputError when a brick cannot be read, after which this object must not be used any more
  std::size_t grow(const GrowDomain& domain, Progress& progress);

  bool has(glm::ivec3 voxel) const;
  /// A box that holds the region, in whole tiles of rows. Empty where no voxel was tried.
  VoxelBox reach() const;
  std::size_t voxelCount() const { return mCount; }
  /// Voxels of the region that lie in a domain.
  std::size_t countIn(const GrowDomain& domain) const;
  /// The rows, as (y, z), in which the region has voxels that lie in a domain: ascending by z, then by y.
  std::vector<glm::ivec2> rowsIn(const GrowDomain& domain) const;
  /// A word of the bits of a row.
  std::uint64_t word(int y, int z, int w) const;
  /// A row as bits. @param bits  wordsOf(dims.x), all written @return false only where the row has no voxel
  bool read(int y, int z, std::uint64_t* bits) const;

  /// The rows, as (y, z), that grew since takeChanged() was last called, some of them twice, and the box around the
  /// region's voxels in these rows, in whole words along x.
  struct Changed {
    VoxelBox box;
    std::vector<glm::ivec2> rows;
  };
  Changed takeChanged();

  /// Goes on with other labels: looks anew at the bricks that differ. Returns false when the structure has other voxels
  /// in these bricks than the region has; then this object must not be used any more.
  bool follow(const Shared<LabelVolume>& labels);
  /// As follow(), for labels to which nothing but this region itself was added since.
  void adopt(const Shared<LabelVolume>& labels);
  const GrowRule& rule() const;

  /// Bytes of memory that it holds, and how often a row was visited.
  std::size_t bytes() const;
  std::size_t visits() const;

 private:
  struct State;
  std::unique_ptr<State> mState;
  std::size_t mCount = 0;
};

}  // namespace velum::growth
