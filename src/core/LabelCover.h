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

/// A structure that lies where the values of a volume are within a range: its border runs between voxels, where the
/// values leave the range. The labels lie on the grid of the volume's finest level.
struct ValueBorder {
  std::uint16_t structure = 0;
  std::uint16_t within = 0;  ///< label out of which the structure was taken: where values of the range go on into that
                             ///< label, so does the structure
  Shared<Volume> volume;
  int channel = 0, timeStep = 0;
  double low = 0.0, high = 0.0;  ///< values that belong to the structure, the volume's unit, both ends included
  double scale = 1.0;  ///< distance from the range's nearer end, in values, that counts as wholly inside or outside
  bool operator==(const ValueBorder&) const = default;
};

/// The ids of a box of voxels, [size.z][size.y][size.x]. The box may reach beyond the grid, where the ids of the grid's
/// outermost voxels are repeated.
std::vector<std::uint16_t> readAround(const LabelVolume& labels, glm::ivec3 origin, glm::ivec3 size);

/// True when a brick is of one id, and so are the bricks that touch it, of the same. @param index  in the brick grid
bool isUniformAround(const LabelVolume& labels, glm::ivec3 index);

/// How far inside its structure each voxel of a label volume lies, the voxel's cover: a byte from 1, next to the
/// border, to 255, where none of the 26 voxels around belongs to another structure. Label 0 counts as a structure like
/// any other.
///
/// The share of a voxel that belongs to its own structure is (1 + cover / 255) / 2; the rest may belong to another one.
/// Shares are interpolated between voxels, and the border lies where two structures have equal shares (structureAt()).
/// As every voxel gives at least half of itself to its own structure, no voxel's middle changes sides, and structures
/// that are one voxel thin stay whole.
///
/// At the borders of a ValueBorder the cover grows with the distance of the voxel's value from the end of the range, so
/// that the border lies where the value equals that end. At other borders the cover is the membership (1 inside, 0
/// outside) smoothed by G + 2.65 (G - G G), where G is 1 4 6 4 1 along each axis; the second term restores what
/// smoothing takes from thin or round shapes. A function of the labels and borders alone. Any thread.
class LabelCover {
 public:
  static constexpr int kHalo = 4;  ///< width, in voxels, of the surroundings of a brick on which its cover depends
  using Brick = std::vector<std::uint8_t>;  ///< LabelVolume::kBrickSize^3 covers, x fastest; or a single one for a
                                            ///< brick that is 255 everywhere

  explicit LabelCover(Shared<LabelVolume> labels, std::vector<ValueBorder> borders = {});
  /// @param index  in the labels' brick grid
  Brick brick(glm::ivec3 index) const;
  /// The cover of a brick when the labels are joined to just two structures: all labels that are in a set, and all
  /// others. Made from the masks of the two, whatever the value borders.
  Brick brickOfSet(glm::ivec3 index, const std::function<bool(std::uint16_t)>& isIn) const;

  const Shared<LabelVolume>& labels() const { return mLabels; }
  const std::vector<ValueBorder>& borders() const { return mBorders; }

 private:
  const ValueBorder* borderOf(std::uint16_t structure) const;
  Shared<LabelVolume> mLabels;
  std::vector<ValueBorder> mBorders;  ///< ascending by structure
};

/// Which structure a place among labels belongs to.
struct StructurePlace {
  std::uint16_t id = 0;   ///< label id; 0: no structure, or outside the grid
  float coverage = 1.0f;  ///< 1/2 on the border, 1 wholly inside: shaders/shared/structure.h
};

/// Says to which structure each place among labels belongs. Where several structures meet unlabelled material, the sum
/// of their shares decides first whether the place is labelled at all, as in a picture that hides unlabelled material.
/// The cover of a brick is made when first asked for, then kept: a byte a voxel for bricks that have a border. Any
/// thread.
class StructureField {
 public:
  /// @param before  an earlier field: covers of bricks that have not changed since are taken from it
  explicit StructureField(LabelCover cover, const StructureField* before = nullptr);
  /// @param voxel  indices of label voxels, whose middles lie at whole numbers
  StructurePlace at(glm::dvec3 voxel) const;
  /// True for a voxel of the grid whose places may belong to different structures.
  bool hasBorder(glm::ivec3 voxel) const { return coverAt(voxel) < 1.0f; }
  /// The cover of a brick.
  const LabelCover::Brick& brick(glm::ivec3 index) const;
  const LabelCover& cover() const { return mCover; }

 private:
  struct Entry {
    std::once_flag isMade, isLabelledMade;
    LabelCover::Brick cover,
        labelled;  ///< labelled: cover of all labels together, made where several structures meet unlabelled voxels
  };
  Entry& entryOf(glm::ivec3 index) const;
  float coverAt(glm::ivec3 voxel) const;
  float labelledShareAt(glm::ivec3 voxel) const;
  LabelCover mCover;
  BrickTable<std::shared_ptr<Entry>> mEntries;
};

/// For each brick of `now`, x fastest, whether its cover may differ from that in `before`: true for bricks whose labels
/// differ and for the bricks around these. True for all bricks where the grids differ.
std::vector<bool> changedCovers(const LabelVolume& before, const LabelVolume& now);

}  // namespace velum
