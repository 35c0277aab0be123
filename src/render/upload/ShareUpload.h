#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/LabelCover.h"
#include "gpu/Context.h"
#include "gpu/Texture.h"
#include "render/upload/StructureSets.h"

namespace velum::render {

/// How far inside their structures places among labels lie, on the GPU, to be interpolated: covers of voxels
/// (LabelCover), and shares of voxels in sets of structures (StructureSets), with their means over 2 x 2 x 2 voxels.
/// One byte a voxel for the covers, and for the shares two or four, an eighth more with their means. Follows edits
/// brick by brick. GL thread; works on all cores.
class ShareUpload {
 public:
  explicit ShareUpload(const gpu::Limits& limits) : mLimits(limits) {}
  /// @throw gpu::GpuError when labels are larger than the driver's 3D textures or memory
  void begin(const scene::Scene& scene, bool isAlone);
  /// Makes and sends some bricks. @return true when the texture is as the scene is
  bool step();

  /// In the labels' own grid. Of shares shaders get r, g: that cuts spare, by class (g: or of veils), b: of solid
  /// structures, a: that is shown; the texture holds no more than one component for sets that are the same.
  const gpu::Texture& covers() const { return mCovers; }
  const gpu::Texture& shares() const { return mShares; }
  /// Their means: half as many along each axis, one more where the last voxel is alone.
  const gpu::Texture& coarseShares() const { return mCoarseShares; }
  /// Of the frame that has begun.
  const StructureSets& sets() const { return mSets; }

 private:
  /// What the texture of shares holds.
  struct Layout {
    std::vector<std::uint8_t> sets;            ///< a component for each: bits of StructureSets
    std::array<gpu::Component, 4> components;  ///< where shaders find those that they know
    bool operator==(const Layout&) const = default;
  };
  static Layout layoutOf(const StructureSets& sets);
  gpu::Format format() const;
  struct Texels {
    std::vector<std::uint8_t> covers, shares, coarseShares;
  };
  void allocate(glm::ivec3 dims);
  Texels texelsOf(glm::ivec3 index) const;

  gpu::Limits mLimits;
  std::shared_ptr<const StructureField> mField;  ///< of the textures, once nothing is stale
  StructureSets mSets;
  Layout mLayout;
  std::vector<bool> mIsStale;  ///< bricks, x fastest
  std::size_t mNext = 0;       ///< no brick before it is stale
  gpu::Texture mCovers, mShares, mCoarseShares;
};

}  // namespace velum::render
