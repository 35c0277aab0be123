#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "StructureSets.h"
#include "velum/core/LabelCover.h"
#include "velum/gpu/Context.h"
#include "velum/gpu/Texture.h"

namespace velum::render {

/// How far inside their structures places among labels lie, on the GPU, to be interpolated: covers of voxels
/// (LabelCover), and shares of voxels in sets of structures (StructureSets). One byte a voxel for the covers, and one
/// to four for the shares. Follows edits brick by brick. GL thread; works on all cores.
class ShareUpload {
 public:
  explicit ShareUpload(const gpu::Limits& limits) : mLimits(limits) {}
  /// @throw gpu::GpuError when labels are larger than the driver's 3D textures or memory
  void begin(const scene::Scene& scene, bool isAlone);
  /// Makes and sends some bricks. @return true when the texture is as the scene is
  bool step();

  /// In the labels' own grid: R8; and R8, Rg8 or Rgba8: r, g: shares that cuts spare, by class (g:
  /// or of veils), b: of solid structures, a: that is shown.
  const gpu::Texture& covers() const { return mCovers; }
  const gpu::Texture& shares() const { return mShares; }
  /// Of the frame that has begun.
  const StructureSets& sets() const { return mSets; }

 private:
  struct Texels {
    std::vector<std::uint8_t> covers, shares;
  };
  void allocate(glm::ivec3 dims);
  Texels texelsOf(glm::ivec3 index) const;

  gpu::Limits mLimits;
  std::shared_ptr<const StructureField> mField;  ///< of the textures, once nothing is stale
  StructureSets mSets;
  std::vector<bool> mIsStale;  ///< bricks, x fastest
  std::size_t mNext = 0;       ///< no brick before it is stale
  gpu::Texture mCovers, mShares;
};

}  // namespace velum::render
