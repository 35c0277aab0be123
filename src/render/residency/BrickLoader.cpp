#include "render/residency/BrickLoader.h"

#include <algorithm>
#include <exception>

namespace velum::render {

namespace {

/// So many that are done wait to be taken: no more is made meanwhile.
constexpr std::size_t kMostWaiting = 64;

}  // namespace

BrickLoader::BrickLoader(Make make) : mMake(std::move(make)) {
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  for (unsigned i = 0; i < threads; ++i) mThreads.emplace_back([this] { work(); });
}

BrickLoader::~BrickLoader() {
  {
    std::lock_guard lock(mMutex);
    mEnds = true;
  }
  mChanged.notify_all();
  for (auto& thread : mThreads) thread.join();
}

void BrickLoader::ask(std::vector<PageBrick> bricks, IsWorthSlot isWorthSlot) {
  {
    std::lock_guard lock(mMutex);
    mAsked.clear();
    mIsWorthSlot = std::make_shared<const IsWorthSlot>(std::move(isWorthSlot));
    std::unordered_set<std::uint64_t> done;
    for (const auto& loaded : mDone) done.insert(loaded.brick.key());
    for (const auto& brick : bricks)
      if (!mInWork.contains(brick.key()) && !done.contains(brick.key())) mAsked.push_back(brick);
  }
  mChanged.notify_all();
}

std::optional<BrickLoader::Loaded> BrickLoader::take() {
  std::optional<Loaded> loaded;
  {
    std::lock_guard lock(mMutex);
    if (mDone.empty()) return std::nullopt;
    loaded = std::move(mDone.front());
    mDone.pop_front();
  }
  mChanged.notify_one();
  return loaded;
}

bool BrickLoader::isIdle() const {
  std::lock_guard lock(mMutex);
  return mAsked.empty() && mInWork.empty() && mDone.empty();
}

void BrickLoader::work() {
  std::unique_lock lock(mMutex);
  for (;;) {
    mChanged.wait(lock, [&] { return mEnds || (!mAsked.empty() && mDone.size() < kMostWaiting); });
    if (mEnds) return;
    Loaded loaded{mAsked.front(), {}, {}};
    mAsked.pop_front();
    mInWork.insert(loaded.brick.key());
    auto isWorthSlot = mIsWorthSlot;
    lock.unlock();
    try {
      loaded.texels = mMake(loaded.brick, *isWorthSlot);
    } catch (const std::exception& error) {
      loaded.error = error.what();
    }
    lock.lock();
    mInWork.erase(loaded.brick.key());
    mDone.push_back(std::move(loaded));
  }
}

}  // namespace velum::render
