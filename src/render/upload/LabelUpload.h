#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/Shared.h"
#include "gpu/Context.h"
#include "gpu/Texture.h"
#include "render/upload/LabelCells.h"

namespace velum::render {

/// @param bytes  bytes that a voxel of labels takes on the GPU
/// @throw gpu::GpuError when labels of this size are larger than the driver's 3D textures or memory
void checkLabelSize(glm::ivec3 dims, std::size_t bytes, const gpu::Limits& limits);

/// Labels on the GPU and, cell by cell of a grid, which ids are there. Follows edits: bricks that two label volumes
/// share have the same id, so what differs is known without looking at voxels, and only that is sent and counted. Ids
/// always take 16 bits on the GPU, so that a new id costs no more than any other. GL thread.
class LabelUpload {
 public:
  explicit LabelUpload(const gpu::Limits& limits) : mLimits(limits) {}
  /// Brings the GPU's copy from the labels of the last call to the present labels.
  /// @throw gpu::GpuError when the labels are larger than the driver's 3D textures or memory
  /// @param hasTexture  false: the cells alone are wanted
  void update(const Shared<LabelVolume>& labels, const LabelSpace& over, bool hasTexture = true);

  /// The ids, R16ui, in the labels' own grid.
  const gpu::Texture& texture() const { return mTexture; }
  /// The reference stays valid.
  const LabelCells& cells() const { return *mCells; }
  /// A number, from 1, that is new whenever the sets of ids in the cells, or the grid of cells, change.
  std::uint64_t cellsRevision() const { return mCellsRevision; }
  /// How many bytes the last update() sent.
  std::size_t bytesSent() const { return mBytesSent; }

 private:
  void allocate(glm::ivec3 dims);
  std::vector<glm::ivec3> takeChanged(const LabelVolume& labels);
  void sendBricks(const LabelVolume& labels, const std::vector<glm::ivec3>& bricks);

  gpu::Limits mLimits;
  std::uint64_t mId = 0;
  LabelSpace mOver;
  glm::ivec3 mDims{0};
  glm::dmat4 mWorldFromVoxel{1.0};
  std::vector<std::uint64_t> mBrickIds;  ///< Ids of the bricks that the texture holds.
  std::optional<LabelCells> mCells;
  std::uint64_t mCellsRevision = 0;
  gpu::Texture mTexture;
  std::size_t mBytesSent = 0;
};

}  // namespace velum::render
