#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "core/Memory.h"

namespace velum {

TEST(Memory, WhatIsAllocatedIsCountedUntilItIsFreed) {
  constexpr std::size_t kLarge = std::size_t(64) << 20, kSmall = 1000, kPieces = 10'000;
  std::size_t before = allocatedBytes();
  auto large = std::make_unique<std::vector<char>>(kLarge);
  std::vector<std::unique_ptr<char[]>> small(kPieces);
  for (auto& piece : small) piece = std::make_unique<char[]>(kSmall);
  std::size_t held = allocatedBytes();
  EXPECT_GE(held, before + kLarge + kPieces * kSmall);
  EXPECT_LE(held, before + kLarge + kPieces * kSmall * 5 / 4 + (1 << 20)) << "room for what each piece needs beside";
  large.reset();
  small.clear();
  EXPECT_LE(allocatedBytes(), before + (1 << 20));
  releaseFreeMemory();
  EXPECT_LE(allocatedBytes(), before + (1 << 20)) << "what is free was not counted";
}

}  // namespace velum
