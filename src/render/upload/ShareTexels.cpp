#include "render/upload/ShareTexels.h"

#include <algorithm>
#include <map>

#include "render/upload/gridIndex.h"

namespace velum::render {

namespace {

constexpr int kShareBrick = LabelVolume::kBrickSize;

/// Of how many labels sets speak, and of those that they say nothing of.
std::vector<bool> membersOf(const StructureSets& sets, std::uint8_t bit) {
  std::vector<bool> members;
  for (std::uint8_t bits : sets.of) members.push_back((bits & bit) != 0);
  members.push_back((sets.ofOthers & bit) != 0);
  return members;
}

std::size_t inBrick(glm::ivec3 at) {
  return (std::size_t(at.z) * kShareBrick + std::size_t(at.y)) * kShareBrick + std::size_t(at.x);
}

/// Means over 2 x 2 x 2 texels, of as many as there are.
/// @param components  bytes a texel
std::vector<std::uint8_t> meansOf(const std::vector<std::uint8_t>& texels, glm::ivec3 size, int components) {
  glm::ivec3 coarse = (size + 1) / 2;
  std::vector<std::uint8_t> means;
  means.reserve(countOf(coarse) * std::size_t(components));
  for (std::size_t i = 0; i < countOf(coarse); ++i) {
    glm::ivec3 from = 2 * cellIn(coarse, i), to = glm::min(from + 2, size);
    glm::ivec4 sums(0);
    for (int z = from.z; z < to.z; ++z)
      for (int y = from.y; y < to.y; ++y)
        for (int x = from.x; x < to.x; ++x)
          for (int c = 0; c < components; ++c)
            sums[c] += texels[indexIn(size, {x, y, z}) * std::size_t(components) + std::size_t(c)];
    int count = int(countOf(to - from));
    for (int c = 0; c < components; ++c) means.push_back(std::uint8_t((sums[c] + count / 2) / count));
  }
  return means;
}

/// The covers of a box of voxels.
std::vector<std::uint8_t> coversOf(const StructureField& field, glm::ivec3 low, glm::ivec3 size) {
  std::vector<std::uint8_t> covers(countOf(size), 255);
  glm::ivec3 first = low / kShareBrick, last = (low + size - 1) / kShareBrick, index;
  for (index.z = first.z; index.z <= last.z; ++index.z)
    for (index.y = first.y; index.y <= last.y; ++index.y)
      for (index.x = first.x; index.x <= last.x; ++index.x) {
        const LabelCover::Brick& brick = field.brick(index);
        if (brick.size() == 1 && brick[0] == 255) continue;
        glm::ivec3 corner = index * kShareBrick;
        glm::ivec3 from = glm::max(low, corner), to = glm::min(low + size, corner + kShareBrick), v;
        for (v.z = from.z; v.z < to.z; ++v.z)
          for (v.y = from.y; v.y < to.y; ++v.y)
            for (v.x = from.x; v.x < to.x; ++v.x)
              covers[indexIn(size, v - low)] = brick.size() == 1 ? brick[0] : brick[inBrick(v - corner)];
      }
  return covers;
}

/// Shares of the voxels of a box in a set of structures, 0..255.
class BoxShares {
 public:
  BoxShares(const LabelCover& labels, const StructureSets& sets, glm::ivec3 low, glm::ivec3 size,
            const std::vector<std::uint8_t>& covers)
      : mLabels(labels),
        mSets(sets),
        mLow(low),
        mSize(size),
        mCovers(covers),
        mIds(readAround(*labels.labels(), low - 1, size + 2)) {}

  /// @param stride  bytes from voxel to voxel
  void write(std::uint8_t bit, std::uint8_t* out, std::size_t stride) {
    std::map<std::size_t, LabelCover::Brick> ofSet;
    std::size_t i = 0;
    for (int z = 0; z < mSize.z; ++z)
      for (int y = 0; y < mSize.y; ++y)
        for (int x = 0; x < mSize.x; ++x, ++i, out += stride) {
          glm::ivec3 at(x, y, z);
          bool isIn = isInSet(at, bit);
          // Of a cover of 255 none of another structure around it counts.
          Around around = mCovers[i] == 255 ? Around{} : look(at, bit, isIn);
          int cover = around.isMixed ? coverOfSet(ofSet, mLow + at, bit) : mCovers[i];
          int share = isIn ? 128 + cover / 2 : 127 - cover / 2;
          *out = std::uint8_t(!around.hasBorder ? (isIn ? 255 : 0) : share);
        }
  }

 private:
  struct Around {
    bool hasBorder = false;  ///< of the set
    bool isMixed = false;    ///< and one that is none of the set's
  };
  std::uint16_t id(glm::ivec3 at) const { return mIds[indexIn(mSize + 2, at + 1)]; }
  bool isInSet(glm::ivec3 at, std::uint8_t bit) const { return (mSets.bits(id(at)) & bit) != 0; }
  Around look(glm::ivec3 at, std::uint8_t bit, bool isIn) const {
    Around around;
    bool hasInner = false;
    for (int n = 0; n < 27; ++n) {
      glm::ivec3 there = at + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1;
      if (id(there) == id(at)) continue;
      (isInSet(there, bit) == isIn ? hasInner : around.hasBorder) = true;
    }
    around.isMixed = around.hasBorder && hasInner;
    return around;
  }
  int coverOfSet(std::map<std::size_t, LabelCover::Brick>& made, glm::ivec3 voxel, std::uint8_t bit) const {
    glm::ivec3 index = voxel / kShareBrick;
    auto [found, isNew] = made.try_emplace(indexIn(mLabels.labels()->brickGrid(), index));
    if (isNew)
      found->second = mLabels.brickOfSet(index, [&](std::uint16_t other) { return (mSets.bits(other) & bit) != 0; });
    return found->second.size() == 1 ? found->second[0] : found->second[inBrick(voxel - index * kShareBrick)];
  }

  const LabelCover& mLabels;
  const StructureSets& mSets;
  glm::ivec3 mLow, mSize;
  const std::vector<std::uint8_t>& mCovers;
  std::vector<std::uint16_t> mIds;
};

}  // namespace

/// As few components as the sets need.
ShareLayout shareLayoutOf(const StructureSets& sets) {
  ShareLayout layout;
  std::uint8_t second = sets.hasAny(StructureSets::kVeil) ? StructureSets::kVeil : StructureSets::kSparedToo;
  const std::uint8_t known[] = {StructureSets::kSpared, second, StructureSets::kSolid, StructureSets::kShown};
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<bool> members = membersOf(sets, known[i]);
    auto first = std::find(members.begin(), members.end(), !members.front());
    std::size_t at = 0;
    while (at < layout.sets.size() && membersOf(sets, layout.sets[at]) != members) ++at;
    bool isSame = first == members.end();
    if (!isSame && at == layout.sets.size()) layout.sets.push_back(known[i]);
    layout.components[i] = !isSame           ? static_cast<gpu::Component>(at)
                           : members.front() ? gpu::Component::One
                                             : gpu::Component::Zero;
  }
  return layout;
}

gpu::Format ShareLayout::format() const {
  if (sets.size() > 2) return gpu::Format::Rgba8;
  // Software drivers interpolate one component of 16 bits faster than one of 8.
  return sets.size() == 2 ? gpu::Format::Rg8 : gpu::Format::R16;
}

ShareTexels shareTexelsOf(const StructureField& field, const StructureSets& sets, const ShareLayout& layout,
                          glm::ivec3 low, glm::ivec3 size) {
  std::size_t components = layout.bytes();
  ShareTexels texels;
  texels.covers = coversOf(field, low, size);
  texels.shares.resize(countOf(size) * components);
  BoxShares shares(field.cover(), sets, low, size, texels.covers);
  for (std::size_t i = 0; i < layout.sets.size(); ++i) shares.write(layout.sets[i], &texels.shares[i], components);
  texels.means = meansOf(texels.shares, size, int(components));
  return texels;
}

std::vector<std::uint8_t> wholeShare(const StructureSets& sets, const ShareLayout& layout, std::uint16_t id) {
  std::vector<std::uint8_t> texel(layout.bytes(), 0);
  for (std::size_t i = 0; i < layout.sets.size(); ++i) texel[i] = (sets.bits(id) & layout.sets[i]) != 0 ? 255 : 0;
  return texel;
}

std::vector<std::uint8_t> shareUpload(const ShareLayout& layout, std::vector<std::uint8_t> texels) {
  if (layout.bytes() > 1) return texels;
  std::vector<std::uint8_t> twice;
  twice.reserve(2 * texels.size());
  for (std::uint8_t byte : texels) twice.insert(twice.end(), {byte, byte});
  return twice;
}

}  // namespace velum::render
