#pragma once
#include <gtest/gtest.h>

#include <memory>

#include "velum/gpu/Context.h"

namespace velum {

/// A test that needs OpenGL: one EGL context for the whole process, current in each test. Fails when the driver has
/// reported an error meanwhile.
class GlTest : public testing::Test {
 protected:
  static gpu::Context& context() {
    // Lives until the process ends: Mesa's own exit handlers may run before a destructor of ours.
    static gpu::Context* one = gpu::Context::createEgl().release();
    return *one;
  }

  void SetUp() override {
    context().makeCurrent();
    mErrorsBefore = context().errorCount();
  }
  void TearDown() override {
    context().makeCurrent();
    if (mErrorsExpected) return;
    EXPECT_EQ(context().errorCount(), mErrorsBefore) << "the driver has reported errors: see the warnings above";
  }
  /// For tests that ask the driver for what it must refuse.
  void expectDriverErrors() { mErrorsExpected = true; }

 private:
  int mErrorsBefore = 0;
  bool mErrorsExpected = false;
};

}  // namespace velum
