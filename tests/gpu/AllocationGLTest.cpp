// Memory that the driver has not: said in words, nothing is left half made.
#include "GlFixture.h"
#include "gpu/Allocation.h"
#include "gpu/Buffer.h"
#include "gpu/Gl.h"
#include "gpu/GpuError.h"
#include "gpu/Readback.h"
#include "gpu/Texture.h"

namespace velum::gpu {
namespace {

using AllocationGL = GlTest;
using Which = AllocationFault::Which;

/// One of each kind.
void makeAll() {
  Buffer small("a small buffer", 100), large("a large buffer", 3 << 20);
  Texture plane = Texture::make2d("a plane", Format::Rgba8, {40, 30});
  Texture box = Texture::make3d("a box", Format::R16f, {16, 8, 4}, Filter::Linear, 3);
  Buffer mapped = Buffer::makeReadable("a mapped buffer", 64);
  UniformBuffer<glm::vec4> block("a block");
  block.set(glm::vec4(1.0f));
}

std::string refusalOf(Which which, std::size_t n) {
  AllocationFault fault(which, n);
  try {
    makeAll();
  } catch (const NoMemory& refusal) {
    return refusal.what();
  }
  return {};
}

TEST_F(AllocationGL, AllMemoryIsAskedForInOnePlace) {
  AllocationFault count;
  makeAll();
  EXPECT_EQ(count.asked(), (std::vector<std::string>{"a small buffer", "a large buffer", "a plane", "a box",
                                                     "a mapped buffer", "a block"}));
  EXPECT_TRUE(count.failed().empty());
}

TEST_F(AllocationGL, EachThatFailsSaysWhichAndHowLargeAndWhatToDo) {
  const char* kSaid[] = {"a small buffer (100 bytes)", "a large buffer (3 MiB)",     "a plane (40 x 30 x 1, 4 KiB)",
                         "a box (16 x 8 x 4, 1 KiB)",  "a mapped buffer (64 bytes)", "a block (16 bytes)"};
  for (std::size_t n = 1; n <= std::size(kSaid); ++n)
    for (Which which : {Which::Nth, Which::NthOn}) {
      std::string words = refusalOf(which, n);
      EXPECT_NE(words.find(kSaid[n - 1]), std::string::npos) << words;
      EXPECT_NE(words.find("close other programs"), std::string::npos) << words;
      EXPECT_EQ(words.find('\n'), std::string::npos) << words;
    }
  EXPECT_EQ(refusalOf(Which::Nth, std::size(kSaid) + 1), "");
  EXPECT_NE(refusalOf(Which::Larger, 1 << 20).find("a large buffer"), std::string::npos);
  EXPECT_EQ(refusalOf(Which::Larger, 4 << 20), "");
  makeAll();
}

TEST_F(AllocationGL, ARefusalAsByDriversIsSaidWhenItIsAskedFor) {
  AllocationFault fault(Which::NthLate, 1);
  Buffer small("small", 100);
  EXPECT_EQ(fault.failed(), std::vector<std::string>{"small"});
  EXPECT_THROW(throwIfExhausted(), NoMemory);
  EXPECT_NO_THROW(throwIfExhausted());
  AllocationFault other(Which::NthLate, 1);
  EXPECT_THROW(Buffer("large", 3 << 20), NoMemory);
}

TEST_F(AllocationGL, WhatWasThereStaysWhereSomethingNewFails) {
  Buffer buffer("kept", 4);
  std::uint32_t seven = 7, read = 0;
  buffer.write(0, 4, &seven);
  {
    AllocationFault fault(Which::NthOn, 1);
    EXPECT_THROW(buffer = Buffer("new", 4), NoMemory);
    ReadbackRing ring("ring", 1);
    EXPECT_THROW(ring.start(buffer, 0, 4), NoMemory);
    EXPECT_EQ(ring.inFlight(), 0);
  }
  buffer.read(0, 4, &read);
  EXPECT_EQ(read, 7u);
}

/// A driver is not waited for when a small buffer is made: who asks later hears of it, whoever it is.
TEST_F(AllocationGL, WhatASmallBufferWasRefusedIsHeardLater) {
  auto exhaust = [] {
    MayRefuse mayRefuse;
    GLuint id = 0;
    gl().CreateBuffers(1, &id);
    gl().NamedBufferStorage(id, GLsizeiptr(1) << 60, nullptr, 0);
    gl().DeleteBuffers(1, &id);
  };
  throwIfExhausted();
  exhaust();
  EXPECT_THROW(throwIfExhausted(), NoMemory);
  EXPECT_NO_THROW(throwIfExhausted());
  exhaust();
  EXPECT_THROW(Texture::make2d("the next", Format::R8, {4, 4}), NoMemory);
  EXPECT_NO_THROW(Texture::make2d("the next", Format::R8, {4, 4}));
}

}  // namespace
}  // namespace velum::gpu
