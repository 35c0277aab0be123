#pragma once
#include <cstddef>
#include <vector>

namespace velum::growth {

/// What a region is in one slab, volumes by the slab's thickness: the scene's unit, squared.
struct Section {
  double area = 0.0;  ///< of all that lies in it
  /// The same with what has joined meanwhile in the slabs before: what leaks comes back into them.
  double joined = 0.0;
  double solid = 0.0;  ///< of the area, as much as of what joined is inside of what is no thread, shell or strut
};

/// Watches how wide a region is, slab by slab, and tells when it jumps: then it has leaked through a weak border into
/// something else, for what has one form changes its width little by little. Of what is thin that says nothing: a
/// thread, a shell or spongy bone that is cut is many pieces, which hang together by few voxels farther on. But what is
/// thin does not become something solid.
class LeakGuard {
 public:
  /// The widest of so many slabs counts, so that a neck is no leak; what lies before them no longer does.
  static constexpr std::size_t kSlabsBefore = 3;

  /// @param crossSection  of what was clicked on, in the cut itself; no area: unknown
  /// @param planeArea  of a plane through all of the data: what is small beside it may change as it likes; 0: unknown
  explicit LeakGuard(const Section& crossSection = {}, double planeArea = 0.0);

  /// One slab more. @param voxels  that joined with it
  /// @return true when it jumps; then it is not one of those before
  bool leaks(const Section& slab, std::size_t voxels);
  /// What the first slab is held against: how wide it is where it begins, if that is more than what was clicked on. A
  /// section through spongy bone is many pieces, which one click does not join.
  void beginAs(const Section& section);
  /// How wide the next slab is going to be; infinite while there is nothing to tell from.
  double expected() const;
  /// What counts of a slab: what comes back says nothing where all is thin.
  double width(const Section& next) const;
  /// How wide it may be.
  double widest(const Section& next) const;

 private:
  bool hasBeenThin() const;

  Section mCrossSection;
  double mPlaneArea;
  std::vector<Section> mBefore;  ///< the slabs so far
};

}  // namespace velum::growth
