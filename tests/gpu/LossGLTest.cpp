// Contexts that a driver loses, and drivers that offer too little.
#include "gpu/Loss.h"

#include <dlfcn.h>

#include <cstring>

#include "GlFixture.h"
#include "gpu/Buffer.h"
#include "gpu/Fence.h"
#include "gpu/Gl.h"
#include "gpu/Texture.h"

namespace velum::gpu {
namespace {

class LossGL : public GlTest {
 protected:
  void TearDown() override {
    simulateLoss(0);
    GlTest::TearDown();
  }
};

int valueOf(const Buffer& buffer) {
  int value = 0;
  buffer.read(0, sizeof value, &value);
  return value;
}

void* eglProcAddress(const char* name) {
  static auto get = reinterpret_cast<void* (*)(const char*)>(
      dlsym(dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL), "eglGetProcAddress"));
  return get(name);
}

TEST_F(LossGL, ContextsAreToldOfResets) {
  auto own = Context::createEgl();  // OSMesa knows of no resets
  GLint strategy = 0;
  gl().GetIntegerv(0x8256, &strategy);  // GL_RESET_NOTIFICATION_STRATEGY
  EXPECT_EQ(strategy, 0x8252);          // GL_LOSE_CONTEXT_ON_RESET
  EXPECT_FALSE(isContextLost());
}

TEST_F(LossGL, ALostContextStaysLostUntilItIsMadeAnew) {
  auto own = Context::createEgl();
  simulateLoss(2);
  EXPECT_FALSE(isContextLost());
  EXPECT_TRUE(isContextLost());
  EXPECT_TRUE(isContextLost()) << "drivers say so only once";
  EXPECT_THROW(throwIfLost(), ContextLost);
  unsigned before = contextNumber();
  Limits limits = own->limits();
  own->renew();
  EXPECT_GT(contextNumber(), before);
  EXPECT_FALSE(isContextLost());
  EXPECT_EQ(own->limits().renderer, limits.renderer);
  EXPECT_EQ(own->limits().memoryBytes, limits.memoryBytes) << "pictures are to be the same";
  int five = 5;
  EXPECT_EQ(valueOf(Buffer("anew", sizeof five, &five)), 5);
}

TEST_F(LossGL, WhatWasInALostContextTakesNothingWithItFromTheNext) {
  int errors = Context::errorCount();
  auto own = Context::createEgl();
  int nine = 9;
  std::vector<Buffer> old;
  std::vector<Fence> fences;
  for (int i = 0; i < 20; ++i) old.emplace_back("old", sizeof nine, &nine), fences.emplace_back("old");
  Texture texture = Texture::make2d("old", Format::R8, {4, 4});
  own->renew();
  // The driver gives them the names of the old ones.
  std::vector<Buffer> young;
  for (int i = 0; i < 20; ++i) young.emplace_back("young", sizeof i, &i);
  old.clear(), fences.clear(), texture = Texture::make2d("young", Format::R8, {4, 4});
  for (int i = 0; i < 20; ++i) EXPECT_EQ(valueOf(young[std::size_t(i)]), i);
  EXPECT_EQ(Context::errorCount(), errors);
}

#ifndef NDEBUG
TEST_F(LossGL, UsingAnObjectOfALostContextIsAMistakeOfOurs) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";  // drivers have threads
  auto use = [] {
    auto own = Context::createEgl();
    Buffer old("old", 16);
    own->renew();
    old.clear();
  };
  EXPECT_DEATH(use(), "an object is used in its own context");
}
#endif

TEST_F(LossGL, WorkIsDoneAgainInANewContextAndSoOftenOnly) {
  auto own = Context::createEgl();
  int tries = 0;
  auto work = [&] {
    ++tries;
    int seven = 7;
    int value = valueOf(Buffer("work", sizeof seven, &seven));
    throwIfLost();
    return value;
  };
  testing::internal::CaptureStderr();
  simulateLoss(1, 2);
  EXPECT_EQ(despiteLoss(work), 7);
  EXPECT_EQ(tries, 3);
  simulateLoss(1, 100);
  try {
    despiteLoss(work);
    ADD_FAILURE() << "it goes on for ever";
  } catch (const ContextLost& error) {
    EXPECT_NE(std::string(error.what()).find("whenever it draws this"), std::string::npos) << error.what();
  }
  EXPECT_EQ(tries, 3 + kMostLosses + 1);
  simulateLoss(0);
  own->renew();
  EXPECT_NE(testing::internal::GetCapturedStderr().find("drawn once more"), std::string::npos);
  // What fails by itself is not done again.
  EXPECT_THROW(despiteLoss([&]() -> int { throw GpuError(std::to_string(++tries)); }), GpuError);
  EXPECT_EQ(tries, 3 + kMostLosses + 2);
}

const void* someContext() { return "the window's"; }

TEST_F(LossGL, AContextOfAWindowIsTheWindowsToRenew) {
  auto own = Context::createEgl();
  auto adopted = Context::adopt(eglProcAddress, someContext);
  adopted->makeCurrent();
  simulateLoss(1);
  int tries = 0;
  EXPECT_THROW(despiteLoss([&] { ++tries, throwIfLost(); }), ContextLost);
  EXPECT_EQ(tries, 1);
}

TEST_F(LossGL, ADriverThatLacksAFunctionIsTooOldAndSaysWhich) {
  auto own = Context::createEgl();
  auto lacking = [](const char* name) -> void* {
    return std::strcmp(name, "glBindTextureUnit") == 0 ? nullptr : eglProcAddress(name);
  };
  try {
    Context::adopt(lacking, someContext);
    ADD_FAILURE() << "it is not missed";
  } catch (const TooOld& error) {
    EXPECT_NE(std::string(error.what()).find("lacks glBindTextureUnit"), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).rfind(own->limits().renderer, 0), 0u) << error.what();
  }
  EXPECT_THROW(Context::adopt([](const char*) -> void* { return nullptr; }, someContext), TooOld);
}

}  // namespace
}  // namespace velum::gpu
