#pragma once
#include <glm/glm.hpp>
#include <limits>

#include "core/Volume.h"

namespace velum::growth {

/// Voxels of a row from `first` to before `end`.
struct RowSpan {
  int first = 0, end = 0;
  bool isEmpty() const { return first >= end; }
  bool operator==(const RowSpan&) const = default;
};

/// The domain in which a step may grow: all voxels whose middle lies in the removed side of a plane, no deeper than a
/// distance ([ACS] Prop. 1). A row of voxels meets the domain in a single span.
class GrowDomain {
 public:
  /// Everywhere.
  GrowDomain() = default;
  /// 0 < depth <= distance, depth = dot(p - centre, axis / |axis|), p in the world.
  /// @param axis  towards the removed side; zero: everywhere, whatever the distance
  /// @throw ArgumentError when centre or axis is not finite, or the distance is no number
  GrowDomain(const Volume& volume, glm::dvec3 centre, glm::dvec3 axis, double distance);

  /// The same plane with another distance.
  GrowDomain upTo(double distance) const;
  /// The part of the domain's half-space with depths from `from` (excluded) to `to` (included); both may be negative.
  GrowDomain between(double from, double to) const;

  bool isEverywhere() const { return mIsEverywhere; }
  double from() const { return mFrom; }
  double distance() const { return mTo; }
  /// Depth of a voxel's middle; 0 where the domain is everywhere. Along each axis it only rises or only falls, in spite
  /// of rounding.
  double depth(glm::ivec3 voxel) const;
  bool contains(glm::ivec3 voxel) const;
  /// The voxels x = 0 to before `width` of row (y, z) for which contains() is true.
  RowSpan rowSpan(int y, int z, int width) const;
  /// False only when no voxel of the box lies in the domain. @param last  included
  bool mayMeet(glm::ivec3 first, glm::ivec3 last) const;
  /// Smallest and largest depth of a box of voxels. @param last  included
  glm::dvec2 depthRange(glm::ivec3 first, glm::ivec3 last) const;
  /// The differences of depth between neighbours along x, y and z, added up: the voxels of a layer this thick are
  /// joined by faces.
  double layer() const;

 private:
  bool mIsEverywhere = true;
  double mFrom = 0.0, mTo = std::numeric_limits<double>::infinity();
  double mAtOrigin = 0.0;  ///< depth of voxel 0, 0, 0
  glm::dvec3 mPerVoxel{0.0};
};

/// Thickness of a slab, the layer that is grown at a time ([ACS] 4.2): two diagonals of a voxel, in the volume's unit
/// of length.
double slabThickness(const Volume& volume);

}  // namespace velum::growth
