#pragma once
#include <vector>

#include "io/meshes/BorderWay.h"

namespace velum::io {

/// What part of the voxels of a box is a structure's: at least half of its own, and what is left of others around it.
/// As pictures have it where they show nothing else. Any thread.
class StructureShares {
 public:
  /// For ways that begin in a box. @param low, high  both included; a way may begin one voxel before the grid
  StructureShares(const StructureField& field, std::uint16_t structure, glm::ivec3 low, glm::ivec3 high);
  /// True where in a cell that the way bounds there is a third structure, or what has no label beside two.
  bool hasThird(const BorderWay& way) const;
  /// The same as io::partOf(), from what is at hand.
  double partOf(const BorderWay& way) const;
  /// Outwards, a unit of voxel space: against the gradient of the shares. Zero where they have none.
  glm::dvec3 normalAt(const BorderWay& way, double part) const;

 private:
  /// Values of a box of voxels, x fastest.
  template <class Value>
  struct Box {
    glm::ivec3 low{0}, size{0};
    std::vector<Value> values;
    std::size_t at(glm::ivec3 voxel) const {
      voxel -= low;
      return (std::size_t(voxel.z) * std::size_t(size.y) + std::size_t(voxel.y)) * std::size_t(size.x) +
             std::size_t(voxel.x);
    }
  };
  void fillIds();
  void fillShares(glm::ivec3 brick);
  bool isBeside(glm::ivec3 voxel) const;
  std::uint16_t idIn(glm::ivec3 voxel) const { return mIds.values[mIds.at(voxel)]; }
  float shareOf(glm::ivec3 voxel) const { return mShares.values[mShares.at(voxel)]; }

  const StructureField& mField;  ///< is kept by whoever asks
  std::uint16_t mStructure;
  Box<std::uint16_t> mIds;  ///< 0 beyond the grid
  Box<float> mShares;       ///< 0 beyond the grid
};

}  // namespace velum::io
