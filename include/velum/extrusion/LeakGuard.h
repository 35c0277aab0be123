#pragma once
#include <cstddef>
#include <vector>

namespace velum::extrusion {

/// Watches how wide a region is, slab by slab, and tells when it jumps: then it has leaked through a weak border into
/// something else, for what has one form changes its width little by little.
class LeakGuard {
 public:
  /// @param crossSection  area of what was clicked on, in the cut itself; 0: unknown
  explicit LeakGuard(double crossSection = 0.0) : mCrossSection(crossSection) {}

  /// One slab more. @param area  volume of what grew, or lies, in it by its thickness: the scene's unit, squared
  /// @param voxels  that these are  @return true when it jumps; then it is not one of those before
  bool leaks(double area, std::size_t voxels);
  /// How wide the next slab may be; infinite while there is nothing to tell from.
  double widest() const;

 private:
  double mCrossSection;
  std::vector<double> mAreas;  ///< of the slabs so far
};

}  // namespace velum::extrusion
