#include "gpu/Readback.h"

#include <chrono>
#include <cstdint>
#include <numeric>
#include <thread>
#include <vector>

#include "GlFixture.h"
#include "ProbeShaders.h"
#include "gpu/Draw.h"
#include "gpu/Framebuffer.h"

namespace velum::gpu {
namespace {

using Words = std::vector<std::uint32_t>;

class ReadbackGL : public GlTest {
 protected:
  static Words ascending(std::size_t count, std::uint32_t first) {
    Words words(count);
    std::iota(words.begin(), words.end(), first);
    return words;
  }
  /// Polls until something has arrived.
  template <class T>
  static ReadbackResult<T> waitFor(Readback<T>& readback) {
    for (int turn = 0; turn < 20000; ++turn) {
      if (auto result = readback.poll()) return *result;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ADD_FAILURE() << "nothing arrives";
    return {};
  }
};

TEST_F(ReadbackGL, PartsOfBuffersArriveExactly) {
  Words all = ascending(1000, 7);
  Buffer buffer("source", std::span<const std::uint32_t>(all));
  Readback<std::uint32_t> readback("test");
  EXPECT_FALSE(readback.poll());
  EXPECT_FALSE(readback.finish());
  ASSERT_TRUE(readback.start(buffer, 100, 50));
  auto result = readback.finish();
  ASSERT_TRUE(result);
  EXPECT_EQ(result->values, Words(all.begin() + 100, all.begin() + 150));
  EXPECT_EQ(result->age, 0);
  EXPECT_FALSE(readback.finish()) << "given out once";
  // More than the slot held before, less than it holds then.
  ASSERT_TRUE(readback.start(buffer, 0, 1000));
  EXPECT_EQ(readback.finish()->values, all);
  ASSERT_TRUE(readback.start(buffer, 999, 1));
  EXPECT_EQ(readback.finish()->values, Words{1006});
}

TEST_F(ReadbackGL, BoxesOfTexturesArriveExactly) {
  // Odd sides: rows are not aligned to four bytes.
  glm::ivec3 size(7, 5, 3);
  std::vector<std::uint16_t> all(7 * 5 * 3);
  std::iota(all.begin(), all.end(), std::uint16_t(500));
  Texture texture = Texture::make3d("source", Format::R16ui, size, Filter::Nearest, 2);
  texture.write({0, 0, 0}, size, all.data());
  std::uint16_t small[] = {1, 2, 3, 4, 5, 6};
  texture.write({0, 0, 0}, {3, 2, 1}, small, 1);
  Readback<std::uint16_t> readback("test");
  ASSERT_TRUE(readback.start(texture, {2, 1, 1}, {3, 2, 2}));
  std::vector<std::uint16_t> expected;
  for (int z = 1; z < 3; ++z)
    for (int y = 1; y < 3; ++y)
      for (int x = 2; x < 5; ++x) expected.push_back(all[std::size_t((z * 5 + y) * 7 + x)]);
  EXPECT_EQ(readback.finish()->values, expected);
  ASSERT_TRUE(readback.start(texture, {1, 0, 0}, {2, 2, 1}, 1));
  EXPECT_EQ(readback.finish()->values, (std::vector<std::uint16_t>{2, 3, 5, 6}));
}

TEST_F(ReadbackGL, WhatIsWrittenAfterwardsDoesNotArrive) {
  Words before = ascending(64, 1), after = ascending(64, 1001);
  Buffer buffer("source", std::span<const std::uint32_t>(before));
  Readback<std::uint32_t> readback("test");
  ASSERT_TRUE(readback.start(buffer, 0, 64));
  buffer.write(0, buffer.bytes(), after.data());
  EXPECT_EQ(readback.finish()->values, before);
}

TEST_F(ReadbackGL, TwoOnTheirWayAndTheNewestIsGivenOut) {
  Words words = ascending(64, 1);
  Buffer buffer("source", std::span<const std::uint32_t>(words));
  Readback<std::uint32_t> readback("test", 2);
  ASSERT_TRUE(readback.start(buffer, 0, 10));
  std::uint32_t nine = 9;
  buffer.write(0, sizeof nine, &nine);
  ASSERT_TRUE(readback.start(buffer, 0, 10));
  EXPECT_EQ(readback.inFlight(), 2);
  EXPECT_FALSE(readback.start(buffer, 0, 10)) << "two slots only";
  auto result = readback.finish();
  EXPECT_EQ(result->values[0], 9u);
  EXPECT_EQ(result->age, 1) << "one start() has been refused since";
  EXPECT_EQ(readback.inFlight(), 0) << "the older one is given up";
  EXPECT_FALSE(readback.poll());
  ASSERT_TRUE(readback.start(buffer, 0, 10));
}

TEST_F(ReadbackGL, OfSeveralThatHaveArrivedTheNewestIsGivenOut) {
  Buffer buffer("source", 16);
  Readback<std::uint32_t> readback("test", 3);
  for (std::uint32_t frame = 1; frame <= 3; ++frame) {
    buffer.write(0, sizeof frame, &frame);
    ASSERT_TRUE(readback.start(buffer, 0, 1));
  }
  ASSERT_TRUE(Fence("all").wait(60e3));
  EXPECT_EQ(waitFor(readback).values[0], 3u);
  EXPECT_FALSE(readback.poll()) << "older ones are given up";
}

TEST_F(ReadbackGL, FramesGoOnWhileOlderOnesArriveAndSayHowOldTheyAre) {
  std::uint32_t frame = 0;
  Buffer buffer("frame", 16);
  Readback<std::uint32_t> readback("test");
  std::uint32_t last = 0;
  for (frame = 1; frame <= 200; ++frame) {
    buffer.write(0, sizeof frame, &frame);
    // A program's frames take their time; these are so short that a driver with threads of its own falls behind.
    bool isRefused = !readback.start(buffer, 0, 1);
    auto result = isRefused ? waitFor(readback) : readback.poll();
    if (!result) continue;
    EXPECT_EQ(result->values[0] + std::uint32_t(result->age), frame);
    EXPECT_GT(result->values[0], last) << "never an older one after a newer one";
    last = result->values[0];
  }
  if (auto rest = readback.finish()) last = rest->values[0];
  EXPECT_GE(last, 197u);
}

TEST_F(ReadbackGL, PollDoesNotWait) {
  // The whole of a picture is drawn over and over by a shader that takes its time; the copy stands behind that.
  ProbeShaders probes;
  probes.add("probe.vert",
             "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }\n");
  probes.add("probe.frag", R"(layout(location = 0) out vec4 color;
void main() {
  float sum = 0.0;
  for (int i = 0; i < 3000; ++i) sum = fract(sum * 1.37 + gl_FragCoord.x * 0.01);
  color = vec4(sum);
}
)");
  Program program = probes.make({"probe.vert", "probe.frag"});
  Texture color = Texture::make2d("slow", Format::R32f, {512, 512});
  Framebuffer target("slow", {&color});
  Words words = ascending(16, 5);
  Buffer buffer("source", std::span<const std::uint32_t>(words));
  Readback<std::uint32_t> readback("test");
  target.bind();
  auto millisecondsSince = [](auto start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  };
  auto drawSlowly = [&] { draw(program, Primitive::Triangles, {.vertices = 3, .instances = 4}, {.depthTest = false}); };
  // Some drivers wait for whatever is drawn where a copy or a fence stands behind it.
  Buffer other("other", buffer.bytes());
  auto first = std::chrono::steady_clock::now();
  drawSlowly();
  buffer.copyTo(other, 0);
  Fence behind("behind");
  behind.isSignalled();
  double copyMs = millisecondsSince(first);
  finish();
  if (copyMs > 0.5 * millisecondsSince(first)) GTEST_SKIP() << "the driver itself waits: " << copyMs << " ms";
  auto start = std::chrono::steady_clock::now();
  drawSlowly();
  ASSERT_TRUE(readback.start(buffer, 0, 16));
  int polls = 0;
  for (; polls < 100000; ++polls) {
    if (auto result = readback.poll()) {
      EXPECT_EQ(result->values, words);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  double ms = millisecondsSince(start);
  finish();
  if (ms < 100) GTEST_SKIP() << "the driver has done the work in " << ms << " ms, too fast to see it in between";
  EXPECT_GT(polls, 3) << "in " << ms << " ms";
}

TEST_F(ReadbackGL, FencesAreSignalledInTheirOrder) {
  Fence empty;
  EXPECT_TRUE(empty.isSignalled());
  EXPECT_FALSE(empty);
  Buffer a("a", 1 << 20), b("b", 1 << 20);
  a.clear();
  Fence first("first");
  for (int i = 0; i < 20; ++i) a.copyTo(b, 0);
  Fence second("second");
  EXPECT_TRUE(first && second);
  EXPECT_TRUE(second.wait(60e3));
  EXPECT_TRUE(first.isSignalled()) << "what stands behind it is done";
  EXPECT_TRUE(second.isSignalled()) << "and stays so";
  Fence moved(std::move(first));
  EXPECT_FALSE(first);  // NOLINT: the law is about moved-from fences
  EXPECT_TRUE(moved.isSignalled());
  moved = Fence();
  EXPECT_FALSE(moved);
}

}  // namespace
}  // namespace velum::gpu
