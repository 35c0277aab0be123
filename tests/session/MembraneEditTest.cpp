#include "session/membrane/MembraneEdit.h"

#include <gtest/gtest.h>

#include "membrane/forces/Kernels.h"
#include "scene/Scene.h"

namespace velum::session {
namespace {

TEST(ProtectValues, SetsTheStrengthOfAStretchAndLeavesAllElseAsItWas) {
  scene::Membrane membrane;
  membrane.field.byValue = {{0, 0}, {100, 50}, {200, 10}, {400, 30}};
  const auto before = membrane.field.byValue;
  protectValues(membrane, 150, 250, 800);
  const auto& after = membrane.field.byValue;
  for (double value : {-50.0, 0.0, 60.0, 100.0, 149.0, 251.0, 300.0, 399.0, 400.0, 900.0})
    EXPECT_NEAR(membrane::strengthAt(after, value), membrane::strengthAt(before, value), 1e-9) << value;
  for (double value : {150.5, 200.0, 249.5}) EXPECT_EQ(membrane::strengthAt(after, value), 800) << value;
}

TEST(ProtectValues, AStretchBeyondTheCurveEndsWithNothing) {
  scene::Membrane membrane;
  membrane.field.byValue = {{0, 0}, {100, 50}};
  protectValues(membrane, 80, 120, 700);
  EXPECT_EQ(membrane::strengthAt(membrane.field.byValue, 110), 700);
  EXPECT_EQ(membrane::strengthAt(membrane.field.byValue, 121), 0);
  EXPECT_NEAR(membrane::strengthAt(membrane.field.byValue, 79), 39.5, 1e-9);
}

}  // namespace
}  // namespace velum::session
