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

/// Where a step of growing goes: all voxels whose middle lies deep in the removed side of a plane, but no deeper than
/// it says ([ACS] Prop. 1). A row of voxels meets it in one span.
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
  /// What lies from one depth, not itself, to another; may be negative.
  GrowDomain between(double from, double to) const;

  bool isEverywhere() const { return mIsEverywhere; }
  double distance() const { return mTo; }
  /// Of a voxel's middle; 0 where it is everywhere. Never falls along an axis and rises elsewhere on it, though
  /// rounded.
  double depth(glm::ivec3 voxel) const;
  bool contains(glm::ivec3 voxel) const;
  /// Exactly what contains() says of a row's voxels from 0 to before `width`.
  RowSpan rowSpan(int y, int z, int width) const;
  /// False only when no voxel of a box lies in it. @param last  included
  bool mayMeet(glm::ivec3 first, glm::ivec3 last) const;
  /// Smallest and largest depth of a box of voxels. @param last  included
  glm::dvec2 depthRange(glm::ivec3 first, glm::ivec3 last) const;
  /// Depth between neighbours along x, y and z, all added up: a layer as thick holds together by faces.
  double layer() const;

 private:
  bool mIsEverywhere = true;
  double mFrom = 0.0, mTo = std::numeric_limits<double>::infinity();
  double mAtOrigin = 0.0;  ///< depth of voxel 0, 0, 0
  glm::dvec3 mPerVoxel{0.0};
};

/// Two diagonals of a voxel: what is grown at a time ([ACS] 4.2), the volume's unit of length.
double slabThickness(const Volume& volume);

}  // namespace velum::growth
