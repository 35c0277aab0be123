#include "model/InstanceTarget.h"

#include <gtest/gtest.h>

#include <vector>

#include "shared/instance.h"

namespace velum {
namespace {

TEST(InstanceParts, AreEachOneDispatchOfWhatDriversPromiseAndTogetherAllInstancesOnce) {
  struct Case {
    std::uint32_t instances;
    int copies;
    std::uint32_t most;
  };
  for (const Case& c : std::vector<Case>{{1, 1, 1u << 17},
                                         {1, 200000, 1u << 24},
                                         {3, 100000, 1u << 20},
                                         {20'000'000, 3, 1u << 27},
                                         {130'000'000, 1, 1u << 27},
                                         {4'200'000, 1, 1u << 22},
                                         {1000, 70'000, 1000}}) {
    std::uint64_t sum = 0;
    std::uint32_t nextFirst = 0;
    int nextCopy = 0;
    for (const model::InstancePart& part : model::instanceParts(c.instances, c.copies, c.most)) {
      std::uint32_t count = part.end - part.first;
      EXPECT_LE((count + shared::kInstanceGroup - 1) / shared::kInstanceGroup, std::uint32_t(gpu::kMostGroups));
      EXPECT_LE(part.copies, gpu::kMostGroups);
      EXPECT_EQ(part.first, nextFirst);
      EXPECT_EQ(part.firstCopy, nextCopy);
      nextFirst = part.end == c.instances ? 0 : part.end;
      nextCopy += nextFirst == 0 ? part.copies : 0;
      sum += std::uint64_t(count) * std::uint64_t(part.copies);
    }
    EXPECT_EQ(sum, std::uint64_t(c.instances) * std::uint64_t(c.copies)) << c.instances << " x " << c.copies;
  }
}

}  // namespace
}  // namespace velum
