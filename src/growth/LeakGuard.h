#pragma once
#include <cstddef>
#include <vector>

namespace velum::growth {

/// How wide a region is in one slab, as areas: volumes divided by the slab's thickness, the scene's unit squared.
struct Section {
  double area = 0.0;  ///< of the part of the region that lies in the slab
  /// `area` with the voxels added that joined in the slabs before while this one grew: a leak comes back into these.
  double joined = 0.0;
  double solid = 0.0;  ///< the part of `area` that is the inside of something solid, see countSolid(); for a slab from
                       ///< which more came back than it holds, by the share that is solid in the whole region
};

/// Watches how wide a region is, slab by slab, and tells when the width jumps: then the region has leaked through a
/// weak border into something else, for a structure of one form changes its width little by little. The width says
/// nothing of thin structures: where a thread, a shell or spongy bone is cut it is many pieces, which hang together by
/// a few voxels farther on. But a thin structure does not become a solid one.
class LeakGuard {
 public:
  /// The next slab is compared with the widest of this many slabs before it, so that the widening behind a neck is no
  /// leak.
  static constexpr std::size_t kSlabsBefore = 3;

  /// @param crossSection  of the structure that was clicked on, in the plane of the cut; area 0: unknown
  /// @param planeArea  area of a plane through all of the data: regions that are small beside it may change as they
  /// like; 0: unknown
  explicit LeakGuard(const Section& crossSection = {}, double planeArea = 0.0);

  /// Looks at the next slab. @param voxels  how many voxels joined with it
  /// @return true when the width jumps; then the slab is not kept among the slabs before
  bool leaks(const Section& slab, std::size_t voxels);
  /// Sets what the first slab is compared with to the region's width where that slab begins, if it is more than that of
  /// the structure clicked on. A section through spongy bone is many pieces, and a click joins only one of them.
  void beginAs(const Section& section);
  /// The width to be expected of the next slab; infinite while nothing is known to tell it from.
  double expected() const;
  /// The width that counts of a slab: `area` where both the slab and those before are thin, for then voxels that come
  /// back say nothing; else `joined`.
  double width(const Section& next) const;
  /// The width beyond which the slab counts as a leak.
  double widest(const Section& next) const;

 private:
  bool hasBeenThin() const;

  Section mCrossSection;
  double mPlaneArea;
  std::vector<Section> mBefore;  ///< the slabs so far
};

}  // namespace velum::growth
