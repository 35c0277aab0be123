#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "core/FinestVoxels.h"
#include "core/Task.h"
#include "growth/GrowDomain.h"
#include "growth/RegionGrow.h"
#include "growth/Thickness.h"

namespace velum::growth {

/// The cost of going through a region from voxel to voxel: little where the region goes on as it is, much across an
/// edge of values, and as much where the region becomes thicker or thinner all at once, as at a neck between two
/// things.
///
/// Memory: seven bytes for each voxel of the region's box, and while it is made up to two more for each core, or four.
class PassageCosts {
 public:
  /// @param domain  where the region has grown; whether voxels outside it would belong to the region is unknown
  /// @throw Cancelled; InputError when a brick cannot be read, or the box is too large for the memory
  PassageCosts(const RegionGrow& region, const FinestVoxels& voxels, const GrowDomain& domain, Progress& progress);

  const RoomyBox& box() const { return mBox; }
  bool holds(std::size_t place) const { return mIsIn[place] != 0; }
  /// Cost of the step between two neighbours, the same in both directions; at least 1.
  /// @param from, to  places in the box whose voxels share a face; both belong to the region
  int cost(std::size_t from, std::size_t to, int axis) const {
    float edge = std::abs(mValues[from] - mValues[to]) * mPerNoise;
    // Also true where a value is not a number.
    if (!(edge < kMostEdge)) edge = kMostEdge;
    int one = mLevels[from], other = mLevels[to];
    std::uint8_t depth = std::min(mDepths[from], mDepths[to]);
    return mLength[std::size_t(axis)] + int(kPerEdge * edge * edge) + kPerLevel * std::abs(one - other) +
           mThinness[depth];
  }
  int mostCost() const;

 private:
  /// Costs, in thousandths of the cost of becoming e times as thick. An edge of 1 is noise: half of the differences of
  /// neighbouring values are less; the squares of edges count, so that noise is cheap. The length of a step costs
  /// little, only so that the border lies in the middle where all else is the same. A step costs more the nearer to the
  /// outside of the region it goes, by the square of its depth in voxels, so that two balls with a neck between them
  /// have their border there, even where one of the balls would cover the neck. Chosen with all cases of NotThisTest in
  /// sight.
  static constexpr float kMostEdge = 20.0f, kPerEdge = 60.0f;
  static constexpr int kPerLevel = 300, kPerStep = 2, kPerThinStep = 150;

  /// Unit of depths: eighths of a voxel; voxels deeper than 32 count as 32 deep.
  static constexpr int kDepthUnit = 8;

  void takeRegion(const RegionGrow& region);
  void takeDepths(const Lengths& depths);
  Lengths depths(const Volume& volume, const GrowDomain& domain) const;
  void readValues(const FinestVoxels& voxels, int channel, int timeStep, std::vector<float>& raw) const;
  void smoothValues(const FinestVoxels& voxels, int channel, int timeStep);
  double noise() const;

  RoomyBox mBox;
  std::vector<std::uint8_t> mIsIn, mLevels;
  std::vector<std::uint8_t> mDepths;  ///< distance of each voxel from the outside of the region, in kDepthUnit
  std::vector<float> mValues;
  std::array<int, 3> mLength{};
  std::array<int, 256> mThinness{};  ///< by depth
  float mPerNoise = 0.0f;
};

}  // namespace velum::growth
