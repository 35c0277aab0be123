#include "velum/extrusion/LeakGuard.h"

#include <algorithm>
#include <limits>

namespace velum::extrusion {

namespace {

/// By so much a slab is wider than those before let expect when it leaks. Between what structures do by themselves and
/// what leaks do, on the phantoms of LeakGuardTest: balls, cones of up to 45 degrees and vessels that fork stay below
/// 1.9, the leaks begin at 9.
constexpr double kJump = 3.0;
/// The same for the first slab against the cut, where nothing tells yet how the width changes: the cap of a ball is
/// there up to 2.6 times as wide as its cut.
constexpr double kFirstJump = 4.0;
/// The widest of so many slabs counts, so that a neck is no leak.
constexpr std::size_t kSlabsBefore = 3;
/// A section that is less than this share of a plane through the data counts as so much: a thread that opens into its
/// tree, a thin shell that is met along its side. Leaks that do harm become some hundredths of the plane and more.
constexpr double kFloorShare = 0.02;
/// Fewer voxels than these do no harm, and their number says little.
constexpr std::size_t kFewVoxels = 200;

}  // namespace

LeakGuard::LeakGuard(double crossSection, double planeArea)
    : mCrossSection(crossSection), mFloor(kFloorShare * planeArea) {}

void LeakGuard::beginAs(double area) {
  if (mCrossSection > 0.0) mCrossSection = std::max(mCrossSection, area);
}

double LeakGuard::expected() const {
  if (mAreas.empty()) return mCrossSection > 0.0 ? mCrossSection : std::numeric_limits<double>::infinity();
  std::size_t count = std::min(mAreas.size(), kSlabsBefore);
  double expected = *std::max_element(mAreas.end() - std::ptrdiff_t(count), mAreas.end());
  // A form that has become wider goes on as steeply.
  double before = mAreas.size() > 1 ? mAreas[mAreas.size() - 2] : mCrossSection;
  if (before > 0.0) expected = std::max(expected, mAreas.back() + std::max(mAreas.back() - before, 0.0));
  return expected;
}

double LeakGuard::widest() const { return (mAreas.empty() ? kFirstJump : kJump) * std::max(expected(), mFloor); }

bool LeakGuard::leaks(double area, std::size_t voxels) {
  if (voxels >= kFewVoxels && area > widest()) return true;
  // Where it has not yet begun nothing tells how wide it is.
  if (area > 0.0) mAreas.push_back(area);
  return false;
}

}  // namespace velum::extrusion
