#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/Task.h"

namespace velum::growth {

/// Places (indices) for the voxels of a box with one more layer of voxels, the room, on all sides: code that looks at
/// the neighbours of a voxel of the box need not check whether they exist.
class RoomyBox {
 public:
  /// @param first  first voxel of the box @param size  of the box without the room
  RoomyBox(glm::ivec3 first, glm::ivec3 size) : mFirst(first - 1), mDims(size + 2) {}

  /// Size with the room.
  glm::ivec3 dims() const { return mDims; }
  std::size_t count() const { return std::size_t(mDims.x) * std::size_t(mDims.y) * std::size_t(mDims.z); }
  std::size_t at(glm::ivec3 voxel) const {
    glm::ivec3 p = voxel - mFirst;
    return (std::size_t(p.z) * std::size_t(mDims.y) + std::size_t(p.y)) * std::size_t(mDims.x) + std::size_t(p.x);
  }
  /// True for voxels of the box; false for the room.
  bool holds(glm::ivec3 voxel) const {
    glm::ivec3 p = voxel - mFirst;
    return glm::all(glm::greaterThan(p, glm::ivec3(0))) && glm::all(glm::lessThan(p, mDims - 1));
  }
  /// The differences between the places of neighbours along x, y and z.
  std::array<std::ptrdiff_t, 3> steps() const {
    return {1, std::ptrdiff_t(mDims.x), std::ptrdiff_t(mDims.x) * std::ptrdiff_t(mDims.y)};
  }
  /// The first voxel of the box without the room, and one past the last along each axis.
  glm::ivec3 first() const { return mFirst + 1; }
  glm::ivec3 end() const { return mFirst + mDims - 1; }

 private:
  glm::ivec3 mFirst, mDims;
};

/// Lengths in sixteenths of the shortest step between neighbours.
using Lengths = std::vector<std::uint16_t>;
constexpr int kLengthUnit = 16;
constexpr std::uint16_t kFarAway = 60000;

/// Computes for each voxel the length of the shortest path, by steps to any of 26 neighbours, to the nearest of some
/// voxels ([BORGEFORS]'s chamfer). Two passes.
/// @param lengths  in: 0 at the voxels to be reached, kFarAway at all others; out: the lengths
void spreadLengths(const RoomyBox& box, const glm::dmat3& worldFromVoxel, Lengths& lengths);

/// The factor between levels of thickness ([THICKNESS]). The thickness of a shape at a voxel is the radius of the
/// largest ball within the shape that holds the voxel. A ball is equally thick everywhere, and so is a tube; where the
/// two meet the thickness jumps.
constexpr double kThicker = 1.35;
/// @param depths  distance from each voxel of the shape to the outside of the shape; 0 at all other voxels
/// @return the level of each voxel: its thickness is kThicker^level or more; 0: less
/// @throw Cancelled
std::vector<std::uint8_t> thicknessLevels(const RoomyBox& box, const glm::dmat3& worldFromVoxel, const Lengths& depths,
                                          const Progress& progress);

}  // namespace velum::growth
