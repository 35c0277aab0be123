#include "growth/LeakGuard.h"

#include <algorithm>
#include <limits>

namespace velum::growth {

namespace {

/// By so much a slab is wider than those before let expect when it leaks. Between what structures do by themselves and
/// what leaks do, on the phantoms of LeakGuardTest: balls, cones of up to 45 degrees and vessels that fork stay below
/// 1.9, the leaks begin at 9.
constexpr double kJump = 3.0;
/// The same for the first slab against the cut, where nothing tells yet how the width changes: the cap of a ball is
/// there up to 2.6 times as wide as its cut.
constexpr double kFirstJump = 4.0;
/// The same where what has been thin becomes solid, which says as much again.
constexpr double kSolidJump = 2.0;
/// A section that is less than this share of a plane through the data counts as so much: a thread that opens into its
/// tree, a thin shell that is met along its side. Leaks that do harm become some hundredths of the plane and more.
constexpr double kFloorShare = 0.02;
/// Of a section, less is the inside of something where it is thin. Tuned on the rows of RealPulls that say so: threads,
/// shells of skulls and spongy bone are below 0.03, vessels, hearts and what bone leaks into are above 0.14.
constexpr double kThinShare = 0.08;
/// What is thin may become this share of the plane, however little it has been; trees and shells are half of it.
constexpr double kThinMost = 0.25;
/// Fewer voxels than these do no harm, and their number says little.
constexpr std::size_t kFewVoxels = 200;

bool isThin(const Section& section) { return section.solid < kThinShare * section.area; }

}  // namespace

LeakGuard::LeakGuard(const Section& crossSection, double planeArea)
    : mCrossSection(crossSection), mPlaneArea(planeArea) {}

void LeakGuard::beginAs(const Section& section) {
  if (mCrossSection.area > 0.0 && section.area > mCrossSection.area) mCrossSection = section;
}

double LeakGuard::expected() const {
  if (mBefore.empty()) return mCrossSection.area > 0.0 ? mCrossSection.area : std::numeric_limits<double>::infinity();
  std::size_t count = std::min(mBefore.size(), kSlabsBefore);
  auto isNarrower = [](const Section& a, const Section& b) { return a.area < b.area; };
  double expected = std::max_element(mBefore.end() - std::ptrdiff_t(count), mBefore.end(), isNarrower)->area;
  // A form that has become wider goes on as steeply.
  double last = mBefore.back().area,
         before = mBefore.size() > 1 ? mBefore[mBefore.size() - 2].area : mCrossSection.area;
  if (before > 0.0) expected = std::max(expected, last + std::max(last - before, 0.0));
  return expected;
}

bool LeakGuard::hasBeenThin() const {
  if (mBefore.empty()) return isThin(mCrossSection);
  std::size_t count = std::min(mBefore.size(), kSlabsBefore);
  return std::all_of(mBefore.end() - std::ptrdiff_t(count), mBefore.end(), isThin);
}

double LeakGuard::width(const Section& next) const { return hasBeenThin() && isThin(next) ? next.area : next.joined; }

double LeakGuard::widest(const Section& next) const {
  double wide = std::max(expected(), kFloorShare * mPlaneArea);
  if (!hasBeenThin()) return (mBefore.empty() ? kFirstJump : kJump) * wide;
  if (isThin(next)) return std::max(kJump * wide, kThinMost * mPlaneArea);
  return (mBefore.empty() ? kFirstJump : kSolidJump) * wide;
}

bool LeakGuard::leaks(const Section& slab, std::size_t voxels) {
  if (voxels >= kFewVoxels && width(slab) > widest(slab)) return true;
  // Where it has not yet begun nothing tells how wide it is.
  if (slab.area > 0.0) mBefore.push_back(slab);
  return false;
}

}  // namespace velum::growth
