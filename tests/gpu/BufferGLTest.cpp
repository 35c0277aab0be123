#include "gpu/Buffer.h"

#include <cstdint>
#include <numeric>
#include <vector>

#include "GlFixture.h"
#include "gpu/Framebuffer.h"
#include "gpu/GpuError.h"
#include "gpu/Program.h"
#include "gpu/Texture.h"

namespace velum::gpu {
namespace {

class BufferGL : public GlTest {};

TEST_F(BufferGL, GivesBackWhatItWasMadeFrom) {
  std::vector<std::uint32_t> in(1000), out(1000);
  std::iota(in.begin(), in.end(), 7u);
  Buffer buffer("test", std::span<const std::uint32_t>(in));
  ASSERT_EQ(buffer.bytes(), 4000u);
  buffer.read(0, 4000, out.data());
  EXPECT_EQ(out, in);
}

TEST_F(BufferGL, WritesAndReadsParts) {
  std::vector<std::uint32_t> out(10);
  Buffer buffer("test", 40);
  buffer.clear();
  std::uint32_t values[] = {5, 6, 7};
  buffer.write(8, 12, values);
  buffer.read(0, 40, out.data());
  EXPECT_EQ(out, (std::vector<std::uint32_t>{0, 0, 5, 6, 7, 0, 0, 0, 0, 0}));
  std::uint32_t middle = 0;
  buffer.read(12, 4, &middle);
  EXPECT_EQ(middle, 6u);
}

template <class Made>
void expectMovesLeaveNothingBehind(Made first, Made second) {
  ASSERT_TRUE(first);
  unsigned firstId = first.id(), secondId = second.id();
  EXPECT_NE(firstId, secondId);
  Made moved(std::move(first));
  EXPECT_FALSE(first);  // NOLINT: the law is about moved-from handles
  EXPECT_EQ(moved.id(), firstId);
  moved = std::move(second);
  EXPECT_EQ(moved.id(), secondId);
  second = Made();
  EXPECT_FALSE(second);
}

TEST_F(BufferGL, AMovedFromHandleIsEmpty) {
  expectMovesLeaveNothingBehind(Buffer("a", 16), Buffer("b", 32));
  expectMovesLeaveNothingBehind(Texture::make2d("a", Format::R8, {4, 4}), Texture::make2d("b", Format::R8, {4, 4}));
  Texture color = Texture::make2d("colour", Format::Rgba8, {4, 4});
  expectMovesLeaveNothingBehind(Framebuffer("a", {&color}), Framebuffer("b", {&color}));
  expectMovesLeaveNothingBehind(Program({"render/resolve.comp"}), Program({"render/resolve.comp"}));
}

TEST_F(BufferGL, AMovedBufferKeepsItsSize) {
  Buffer a("a", 48);
  Buffer b(std::move(a));
  EXPECT_EQ(b.bytes(), 48u);
  a = std::move(b);
  EXPECT_EQ(a.bytes(), 48u);
}

TEST_F(BufferGL, EmptyHandlesNeedNoContext) {
  Buffer buffer;
  Texture texture;
  Program program;
  EXPECT_FALSE(buffer || texture || program);
  EXPECT_EQ(buffer.bytes(), 0u);
}

TEST_F(BufferGL, WithoutMemoryForItNobodyGetsOne) {
  try {
    Buffer buffer("volume", std::size_t(1) << 50);
    FAIL() << "made";
  } catch (const GpuError& error) {
    EXPECT_NE(std::string(error.what()).find("volume"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace velum::gpu
