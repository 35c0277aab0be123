// Dispatches of any size, by what OpenGL promises.
#include <cstdint>
#include <numeric>
#include <vector>

#include "GlFixture.h"
#include "ProbeShaders.h"
#include "gpu/Buffer.h"
#include "gpu/GpuError.h"
#include "gpu/Program.h"
#include "gpu/Strided.h"
#include "gpu/Texture.h"

namespace velum::gpu {
namespace {

class DispatchGL : public GlTest {
 protected:
  /// Each thread adds its number plus one to its own word; groups beyond the last find no word.
  Program makeCounting(int threads) {
    mProbes.add("count.comp", "layout(local_size_x = " + std::to_string(threads) + R"() in;
#include "common/line.glsl"
layout(std430, binding = 0) buffer WordBlock { uint words[]; };
layout(location = 0) uniform int count;
void main() {
  uint at = lineThread();
  if (at < uint(count)) atomicAdd(words[at], at + 1u + 1000000u * gl_WorkGroupID.z);
}
)");
    return mProbes.make({"count.comp"});
  }
  std::vector<std::uint32_t> run(const Program& program, std::uint32_t words, std::uint32_t groups, int parts) {
    Buffer buffer("words", words * sizeof(std::uint32_t));
    buffer.clear();
    buffer.bindStorage(0);
    program.set(0, int(words));
    dispatchLine(program, groups, parts);
    barrier();
    std::vector<std::uint32_t> out(words);
    buffer.read(0, buffer.bytes(), out.data());
    return out;
  }
  ProbeShaders mProbes;
};

TEST_F(DispatchGL, MoreGroupsThanDriversPromiseRunOnceEach) {
  Program program = makeCounting(2);
  for (std::uint32_t groups : {1u, 32768u, 32769u, 65535u, 65536u, 200001u}) {
    std::vector<std::uint32_t> expected(2 * groups);
    std::iota(expected.begin(), expected.end(), 1u);
    EXPECT_EQ(run(program, 2 * groups, groups, 1), expected) << groups;
  }
}

TEST_F(DispatchGL, PartsRunOfEachGroup) {
  Program program = makeCounting(1);
  std::vector<std::uint32_t> out = run(program, 40000, 40000, 3);
  for (std::uint32_t i = 0; i < 40000; ++i) ASSERT_EQ(out[i], 3 * (i + 1) + 3000000) << i;
}

TEST_F(DispatchGL, NoGroupsRunNothing) { EXPECT_EQ(run(makeCounting(1), 3, 0, 1), std::vector<std::uint32_t>(3)); }

TEST(Strided, ComesToEachGroupOnce) {
  for (int groups : {1, 2, 3, 64, 1000, 4095}) {
    Strided order = stridedGroups(groups);
    ASSERT_GE(order.count, groups);
    std::vector<int> times(std::size_t(order.count));
    for (int n = 0; n < order.count; ++n) ++times[std::size_t(n * order.stride % order.count)];
    EXPECT_EQ(times, std::vector<int>(std::size_t(order.count), 1)) << groups;
  }
}

#ifndef NDEBUG
TEST_F(DispatchGL, MoreGroupsAlongAnAxisThanDriversPromiseAreOurMistake) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";  // drivers have threads
  Program program = makeCounting(1);
  EXPECT_DEATH(dispatch(program, {kMostGroups + 1, 1, 1}), "every driver takes");
  EXPECT_DEATH(dispatch(program, {1, kMostGroups + 1, 1}), "every driver takes");
  EXPECT_DEATH(dispatch(program, {-1, 1, 1}), "every driver takes");
}
#endif

TEST_F(DispatchGL, BuffersLongerThanTheDriverReadsAreRefused) {
  ::setenv("VELUM_MAX_STORAGE_BLOCK", "4096", 1);
  ::setenv("VELUM_MAX_TEXTURE_BUFFER", "512", 1);
  auto small = Context::create(ContextKind::Auto);
  ::unsetenv("VELUM_MAX_STORAGE_BLOCK");
  ::unsetenv("VELUM_MAX_TEXTURE_BUFFER");
  EXPECT_NO_THROW(Buffer("fits", 4096).bindStorage(0));
  EXPECT_THROW(Buffer("too long", 4100).bindStorage(0), GpuError);
  EXPECT_NO_THROW(Texture::makeOfBuffer("fits", Format::R32ui, Buffer("fits", 2048)));
  EXPECT_THROW(Texture::makeOfBuffer("too long", Format::R32ui, Buffer("too long", 2052)), GpuError);
}

}  // namespace
}  // namespace velum::gpu
