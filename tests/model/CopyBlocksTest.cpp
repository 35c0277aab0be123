// Blocks of copies: what of a crowd a view looks at.
#include "model/CopyBlocks.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "model/InstanceTarget.h"
#include "shared/instance.h"

namespace velum {
namespace {

/// A view from a place in a grid of copies of edge 1, at random.
shared::InstanceView viewOf(glm::ivec3 grid, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  auto anywhere = [&] { return glm::vec3(unit(random), unit(random), unit(random)); };
  glm::vec3 forward = glm::normalize(anywhere() - 0.5f), right = glm::normalize(glm::cross(forward, anywhere()));
  shared::InstanceView view{};
  bool isFlat = seed % 3 == 0;
  view.eye = glm::vec4(1.4f * glm::vec3(grid) * (anywhere() - 0.2f), 0.0f);
  view.forward = glm::vec4(forward, 0.0f);
  view.right = glm::vec4(right * (isFlat ? 6.0f : 0.6f), 0.0f);
  view.up = glm::vec4(glm::cross(right, forward) * (isFlat ? 4.0f : 0.4f), 0.0f);
  view.isOrthographic = isFlat ? 1 : 0;
  view.pictureSize = {300.0f, 200.0f};
  view.shift = {0.5f, 0.5f};
  view.size = {300, 200};
  view.copyStep = glm::vec4(1.0f);
  view.copySphere = {0.0f, 0.0f, 0.0f, 0.9f};
  view.copiesX = grid.x, view.copiesY = grid.y, view.copiesZ = grid.z;
  view.allCopies = grid.x * grid.y * grid.z - 3;
  view.detail = 1.0f;
  return view;
}

/// The middle of a copy in the picture, pixels, and its depth.
glm::vec3 seenAt(const shared::InstanceView& view, std::uint32_t copy) {
  glm::vec3 q = model::copyShift(view, copy) - glm::vec3(view.eye);
  glm::vec3 right(view.right), up(view.up);
  float depth = glm::dot(q, glm::vec3(view.forward)), by = view.isOrthographic != 0 ? 1.0f : depth;
  glm::vec2 at = glm::vec2(glm::dot(q, right) / glm::dot(right, right), -glm::dot(q, up) / glm::dot(up, up)) / by;
  return {(at * 0.5f + 0.5f) * view.pictureSize, depth};
}

std::uint32_t blockOf(glm::ivec3 grid, std::uint32_t copy) {
  glm::ivec3 at(int(copy) % grid.x, int(copy) / grid.x % grid.y, int(copy) / (grid.x * grid.y));
  glm::ivec3 blocks = (grid + shared::kBlockEdge - 1) / shared::kBlockEdge;
  at /= shared::kBlockEdge;
  return std::uint32_t((at.z * blocks.y + at.y) * blocks.x + at.x);
}

TEST(CopyBlocks, HoldEveryCopyThatTheWindowShows) {
  glm::ivec3 grid(23, 18, 9);
  for (unsigned seed = 0; seed < 30; ++seed) {
    shared::InstanceView view = viewOf(grid, seed);
    auto found = model::blocksInView(view);
    std::set<std::uint32_t> blocks(found.blocks.begin(), found.blocks.end());
    EXPECT_EQ(blocks.size(), found.blocks.size()) << "each once";
    for (std::uint32_t copy = 0; copy < std::uint32_t(view.allCopies); ++copy) {
      glm::vec3 at = seenAt(view, copy);
      bool isIn = at.z > 0.0f && at.x > 0.0f && at.y > 0.0f && at.x < view.pictureSize.x && at.y < view.pictureSize.y;
      ASSERT_TRUE(!isIn || blocks.contains(blockOf(grid, copy))) << "view " << seed << ", copy " << copy;
    }
  }
}

TEST(CopyBlocks, BesideTheWindowAreLeftOutLevelByLevel) {
  // A million copies, of which a window into the middle holds few: 15,625 blocks are not looked at one by one.
  glm::ivec3 grid(100);
  shared::InstanceView view = viewOf(grid, 1);
  view.eye = glm::vec4(glm::vec3(50.0f, 50.0f, 90.0f), 0.0f);
  view.forward = {0.0f, 0.0f, 1.0f, 0.0f};
  view.right = {0.3f, 0.0f, 0.0f, 0.0f};
  view.up = {0.0f, 0.2f, 0.0f, 0.0f};
  auto found = model::blocksInView(view);
  EXPECT_GT(found.blocks.size(), 2u);
  EXPECT_LT(found.looks, 600u);
  view.forward = {0.0f, 0.0f, -1.0f, 0.0f};
  view.eye.z = -200.0f;
  found = model::blocksInView(view);
  EXPECT_EQ(found.blocks.size(), 0u);
  EXPECT_EQ(found.looks, 1u) << "all of it lies behind the eye";
}

TEST(CopyBlocks, NearCopiesAreThoseAtWhichAnErrorShows) {
  glm::ivec3 grid(23, 18, 9);
  for (unsigned seed = 0; seed < 30; ++seed) {
    shared::InstanceView view = viewOf(grid, seed);
    auto near = model::nearCopies(view, 0.02f, 1u << 20);
    std::set<std::uint32_t> found(near.begin(), near.end());
    float perLength = 0.5f * view.pictureSize.y / glm::length(glm::vec3(view.up));
    for (std::uint32_t copy = 0; copy < std::uint32_t(view.allCopies); ++copy) {
      glm::vec3 at = seenAt(view, copy);
      bool isIn = at.z > 0.0f && at.x > 0.0f && at.y > 0.0f && at.x < view.pictureSize.x && at.y < view.pictureSize.y;
      float nearest = std::max(at.z - view.copySphere.w, 1e-6f);
      float pixels = 0.02f * perLength / (view.isOrthographic != 0 ? 1.0f : nearest);
      bool isFound = found.contains(copy);
      EXPECT_TRUE(!isIn || pixels < 1.001f || isFound) << "view " << seed << ", copy " << copy;
      EXPECT_TRUE(pixels > 0.999f || !isFound) << "view " << seed << ", copy " << copy;
    }
    auto few = model::nearCopies(view, 0.02f, 5);
    ASSERT_EQ(few.size(), std::min<std::size_t>(5, near.size()));
    EXPECT_TRUE(std::equal(few.begin(), few.end(), near.begin())) << "the nearest";
  }
}

TEST(InstanceRoom, OfACrowdGrowsByANumberACopy) {
  model::InstanceRoom few{235'671, 569, 1000}, many{235'671, 569, 1'000'000};
  EXPECT_EQ(many.count() - few.count(), 999'000u);
  EXPECT_EQ(many.firstWhole(), few.firstWhole());
  EXPECT_EQ(many.firstWhole() % 32, 0u);
  EXPECT_LT(many.count() / 8, 17'000'000u) << "bytes of a bit each";
}

}  // namespace
}  // namespace velum
