#include <cstdlib>
#include <thread>
#include <vector>

#include "GlFixture.h"
#include "velum/gpu/Buffer.h"
#include "velum/gpu/GpuError.h"

namespace velum::gpu {
namespace {

class ContextGL : public GlTest {};

TEST_F(ContextGL, SaysWhatTheDriverOffers) {
  const Limits& limits = context().limits();
  EXPECT_FALSE(limits.renderer.empty());
  EXPECT_FALSE(limits.version.empty());
  EXPECT_GE(limits.texture3d, 2048);  // what OpenGL 4.5 promises
  EXPECT_GE(limits.texture2d, 16384);
  EXPECT_GE(limits.textureBuffer, 65536u);
  EXPECT_GT(limits.memoryBytes, std::size_t(64) << 20);
}

TEST_F(ContextGL, LimitsCanBeLoweredForTests) {
  ::setenv("VELUM_MAX_TEXTURE_3D", "64", 1);
  ::setenv("VELUM_GPU_MEMORY_MB", "100", 1);
  auto small = Context::createEgl();
  ::unsetenv("VELUM_MAX_TEXTURE_3D");
  ::unsetenv("VELUM_GPU_MEMORY_MB");
  EXPECT_EQ(small->limits().texture3d, 64);
  EXPECT_EQ(small->limits().memoryBytes, std::size_t(100) << 20);
}

TEST_F(ContextGL, TwoContextsTakeTurnsOnAThread) {
  auto other = Context::createEgl();
  int five = 5, nine = 9, out = 0;
  Buffer theirs("theirs", sizeof(int), &nine);
  context().makeCurrent();
  Buffer ours("ours", sizeof(int), &five);
  other->makeCurrent();
  theirs.read(0, sizeof(int), &out);
  EXPECT_EQ(out, 9);
  theirs = Buffer();
  context().makeCurrent();
  ours.read(0, sizeof(int), &out);
  EXPECT_EQ(out, 5);
  EXPECT_EQ(other->errorCount(), 0);
}

TEST_F(ContextGL, WorksOnAnotherThread) {
  std::thread worker([] {
    auto own = Context::createEgl();
    int five = 5, out = 0;
    Buffer buffer("worker", sizeof(int), &five);
    buffer.read(0, sizeof(int), &out);
    EXPECT_EQ(out, 5);
    EXPECT_EQ(own->errorCount(), 0);
  });
  worker.join();
}

TEST_F(ContextGL, OsMesaIsThereOrSaysWhyNot) {
  // A thread of its own: OSMesa does not know of the EGL context that is current here.
  std::thread worker([] {
    try {
      auto mesa = Context::createOsMesa();
      int five = 5, out = 0;
      Buffer buffer("osmesa", sizeof(int), &five);
      buffer.read(0, sizeof(int), &out);
      EXPECT_EQ(out, 5);
    } catch (const GpuError& error) {
      EXPECT_GT(std::string(error.what()).size(), 20u) << error.what();
    }
  });
  worker.join();
}

}  // namespace
}  // namespace velum::gpu
