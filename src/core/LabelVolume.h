#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "core/BrickTable.h"
#include "core/Shared.h"
#include "core/Units.h"

namespace velum {

/// One named region of a label volume.
struct LabelInfo {
  std::uint16_t id = 0;
  std::string name;
  glm::vec3 color{1.0f};     ///< sRGB, 0..1
  float opacity = 1.0f;      ///< 0..1
  std::uint64_t fileId = 0;  ///< its number in the file where that is another, of up to 64 bits; else 0
  bool operator==(const LabelInfo&) const = default;
};

/// Structure ids on a grid of their own, 0 = nothing, up to 65,535 structures.
///
/// Stored in bricks of 32^3 that copies share: an edited copy costs the bricks that it touched, so undo is cheap.
/// A brick of one id keeps only that id; large parts of the grid that were never written to take next to nothing. Shape
/// and frame as in Volume.
class LabelVolume {
 public:
  static constexpr int kBrickSize = 32;
  using Brick = std::vector<std::uint16_t>;  ///< kBrickSize^3 ids, x fastest; or one id for a uniform brick.

  LabelVolume() = default;
  /// All zero. @throw ArgumentError when a dimension is < 1
  LabelVolume(glm::ivec3 dims, const glm::dmat4& worldFromVoxel, LengthUnit unit = LengthUnit::Millimetre);

  glm::ivec3 dims() const { return mDims; }
  const glm::dmat4& worldFromVoxel() const { return mWorldFromVoxel; }
  /// Id at a voxel; 0 outside.
  std::uint16_t at(glm::ivec3 voxel) const;
  /// Writes a box of ids, shape [size.z][size.y][size.x]. Bricks that become uniform are stored as one id. Bricks whose
  /// ids do not change keep their brickId().
  /// @throw ArgumentError when the box leaves the grid or the span is short
  void write(glm::ivec3 origin, glm::ivec3 size, std::span<const std::uint16_t> ids);
  /// Gives all voxels of a brick one id. O(1). @param index  in the brick grid
  void fillBrick(glm::ivec3 index, std::uint16_t id);
  /// Copies a box out, the counterpart of write().
  void read(glm::ivec3 origin, glm::ivec3 size, std::span<std::uint16_t> ids) const;

  glm::ivec3 brickGrid() const { return mBricks.grid(); }
  const Brick& brick(glm::ivec3 index) const;
  /// Number of a brick's contents, never used twice: bricks of two label volumes that have the same number hold the
  /// same ids.
  std::uint64_t brickId(glm::ivec3 index) const;
  /// Bytes held by bricks that are not uniform.
  std::size_t storedBytes() const;
  /// Ids in use, ascending, without 0. O(voxels of the bricks that are not uniform).
  std::vector<std::uint16_t> idsInUse() const;

  std::vector<LabelInfo> table;  ///< Names and colours, ascending by id; made up where the file has none.
  std::string name;
  std::vector<std::string> warnings;

  LengthUnit lengthUnit() const { return mLengthUnit; }
  /// The same labels with their world in another unit.
  void setLengthUnit(LengthUnit unit);

 private:
  glm::ivec3 mDims{0};
  glm::dmat4 mWorldFromVoxel{1.0};
  LengthUnit mLengthUnit = LengthUnit::Millimetre;
  BrickTable<Shared<Brick>> mBricks;
};

/// A calm, colour-blind-friendly colour, sRGB, for an id for which no colour is known. The same id gives the same
/// colour.
glm::vec3 defaultLabelColor(std::uint16_t id);

}  // namespace velum
