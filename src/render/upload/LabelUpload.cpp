#include "render/upload/LabelUpload.h"

#include <fmt/format.h>

#include <algorithm>

#include "gpu/GpuError.h"
#include "render/upload/gridIndex.h"

namespace velum::render {

void checkLabelSize(glm::ivec3 dims, std::size_t bytes, const gpu::Limits& limits) {
  if (std::max({dims.x, dims.y, dims.z}) > limits.texture3d ||
      double(countOf(dims)) * double(bytes) > 0.7 * double(limits.memoryBytes))
    throw gpu::GpuError(fmt::format(
        "the labels ({} x {} x {}) are larger than the driver's 3D textures ({}) or memory; crop or reduce them",
        dims.x, dims.y, dims.z, limits.texture3d));
}

void LabelUpload::allocate(glm::ivec3 dims) {
  checkLabelSize(dims, 2, mLimits);
  mTexture = gpu::Texture::make3d("labels", gpu::Format::R16ui, dims);
}

/// The bricks that are not those of the texture, in their order, x fastest; from now on they are.
std::vector<glm::ivec3> LabelUpload::takeChanged(const LabelVolume& labels) {
  std::vector<glm::ivec3> changed;
  glm::ivec3 grid = labels.brickGrid(), at;
  std::size_t i = 0;
  for (at.z = 0; at.z < grid.z; ++at.z)
    for (at.y = 0; at.y < grid.y; ++at.y)
      for (at.x = 0; at.x < grid.x; ++at.x, ++i)
        if (std::uint64_t id = labels.brickId(at); mBrickIds[i] != id) {
          mBrickIds[i] = id;
          changed.push_back(at);
        }
  return changed;
}

/// Bricks that lie side by side go as one box.
void LabelUpload::sendBricks(const LabelVolume& labels, const std::vector<glm::ivec3>& bricks) {
  std::vector<std::uint16_t> ids;
  for (std::size_t first = 0, past = 0; first < bricks.size(); first = past) {
    past = first + 1;
    while (past < bricks.size() && bricks[past] == bricks[past - 1] + glm::ivec3(1, 0, 0)) ++past;
    glm::ivec3 low = bricks[first] * LabelVolume::kBrickSize;
    glm::ivec3 size = glm::min((bricks[past - 1] + 1) * LabelVolume::kBrickSize, labels.dims()) - low;
    ids.resize(countOf(size));
    labels.read(low, size, ids);
    mTexture.write(low, size, ids.data());
    mBytesSent += ids.size() * sizeof(ids[0]);
  }
}

void LabelUpload::update(const Shared<LabelVolume>& labels, const LabelSpace& over, bool hasTexture) {
  mBytesSent = 0;
  bool isOther = mDims != labels->dims() || hasTexture != bool(mTexture);
  if (mCells && !isOther && mId == labels.id() && mOver == over) return;
  if (isOther) {
    mTexture = gpu::Texture();
    mCells.reset();
    if (hasTexture) allocate(labels->dims());
    mDims = labels->dims();
    mBrickIds.assign(countOf(labels->brickGrid()), 0);  // no brick has this id
  }
  std::vector<glm::ivec3> changed = takeChanged(*labels);
  if (hasTexture) sendBricks(*labels, changed);
  if (!mCells || mOver != over || mWorldFromVoxel != labels->worldFromVoxel()) {
    mCells.emplace(*labels, over);
    ++mCellsRevision;
  } else if (mCells->update(*labels, changed)) {
    ++mCellsRevision;
  }
  mId = labels.id();
  mOver = over;
  mWorldFromVoxel = labels->worldFromVoxel();
}

}  // namespace velum::render
