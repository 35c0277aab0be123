#pragma once
#include <cstdint>
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
  enum class Stale : std::uint8_t { No, Shares, Cover };
  void allocate(glm::ivec3 dims);
  void markChanged(const LabelVolume& labels);
  void markAll(Stale what);
  void writeTexels(const LabelCover& labels, glm::ivec3 index, const LabelCover::Brick& cover,
                   std::vector<std::uint8_t>& texels) const;

  gpu::Limits mLimits;
  Shared<LabelVolume> mLabels;
  Shared<Volume> mVolume;             ///< mBorders are of,
  std::vector<scene::Growth> mGrown;  ///< with these steps,
  int mTimeStep = 0;                  ///< at this time
  std::vector<ValueBorder> mBorders;
  StructureSets mSets;
  bool mHides = false;
  std::vector<std::uint64_t> mBrickIds;  ///< of what the texture holds, or will
  std::vector<LabelCover::Brick> mCovers;
  std::vector<Stale> mStale;
  std::size_t mNext = 0;  ///< no brick before it is stale
  gpu::Texture mTexture;
};

}  // namespace velum::render
