#pragma once
#include <memory>
#include <vector>

#include "gpu/Context.h"
#include "gpu/Texture.h"
#include "render/upload/ShareTexels.h"

namespace velum::render {

/// Textures, to be interpolated by shaders, that tell how far inside their structures places among labels lie: the
/// covers of voxels (LabelCover), the shares of voxels in sets of structures (StructureSets), and the means of the
/// shares over 2 x 2 x 2 voxels. Covers take one byte a voxel, shares two or four, and their means an eighth more.
/// Follows edits brick by brick. GL thread; works on all cores.
class ShareUpload {
 public:
  explicit ShareUpload(const gpu::Limits& limits) : mLimits(limits) {}
  /// @throw gpu::GpuError when labels are larger than the driver's 3D textures or memory
  void begin(const scene::Scene& scene, bool isAlone);
  /// Makes and sends some bricks. @return true when the textures agree with the scene
  bool step();

  /// The textures, in the labels' own grid.
  const gpu::Texture& covers() const { return mCovers; }
  const gpu::Texture& shares() const { return mShares; }
  /// Means of the shares: half as many texels along each axis, rounded up.
  const gpu::Texture& coarseShares() const { return mCoarseShares; }
  /// Sets of the scene for which begin() was called last.
  const StructureSets& sets() const { return mSets; }

 private:
  void allocate(glm::ivec3 dims);

  gpu::Limits mLimits;
  std::shared_ptr<const StructureField> mField;  ///< the field that the textures show, once no brick is stale
  StructureSets mSets;
  ShareLayout mLayout;
  std::vector<bool> mIsStale;  ///< by brick, x fastest
  std::size_t mNext = 0;       ///< no brick before this one is stale
  gpu::Texture mCovers, mShares, mCoarseShares;
};

}  // namespace velum::render
