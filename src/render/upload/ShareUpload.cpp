#include "render/upload/ShareUpload.h"

#include <algorithm>

#include "core/Parallel.h"
#include "render/upload/LabelUpload.h"
#include "render/upload/gridIndex.h"
#include "scene/Scene.h"
#include "scene/StructureAt.h"

namespace velum::render {

namespace {

constexpr int kBrickVoxels = LabelVolume::kBrickSize;
constexpr std::size_t kPerStep = 64;  ///< bricks: some 20 ms on two cores

glm::ivec3 halved(glm::ivec3 size) { return (size + 1) / 2; }

}  // namespace

void ShareUpload::allocate(glm::ivec3 dims) {
  mShares = gpu::Texture();
  mCoarseShares = gpu::Texture();
  mCovers = gpu::Texture();
  checkLabelSize(dims, gpu::texelBytes(mLayout.format()) + 4, mLimits);
  mShares = gpu::Texture::make3d("structure shares", mLayout.format(), dims, gpu::Filter::Linear);
  mCoarseShares =
      gpu::Texture::make3d("means of structure shares", mLayout.format(), halved(dims), gpu::Filter::Linear);
  mShares.setComponents(mLayout.components);
  mCoarseShares.setComponents(mLayout.components);
  mCovers = gpu::Texture::make3d("structure covers", gpu::Format::R8, dims, gpu::Filter::Linear);
}

void ShareUpload::begin(const scene::Scene& scene, bool isAlone) {
  std::shared_ptr<const StructureField> field = scene::structureFieldOf(scene);
  const LabelVolume& labels = *field->cover().labels();
  StructureSets sets = makeStructureSets(scene, isAlone);
  ShareLayout layout = shareLayoutOf(sets);
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

bool ShareUpload::step() {
  const LabelVolume& labels = *mField->cover().labels();
  glm::ivec3 grid = labels.brickGrid();
  std::vector<std::size_t> now;
  for (; mNext < mIsStale.size() && now.size() < kPerStep; ++mNext)
    if (mIsStale[mNext]) now.push_back(mNext);
  std::vector<ShareTexels> texels(now.size());
  auto cornerOf = [&](std::size_t i) { return cellIn(grid, now[i]) * kBrickVoxels; };
  auto sizeOf = [&](std::size_t i) { return glm::min(labels.dims() - cornerOf(i), glm::ivec3(kBrickVoxels)); };
  parallelFor(std::size_t(0), now.size(), [&](std::size_t i) {
    texels[i] = shareTexelsOf(*mField, mSets, mLayout, cornerOf(i), sizeOf(i));
    texels[i].shares = shareUpload(mLayout, std::move(texels[i].shares));
    texels[i].means = shareUpload(mLayout, std::move(texels[i].means));
  });
  for (std::size_t i = 0; i < now.size(); ++i) {
    glm::ivec3 corner = cornerOf(i), size = sizeOf(i);
    mCovers.write(corner, size, texels[i].covers.data());
    mShares.write(corner, size, texels[i].shares.data());
    mCoarseShares.write(corner / 2, halved(size), texels[i].means.data());
    mIsStale[now[i]] = false;
  }
  return mNext == mIsStale.size();
}

}  // namespace velum::render
