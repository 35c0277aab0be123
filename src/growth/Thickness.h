#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/Task.h"

namespace velum::growth {

/// A byte for each voxel of a box, with a layer of room on all sides that nobody knows: whoever looks beside a voxel
/// of the box need not ask whether there is one.
class RoomyBox {
 public:
  /// @param first  its first voxel  @param size  without the room
  RoomyBox(glm::ivec3 first, glm::ivec3 size) : mFirst(first - 1), mDims(size + 2) {}

  /// With the room.
  glm::ivec3 dims() const { return mDims; }
  std::size_t count() const { return std::size_t(mDims.x) * std::size_t(mDims.y) * std::size_t(mDims.z); }
  std::size_t at(glm::ivec3 voxel) const {
    glm::ivec3 p = voxel - mFirst;
    return (std::size_t(p.z) * std::size_t(mDims.y) + std::size_t(p.y)) * std::size_t(mDims.x) + std::size_t(p.x);
  }
  /// False for its room, too.
  bool holds(glm::ivec3 voxel) const {
    glm::ivec3 p = voxel - mFirst;
    return glm::all(glm::greaterThan(p, glm::ivec3(0))) && glm::all(glm::lessThan(p, mDims - 1));
  }
  /// How far apart in memory neighbours along x, y and z are.
  std::array<std::ptrdiff_t, 3> steps() const {
    return {1, std::ptrdiff_t(mDims.x), std::ptrdiff_t(mDims.x) * std::ptrdiff_t(mDims.y)};
  }
  /// The first voxel without the room, and behind the last one.
  glm::ivec3 first() const { return mFirst + 1; }
  glm::ivec3 end() const { return mFirst + mDims - 1; }

 private:
  glm::ivec3 mFirst, mDims;
};

/// Lengths in sixteenths of the shortest step between neighbours.
using Lengths = std::vector<std::uint16_t>;
constexpr int kLengthUnit = 16;
constexpr std::uint16_t kFarAway = 60000;

/// For each voxel how long the shortest way to one of some is, in steps to any of 26 neighbours ([BORGEFORS]'s
/// chamfer). Two passes.
/// @param lengths  0 at those, kFarAway at all others; becomes the lengths
void spreadLengths(const RoomyBox& box, const glm::dmat3& worldFromVoxel, Lengths& lengths);

/// How thick something is ([THICKNESS]): the radius of the largest ball within it that holds a voxel, in steps of
/// kThicker. A ball is as thick everywhere, a tube, too, and where they meet the thickness jumps.
constexpr double kThicker = 1.35;
/// @param depths  from each voxel of it to what is not; 0 at all others
/// @return levels: of radius kThicker^level or more; 0: less
/// @throw Cancelled
std::vector<std::uint8_t> thicknessLevels(const RoomyBox& box, const glm::dmat3& worldFromVoxel, const Lengths& depths,
                                          const Progress& progress);

}  // namespace velum::growth
