#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "core/Task.h"
#include "core/Volume.h"
#include "growth/GrowDomain.h"
#include "growth/RegionGrow.h"
#include "growth/Thickness.h"

namespace velum::growth {

/// What it costs to go through a region from voxel to voxel: little where it goes on as it is, much over an edge of
/// values, and as much where it becomes thicker or thinner all at once, as a neck between two things does.
///
/// Seven bytes a voxel of the region's box, and up to two for each core, or four, while it is made.
class PassageCosts {
 public:
  /// @param domain  where the region has grown: nothing is known of what lies outside
  /// @throw Cancelled
  PassageCosts(const RegionGrow& region, const Volume& volume, const GrowDomain& domain, Progress& progress);

  const RoomyBox& box() const { return mBox; }
  bool holds(std::size_t place) const { return mIsIn[place] != 0; }
  /// The same from either side; at least 1.
  /// @param from, to  places of the box that are joined by a face, both of the region
  int cost(std::size_t from, std::size_t to, int axis) const {
    float edge = std::abs(mValues[from] - mValues[to]) * mPerNoise;
    // Also false for what is no number.
    if (!(edge < kMostEdge)) edge = kMostEdge;
    int one = mLevels[from], other = mLevels[to];
    std::uint8_t depth = std::min(mDepths[from], mDepths[to]);
    return mLength[std::size_t(axis)] + int(kPerEdge * edge * edge) + kPerLevel * std::abs(one - other) +
           mThinness[depth];
  }
  int mostCost() const;

 private:
  /// In thousandths of the cost of becoming e times as thick. Of the differences of values half are less than an edge
  /// of 1, which is noise; their squares count, so that noise is cheap. Length says little, but where all else is the
  /// same the middle is the border. A step counts more the nearer to what is not of the region it goes, by the square
  /// of its depth in voxels, so that two balls of which one would cover the neck between them have a border there.
  /// Chosen with all cases of NotThisTest in sight.
  static constexpr float kMostEdge = 20.0f, kPerEdge = 60.0f;
  static constexpr int kPerLevel = 300, kPerStep = 2, kPerThinStep = 150;

  /// Eighths of a voxel; what lies deeper than 32 counts as that.
  static constexpr int kDepthUnit = 8;

  void takeRegion(const RegionGrow& region);
  void takeDepths(const Lengths& depths);
  Lengths depths(const Volume& volume, const GrowDomain& domain) const;
  void smoothValues(const Volume& volume, int channel, int timeStep);
  double noise() const;

  RoomyBox mBox;
  std::vector<std::uint8_t> mIsIn, mLevels;
  std::vector<std::uint8_t> mDepths;  ///< below what is not of it, in kDepthUnit
  std::vector<float> mValues;
  std::array<int, 3> mLength{};
  std::array<int, 256> mThinness{};  ///< by depth
  float mPerNoise = 0.0f;
};

}  // namespace velum::growth
