#pragma once
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <mutex>
#include <vector>

#include "core/LabelVolume.h"
#include "core/Shared.h"
#include "core/Volume.h"

namespace velum {

/// A structure that lies where a volume has values of a range: its border is where they end, between voxels. The labels
/// lie on the volume's grid.
struct ValueBorder {
  std::uint16_t structure = 0;
  std::uint16_t within =
      0;  ///< label that it was taken from: where values of the range go on in it, so does the structure
  Shared<Volume> volume;
  int channel = 0, timeStep = 0;
  double low = 0.0, high = 0.0;  ///< values that belong to it, the volume's unit, both ends included
  double scale = 1.0;  ///< distance from the range's nearer end, in values, that counts as wholly inside or outside
  bool operator==(const ValueBorder&) const = default;
};

/// The ids of a box of voxels that may leave the grid: beyond it its outermost voxels go on. [size.z][size.y][size.x]
std::vector<std::uint16_t> readAround(const LabelVolume& labels, glm::ivec3 origin, glm::ivec3 size);

/// How far inside their structures the voxels of labels lie: a byte each, from 1, next to the border, to 255, where no
/// voxel of the 26 around is of another structure. Label 0 is a structure as any other.
///
/// A voxel is a share of (1 + cover / 255) / 2 its own structure's, and the rest may be another's: between voxels whose
/// shares are interpolated the border lies where two structures have as much (structureAt()). As no voxel has less than
/// half of its own, no voxel's middle changes sides, and what is one voxel thin stays whole.
///
/// Borders of values: the cover grows with the distance of the value from the range's end, so that the border lies
/// where the value is the end. Other borders: membership smoothed by G + 2.65 (G - G G), where G is 1 4 6 4 1 along
/// each axis; the second term gives back what smoothing takes from what is thin or round. A function of the labels
/// and borders alone. Any thread.
class LabelCover {
 public:
  static constexpr int kHalo = 4;  ///< voxels around a brick that its cover depends on
  using Brick =
      std::vector<std::uint8_t>;  ///< LabelVolume::kBrickSize^3, x fastest; or one for a brick that is all 255

  explicit LabelCover(Shared<LabelVolume> labels, std::vector<ValueBorder> borders = {});
  /// @param index  in the labels' brick grid
  Brick brick(glm::ivec3 index) const;
  /// The cover of two structures that labels make together: those that are in a set, and all others. By their masks.
  Brick brickOfSet(glm::ivec3 index, const std::function<bool(std::uint16_t)>& isIn) const;

  const Shared<LabelVolume>& labels() const { return mLabels; }
  const std::vector<ValueBorder>& borders() const { return mBorders; }

 private:
  const ValueBorder* borderOf(std::uint16_t structure) const;
  Shared<LabelVolume> mLabels;
  std::vector<ValueBorder> mBorders;  ///< ascending by structure
};

/// Who has a place among labels.
struct StructurePlace {
  std::uint16_t id = 0;   ///< 0: nobody, or outside the grid
  float coverage = 1.0f;  ///< 1/2 on the border, 1 wholly inside: shaders/shared/structure.h
};

/// Whose the places among labels are. Where several structures meet what has no label, how much all of them have
/// decides first whether there is any, as in a picture that hides what has none. Makes the cover of a brick when it is
/// first asked for and keeps it: a byte a voxel of bricks that have a border. Any thread.
class StructureField {
 public:
  /// @param before  bricks that have not changed since are taken from it
  explicit StructureField(LabelCover cover, const StructureField* before = nullptr);
  /// @param voxel  indices of label voxels, whose middles lie at whole numbers
  StructurePlace at(glm::dvec3 voxel) const;
  /// True of a voxel of the grid in which places may be of different structures.
  bool hasBorder(glm::ivec3 voxel) const { return coverAt(voxel) < 1.0f; }
  /// The cover of a brick.
  const LabelCover::Brick& brick(glm::ivec3 index) const;
  const LabelCover& cover() const { return mCover; }

 private:
  struct Entry {
    std::once_flag isMade, isLabelledMade;
    LabelCover::Brick cover,
        labelled;  ///< labelled: of all that has a label, made where several structures meet nothing
  };
  Entry& entryOf(glm::ivec3 index) const;
  float coverAt(glm::ivec3 voxel) const;
  float labelledShareAt(glm::ivec3 voxel) const;
  LabelCover mCover;
  std::vector<std::shared_ptr<Entry>> mEntries;  ///< [brick grid]
};

/// Bricks of labels, x fastest, whose cover may be another than that of labels of the same grid: those that differ, and
/// those around them. All of them where the grids differ.
std::vector<bool> changedCovers(const LabelVolume& before, const LabelVolume& now);

}  // namespace velum
