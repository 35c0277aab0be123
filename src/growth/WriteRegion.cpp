#include "growth/WriteRegion.h"

#include <algorithm>

#include "growth/RowBits.h"

namespace velum::growth {

namespace {

constexpr int kBrick = LabelVolume::kBrickSize;

/// The part of a row's bits that lies in a brick.
std::uint32_t halfWord(const RegionWord& region, glm::ivec2 row, int bx) {
  return std::uint32_t(region(row.x, row.y, bx / 2) >> (bx % 2 * kBrick));
}

class BrickWriter {
 public:
  BrickWriter(const RegionWord& region, std::uint16_t id, LabelVolume& labels)
      : mRegion(region), mId(id), mLabels(labels), mIds(std::size_t(kBrick) * kBrick * kBrick) {}

  /// @param rows  of the region that lie in the brick, as y and z
  void write(glm::ivec3 brick, const std::vector<glm::ivec2>& rows) {
    mBits.clear();
    std::uint32_t any = 0;
    for (glm::ivec2 row : rows) any |= mBits.emplace_back(halfWord(mRegion, row, brick.x));
    if (any == 0) return;
    glm::ivec3 corner = brick * kBrick, size = glm::min(mLabels.dims() - corner, glm::ivec3(kBrick));
    mLabels.read(corner, size, mIds);
    std::size_t before = mWritten.voxels;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      glm::ivec2 row = rows[i], in = row - glm::ivec2(corner.y, corner.z);
      label(mIds.data() + (std::size_t(in.y) * std::size_t(size.y) + std::size_t(in.x)) * std::size_t(size.x), mBits[i],
            glm::ivec3(corner.x, row));
    }
    if (mWritten.voxels != before) mLabels.write(corner, size, mIds);
  }
  const Written& written() const { return mWritten; }

 private:
  /// @param start  voxel of bit 0
  void label(std::uint16_t* ids, std::uint32_t bits, glm::ivec3 start) {
    int first = kBrick, last = -1;
    for (; bits != 0; bits &= bits - 1) {
      int x = std::countr_zero(bits);
      if (ids[x] == mId) continue;
      ids[x] = mId;
      first = std::min(first, x), last = x;
      ++mWritten.voxels;
    }
    if (last < 0) return;
    VoxelBox row{start + glm::ivec3(first, 0, 0), start + glm::ivec3(last + 1, 1, 1)};
    VoxelBox& box = mWritten.box;
    box = box.isEmpty() ? row : VoxelBox{glm::min(box.first, row.first), glm::max(box.end, row.end)};
  }

  const RegionWord& mRegion;
  std::uint16_t mId;
  LabelVolume& mLabels;
  std::vector<std::uint16_t> mIds;
  std::vector<std::uint32_t> mBits;  ///< of the rows in the brick that is written
  Written mWritten;
};

}  // namespace

Written writeRegion(const RegionWord& region, const RegionGrow::Changed& changed, std::uint16_t id,
                    LabelVolume& labels) {
  if (changed.rows.empty()) return {};
  glm::ivec3 first = changed.box.first / kBrick, last = (changed.box.end - 1) / kBrick, count = last - first + 1;
  std::vector<std::vector<glm::ivec2>> rows(std::size_t(count.y) * std::size_t(count.z));
  for (glm::ivec2 row : changed.rows) {
    glm::ivec2 at = row / kBrick - glm::ivec2(first.y, first.z);
    rows[std::size_t(at.y) * std::size_t(count.y) + std::size_t(at.x)].push_back(row);
  }
  BrickWriter writer(region, id, labels);
  for (int z = 0; z < count.z; ++z)
    for (int y = 0; y < count.y; ++y) {
      const auto& here = rows[std::size_t(z) * std::size_t(count.y) + std::size_t(y)];
      for (int x = 0; x < count.x && !here.empty(); ++x) writer.write(first + glm::ivec3(x, y, z), here);
    }
  return writer.written();
}

}  // namespace velum::growth
