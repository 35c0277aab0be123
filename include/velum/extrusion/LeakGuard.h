#pragma once
#include <cstddef>
#include <vector>

namespace velum::extrusion {

/// Watches how wide a region is, slab by slab, and tells when it jumps: then it has leaked through a weak border into
/// something else, for what has one form changes its width little by little.
class LeakGuard {
 public:
  /// @param crossSection  area of what was clicked on, in the cut itself; 0: unknown
  /// @param planeArea  of a plane through all of the data: what is small beside it may change as it likes; 0: unknown
  explicit LeakGuard(double crossSection = 0.0, double planeArea = 0.0);

  /// One slab more. @param area  volume of what grew, or lies, in it by its thickness: the scene's unit, squared
  /// @param voxels  that these are  @return true when it jumps; then it is not one of those before
  bool leaks(double area, std::size_t voxels);
  /// What the first slab is held against: how wide it is where it begins, if that is more than what was clicked on. A
  /// section through spongy bone is many pieces, which one click does not join.
  void beginAs(double area);
  /// How wide the next slab is going to be; infinite while there is nothing to tell from.
  double expected() const;
  /// How wide it may be.
  double widest() const;

 private:
  double mCrossSection, mFloor;
  std::vector<double> mAreas;  ///< of the slabs so far
};

}  // namespace velum::extrusion
