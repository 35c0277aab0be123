#include "session/measure/Follow.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/LabelVolume.h"
#include "core/Parallel.h"
#include "scene/Scene.h"

namespace velum::session {

namespace {

constexpr std::size_t kVolumesKept =
    4;  // label volumes that are remembered: the one shown, and those of work beside it
constexpr std::size_t kBricksAtOnce = 64;  // pieces of the loop

/// The voxels of an id in a brick: how many, and the sum of their places in the brick. Whole numbers, so exact.
struct IdSum {
  std::uint16_t id = 0;
  std::uint32_t voxels = 0;
  glm::uvec3 places{0};
};
using IdSums = std::vector<IdSum>;

/// What is remembered of a brick, and shared by all label volumes that have the brick there.
struct BrickSums {
  std::uint64_t brick = 0;             ///< see LabelVolume::brickId(); 0: not looked at
  std::shared_ptr<const IdSums> sums;  ///< null: only 0
};

/// What is remembered of a label volume.
struct VoxelSums {
  std::uint64_t labels = 0;  ///< Shared<LabelVolume>::id()
  glm::ivec3 dims{0};
  std::vector<BrickSums> bricks;                ///< x fastest
  std::unordered_map<int, glm::dvec3> middles;  ///< of all ids in use, world
};

/// Sums up bricks, one after the other.
class BrickAdder {
 public:
  std::shared_ptr<const IdSums> sum(const LabelVolume& labels, glm::ivec3 index) {
    constexpr int kEdge = LabelVolume::kBrickSize;
    const LabelVolume::Brick& brick = labels.brick(index);
    bool isUniform = brick.size() == 1;
    if (isUniform && brick[0] == 0) return nullptr;
    mSlots.resize(65536);
    glm::ivec3 inside = glm::min(labels.dims() - index * kEdge, glm::ivec3(kEdge));
    for (int z = 0; z < inside.z; ++z)
      for (int y = 0; y < inside.y; ++y) {
        const std::uint16_t* row = brick.data() + (isUniform ? 0 : (std::size_t(z) * kEdge + std::size_t(y)) * kEdge);
        for (int x = 0, end = 0; x < inside.x; x = end) {
          for (end = isUniform ? inside.x : x + 1; end < inside.x && row[end] == row[x];) ++end;
          add(row[isUniform ? 0 : x], glm::uvec3(x, y, z), std::uint32_t(end - x));
        }
      }
    for (const IdSum& of : mSums) mSlots[of.id] = 0;
    auto sums = std::make_shared<const IdSums>(mSums.begin(), mSums.end());
    mSums.clear();
    return sums;
  }

 private:
  /// A row of voxels along x.
  void add(std::uint16_t id, glm::uvec3 from, std::uint32_t count) {
    if (id == 0) return;
    if (mSlots[id] == 0) mSums.push_back({id, 0, {}}), mSlots[id] = std::uint32_t(mSums.size());
    IdSum& sum = mSums[mSlots[id] - 1];
    sum.voxels += count;
    sum.places += count * from + glm::uvec3(count * (count - 1) / 2, 0, 0);
  }

  std::vector<std::uint32_t> mSlots;  ///< by id: its place in `mSums`, from 1; 0: it has none
  IdSums mSums;
};

/// The middles of all ids, from the sums of their bricks.
std::unordered_map<int, glm::dvec3> middlesOf(const LabelVolume& labels, const std::vector<BrickSums>& bricks) {
  struct All {
    std::uint64_t voxels = 0;
    glm::vec<3, std::uint64_t> places{0};
  };
  std::vector<All> all(65536);
  glm::ivec3 grid = labels.brickGrid();
  std::size_t at = 0;
  for (int z = 0; z < grid.z; ++z)
    for (int y = 0; y < grid.y; ++y)
      for (int x = 0; x < grid.x; ++x) {
        const BrickSums& brick = bricks[at++];
        if (!brick.sums) continue;
        glm::vec<3, std::uint64_t> corner(glm::ivec3(x, y, z) * LabelVolume::kBrickSize);
        for (const IdSum& sum : *brick.sums) {
          all[sum.id].voxels += sum.voxels;
          all[sum.id].places += glm::vec<3, std::uint64_t>(sum.places) + std::uint64_t(sum.voxels) * corner;
        }
      }
  std::unordered_map<int, glm::dvec3> middles;
  for (std::size_t id = 1; id < all.size(); ++id) {
    if (all[id].voxels == 0) continue;
    glm::dvec3 middle = glm::dvec3(all[id].places) / double(all[id].voxels);
    middles.emplace(int(id), glm::dvec3(labels.worldFromVoxel() * glm::dvec4(middle, 1.0)));
  }
  return middles;
}

/// One pass over the bricks that another label volume does not have in the same place.
/// @param before  of the same size; or null
std::shared_ptr<const VoxelSums> voxelSumsOf(const Shared<LabelVolume>& labels, const VoxelSums* before) {
  auto sums = std::make_shared<VoxelSums>();
  sums->labels = labels.id();
  sums->dims = labels->dims();
  if (before) sums->bricks = before->bricks;
  auto grid = glm::vec<3, std::size_t>(labels->brickGrid());
  sums->bricks.resize(grid.x * grid.y * grid.z);
  auto look = [&](std::size_t first, std::size_t end) {
    BrickAdder adder;
    for (std::size_t i = first; i < end; ++i) {
      glm::ivec3 index(i % grid.x, i / grid.x % grid.y, i / (grid.x * grid.y));
      std::uint64_t brick = labels->brickId(index);
      if (sums->bricks[i].brick != brick) sums->bricks[i] = {brick, adder.sum(*labels, index)};
    }
  };
  // Who asks may hold a lock.
  isolated([&] { parallelForRanges(std::size_t(0), sums->bricks.size(), kBricksAtOnce, look); });
  sums->middles = middlesOf(*labels, sums->bricks);
  return sums;
}

/// The sums of label volumes that were asked for last. Any thread.
class KnownSums {
 public:
  std::shared_ptr<const VoxelSums> of(const Shared<LabelVolume>& labels) {
    std::shared_ptr<const VoxelSums> before;
    {
      std::lock_guard lock(mMutex);
      auto found = std::ranges::find_if(mKnown, [&](const auto& known) { return known->labels == labels.id(); });
      if (found != mKnown.end()) {
        std::rotate(mKnown.begin(), found, found + 1);
        return mKnown.front();
      }
      auto alike = std::ranges::find_if(mKnown, [&](const auto& known) { return known->dims == labels->dims(); });
      if (alike != mKnown.end()) before = *alike;
    }
    auto sums = voxelSumsOf(labels, before.get());  // not under the lock: it takes all cores
    std::lock_guard lock(mMutex);
    std::erase_if(mKnown, [&](const auto& known) { return known->labels == labels.id(); });
    mKnown.insert(mKnown.begin(), sums);
    mKnown.resize(std::min(mKnown.size(), kVolumesKept));
    return sums;
  }

 private:
  std::mutex mMutex;
  std::vector<std::shared_ptr<const VoxelSums>> mKnown;  ///< what was asked for last first
};

}  // namespace

std::optional<glm::dvec3> middleOfVoxels(const scene::Scene& scene, int structure) {
  static KnownSums known;
  const Shared<LabelVolume>& labels = scene.labels.data;
  if (!labels || structure <= 0) return std::nullopt;
  auto sums = known.of(labels);
  auto found = sums->middles.find(structure);
  if (found == sums->middles.end()) return std::nullopt;
  return found->second;
}

}  // namespace velum::session
