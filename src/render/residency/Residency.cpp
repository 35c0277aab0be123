#include "render/residency/Residency.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "core/Clock.h"
#include "scene/Project.h"
#include "scene/Scene.h"
#include "scene/Shown.h"

namespace velum::render {

namespace {

constexpr double kBudgetBytes = double(std::size_t(2) << 30);  ///< of the textures
constexpr double kBudgetShare = 0.25;                          ///< of the driver's memory
constexpr int kSlotsAlong = 16;                                ///< of the texture, along x and y
constexpr double kVoxelsPerPixel = 1.42;  ///< a voxel may be so many pixels wide: halfway between two levels
constexpr std::size_t kMostKnown = 1u << 18;
constexpr float kAnyTexel = 1e30f;

int roundUp(int size) { return (size + kSlotEdge - 1) / kSlotEdge * kSlotEdge; }

}  // namespace

Residency::Residency(const scene::VolumeLayer& layer, const gpu::Limits& limits)
    : mCoarse(layer.data), mGrid(*layer.data), mLimits(limits) {
  mRecipe.bricks = mCoarse->finer->bricks;
  mRecipe.channel = scene::shownChannel(layer);
  mRecipe.timeStep = scene::shownTimeStep(layer);
  mRecipe.isMixed = scene::mixesChannels(layer);
  if (mRecipe.isMixed) mRecipe.mix = makeMixTable(layer);
  mRecipe.plan = storedPlan(*mCoarse, mRecipe.isMixed, limits, 0.0);
  mRecipe.range = mCoarse->range;
  mRecipe.longestGradient = longestGradientOf(*mCoarse, mRecipe.plan, mCoarse->isColor || mRecipe.isMixed);
  makeSlots(limits);
  scene::VolumeLayer coarse = layer;
  coarse.smooth = false;
  mUpload = std::make_unique<VolumeUpload>(coarse, limits, mRecipe.plan, mVolume);
  mLoader = std::make_unique<BrickLoader>(
      [recipe = mRecipe, grid = mGrid](const PageBrick& brick, const IsWorthSlot& isWorthSlot) {
        return makeBrickTexels(recipe, grid, brick, isWorthSlot);
      });
}

Residency::~Residency() = default;

/// The coarse volume lies in the corner of the texture, slots all around it.
void Residency::makeSlots(const gpu::Limits& limits) {
  std::size_t texel = gpu::texelBytes(mRecipe.plan.format) * (mRecipe.plan.packing == Packing::None ? 1 : 4) + 4;
  double texels = std::min(kBudgetBytes, kBudgetShare * double(limits.memoryBytes)) / double(texel);
  if (mRecipe.plan.packing != Packing::None) texels = std::min(texels, double(limits.textureBuffer));
  glm::ivec3 coarse = mCoarse->dims, size;
  int most = limits.texture3d / kSlotEdge * kSlotEdge;
  for (int axis = 0; axis < 2; ++axis) size[axis] = std::min(most, std::max(roundUp(coarse[axis]), kSlotsAlong * kSlotEdge));
  int deep = int(texels / (double(size.x) * size.y)) / kSlotEdge * kSlotEdge;
  size.z = std::min(most, std::max(roundUp(coarse.z), deep));
  allocateTexels(mVolume, mRecipe.plan, size, true);
  mSlots.push_back({});
  glm::ivec3 at;
  for (at.z = 0; at.z < size.z; at.z += kSlotEdge)
    for (at.y = 0; at.y < size.y; at.y += kSlotEdge)
      for (at.x = 0; at.x < size.x; at.x += kSlotEdge)
        if (glm::any(glm::greaterThanEqual(at, coarse))) mSlots.push_back({.place = at});
  mRows = gpu::Buffer("slots", mSlots.size() * 2 * sizeof(glm::vec4));
  mRowTexels = gpu::Texture::makeOfBuffer("slots", gpu::Format::Rgba32f, mRows);
}

bool Residency::step() {
  if (!mUpload) return true;
  if (!mUpload->step()) return false;
  GpuVolume done = mUpload->take();
  mUpload.reset();
  mCoarseRanges = std::move(done.cellRanges);
  mCoarseCells = done.cells;
  mVolume.gradientScale = done.gradientScale;
  mVolume.valueScale = done.valueScale;
  mVolume.valueOffset = done.valueOffset;
  mVolume.isColor = done.isColor;
  mVolume.isMixed = done.isMixed;
  return true;
}

double Residency::fractionDone() const { return mUpload ? mUpload->fractionDone() : 1.0; }

/// The level whose voxels are about as large as a pixel.
int Residency::levelFor(double pixelSize) const {
  int level = mGrid.coarsest();
  while (level > 0 && mGrid.levels()[std::size_t(level)].voxelSize > kVoxelsPerPixel * pixelSize) --level;
  return level;
}

void Residency::look(const Frame& frame) {
  const scene::Camera& camera = frame.scene.camera;
  scene::CameraBasis basis = scene::cameraBasis(camera);
  Eye eye;
  eye.eye = camera.eye;
  eye.forward = basis.forward;
  eye.pixel = 2.0 * scene::halfPictureHeight(camera) / std::max(1, frame.pictureSize.y);
  eye.isOrthographic = camera.projection == scene::Projection::Orthographic;
  double nearest = eye.isOrthographic ? 1.0 : std::numeric_limits<double>::max();
  if (!eye.isOrthographic) {
    // Where rays of a few pixels enter the data's box.
    glm::dmat4 texFromWorld = glm::inverse(mGrid.levels().front().worldFromTex);
    glm::dvec3 from = texFromWorld * glm::dvec4(eye.eye, 1.0);
    double tall = scene::halfPictureHeight(camera), wide = tall * frame.pictureSize.x / std::max(1, frame.pictureSize.y);
    constexpr int kRays = 16;
    for (int i = 0; i <= kRays; ++i)
      for (int j = 0; j <= kRays; ++j) {
        glm::dvec3 way = basis.forward + (2.0 * i / kRays - 1.0) * wide * basis.right + (2.0 * j / kRays - 1.0) * tall * basis.up;
        glm::dvec3 d = texFromWorld * glm::dvec4(way, 0.0);
        double enter = 0.0, leave = std::numeric_limits<double>::max();
        for (int axis = 0; axis < 3; ++axis) {
          if (std::abs(d[axis]) < 1e-300) d[axis] = 1e-300;
          double a = -from[axis] / d[axis], b = (1.0 - from[axis]) / d[axis];
          enter = std::max(enter, std::min(a, b));
          leave = std::min(leave, std::max(a, b));
        }
        if (enter < leave) nearest = std::min(nearest, enter);
      }
  }
  mEye = eye;
  bool isSeen = nearest < std::numeric_limits<double>::max();
  int level = isSeen ? levelFor(nearest * eye.pixel) : mGrid.coarsest();
  // While something moves what is there stays, unless it is far from what is wanted.
  bool isNear = mTable.level() >= 0 && std::abs(level - mTable.level()) <= 1;
  if (mTable.level() != level && !(frame.isPreview && isNear)) restartTable(level);
}

void Residency::restartTable(int level) {
  mTable.reset(mGrid, level);
  const PageLevel& own = mGrid.levels()[std::size_t(level)];
  mVolume.dims = own.dims;
  mVolume.worldFromTex = own.worldFromTex;
  mVolume.cells = cellGridFor(own.dims);
  PagePlace pages;
  pages.grid = mTable.size();
  pages.perTex = glm::dvec3(own.dims) / own.voxelsPerBox / own.brickEdge;
  pages.first = -own.firstVoxel / own.voxelsPerBox / own.brickEdge;
  mVolume.pages = pages;
  mSeen = gpu::Buffer("pages seen", (std::size_t(pages.grid.x) * std::size_t(pages.grid.y) * std::size_t(pages.grid.z) + 31) / 32 * 4);
  for (std::uint32_t slot = 0; slot < mSlots.size(); ++slot)
    if (slot == 0 || mSlots[slot].isUsed) writeRow(slot);
  std::vector<PageBrick> bricks;
  for (const auto& slot : mSlots)
    if (slot.isUsed) bricks.push_back(slot.brick);
  for (const auto& brick : bricks) refreshPages(brick);
  mVolume.cellRange = gpu::Buffer("cell ranges", std::size_t(mVolume.cells.size.x) * std::size_t(mVolume.cells.size.y) * std::size_t(mVolume.cells.size.z) * sizeof(glm::vec2));
  updateCells();
}

/// Where a slot's voxels lie in the frame's texture coordinates.
void Residency::writeRow(std::uint32_t slot) {
  const PageLevel& own = mGrid.levels()[std::size_t(mTable.level())];
  int level = slot == 0 ? mGrid.coarsest() : mSlots[slot].brick.level;
  const PageLevel& its = mGrid.levels()[std::size_t(level)];
  glm::dvec3 origin = slot == 0 ? glm::dvec3(0.0) : glm::dvec3(mGrid.slotOrigin(mSlots[slot].brick));
  // Its voxels = tex * scale + offset.
  glm::dvec3 scale = glm::dvec3(own.dims) / own.voxelsPerBox * its.voxelsPerBox;
  glm::dvec3 offset = its.firstVoxel - own.firstVoxel / own.voxelsPerBox * its.voxelsPerBox;
  if (slot == 0) mVolume.pages->coarseEdge = 0.5 / scale;
  offset += glm::dvec3(mSlots[slot].place) - origin;
  glm::dvec3 size(mVolume.storeSize);
  glm::vec4 row[2] = {glm::vec4(glm::vec3(scale / size), 0.0f), glm::vec4(glm::vec3(offset / size), 0.0f)};
  mRows.write(std::size_t(slot) * sizeof(row), sizeof(row), row);
}

int Residency::wantedAt(glm::ivec3 page) const {
  double pixel = mEye.pixel;
  if (!mEye.isOrthographic) {
    const PageLevel& own = mGrid.levels()[std::size_t(mTable.level())];
    glm::dvec3 tex = (glm::dvec3(page) + 0.5 - mVolume.pages->first) / mVolume.pages->perTex;
    glm::dvec3 world = own.worldFromTex * glm::dvec4(tex, 1.0);
    pixel *= std::max(0.0, glm::dot(world - mEye.eye, mEye.forward));
  }
  return std::max(mTable.level(), levelFor(pixel * std::exp2(mEye.coarser)));
}

/// The slot of the level that a page wants; else of a finer one, else of the least coarse one that is there.
std::uint32_t Residency::bestSlot(glm::ivec3 page) const {
  int wanted = wantedAt(page);
  PageBrick own{mTable.level(), page};
  auto slotOf = [&](int level) -> std::uint32_t {
    if (level == mGrid.coarsest()) return 0;
    auto found = mResident.find(mGrid.parent(own, level).key());
    return found == mResident.end() ? 0 : found->second;
  };
  if (wanted == mGrid.coarsest()) return 0;
  for (int level = wanted; level >= mTable.level(); --level)
    if (auto slot = slotOf(level)) return slot;
  for (int level = wanted + 1; level < mGrid.coarsest(); ++level)
    if (auto slot = slotOf(level)) return slot;
  return 0;
}

/// Chooses anew for the pages that a brick covers, which has come or gone.
void Residency::refreshPages(const PageBrick& brick) {
  PageTable::Pages pages = mTable.covered(mGrid, brick);
  glm::ivec3 page;
  for (page.z = pages.low.z; page.z < pages.high.z; ++page.z)
    for (page.y = pages.low.y; page.y < pages.high.y; ++page.y)
      for (page.x = pages.low.x; page.x < pages.high.x; ++page.x) mTable.set(mTable.indexOf(page), bestSlot(page));
}

void Residency::bind() const {
  mTable.bind();
  mRowTexels.bindSampler(shared::kSlotRowUnit);
}

/// What no ray meets any more goes first. 0: all of it is seen.
std::uint32_t Residency::freeSlot() {
  std::uint32_t oldest = 0;
  for (std::uint32_t slot = 1; slot < mSlots.size(); ++slot) {
    if (!mSlots[slot].isUsed) return slot;
    if (mSlots[slot].seen < mTurn && (oldest == 0 || mSlots[slot].seen < mSlots[oldest].seen)) oldest = slot;
  }
  if (oldest == 0) return 0;
  mResident.erase(mSlots[oldest].brick.key());
  mSlots[oldest].isUsed = false;
  refreshPages(mSlots[oldest].brick);
  return oldest;
}

/// What cannot be seen takes no place where rays leap over it: cells are no larger than its page.
IsWorthSlot Residency::worthOf(const MayShow& mayShow) const {
  if (mVolume.cells.edge > kPageVoxels) return [](const BrickRanges&) { return true; };
  return [mayShow](const BrickRanges& ranges) { return std::ranges::any_of(ranges, mayShow); };
}

std::size_t Residency::gather(const MayShow& mayShow) {
  std::vector<std::uint32_t> words(mSeen.bytes() / sizeof(std::uint32_t));
  mSeen.read(0, mSeen.bytes(), words.data());
  if (mKnown.size() > kMostKnown) mKnown.clear();
  struct Wish {
    PageBrick brick;
    double urgency;  ///< the smaller the more urgent
  };
  std::size_t room = mSlots.size() - 1;
  IsWorthSlot isWorthSlot = worthOf(mayShow);
  for (;;) {
    ++mTurn;
    std::unordered_set<std::uint64_t> wanted;
    std::vector<Wish> wishes;
    std::size_t needed = 0;
    for (std::size_t i = 0; i < words.size(); ++i)
      for (std::uint32_t bits = words[i]; bits != 0; bits &= bits - 1) {
        std::size_t index = i * 32 + std::size_t(std::countr_zero(bits));
        glm::ivec3 page = mTable.pageAt(index);
        int level = wantedAt(page);
        if (level == mGrid.coarsest()) {
          mTable.set(index, 0);
          continue;
        }
        PageBrick brick = mGrid.parent({mTable.level(), page}, level);
        std::uint64_t key = brick.key();
        if (auto found = mResident.find(key); found != mResident.end()) {
          if (mSlots[found->second].seen != mTurn) ++needed;
          mSlots[found->second].seen = mTurn;
          mTable.set(index, found->second);
          continue;
        }
        if (std::uint32_t shown = mTable.slot(index)) mSlots[shown].seen = std::max(mSlots[shown].seen, mTurn - 1);
        if (mFailed.contains(key) || !wanted.insert(key).second) continue;
        if (auto known = mKnown.find(key); known != mKnown.end()) {
          if (!isWorthSlot(known->second)) {
            wanted.erase(key);
            continue;
          }
          ++needed;
        }
        std::uint32_t shown = mTable.slot(index);
        int shownLevel = shown == 0 ? mGrid.coarsest() : mSlots[shown].brick.level;
        glm::dvec3 tex = (glm::dvec3(page) + 0.5 - mVolume.pages->first) / mVolume.pages->perTex;
        glm::dvec3 world = mGrid.levels()[std::size_t(mTable.level())].worldFromTex * glm::dvec4(tex, 1.0);
        wishes.push_back({brick, glm::dot(world - mEye.eye, mEye.forward) * std::exp2(double(level - shownLevel))});
      }
    if (needed > room && room > 0 && mEye.coarser < 16.0) {
      mEye.coarser += 0.5;
      continue;
    }
    std::sort(wishes.begin(), wishes.end(), [](const Wish& a, const Wish& b) { return a.urgency < b.urgency; });
    // Of most that was never read nothing will be seen. What will be asks for room once it is known.
    if (wishes.size() > room) wishes.resize(room);
    std::vector<PageBrick> bricks;
    mMissing.clear();
    for (const auto& wish : wishes) {
      bricks.push_back(wish.brick);
      mMissing.insert(wish.brick.key());
    }
    mLoader->ask(std::move(bricks), isWorthSlot);
    mTable.upload();
    return mMissing.size();
  }
}

std::size_t Residency::receive(double budgetMs, const MayShow& mayShow) {
  Clock::time_point start = Clock::now();
  IsWorthSlot isWorthSlot = worthOf(mayShow);
  while (!mMissing.empty()) {
    auto loaded = mLoader->take();
    if (!loaded) break;
    std::uint64_t key = loaded->brick.key();
    mMissing.erase(key);
    mHasNews = true;
    if (!loaded->error.empty()) {
      if (mError.empty()) mError = loaded->error;
      mFailed.insert(key);
      continue;
    }
    mKnown[key] = loaded->texels.ranges;
    if (!mResident.contains(key) && !loaded->texels.texels.empty() && isWorthSlot(loaded->texels.ranges)) {
      if (std::uint32_t slot = freeSlot()) {
        mSlots[slot].brick = loaded->brick;
        mSlots[slot].isUsed = true;
        mSlots[slot].seen = mTurn;
        mResident[key] = slot;
        writeTexels(mVolume, mSlots[slot].place, glm::ivec3(kSlotEdge), loaded->texels.texels.data(),
                    loaded->texels.gradients.data());
        writeRow(slot);
        refreshPages(loaded->brick);
      }
    }
    if (std::chrono::duration<double, std::milli>(Clock::now() - start).count() > budgetMs) break;
  }
  mTable.upload();
  return mMissing.size();
}

/// Of the coarse volume's texels in a box, box coordinates.
glm::vec2 Residency::coarseRange(glm::dvec3 low, glm::dvec3 high) const {
  const PageLevel& level = mGrid.levels().back();
  double edge = mCoarseCells.edge;
  glm::ivec3 last = mCoarseCells.size - 1;
  glm::ivec3 from = glm::clamp(glm::ivec3(glm::floor((low * level.voxelsPerBox + level.firstVoxel - 0.5) / edge)), glm::ivec3(0), last);
  glm::ivec3 to = glm::clamp(glm::ivec3(glm::floor((high * level.voxelsPerBox + level.firstVoxel + 0.5) / edge)), from, last);
  glm::vec2 range(kAnyTexel, -kAnyTexel);
  for (int z = from.z; z <= to.z; ++z)
    for (int y = from.y; y <= to.y; ++y)
      for (int x = from.x; x <= to.x; ++x) {
        glm::vec2 cell = mCoarseRanges[(std::size_t(z) * std::size_t(mCoarseCells.size.y) + std::size_t(y)) * std::size_t(mCoarseCells.size.x) + std::size_t(x)];
        range = {std::min(range.x, cell.x), std::max(range.y, cell.y)};
      }
  return range;
}

glm::vec2 Residency::brickRange(const PageBrick& brick, const BrickRanges& ranges, glm::dvec3 low, glm::dvec3 high) const {
  glm::dvec3 edge = mGrid.levels()[std::size_t(brick.level)].brickEdge;
  glm::dvec3 a = (low / edge - glm::dvec3(brick.at)) * double(kRangeCells), b = (high / edge - glm::dvec3(brick.at)) * double(kRangeCells);
  glm::ivec3 from = glm::clamp(glm::ivec3(glm::floor(a + 1e-6)), glm::ivec3(0), glm::ivec3(kRangeCells - 1));
  glm::ivec3 to = glm::clamp(glm::ivec3(glm::ceil(b - 1e-6)) - 1, from, glm::ivec3(kRangeCells - 1));
  glm::vec2 range(kAnyTexel, -kAnyTexel);
  for (int z = from.z; z <= to.z; ++z)
    for (int y = from.y; y <= to.y; ++y)
      for (int x = from.x; x <= to.x; ++x) {
        glm::vec2 cell = ranges[std::size_t((z * kRangeCells + y) * kRangeCells + x)];
        range = {std::min(range.x, cell.x), std::max(range.y, cell.y)};
      }
  return range;
}

/// Of what is shown in a cell, and of what is wanted there: anything, where that was never read.
glm::vec2 Residency::cellRange(glm::ivec3 cell) const {
  const PageLevel& own = mGrid.levels()[std::size_t(mTable.level())];
  double edge = mVolume.cells.edge;
  glm::dvec3 low = (glm::dvec3(cell) * edge - own.firstVoxel) / own.voxelsPerBox;
  glm::dvec3 high = (glm::dvec3(cell + 1) * edge - own.firstVoxel) / own.voxelsPerBox;
  glm::ivec3 last = mTable.size() - 1;
  glm::ivec3 from = glm::clamp(glm::ivec3(glm::floor(low / own.brickEdge + 1e-9)), glm::ivec3(0), last);
  glm::ivec3 to = glm::clamp(glm::ivec3(glm::ceil(high / own.brickEdge - 1e-9)) - 1, from, last);
  glm::vec2 range(kAnyTexel, -kAnyTexel);
  auto add = [&](glm::vec2 more) { range = {std::min(range.x, more.x), std::max(range.y, more.y)}; };
  glm::ivec3 page;
  std::uint64_t before = ~std::uint64_t(0);
  bool addedCoarse = false;
  for (page.z = from.z; page.z <= to.z; ++page.z)
    for (page.y = from.y; page.y <= to.y; ++page.y)
      for (page.x = from.x; page.x <= to.x; ++page.x) {
        int wanted = wantedAt(page);
        std::uint32_t slot = mTable.slot(mTable.indexOf(page));
        if (slot == 0) {
          if (!addedCoarse) add(coarseRange(low, high));
          addedCoarse = true;
        } else {
          auto known = mKnown.find(mSlots[slot].brick.key());
          if (known == mKnown.end()) return {-kAnyTexel, kAnyTexel};
          add(brickRange(mSlots[slot].brick, known->second, low, high));
          if (mSlots[slot].brick.level == wanted) continue;
        }
        if (wanted == mGrid.coarsest()) continue;
        PageBrick brick = mGrid.parent({mTable.level(), page}, wanted);
        if (brick.key() == before) continue;
        before = brick.key();
        auto known = mKnown.find(before);
        if (known != mKnown.end())
          add(brickRange(brick, known->second, low, high));
        else if (!mFailed.contains(before))
          return {-kAnyTexel, kAnyTexel};
      }
  return range;
}

void Residency::updateCells() {
  const CellGrid& cells = mVolume.cells;
  mVolume.cellRanges.resize(std::size_t(cells.size.x) * std::size_t(cells.size.y) * std::size_t(cells.size.z));
  std::size_t i = 0;
  glm::ivec3 cell;
  for (cell.z = 0; cell.z < cells.size.z; ++cell.z)
    for (cell.y = 0; cell.y < cells.size.y; ++cell.y)
      for (cell.x = 0; cell.x < cells.size.x; ++cell.x) mVolume.cellRanges[i++] = cellRange(cell);
  mVolume.cellRange.write(0, mVolume.cellRanges.size() * sizeof(glm::vec2), mVolume.cellRanges.data());
  ++mVolume.cellsRevision;
  mHasNews = false;
}

std::string Residency::shortfall() const {
  std::string words;
  if (!mFailed.empty())
    words = fmt::format("{} {} could not be read and is seen coarse: {}", mFailed.size(), mFailed.size() == 1 ? "brick" : "bricks", mError);
  if (mEye.coarser > 0)
    words += fmt::format("{}shown {:.1f} times coarser than pixels: the {} bricks that are seen have no room in {} MiB", words.empty() ? "" : "; ",
                         std::exp2(mEye.coarser), mSlots.size() - 1, std::size_t(kBudgetBytes) >> 20);
  return words;
}

}  // namespace velum::render
