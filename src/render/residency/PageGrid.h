#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/Volume.h"
#include "shared/frame.h"

namespace velum::render {

/// Voxels along an edge of a page's brick, at most; how far a group of samples reaches from its middle, voxels
/// (march_volume.glsl: eight steps of half a voxel); and texels along an edge of a slot, which holds a brick with what
/// its neighbours lend: the reach, and what interpolation takes, wherever the levels' grids lie to each other.
inline constexpr int kPageVoxels = shared::kPageEdge;
inline constexpr double kGroupReach = 2.0;
inline constexpr int kSlotEdge = shared::kBrickSlotEdge;

/// A brick of a level, as it lies in a slot.
struct PageBrick {
  int level = 0;
  glm::ivec3 at{0};  ///< its place among the bricks of its level
  bool operator==(const PageBrick&) const = default;
  /// One number for it. A level has fewer than 2^19 bricks along an axis.
  std::uint64_t key() const {
    return ((std::uint64_t(level) << 19 | std::uint64_t(at.z)) << 19 | std::uint64_t(at.y)) << 19 | std::uint64_t(at.x);
  }
};

/// How the voxels of each level are divided into bricks, by our own measure, not the file's: those of a coarser level
/// are whole numbers of those of a finer one, whatever the ratio of their voxels. "Box" coordinates run from 0 to 1
/// over the box of the finest level.
struct PageLevel {
  glm::ivec3 dims{0};            ///< voxels
  glm::dmat4 worldFromTex{1.0};  ///< from texture coordinates 0..1 over its own box
  glm::dvec3 voxelsPerBox{1.0};  ///< place among voxels, whose corners are at whole numbers = box * this + firstVoxel
  glm::dvec3 firstVoxel{0.0};
  glm::dvec3 brickEdge{1.0};  ///< of a brick, box coordinates
  glm::ivec3 bricks{1};
  glm::ivec3 shift{0};      ///< a brick is 2^shift of the finest level's along each axis
  glm::dvec3 spacing{1.0};  ///< world
  double voxelSize = 1.0;   ///< the smallest of them
};

/// The levels of a volume that is a coarse level of a larger one, down to its own. Levels that lie askew are left out.
class PageGrid {
 public:
  /// @param volume  with finer levels
  explicit PageGrid(const Volume& volume);

  const std::vector<PageLevel>& levels() const { return mLevels; }
  /// The level of the source that one of levels() is.
  int sourceLevel(int level) const { return mSourceLevels[std::size_t(level)]; }
  /// Bricks of all levels but the coarsest.
  std::size_t finerBricks() const;
  /// The volume's own level, the coarsest.
  int coarsest() const { return int(mLevels.size()) - 1; }

  /// The lowest voxel that the slot of a brick holds; may lie outside the level.
  glm::ivec3 slotOrigin(const PageBrick& brick) const;
  /// Where a brick begins among the voxels of its level, whose corners are at whole numbers.
  glm::dvec3 lowCorner(const PageBrick& brick) const;
  /// Voxels along its edges.
  glm::dvec3 edges(int level) const;
  /// The brick of another level in which a brick lies. @param level  not finer than its own
  PageBrick parent(const PageBrick& brick, int level) const;

 private:
  std::vector<PageLevel> mLevels;
  std::vector<int> mSourceLevels;
};

}  // namespace velum::render
