#include "membrane/sheet/SheetCurve.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sheetShapes.h"

namespace velum {
namespace {

const glm::dvec3 kSize(120, 90, 50);

TEST(SheetCurve, EveryCornerLiesInThePlaneAndOpenOnesEndOnTheRim) {
  int open = 0, closed = 0;
  for (const auto& [name, shape] : allSheets({31, 26}, kSize))
    for (glm::vec3 normal : {glm::vec3(1, 0, 0), glm::vec3(0.3f, -0.8f, 0.2f), glm::vec3(0.1f, 0.2f, 1)}) {
      normal = glm::normalize(normal);
      for (const auto& curve : membrane::crossPlane(shape, normal, 1.3f)) {
        ASSERT_GE(curve.places.size(), 2u) << name;
        for (glm::vec3 p : curve.places) EXPECT_NEAR(glm::dot(normal, p), 1.3f, 1e-4f) << name;
        for (glm::vec3 end : {curve.places.front(), curve.places.back()})
          if (!curve.isClosed) {
            EXPECT_TRUE(std::abs(std::abs(end.x) - 60) < 1e-3f || std::abs(std::abs(end.y) - 45) < 1e-3f) << name;
          }
        ++(curve.isClosed ? closed : open);
      }
    }
  EXPECT_GT(open, 8);
  EXPECT_GT(closed, 0);
}

TEST(SheetCurve, AFlatSheetGivesOneStraightLine) {
  auto curves = membrane::crossPlane(flatSheet({31, 26}, kSize), {1, 0, 0}, 7.0f);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_FALSE(curves[0].isClosed);
  float length = 0;
  for (std::size_t i = 1; i < curves[0].places.size(); ++i)
    length += glm::distance(curves[0].places[i - 1], curves[0].places[i]);
  EXPECT_NEAR(length, 90.0f, 1e-3f);
  EXPECT_TRUE(membrane::crossPlane(flatSheet({31, 26}, kSize), {0, 0, 1}, 3.0f).empty());
}

TEST(SheetCurve, AcrossADomeItIsClosed) {
  auto curves = membrane::crossPlane(domeSheet({31, 26}, kSize), {0, 0, 1}, 10.0f);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0].isClosed);
  // 20 (1 - u^2)(1 - v^2) = 10.
  for (glm::vec3 p : curves[0].places) EXPECT_NEAR(20 * bell({p.x / 60, p.y / 45}), 10.0f, 0.15f);
}

TEST(SheetCurve, AFoldIsMetInSeveralPieces) {
  // Below the hat: the stalk alone; at the rim's height nothing is left out.
  auto curves = membrane::crossPlane(foldedSheet({61, 61}, kSize), {0, 0, 1}, 12.0f);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0].isClosed);
  EXPECT_GE(membrane::crossPlane(wavySheet({61, 61}, kSize), {0, 0, 1}, 5.0f).size(), 4u);
}

}  // namespace
}  // namespace velum
