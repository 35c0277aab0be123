#include "growth/DivideRegion.h"

#include <limits>
#include <utility>

namespace velum::growth {

namespace {

constexpr std::uint32_t kUnreached = std::numeric_limits<std::uint32_t>::max();
/// Voxels that are settled before somebody is asked whether to go on.
constexpr std::size_t kUncancelled = 1 << 16;

/// What waits, by its cost: no cost is more than one step's beyond that of what is taken, so that buckets come round.
class CostQueue {
 public:
  explicit CostQueue(int mostStep) : mBuckets(std::size_t(mostStep) + 1) {}

  void push(std::size_t place, std::uint32_t cost) {
    mBuckets[cost % mBuckets.size()].push_back(place);
    ++mCount;
  }
  bool isEmpty() const { return mCount == 0; }
  /// All that waits at a cost.
  std::vector<std::size_t> take(std::uint32_t cost) {
    auto places = std::exchange(mBuckets[cost % mBuckets.size()], {});
    mCount -= places.size();
    return places;
  }

 private:
  std::vector<std::vector<std::size_t>> mBuckets;
  std::size_t mCount = 0;
};

class Division {
 public:
  explicit Division(const PassageCosts& costs)
      : mCosts(costs), mQueue(costs.mostCost()), mCost(costs.box().count(), kUnreached), mOwners(costs.box().count()) {}

  void begin(std::span<const std::size_t> seeds, Owner owner) {
    for (std::size_t place : seeds)
      if (mCosts.holds(place)) offer(place, 0, owner);
  }
  void run(Progress& progress) {
    std::size_t settled = 0;
    for (std::uint32_t cost = 0; !mQueue.isEmpty(); ++cost)
      for (std::size_t place : mQueue.take(cost)) {
        if (mCost[place] != cost) continue;
        goOnFrom(place);
        if (++settled % kUncancelled == 0) progress.throwIfCancelled();
      }
    progress.throwIfCancelled();
  }
  std::vector<Owner> takeOwners() { return std::move(mOwners); }

 private:
  /// All that may still come at this cost has come, as each step costs something: so its owner is known.
  void goOnFrom(std::size_t place) {
    auto steps = mCosts.box().steps();
    for (int axis = 0; axis < 3; ++axis)
      for (std::ptrdiff_t step : {-steps[std::size_t(axis)], steps[std::size_t(axis)]}) {
        auto to = std::size_t(std::ptrdiff_t(place) + step);
        if (!mCosts.holds(to)) continue;
        std::uint64_t cost = std::uint64_t(mCost[place]) + std::uint64_t(mCosts.cost(place, to, axis));
        // A way longer than numbers reach ends: nobody's.
        if (cost < kUnreached) offer(to, std::uint32_t(cost), mOwners[place]);
      }
  }
  void offer(std::size_t place, std::uint32_t cost, Owner owner) {
    if (cost < mCost[place]) {
      mCost[place] = cost;
      mOwners[place] = owner;
      mQueue.push(place, cost);
    } else if (cost == mCost[place] && owner == Owner::Own) {
      mOwners[place] = owner;
    }
  }

  const PassageCosts& mCosts;
  CostQueue mQueue;
  std::vector<std::uint32_t> mCost;  ///< of the cheapest way so far
  std::vector<Owner> mOwners;
};

}  // namespace

std::vector<Owner> divideRegion(const PassageCosts& costs, std::span<const std::size_t> own,
                                std::span<const std::size_t> others, Progress& progress) {
  Division division(costs);
  division.begin(own, Owner::Own);
  division.begin(others, Owner::Others);
  division.run(progress);
  return division.takeOwners();
}

}  // namespace velum::growth
