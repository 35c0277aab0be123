#include "render/passes/ProgramCache.h"

#include <gtest/gtest.h>

#include <vector>

namespace velum::render {

TEST(ProgramCache, KeepsWhatWasAskedForLastAndNoMore) {
  ProgramCache<int> cache;
  std::vector<int> made;
  auto ask = [&](int variant) {
    cache.find(variant, [&] {
      made.push_back(variant);
      return gpu::Program();
    });
  };
  const int most = int(ProgramCache<int>::kMost);
  for (int round = 0; round < 3; ++round)
    for (int variant = 0; variant < most; ++variant) ask(variant);
  EXPECT_EQ(int(made.size()), most) << "each is made once";
  ask(0);
  ask(most);  // 1 has not been asked for longest
  made.clear();
  for (int variant = 2; variant <= most; ++variant) ask(variant);
  ask(0);
  EXPECT_TRUE(made.empty());
  ask(1);
  EXPECT_EQ(made, std::vector<int>{1});
}

TEST(ProgramCache, TheOneThatWasFoundLastStaysWhereItIs) {
  ProgramCache<int> cache;
  auto make = [] { return gpu::Program(); };
  const gpu::Program* first = &cache.find(7, make);
  for (int variant = 100; variant < 109; ++variant) cache.find(variant, make);
  EXPECT_EQ(&cache.find(7, make), first);
}

}  // namespace velum::render
