// A case in which a driver reports an error, or what is undefined, fails, in whichever context and thread.
#include <gtest/gtest.h>

#include "gpu/Context.h"

namespace velum {
namespace {

class WatchDriver : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo&) override { mBefore = gpu::Context::errorCount(); }
  void OnTestEnd(const testing::TestInfo&) override {
    EXPECT_EQ(gpu::Context::errorCount(), mBefore) << "the driver has reported errors: see the warnings above";
  }
  int mBefore = 0;
};

[[maybe_unused]] const bool kIsWatched = [] {
  testing::UnitTest::GetInstance()->listeners().Append(new WatchDriver);
  return true;
}();

}  // namespace
}  // namespace velum
