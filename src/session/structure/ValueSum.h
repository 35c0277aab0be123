#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "session/structure/StructureValues.h"

namespace velum::session {

/// Sums of values over voxels, about the first of them, so that few digits are lost.
struct ValueSum {
  std::uint64_t voxels = 0;
  double first = 0, sum = 0, squares = 0;
  double least = std::numeric_limits<double>::infinity(), most = -least;

  void add(double value) {
    if (voxels++ == 0) first = value;
    double off = value - first;
    sum += off;
    squares += off * off;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  void join(const ValueSum& other) {
    if (other.voxels == 0) return;
    if (voxels == 0) {
      *this = other;
      return;
    }
    double shift = other.first - first, count = double(other.voxels);
    squares += other.squares + 2 * shift * other.sum + count * shift * shift;
    sum += other.sum + count * shift;
    voxels += other.voxels;
    least = std::min(least, other.least);
    most = std::max(most, other.most);
  }
};

/// @param sum  of one voxel or more
inline StructureValues valuesOf(const ValueSum& sum) {
  double count = double(sum.voxels), mean = sum.sum / count;
  return {sum.voxels, sum.first + mean, std::sqrt(std::max(0.0, sum.squares / count - mean * mean)), sum.least,
          sum.most};
}

}  // namespace velum::session
