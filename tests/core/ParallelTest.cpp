#include "core/Parallel.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <thread>
#include <vector>

#include "core/Task.h"

namespace velum {

using namespace std::chrono_literals;

TEST(Parallel, EveryIndexComesOnce) {
  for (int count : {0, 1, 2, 7, 1000, 100'000}) {
    std::vector<int> visits(std::size_t(count), 0);
    parallelFor(-3, count - 3, [&](int i) { ++visits[std::size_t(i + 3)]; });
    EXPECT_EQ(visits, std::vector<int>(std::size_t(count), 1)) << count;
  }
}

TEST(Parallel, NothingIsDoneWhereTheEndLiesBeforeTheBeginning) {
  parallelFor(5, 2, [](int) { ADD_FAILURE(); });
  EXPECT_EQ(parallelReduce(
                5u, 2u, 1u, 9, [](unsigned, unsigned) { return 1; }, std::plus<>()),
            9);
}

TEST(Parallel, RangesCoverEveryIndexOnceAndAreNoSmallerThanHalfTheGrain) {
  std::vector<int> visits(10'000, 0);
  std::atomic<int> smallest = 10'000;
  parallelForRanges(0, 10'000, 64, [&](int first, int end) {
    for (int low = smallest; end - first < low && !smallest.compare_exchange_weak(low, end - first);) {
    }
    for (int i = first; i < end; ++i) ++visits[std::size_t(i)];
  });
  EXPECT_EQ(visits, std::vector<int>(10'000, 1));
  EXPECT_GE(smallest, 32);
}

TEST(Parallel, ReducingEqualsTheSerialSum) {
  std::vector<int> values(100'003);
  std::iota(values.begin(), values.end(), -500);
  auto sum = [&](std::size_t first, std::size_t end) {
    return std::accumulate(values.begin() + std::ptrdiff_t(first), values.begin() + std::ptrdiff_t(end),
                           std::int64_t(0));
  };
  for (std::size_t grain : {1u, 7u, 1000u, 1'000'000u})
    EXPECT_EQ(parallelReduce(std::size_t(0), values.size(), grain, std::int64_t(0), sum, std::plus<>()),
              sum(0, values.size()));
}

TEST(Parallel, SumsOfFloatsAreTheSameBitsWhoeverHelps) {
  std::vector<float> values(50'000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1.0f / float(i + 1);
  auto part = [&](std::size_t first, std::size_t end) {
    return std::accumulate(values.begin() + std::ptrdiff_t(first), values.begin() + std::ptrdiff_t(end), 0.0f);
  };
  float serial = 0.0f;
  for (std::size_t i = 0; i < values.size(); i += 100) serial += part(i, i + 100);
  for (int turn = 0; turn < 20; ++turn)
    ASSERT_EQ(parallelReduce(std::size_t(0), values.size(), std::size_t(100), 0.0f, part, std::plus<>()), serial);
}

TEST(Parallel, WhatABodyThrowsComesThroughAndEndsTheLoop) {
  std::atomic<int> done = 0;
  Progress progress;
  auto work = [&](int i) {
    progress.throwIfCancelled();
    ++done;
    if (i == 10) progress.cancel();
  };
  EXPECT_THROW(parallelFor(0, 1'000'000, work), Cancelled);
  EXPECT_LT(done, 1'000'000);
}

TEST(Parallel, TheCallersLastWordIsHeardAndSoAreTheBodies) {
  // In the preset tsan this is a test of what the sanitizer is told: it must find nothing here.
  for (int turn = 0; turn < 50; ++turn) {
    std::vector<std::vector<int>> rows(64);
    int plain = turn;
    parallelFor(std::size_t(0), rows.size(), [&](std::size_t i) { rows[i].assign(100, plain + int(i)); });
    for (std::size_t i = 0; i < rows.size(); ++i) ASSERT_EQ(rows[i].back(), turn + int(i));
  }
}

TEST(Parallel, LoopsWithinLoopsEnd) {
  std::vector<int> sums(50, 0);
  parallelFor(std::size_t(0), sums.size(), [&](std::size_t i) {
    sums[i] = parallelReduce(
        0, 1000, 10, 0, [](int first, int end) { return end - first; }, std::plus<>());
  });
  EXPECT_EQ(sums, std::vector<int>(50, 1000));
}

TEST(Parallel, WhoIsIsolatedTakesUpNothingElse) {
  // With two threads there is never anything else left to take up: four, however many cores there are.
  tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 4);
  static thread_local int depth = 0;
  std::atomic<int> done = 0, deepest = 0;
  tbb::task_arena(4).execute([&] {
    parallelFor(0, 1000, [&](int) {
      if (depth > 0) deepest = 1;
      ++depth;
      isolated([&] {
        parallelFor(0, 7, [&](int) {
          std::this_thread::sleep_for(100us);  // so that there is something to wait for
          ++done;
        });
      });
      --depth;
    });
  });
  EXPECT_EQ(done, 7000);
  EXPECT_EQ(deepest, 0) << "a piece of the outer loop began within another";
}

TEST(Parallel, HelpersAreToldOf) {
  static thread_local bool isTold = false;
  onHelpers([] { isTold = true; });
  auto caller = std::this_thread::get_id();
  std::atomic<bool> helped = false, told = false;
  // Who has just helped another loop may come without having been asked anew.
  for (int turn = 0; turn < 200 && !told; ++turn) {
    parallelFor(0, 8, [&](int) {
      std::this_thread::sleep_for(1ms);
      if (std::this_thread::get_id() == caller) return;
      helped = true;
      if (isTold) told = true;
    });
    std::this_thread::sleep_for(1ms);
  }
  if (!helped) GTEST_SKIP() << "nobody helps: one core";
  EXPECT_TRUE(told);
}

#if defined(__SANITIZE_THREAD__)
namespace {

/// Two threads write to one place, in pieces of which one has ended long before the other begins. Nothing but the loop
/// itself may order them for the sanitizer: the flags are relaxed.
void raceInALoop() {
  int place = 0;
  std::atomic<std::size_t> writer = 0;
  std::atomic<int> later = 0;
  auto relaxed = std::memory_order_relaxed;
  for (int turn = 0; turn < 100 && later.load(relaxed) < 3; ++turn)
    parallelForRanges(0, 64, 1, [&](int, int) {
      std::size_t self = std::hash<std::thread::id>()(std::this_thread::get_id()), nobody = 0;
      if (turn == 0 && writer.compare_exchange_strong(nobody, self, relaxed)) place = 1;
      std::this_thread::sleep_for(5ms);
      if (writer.load(relaxed) == self || later.fetch_add(1, relaxed) != 2) return;
      place = 2;
    });
}

}  // namespace

TEST(Parallel, TheSanitizerSeesARaceOfPieces) {
  if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "nobody helps: one core";
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        raceInALoop();
        std::exit(0);
      },
      [](int status) { return status != 0; }, "data race");
}
#endif

}  // namespace velum
