#pragma once
#include <vector>

#include "io/meshes/BorderWay.h"

namespace velum::io {

/// The share of each voxel of a box that belongs to one structure: at least half of the structure's own voxels, and of
/// other structures' voxels around it what these leave. These are the shares of a picture that shows only this
/// structure. Any thread.
class StructureShares {
 public:
  /// Makes the shares for ways that begin in a box. @param low, high  both included; a way may begin one voxel before
  /// the grid
  StructureShares(const StructureField& field, std::uint16_t structure, glm::ivec3 low, glm::ivec3 high);
  /// True where a cell (cube of eight voxel middles) that the way bounds holds a third structure, or two structures and
  /// unlabelled voxels.
  bool hasThird(const BorderWay& way) const;
  /// As io::partOf(), but computed from the shares kept here.
  double partOf(const BorderWay& way) const;
  /// The outward normal at a part of the way, of unit length in voxel space: opposite to the gradient of the shares.
  /// Zero where the gradient is zero.
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

  const StructureField& mField;  ///< owned by the caller, who keeps it alive
  std::uint16_t mStructure;
  Box<std::uint16_t> mIds;  ///< 0 beyond the grid
  Box<float> mShares;       ///< 0 beyond the grid
};

}  // namespace velum::io
