#pragma once
#include <gtest/gtest.h>

#include <memory>

#include "gpu/Context.h"

namespace velum {

/// A test that needs OpenGL: one context without a window for the whole process, current in each test. VELUM_CONTEXT
/// says of which kind.
class GlTest : public testing::Test {
 protected:
  static gpu::Context& context() {
    // Lives until the process ends: Mesa's own exit handlers may run before a destructor of ours.
    static gpu::Context* one = gpu::Context::create(gpu::ContextKind::Auto).release();
    return *one;
  }

  void SetUp() override { context().makeCurrent(); }
  void TearDown() override { context().makeCurrent(); }
};

}  // namespace velum
