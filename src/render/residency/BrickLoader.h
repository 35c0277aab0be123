#pragma once
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <unordered_set>
#include <vector>

#include "render/residency/BrickTexels.h"

namespace velum::render {

/// Makes the texels of bricks on threads of its own, in the order in which they are asked for.
class BrickLoader {
 public:
  struct Loaded {
    PageBrick brick;
    BrickTexels texels;
    std::string error;  ///< not empty: the brick could not be read, and why
  };
  using Make = std::function<BrickTexels(const PageBrick&, const IsWorthSlot&)>;

  /// @param make  called on several threads at once; may throw
  explicit BrickLoader(Make make);
  ~BrickLoader();

  /// What is wanted now, the most urgent first, instead of all that was asked for and has not begun.
  void ask(std::vector<PageBrick> bricks, IsWorthSlot isWorthSlot);
  /// A brick that is done, if there is one.
  std::optional<Loaded> take();
  /// True when nothing is asked for, in work, or waiting to be taken.
  bool isIdle() const;

 private:
  void work();

  Make mMake;
  mutable std::mutex mMutex;
  std::condition_variable mChanged;
  std::deque<PageBrick> mAsked;
  std::shared_ptr<const IsWorthSlot> mIsWorthSlot;
  std::unordered_set<std::uint64_t> mInWork;
  std::deque<Loaded> mDone;
  bool mEnds = false;
  std::vector<std::thread> mThreads;
};

}  // namespace velum::render
