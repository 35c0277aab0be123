#include "render/upload/LabelBricks.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/Parallel.h"
#include "gpu/GpuError.h"
#include "render/upload/gridIndex.h"
#include "scene/Scene.h"
#include "scene/StructureAt.h"
#include "shared/bindings.h"
#include "shared/frame.h"

namespace velum::render {

namespace {

constexpr int kLabelEdge = shared::kLabelBrick, kSlot = shared::kLabelSlotEdge, kHalo = shared::kLabelSlotHalo;
static_assert(kLabelEdge == LabelVolume::kBrickSize);
constexpr std::size_t kSlotTexels = std::size_t(kSlot) * kSlot * kSlot;
constexpr std::size_t kLayer =
    std::size_t(shared::kLabelSlotsAlong) * shared::kLabelSlotsAlong;  ///< slots of one layer
constexpr std::size_t kBricksPerStep = 48;                             ///< some 20 ms on two cores
constexpr double kBorderShare = 0.25;                                  ///< of the driver's memory
constexpr std::size_t kMostHalves = 8;
constexpr std::size_t kPerMixed = 4;  ///< slots for a brick of several ids, with those that it needs around it

struct NoRoom {};

/// Texels of a box of a slot out of those of a smaller box, of which the outermost are repeated.
/// @param low  of the smaller box, in the slot  @param bytes  of a texel
template <class T>
std::vector<T> widenedBox(const std::vector<T>& texels, glm::ivec3 low, glm::ivec3 size, int edge, std::size_t each) {
  std::vector<T> wide;
  wide.reserve(std::size_t(edge) * std::size_t(edge) * std::size_t(edge) * each);
  glm::ivec3 v;
  for (v.z = 0; v.z < edge; ++v.z)
    for (v.y = 0; v.y < edge; ++v.y)
      for (v.x = 0; v.x < edge; ++v.x) {
        auto from = texels.begin() + std::ptrdiff_t(indexIn(size, glm::clamp(v - low, glm::ivec3(0), size - 1)) * each);
        wide.insert(wide.end(), from, from + std::ptrdiff_t(each));
      }
  return wide;
}

/// How many bricks have several ids.
std::size_t mixedBricks(const LabelVolume& labels) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < countOf(labels.brickGrid()); ++i)
    count += labels.brick(cellIn(labels.brickGrid(), i)).size() > 1;
  return count;
}

glm::ivec3 placeOf(std::uint32_t slot) {
  auto along = std::uint32_t(shared::kLabelSlotsAlong);
  return glm::ivec3(slot % along, slot / along % along, slot / (along * along)) * kSlot;
}

}  // namespace

void LabelBricks::restart(glm::ivec3 grid) {
  mPages.assign(countOf(grid), 0);
  mOwn.clear();
  mOnly.clear();
  mStale.clear();
  mStaleOnly.clear();
  mFree.clear();
  mUsed = mRoom = 0;
  for (gpu::Texture* texture : {&mIds, &mCovers, &mShares, &mPageTexels}) *texture = {};
  mPageBuffer = gpu::Buffer("bricks of labels", mPages.size() * sizeof(std::uint32_t));
  mPageTexels = gpu::Texture::makeOfBuffer("bricks of labels", gpu::Format::R32ui, mPageBuffer);
  mFirstChanged = 0;
  mEndChanged = mPages.size();
}

/// Whole layers of them.
std::size_t LabelBricks::mostSlots() const {
  double bytes = double(kSlotTexels) * double(3 + gpu::texelBytes(mLayout.format()) * 9 / 8);
  double layers = kBorderShare * double(mLimits.memoryBytes) / (bytes * double(kLayer));
  return std::size_t(std::min(layers, double(mLimits.texture3d / kSlot))) * kLayer;
}

/// Twice as many slots as before. All of them must be sent anew.
void LabelBricks::makeRoom() {
  std::size_t room = std::min(std::max(2 * mRoom, kLayer), mostSlots()), layers = room / kLayer;
  if (room <= mRoom) throw NoRoom();
  glm::ivec3 size(shared::kLabelSlotsAlong * kSlot, shared::kLabelSlotsAlong * kSlot, int(layers) * kSlot);
  for (gpu::Texture* texture : {&mIds, &mCovers, &mShares}) *texture = {};
  mIds = gpu::Texture::make3d("labels", gpu::Format::R16ui, size);
  mCovers = gpu::Texture::make3d("structure covers", gpu::Format::R8, size, gpu::Filter::Linear);
  mShares = gpu::Texture::make3d("structure shares", mLayout.format(), size, gpu::Filter::Linear, 2);
  mShares.setComponents(mLayout.components);
  mRoom = room;
  for (const auto& [brick, slot] : mOwn) mStale.insert(brick);
  for (const auto& [id, slot] : mOnly) mStaleOnly.insert(id);
}

std::uint32_t LabelBricks::takeSlot() {
  if (!mFree.empty()) {
    std::uint32_t slot = mFree.back();
    mFree.pop_back();
    return slot;
  }
  if (mUsed == mRoom) makeRoom();
  return std::uint32_t(mUsed++);
}

void LabelBricks::setPage(std::size_t brick, std::uint32_t slot) {
  if (mPages[brick] == slot) return;
  mPages[brick] = slot;
  if (mFirstChanged == mEndChanged) mFirstChanged = brick, mEndChanged = brick + 1;
  mFirstChanged = std::min(mFirstChanged, brick);
  mEndChanged = std::max(mEndChanged, brick + 1);
}

std::uint32_t LabelBricks::slotOfOnly(std::uint16_t id) {
  if (auto found = mOnly.find(id); found != mOnly.end()) return found->second;
  std::uint32_t slot = takeSlot();
  mStaleOnly.insert(id);
  return mOnly[id] = slot;
}

/// The id of all that a brick's texels depend on; none where there are several.
std::optional<std::uint16_t> LabelBricks::onlyAround(glm::ivec3 index) const {
  const LabelVolume& labels = *mField->cover().labels();
  const LabelVolume::Brick& own = labels.brick(index);
  if (own.size() > 1) return std::nullopt;
  if (isUniformAround(labels, index)) return own[0];
  auto ids = readAround(labels, index * kLabelEdge - kHalo - 1, glm::ivec3(kSlot + 2));
  bool isOne = std::all_of(ids.begin(), ids.end(), [&](std::uint16_t id) { return id == own[0]; });
  return isOne ? std::optional(own[0]) : std::nullopt;
}

/// Gives bricks slots of their own, or takes them away; what has one is stale.
void LabelBricks::place(const std::vector<std::size_t>& bricks) {
  glm::ivec3 grid = mField->cover().labels()->brickGrid();
  std::vector<std::optional<std::uint16_t>> only(bricks.size());
  parallelFor(std::size_t(0), bricks.size(), [&](std::size_t i) { only[i] = onlyAround(cellIn(grid, bricks[i])); });
  for (std::size_t i = 0; i < bricks.size(); ++i) {
    auto own = mOwn.find(bricks[i]);
    if (!only[i]) {
      if (own == mOwn.end()) own = mOwn.emplace(bricks[i], takeSlot()).first;
      setPage(bricks[i], own->second);
      mStale.insert(bricks[i]);
      continue;
    }
    if (own != mOwn.end()) {
      mFree.push_back(own->second);
      mOwn.erase(own);
      mStale.erase(bricks[i]);
    }
    setPage(bricks[i], slotOfOnly(*only[i]));
  }
}

/// Of the labels as they are drawn. Borders by values are those of the scene's own voxels.
std::shared_ptr<const StructureField> LabelBricks::fieldOf(const scene::Scene& scene) {
  std::shared_ptr<const StructureField> field = scene::structureFieldOf(scene);
  if (mHalves.empty()) return field;
  Shared<LabelVolume> labels = field->cover().labels();
  for (HalvedLabels& half : mHalves) labels = half.update(labels);
  if (mField && mField->cover().labels().id() == labels.id()) return mField;
  return std::make_shared<const StructureField>(LabelCover(labels), mField.get());
}

void LabelBricks::placeAll(std::shared_ptr<const StructureField> field, StructureSets sets) {
  std::shared_ptr<const StructureField> before = mField;
  const LabelVolume& labels = *field->cover().labels();
  ShareLayout layout = shareLayoutOf(sets);
  bool isOther = !before || before->cover().labels()->dims() != labels.dims() || layout != mLayout;
  bool hasOtherTexels = sets != mSets || (before && field->cover().borders() != before->cover().borders());
  mSets = std::move(sets);
  mLayout = std::move(layout);
  mField = std::move(field);
  std::vector<std::size_t> bricks;
  if (isOther) {
    restart(labels.brickGrid());
    for (std::size_t i = 0; i < mPages.size(); ++i) bricks.push_back(i);
  } else {
    if (hasOtherTexels) {
      for (const auto& [brick, slot] : mOwn) mStale.insert(brick);
      for (const auto& [id, slot] : mOnly) mStaleOnly.insert(id);
    }
    if (mField != before) {
      std::vector<bool> changed = changedCovers(*before->cover().labels(), labels);
      for (std::size_t i = 0; i < changed.size(); ++i)
        if (changed[i]) bricks.push_back(i);
    }
  }
  place(bricks);
}

void LabelBricks::begin(const scene::Scene& scene, bool isAlone) {
  mBytesSent = 0;
  // Labels that were edited may have room again. The same ones have not.
  const Shared<LabelVolume>& labels = scene.labels.data;
  if (!mHalves.empty() && labels.id() != mPlacedId && kPerMixed * mixedBricks(*labels) < mostSlots()) {
    mHalves.clear();
    mField.reset();
  }
  mPlacedId = labels.id();
  StructureSets sets = makeStructureSets(scene, isAlone);
  for (;;) {
    try {
      return placeAll(fieldOf(scene), sets);
    } catch (const NoRoom&) {  // half of it is placed
      mField.reset();
      if (mHalves.size() == kMostHalves)
        throw gpu::GpuError("the driver's memory has no room for the borders of the structures; hide the labels");
      mHalves.emplace_back();
    } catch (...) {
      mField.reset();
      throw;
    }
  }
}

std::string LabelBricks::shortfall() const {
  if (mHalves.empty()) return {};
  return fmt::format("structures are drawn {} times coarser than they are: their borders have no room in {} MiB",
                     1 << mHalves.size(), std::size_t(kBorderShare * double(mLimits.memoryBytes)) >> 20);
}

LabelBricks::SlotTexels LabelBricks::texelsOf(glm::ivec3 index) const {
  const LabelVolume& labels = *mField->cover().labels();
  glm::ivec3 corner = index * kLabelEdge - kHalo;
  glm::ivec3 low = glm::max(corner, glm::ivec3(0)), size = glm::min(corner + kSlot, labels.dims()) - low;
  ShareTexels made = shareTexelsOf(*mField, mSets, mLayout, low, size);
  std::size_t bytes = mLayout.bytes();
  SlotTexels texels;
  texels.ids = readAround(labels, corner, glm::ivec3(kSlot));
  texels.covers = widenedBox(made.covers, low - corner, size, kSlot, 1);
  texels.shares = shareUpload(mLayout, widenedBox(made.shares, low - corner, size, kSlot, bytes));
  texels.means = shareUpload(mLayout, widenedBox(made.means, (low - corner) / 2, (size + 1) / 2, kSlot / 2, bytes));
  return texels;
}

LabelBricks::SlotTexels LabelBricks::texelsOfOnly(std::uint16_t id) const {
  std::vector<std::uint8_t> share = wholeShare(mSets, mLayout, id);
  SlotTexels texels;
  texels.ids.assign(kSlotTexels, id);
  texels.covers.assign(kSlotTexels, 255);
  texels.shares = shareUpload(mLayout, widenedBox(share, glm::ivec3(0), glm::ivec3(1), kSlot, share.size()));
  texels.means = shareUpload(mLayout, widenedBox(share, glm::ivec3(0), glm::ivec3(1), kSlot / 2, share.size()));
  return texels;
}

void LabelBricks::send(std::uint32_t slot, const SlotTexels& texels) {
  glm::ivec3 at = placeOf(slot), edge(kSlot);
  mIds.write(at, edge, texels.ids.data());
  mCovers.write(at, edge, texels.covers.data());
  mShares.write(at, edge, texels.shares.data());
  mShares.write(at / 2, edge / 2, texels.means.data(), 1);
  mBytesSent += 2 * texels.ids.size() + texels.covers.size() + texels.shares.size() + texels.means.size();
}

bool LabelBricks::step() {
  glm::ivec3 grid = mField->cover().labels()->brickGrid();
  for (std::uint16_t id : mStaleOnly) send(mOnly[id], texelsOfOnly(id));
  mStaleOnly.clear();
  std::vector<std::size_t> now;
  while (!mStale.empty() && now.size() < kBricksPerStep) now.push_back(mStale.extract(mStale.begin()).value());
  std::vector<SlotTexels> texels(now.size());
  parallelFor(std::size_t(0), now.size(), [&](std::size_t i) { texels[i] = texelsOf(cellIn(grid, now[i])); });
  for (std::size_t i = 0; i < now.size(); ++i) send(mOwn[now[i]], texels[i]);
  if (mFirstChanged < mEndChanged) {
    constexpr std::size_t kWord = sizeof(std::uint32_t);
    mPageBuffer.write(mFirstChanged * kWord, (mEndChanged - mFirstChanged) * kWord, mPages.data() + mFirstChanged);
    mFirstChanged = mEndChanged = 0;
  }
  return mStale.empty();
}

void LabelBricks::bind() const {
  mIds.bindSampler(shared::kLabelUnit);
  mCovers.bindSampler(shared::kCoverUnit);
  mShares.bindSampler(shared::kShareUnit);
  mPageTexels.bindSampler(shared::kLabelPageUnit);
}

}  // namespace velum::render
