#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include "GlFixture.h"
#include "core/Error.h"
#include "gpu/Buffer.h"
#include "gpu/GpuError.h"
#include "gpu/Texture.h"

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
  EXPECT_GE(limits.storageBlock, std::size_t(1) << 27);
  EXPECT_GT(limits.memoryBytes, std::size_t(64) << 20);
}

TEST_F(ContextGL, IsTheDriverThatWasAskedFor) {
  const char* wanted = std::getenv("VELUM_TEST_DRIVER");
  if (!wanted) GTEST_SKIP() << "whichever the machine has: " << context().limits().renderer;
  EXPECT_EQ(context().limits().renderer.rfind(wanted, 0), 0u) << context().limits().renderer;
}

TEST_F(ContextGL, IsOfTheKindThatTheEnvironmentNames) {
  const char* wanted = std::getenv("VELUM_CONTEXT");
  if (!wanted) GTEST_SKIP() << "VELUM_CONTEXT names none";
  context();
  std::ifstream maps("/proc/self/maps");
  std::string loaded(std::istreambuf_iterator<char>(maps), {});
  bool isOsMesa = std::string_view(wanted) == "osmesa";
  EXPECT_NE(loaded.find(isOsMesa ? "/libOSMesa.so" : "/libEGL.so"), std::string::npos);
  EXPECT_TRUE(!isOsMesa || loaded.find("/libEGL.so") == std::string::npos);
}

TEST_F(ContextGL, TheEnvironmentNamesNoKindThatThereIsNot) {
  const char* before = std::getenv("VELUM_CONTEXT");
  std::string kept = before ? before : "";
  ::setenv("VELUM_CONTEXT", "vulkan", 1);
  EXPECT_THROW(Context::create(ContextKind::Auto), ArgumentError);
  before ? ::setenv("VELUM_CONTEXT", kept.c_str(), 1) : ::unsetenv("VELUM_CONTEXT");
}

TEST_F(ContextGL, LimitsCanBeLoweredForTests) {
  ::setenv("VELUM_MAX_TEXTURE_3D", "64", 1);
  ::setenv("VELUM_GPU_MEMORY_MB", "100", 1);
  auto small = Context::create(ContextKind::Auto);
  ::unsetenv("VELUM_MAX_TEXTURE_3D");
  ::unsetenv("VELUM_GPU_MEMORY_MB");
  EXPECT_EQ(small->limits().texture3d, 64);
  EXPECT_EQ(small->limits().memoryBytes, std::size_t(100) << 20);
}

TEST_F(ContextGL, TwoContextsTakeTurnsOnAThread) {
  auto other = Context::create(ContextKind::Auto);
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
}

TEST_F(ContextGL, WorksOnAnotherThread) {
  std::thread worker([] {
    auto own = Context::create(ContextKind::Auto);
    int five = 5, out = 0;
    Buffer buffer("worker", sizeof(int), &five);
    buffer.read(0, sizeof(int), &out);
    EXPECT_EQ(out, 5);
  });
  worker.join();
}

/// What no driver lets pass: there is no such image unit.
void makeDriverReport() { Texture::make2d("test", Format::R8, {1, 1}).bindImage(1u << 20, Access::Read); }

TEST_F(ContextGL, WhatIsRefusedAndSaidIsNoErrorOfTheDriver) {
  int before = Context::errorCount();
  EXPECT_THROW(Texture::make3d("too long", Format::R8, {context().limits().texture3d * 2, 1, 1}), GpuError);
  EXPECT_EQ(Context::errorCount(), before);
}

/// Run by the next law alone.
TEST_F(ContextGL, DISABLED_AnError) {
  makeDriverReport();
  EXPECT_GT(Context::errorCount(), 0);
}

TEST_F(ContextGL, ACaseInWhichTheDriverReportsAnErrorFails) {
  FILE* pipe = ::popen((std::filesystem::read_symlink("/proc/self/exe").string() +
                        " --gtest_also_run_disabled_tests --gtest_filter=ContextGL.DISABLED_AnError 2>&1")
                           .c_str(),
                       "r");
  ASSERT_NE(pipe, nullptr);
  std::string said;
  char part[512];
  while (std::fgets(part, sizeof part, pipe)) said += part;
  EXPECT_EQ(WEXITSTATUS(::pclose(pipe)), 1) << said;
  EXPECT_NE(said.find("the driver has reported errors"), std::string::npos) << said;
  EXPECT_NE(said.find("warning: OpenGL: "), std::string::npos) << said;
}

TEST_F(ContextGL, AProgramEndsAtAnErrorOfTheDriverWhereThatIsAskedFor) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";  // drivers have threads
  auto report = [] {
    ::setenv("VELUM_DRIVER_ERRORS", "fatal", 1);
    makeDriverReport();
    std::exit(0);
  };
  EXPECT_EXIT(report(), testing::ExitedWithCode(3), "OpenGL: ");
}

TEST_F(ContextGL, OsMesaIsThereOrSaysWhyNot) {
  // A thread of its own: OSMesa does not know of an EGL context that is current here.
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
