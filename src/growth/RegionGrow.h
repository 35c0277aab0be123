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
/// in a domain of its own, and keeps the active front between them. After a step it is all that is joined to what was
/// there, and to the step's seeds, through voxels that may join and lie in the domain: the same voxels however the way
/// was cut into steps. One thread at a time; a step works on all cores.
///
/// Differs: in [ACS] 4.2 a structure that is pushed back gives up what was grown; here a region never shrinks, for what
/// is seen of it is told by the distance that a cut spares.
class RegionGrow {
 public:
  /// Begins as what a structure has in the labels, whatever its values. @param structure  0: as nothing
  /// @throw ArgumentError when the labels are not on the volume's grid, or there is no such channel or time step
  RegionGrow(Shared<Volume> volume, const Shared<LabelVolume>& labels, int structure, GrowRule rule);
  ~RegionGrow();
  RegionGrow(RegionGrow&&) noexcept;
  RegionGrow& operator=(RegionGrow&&) noexcept;

  /// Grows from here, too: the voxel joins where it may join, be it outside of any domain, and its neighbours are
  /// tried, from now until forgetSeeds(). Nothing outside the volume.
  void addSeed(glm::ivec3 voxel);
  /// Each voxel that a structure has in other labels joins where it may join. @param labels  on the volume's grid
  void addSeeds(const LabelVolume& labels, int structure);
  /// From now on only the region itself is grown from. A seed that has joined is part of it.
  void forgetSeeds();
  /// One step. Where it is cancelled, what has joined stays, and the next step goes on from there.
  /// @return voxels that joined, new seeds included
  /// @throw Cancelled
  std::size_t grow(const GrowDomain& domain, Progress& progress);

  bool has(glm::ivec3 voxel) const;
  std::size_t voxelCount() const { return mCount; }
  /// Voxels of the region that lie in a domain.
  std::size_t countIn(const GrowDomain& domain) const;
  /// Bits [word] of a row, or nothing where it has none.
  const std::uint64_t* row(int y, int z) const;

  /// Box around the rows that grew since it was last called, as wide as what is in them; the rows, as y and z.
  struct Changed {
    VoxelBox box;
    std::vector<glm::ivec2> rows;
  };
  Changed takeChanged();

  /// Goes on with other labels: looks anew at bricks that differ. False, and nothing of it is good any more, when the
  /// structure has other voxels in them than it has here.
  bool follow(const Shared<LabelVolume>& labels);
  /// The same where the region itself is all that the labels have got since.
  void adopt(const Shared<LabelVolume>& labels);
  const GrowRule& rule() const;

  /// What it holds, and how often a row was visited.
  std::size_t bytes() const;
  std::size_t visits() const;

 private:
  struct State;
  std::unique_ptr<State> mState;
  std::size_t mCount = 0;
};

}  // namespace velum::growth
