#include "render/residency/Residency.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/Clock.h"
#include "render/upload/TexelStore.h"
#include "scene/Scene.h"
#include "scene/Shown.h"

namespace velum::render {

namespace {

constexpr double kBudgetBytes = double(std::size_t(2) << 30);  ///< of the textures, unless told otherwise
constexpr double kBudgetShare = 0.25;                          ///< of the driver's memory, likewise
constexpr double kMostShare = 0.7;                             ///< of it, that can be asked for
constexpr std::size_t kSampled = 192;  ///< bricks by which it is known how many of all will be seen
constexpr std::size_t kMostKnown = 1u << 18;

/// A few of many, from all over.
template <class T>
std::vector<T> spread(const std::vector<T>& all, std::size_t count) {
  std::vector<T> some;
  for (std::size_t i = 0; i < std::min(count, all.size()); ++i)
    some.push_back(all[i * all.size() / std::min(count, all.size())]);
  return some;
}

}  // namespace

Residency::Residency(const scene::VolumeLayer& layer, const gpu::Limits& limits, double budgetBytes)
    : mCoarse(layer.data),
      mGrid(*layer.data),
      mLimits(limits),
      mBudgetBytes(budgetBytes > 0 ? std::min(budgetBytes, kMostShare * double(limits.memoryBytes))
                                   : std::min(kBudgetBytes, kBudgetShare * double(limits.memoryBytes))) {
  mRecipe.bricks = mCoarse->finer->bricks;
  mRecipe.channel = scene::shownChannel(layer);
  mRecipe.timeStep = scene::shownTimeStep(layer);
  mRecipe.isMixed = scene::mixesChannels(layer);
  if (mRecipe.isMixed) mRecipe.mix = makeMixTable(layer);
  mRecipe.plan = storedPlan(*mCoarse, mRecipe.isMixed, limits, 0.0);
  mRecipe.range = mCoarse->range;
  mRecipe.longestGradient = longestGradientOf(*mCoarse, mRecipe.plan, mCoarse->isColor || mRecipe.isMixed);
  mTexelBytes = texelBytes(mRecipe.plan) + sizeof(glm::u8vec4);
  mSlots.push_back({});
  for (const auto& place :
       makeSlots(mVolume, mRecipe.plan, mCoarse->dims, mGrid.finerBricks() + 1, mBudgetBytes, limits))
    mSlots.push_back({.place = place});
  scene::VolumeLayer coarse = layer;
  coarse.smooth = false;
  mUpload = std::make_unique<VolumeUpload>(coarse, limits, mRecipe.plan, mVolume);
  mLoader = std::make_unique<BrickLoader>(
      [recipe = mRecipe, grid = mGrid](const PageBrick& brick, const IsWorthSlot& isWorthSlot) {
        return makeBrickTexels(recipe, grid, brick, isWorthSlot);
      });
}

Residency::~Residency() = default;

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

/// What no ray meets any more goes first. 0: all of it is seen.
std::uint32_t Residency::freeSlot() {
  std::uint32_t oldest = 0;
  for (std::uint32_t slot = kFirstSlot; slot < mSlots.size(); ++slot) {
    if (!mSlots[slot].isUsed) return slot;
    if (mSlots[slot].seen < mTurn && (oldest == 0 || mSlots[slot].seen < mSlots[oldest].seen)) oldest = slot;
  }
  if (oldest == 0) return 0;
  mResident.erase(mSlots[oldest].brick.key());
  mSlots[oldest].isUsed = false;
  refreshPages(mSlots[oldest].brick);
  return oldest;
}

/// What cannot be seen takes no place. Nor must it be seen coarse, where its neighbours' values are mixed in: the page
/// gets a slot of one value that shows nothing, for all such pages.
void Residency::showNothing(std::size_t page, const BrickRanges& ranges, const MayShow& mayShow) {
  if (!hasEmptyTexel || mayShow(glm::vec2(mEmptyTexel))) {
    hasEmptyTexel = true;
    mEmptyTexel = ranges.all.x;
    fillSlot(mVolume, mSlots[kEmptySlot].place, mRecipe.plan, mEmptyTexel);
  }
  show(page, kEmptySlot);
}

void Residency::show(std::size_t page, std::uint32_t slot) {
  if (mTable.slot(page) != slot) mHasNews = true;
  mTable.set(page, slot);
}

/// The nearer, and the coarser what stands there, the more urgent: the smaller the number.
double Residency::urgencyOf(glm::ivec3 page, int level) const {
  std::uint32_t shown = mTable.slot(mTable.indexOf(page));
  int shownLevel = shown < kFirstSlot ? mGrid.coarsest() : mSlots[shown].brick.level;
  glm::dvec3 tex = (glm::dvec3(page) + 0.5 - mVolume.pages->first) / mVolume.pages->perTex;
  glm::dvec3 world = mGrid.levels()[std::size_t(mTable.level())].worldFromTex * glm::dvec4(tex, 1.0);
  return glm::dot(world - mEye.eye, mEye.forward) * std::exp2(double(level - shownLevel));
}

/// What is to be read, which is missing until it comes.
std::vector<PageBrick> Residency::bricksOf(const std::vector<Wish>& wishes) {
  std::vector<PageBrick> bricks;
  mStreaming.reset();
  mMissing.clear();
  for (const auto& wish : wishes) {
    bricks.push_back(wish.brick);
    mMissing.insert(wish.brick.key());
  }
  return bricks;
}

std::size_t Residency::gather(const MayShow& mayShow) {
  std::vector<std::uint32_t>& words = mMarks;
  words.resize(mSeen.bytes() / sizeof(std::uint32_t));
  mSeen.read(0, mSeen.bytes(), words.data());
  if (mKnown.size() > kMostKnown) mKnown.clear();
  std::size_t room = mSlots.size() > kFirstSlot ? mSlots.size() - kFirstSlot : 0;
  IsWorthSlot isWorthSlot = [mayShow](const BrickRanges& ranges) { return mayShow(ranges.all); };
  for (;;) {
    ++mTurn;
    std::unordered_set<std::uint64_t> wanted, emptied;
    std::vector<Wish> wishes;
    std::size_t needed = 0, empty = 0, knownWishes = 0;
    for (std::size_t i = 0; i < words.size(); ++i)
      for (std::uint32_t bits = words[i]; bits != 0; bits &= bits - 1) {
        std::size_t index = i * 32 + std::size_t(std::countr_zero(bits));
        glm::ivec3 page = mTable.pageAt(index);
        int level = wantedAt(page);
        if (level == mGrid.coarsest()) {
          show(index, 0);
          continue;
        }
        PageBrick brick = mGrid.parent({mTable.level(), page}, level);
        std::uint64_t key = brick.key();
        if (auto found = mResident.find(key); found != mResident.end()) {
          if (mSlots[found->second].seen != mTurn) ++needed;
          mSlots[found->second].seen = mTurn;
          show(index, found->second);
          continue;
        }
        if (std::uint32_t shown = mTable.slot(index)) mSlots[shown].seen = std::max(mSlots[shown].seen, mTurn - 1);
        if (mFailed.contains(key) || !wanted.insert(key).second) continue;
        if (auto known = mKnown.find(key); known != mKnown.end()) {
          if (!isWorthSlot(known->second)) {
            showNothing(index, known->second, mayShow);
            if (emptied.insert(key).second) ++empty;
            wanted.erase(key);
            continue;
          }
          ++needed;
          ++knownWishes;
        }
        wishes.push_back({brick, urgencyOf(page, level)});
      }
    // Of those that were never read as many will be seen as of the others.
    std::size_t unread = wishes.size() - knownWishes, read = needed + empty;
    bool isDoubtful = needed + unread > room;
    double expected = double(needed) + (read < kSampled ? 0.0 : double(unread) * double(needed) / double(read));
    if (expected > double(room) && room > 0 && mEye.coarser < 16.0) {
      mEye.coarser += 0.5;
      continue;
    }
    std::sort(wishes.begin(), wishes.end(), [](const Wish& a, const Wish& b) { return a.urgency < b.urgency; });
    mIsSampling = isDoubtful && read < kSampled && wishes.size() > kSampled;
    if (mIsSampling) wishes = spread(wishes, kSampled);
    if (wishes.size() > room) wishes.resize(room);
    mLoader->ask(bricksOf(wishes), isWorthSlot);
    mTable.upload();
    return mMissing.size();
  }
}

std::size_t Residency::receive(double budgetMs, const MayShow& mayShow) {
  Clock::time_point start = Clock::now();
  while (!mMissing.empty()) {
    auto loaded = mLoader->take();
    if (!loaded) break;
    mStreaming.reset();
    std::uint64_t key = loaded->brick.key();
    mMissing.erase(key);
    mHasNews = true;
    if (!loaded->error.empty()) {
      if (mError.empty()) mError = loaded->error;
      mFailed.insert(key);
      continue;
    }
    mKnown[key] = loaded->texels.ranges;
    if (!mResident.contains(key) && !loaded->texels.texels.empty() && mayShow(loaded->texels.ranges.all)) {
      if (std::uint32_t slot = freeSlot()) {
        mSlots[slot].brick = loaded->brick;
        mSlots[slot].isUsed = true;
        mSlots[slot].seen = mTurn;
        mResident[key] = slot;
        writeSlot(mVolume, mSlots[slot].place, loaded->texels);
        writeRow(slot);
        refreshPages(loaded->brick);
      }
    }
    if (std::chrono::duration<double, std::milli>(Clock::now() - start).count() > budgetMs) break;
  }
  mTable.upload();
  return mMissing.size();
}

std::string Residency::shortfall() const {
  std::string words;
  if (!mFailed.empty())
    words = fmt::format("{} {} could not be read and {} seen coarse: {}", mFailed.size(),
                        mFailed.size() == 1 ? "brick" : "bricks", mFailed.size() == 1 ? "is" : "are", mError);
  if (mEye.coarser > 0)
    words += fmt::format(
        "{}shown {:.1f} times coarser than pixels: the {} bricks that are seen have no room in {} MiB; "
        "Preferences > Memory or --gpu-brick-memory gives more",
        words.empty() ? "" : "; ", std::exp2(mEye.coarser), mSlots.size() - kFirstSlot,
        std::size_t(mBudgetBytes) >> 20);
  return words;
}

const Streaming& Residency::streaming() const {
  if (mStreaming) return *mStreaming;
  Streaming& told = mStreaming.emplace();
  told.missing = mMissing.size();
  told.coarser = std::exp2(mEye.coarser);
  auto texel = double(mTexelBytes);
  double slot = texel * kSlotEdge * kSlotEdge * kSlotEdge;
  told.budgetBytes = mBudgetBytes;
  told.usedBytes = texel * mCoarse->dims.x * mCoarse->dims.y * mCoarse->dims.z + slot * double(mResident.size());
  std::vector<double> pages(std::size_t(mGrid.coarsest()) + 1);
  double all = 0;
  for (std::size_t i = 0; i < mMarks.size(); ++i)
    for (std::uint32_t bits = mMarks[i]; bits != 0; bits &= bits - 1) {
      std::uint32_t shown = mTable.slot(i * 32 + std::size_t(std::countr_zero(bits)));
      if (shown == kEmptySlot) continue;
      pages[std::size_t(shown < kFirstSlot ? mGrid.coarsest() : mSlots[shown].brick.level)] += 1;
      all += 1;
    }
  if (all == 0) return told;
  for (double count : pages) told.shares.push_back(count / all);
  return told;
}

}  // namespace velum::render
