#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/Shared.h"
#include "gpu/Context.h"
#include "gpu/Texture.h"
#include "render/upload/LabelCells.h"

namespace velum::render {

/// @param bytes  of a voxel of labels on the GPU
/// @throw gpu::GpuError when labels of a size are larger than the driver's 3D textures or memory
void checkLabelSize(glm::ivec3 dims, std::size_t bytes, const gpu::Limits& limits);

/// Labels on the GPU and, cell by cell of a grid, which ids are there. Follows edits: bricks that two label volumes
/// share have the same id, so what differs is known without looking at voxels, and only that is sent and counted. Ids
/// are 16 bits wide whatever they are, so that one never seen before costs no more than another. GL thread.
class LabelUpload {
 public:
  explicit LabelUpload(const gpu::Limits& limits) : mLimits(limits) {}
  /// Brings what is on the GPU from the labels of the last call to these.
  /// @throw gpu::GpuError when they are larger than the driver's 3D textures or memory
  void update(const Shared<LabelVolume>& labels, const LabelSpace& over);

  /// R16ui, in the labels' own grid.
  const gpu::Texture& texture() const { return mTexture; }
  /// Stays where it is.
  const LabelCells& cells() const { return *mCells; }
  /// Never the same for other sets of ids in the cells, nor for another grid of them. From 1.
  std::uint64_t cellsRevision() const { return mCellsRevision; }
  /// What the last update() sent.
  std::size_t bytesSent() const { return mBytesSent; }

 private:
  void allocate(glm::ivec3 dims);
  std::vector<glm::ivec3> takeChanged(const LabelVolume& labels);
  void sendBricks(const LabelVolume& labels, const std::vector<glm::ivec3>& bricks);

  gpu::Limits mLimits;
  std::uint64_t mId = 0;
  LabelSpace mOver;
  glm::dmat4 mWorldFromVoxel{1.0};
  std::vector<std::uint64_t> mBrickIds;  ///< Of what the texture holds.
  std::optional<LabelCells> mCells;
  std::uint64_t mCellsRevision = 0;
  gpu::Texture mTexture;
  std::size_t mBytesSent = 0;
};

}  // namespace velum::render
