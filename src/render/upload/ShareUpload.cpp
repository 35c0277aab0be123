#include "render/upload/ShareUpload.h"

#include <algorithm>

#include "core/Parallel.h"
#include "render/upload/LabelUpload.h"
#include "render/upload/gridIndex.h"
#include "scene/Scene.h"
#include "scene/StructureAt.h"

namespace velum::render {

namespace {

constexpr int kBrickVoxels = LabelVolume::kBrickSize, kWide = kBrickVoxels + 2;
constexpr std::size_t kPerStep = 64;  ///< bricks: some 20 ms on two cores

/// Of how many labels sets speak, and of those that they say nothing of.
std::vector<bool> membersOf(const StructureSets& sets, std::uint8_t bit) {
  std::vector<bool> members;
  for (std::uint8_t bits : sets.of) members.push_back((bits & bit) != 0);
  members.push_back((sets.ofOthers & bit) != 0);
  return members;
}

std::size_t inBrick(glm::ivec3 at) {
  return (std::size_t(at.z) * kBrickVoxels + std::size_t(at.y)) * kBrickVoxels + std::size_t(at.x);
}

glm::ivec3 halved(glm::ivec3 size) { return (size + 1) / 2; }

/// Means over 2 x 2 x 2 texels, of as many as there are.
/// @param components  bytes a texel
std::vector<std::uint8_t> meansOf(const std::vector<std::uint8_t>& texels, glm::ivec3 size, int components) {
  glm::ivec3 coarse = halved(size);
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

/// Bytes as texels of 16 bits.
std::vector<std::uint8_t> widened(const std::vector<std::uint8_t>& bytes) {
  std::vector<std::uint8_t> twice;
  twice.reserve(2 * bytes.size());
  for (std::uint8_t byte : bytes) twice.insert(twice.end(), {byte, byte});
  return twice;
}

/// Shares of the voxels of a brick in a set of structures, 0..255.
class BrickShares {
 public:
  /// @param ids  of the brick with a voxel around it
  BrickShares(const LabelCover& labels, const StructureSets& sets, glm::ivec3 index, const LabelCover::Brick& cover,
              std::vector<std::uint16_t> ids)
      : mLabels(labels), mSets(sets), mIndex(index), mCover(cover), mIds(std::move(ids)) {}

  /// @param stride  bytes from voxel to voxel
  void write(std::uint8_t bit, glm::ivec3 size, std::uint8_t* out, std::size_t stride) {
    LabelCover::Brick ofSet;
    for (int z = 0; z < size.z; ++z)
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x, out += stride) {
          glm::ivec3 at(x, y, z);
          Around around = look(at, bit);
          if (around.isMixed && ofSet.empty())
            ofSet = mLabels.brickOfSet(mIndex, [&](std::uint16_t id) { return (mSets.bits(id) & bit) != 0; });
          int cover = around.isMixed ? valueIn(ofSet, at) : valueIn(mCover, at);
          bool isIn = isInSet(at, bit);
          int share = isIn ? 128 + cover / 2 : 127 - cover / 2;
          *out = std::uint8_t(!around.hasBorder ? (isIn ? 255 : 0) : share);
        }
  }

 private:
  struct Around {
    bool hasBorder = false;  ///< of the set
    bool isMixed = false;    ///< and one that is none of the set's
  };
  static int valueIn(const LabelCover::Brick& brick, glm::ivec3 at) {
    return brick.size() == 1 ? brick[0] : brick[inBrick(at)];
  }
  std::uint16_t id(glm::ivec3 at) const {
    return mIds[(std::size_t(at.z + 1) * kWide + std::size_t(at.y + 1)) * kWide + std::size_t(at.x + 1)];
  }
  bool isInSet(glm::ivec3 at, std::uint8_t bit) const { return (mSets.bits(id(at)) & bit) != 0; }
  Around look(glm::ivec3 at, std::uint8_t bit) const {
    Around around;
    if (valueIn(mCover, at) == 255) return around;  // none of another structure around it counts
    bool isIn = isInSet(at, bit), hasInner = false;
    for (int n = 0; n < 27; ++n) {
      glm::ivec3 there = at + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1;
      if (id(there) == id(at)) continue;
      (isInSet(there, bit) == isIn ? hasInner : around.hasBorder) = true;
    }
    around.isMixed = around.hasBorder && hasInner;
    return around;
  }

  const LabelCover& mLabels;
  const StructureSets& mSets;
  glm::ivec3 mIndex;
  const LabelCover::Brick& mCover;
  std::vector<std::uint16_t> mIds;
};

}  // namespace

/// As few components as the sets need.
ShareUpload::Layout ShareUpload::layoutOf(const StructureSets& sets) {
  Layout layout;
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

gpu::Format ShareUpload::format() const {
  if (mLayout.sets.size() > 2) return gpu::Format::Rgba8;
  // Software drivers interpolate one component of 16 bits faster than one of 8.
  return mLayout.sets.size() == 2 ? gpu::Format::Rg8 : gpu::Format::R16;
}

void ShareUpload::allocate(glm::ivec3 dims) {
  mShares = gpu::Texture();
  mCoarseShares = gpu::Texture();
  mCovers = gpu::Texture();
  checkLabelSize(dims, gpu::texelBytes(format()) + 4, mLimits);
  mShares = gpu::Texture::make3d("structure shares", format(), dims, gpu::Filter::Linear);
  mCoarseShares = gpu::Texture::make3d("means of structure shares", format(), halved(dims), gpu::Filter::Linear);
  mShares.setComponents(mLayout.components);
  mCoarseShares.setComponents(mLayout.components);
  mCovers = gpu::Texture::make3d("structure covers", gpu::Format::R8, dims, gpu::Filter::Linear);
}

void ShareUpload::begin(const scene::Scene& scene, bool isAlone) {
  std::shared_ptr<const StructureField> field = scene::structureFieldOf(scene);
  const LabelVolume& labels = *field->cover().labels();
  StructureSets sets = makeStructureSets(scene, isAlone);
  Layout layout = layoutOf(sets);
  bool isOther = !mShares || mShares.size() != labels.dims() || layout != mLayout;
  bool hasOtherSets = sets != mSets;
  mSets = std::move(sets);
  mLayout = std::move(layout);
  if (isOther) allocate(labels.dims());
  if (isOther || hasOtherSets || field->cover().borders() != mField->cover().borders()) {
    mIsStale.assign(countOf(labels.brickGrid()), true);
    mNext = 0;
  } else if (field != mField) {
    std::vector<bool> changed = changedCovers(*mField->cover().labels(), labels);
    for (std::size_t i = 0; i < changed.size(); ++i) mIsStale[i] = mIsStale[i] || changed[i];
    mNext = 0;
  }
  mField = std::move(field);
}

/// A brick's texels, as many as lie in the grid, x fastest.
ShareUpload::Texels ShareUpload::texelsOf(glm::ivec3 index) const {
  const LabelVolume& labels = *mField->cover().labels();
  const LabelCover::Brick& cover = mField->brick(index);
  glm::ivec3 corner = index * kBrickVoxels, size = glm::min(labels.dims() - corner, glm::ivec3(kBrickVoxels));
  std::size_t components = mLayout.sets.size() > 2 ? 4 : std::max(mLayout.sets.size(), std::size_t(1));
  Texels texels;
  texels.covers.reserve(countOf(size));
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        texels.covers.push_back(cover.size() == 1 ? cover[0] : cover[inBrick({x, y, z})]);
  texels.shares.resize(countOf(size) * components);
  BrickShares shares(mField->cover(), mSets, index, cover, readAround(labels, corner - 1, glm::ivec3(kWide)));
  for (std::size_t i = 0; i < mLayout.sets.size(); ++i)
    shares.write(mLayout.sets[i], size, &texels.shares[i], components);
  texels.coarseShares = meansOf(texels.shares, size, int(components));
  if (components == 1) texels.shares = widened(texels.shares), texels.coarseShares = widened(texels.coarseShares);
  return texels;
}

bool ShareUpload::step() {
  const LabelVolume& labels = *mField->cover().labels();
  glm::ivec3 grid = labels.brickGrid();
  std::vector<std::size_t> now;
  for (; mNext < mIsStale.size() && now.size() < kPerStep; ++mNext)
    if (mIsStale[mNext]) now.push_back(mNext);
  std::vector<Texels> texels(now.size());
  parallelFor(std::size_t(0), now.size(), [&](std::size_t i) { texels[i] = texelsOf(cellIn(grid, now[i])); });
  for (std::size_t i = 0; i < now.size(); ++i) {
    glm::ivec3 corner = cellIn(grid, now[i]) * kBrickVoxels, size = glm::min(labels.dims() - corner, glm::ivec3(kBrickVoxels));
    mCovers.write(corner, size, texels[i].covers.data());
    mShares.write(corner, size, texels[i].shares.data());
    mCoarseShares.write(corner / 2, halved(size), texels[i].coarseShares.data());
    mIsStale[now[i]] = false;
  }
  return mNext == mIsStale.size();
}

}  // namespace velum::render
