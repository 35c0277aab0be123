#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "StructureSets.h"
#include "velum/core/LabelCover.h"
#include "velum/gpu/Context.h"
#include "velum/gpu/Texture.h"

namespace velum::render {

/// How far inside their structures places among labels lie, on the GPU, to be interpolated: r the cover of a voxel
/// (LabelCover), g the share of it that cuts spare, a the share that is shown (1 everywhere where nothing is hidden;
/// then two bytes a voxel, else four). Follows edits brick by brick; keeps the covers of bricks that have a border, a
/// byte a voxel. GL thread; works on all cores.
class ShareUpload {
 public:
  explicit ShareUpload(const gpu::Limits& limits) : mLimits(limits) {}
  /// @throw gpu::GpuError when labels are larger than the driver's 3D textures or memory
  void begin(const scene::Scene& scene, bool isAlone);
  /// Makes and sends some bricks. @return true when the texture is as the scene is
  bool step();

  /// Rg8 or Rgba8, in the labels' own grid.
  const gpu::Texture& texture() const { return mTexture; }
  /// Of the frame that has begun.
  bool hidesAny() const { return mHides; }

 private:
  void allocate(glm::ivec3 dims);
  void writeTexels(glm::ivec3 index, std::vector<std::uint8_t>& texels) const;

  gpu::Limits mLimits;
  std::shared_ptr<const StructureField> mField;  ///< of the texture, once nothing is stale
  StructureSets mSets;
  bool mHides = false;
  std::vector<bool> mIsStale;  ///< bricks, x fastest
  std::size_t mNext = 0;       ///< no brick before it is stale
  gpu::Texture mTexture;
};

}  // namespace velum::render
