// Where a new membrane hangs.
#include "velum/session/membrane/FirstPlace.h"

#include <gtest/gtest.h>

#include <cmath>

#include "makeVolume.h"
#include "velum/session/membrane/Advice.h"
#include "velum/session/membrane/MembraneEdit.h"

namespace velum::session {
namespace {

constexpr double kReach = 12.0;  ///< to either side

/// A block of bright voxels from z = 60 to 90 of 128, in a world that is shifted and of half a millimetre a voxel.
scene::Scene blockScene() {
  glm::dmat4 frame(0.5);
  frame[3] = glm::dvec4(-7.0, 3.0, 100.0, 1.0);
  auto isBlock = [](glm::ivec3 p) { return p.z >= 60 && p.z <= 90 && p.x > 20 && p.y > 10 ? 900.0 : 0.0; };
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume({64, 48, 128}, SampleType::Int16, isBlock, frame));
  return scene;
}

scene::Cut membraneAt(glm::dvec3 centre, glm::dvec3 axis) {
  scene::Cut cut;
  cut.shape = scene::CutShape::Membrane;
  cut.membrane.emplace();
  cut.centre = centre;
  cut.axis = axis;
  cut.size = {100, 100, 2.0 * kReach};
  protectValues(*cut.membrane, 500, 1000);
  return cut;
}

/// The face of the block that lies towards an axis.
bool isInFront(const scene::Scene& scene, const scene::Cut& cut, double face, double away) {
  Progress progress;
  auto place = firstPlaceOf(scene, cut, progress);
  if (!place || glm::dvec2(*place) != glm::dvec2(cut.centre)) return false;  // along its axis only
  double behind = (face - place->z) * away;
  return behind > 0.0 && behind < kReach;
}

TEST(FirstPlace, LiesBehindTheFrontByLessThanTheReach) {
  // The block's faces are at 130 and 145 mm, and what is removed is in front.
  scene::Scene scene = blockScene();
  scene::Cut cut = membraneAt({4, 5, 110}, {0, 0, 1});
  EXPECT_TRUE(isInFront(scene, cut, 145.0, 1.0));
  cut.invert = true;
  EXPECT_TRUE(isInFront(scene, cut, 130.0, -1.0));
  cut = membraneAt({4, 5, 110}, {0, 0, -2});
  EXPECT_TRUE(isInFront(scene, cut, 130.0, -1.0)) << "an axis of any length";
}

TEST(FirstPlace, IsWhereTheSheetGetsRound) {
  // A long bar along the axis, which no sheet gets round, and a ball further in that one does.
  auto isBright = [](glm::ivec3 p) {
    bool isBar = std::abs(p.x - 12) <= 1 && std::abs(p.y - 12) <= 1 && p.z >= 4 && p.z <= 90;
    return isBar || glm::length(glm::dvec3(p) - glm::dvec3(40, 40, 40)) < 9 ? 900.0 : 0.0;
  };
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume({64, 64, 96}, SampleType::Int16, isBright, glm::dmat4(1.0)));
  Progress progress;
  auto place = firstPlaceOf(scene, membraneAt({32, 32, 48}, {0, 0, 1}), progress);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->z, 40.0, 9.0);
}

template <class ValueAt>
std::optional<Advice> adviceOn(ValueAt valueAt, glm::dvec3 centre) {
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume({64, 64, 96}, SampleType::Int16, valueAt, glm::dmat4(1.0)));
  Progress progress;
  return adviseMembrane(membrane::Potential(scene), scene, membraneAt(centre, {0, 0, 1}), progress);
}

double ball(glm::ivec3 p, glm::dvec3 centre, double radius) { return glm::length(glm::dvec3(p) - centre) < radius; }

TEST(Advice, ADeeperReachGetsRoundALargerBall) {
  glm::dvec3 middle(32, 32, 48);
  auto advice = adviceOn([&](glm::ivec3 p) { return 900.0 * ball(p, middle, 18.0); }, middle);
  ASSERT_TRUE(advice);
  // In front of it the sheet gets round a part; with twice the reach round all of it.
  EXPECT_EQ(advice->step, AdviceStep::DeepenReach);
  EXPECT_EQ(advice->cut.size.z, 4.0 * kReach);
  EXPECT_LT(advice->cutShare, 0.05);
}

TEST(Advice, AFrameThroughSolidMaterialMovesInFront) {
  auto bar = [](glm::ivec3 p) {
    bool isBar = std::abs(p.x - 12) <= 4 && std::abs(p.y - 12) <= 4 && p.z >= 2 && p.z <= 93;
    return isBar || ball(p, {40, 40, 30}, 9.0) > 0 ? 900.0 : 0.0;
  };
  auto advice = adviceOn(bar, {32, 32, 58});
  ASSERT_TRUE(advice);
  EXPECT_EQ(advice->step, AdviceStep::MoveInFront);
  EXPECT_NE(advice->cut.centre.z, 58.0);
  EXPECT_LT(advice->cutShare, 0.5);
}

TEST(Advice, WhereAllIsProtectedLessIsMore) {
  glm::dvec3 middle(32, 32, 48);
  auto solid = [&](glm::ivec3 p) { return ball(p, middle, 8.0) > 0 ? 900.0 : 600.0; };
  auto advice = adviceOn(solid, middle);
  ASSERT_TRUE(advice);
  EXPECT_EQ(advice->step, AdviceStep::ProtectLess);
  EXPECT_LT(advice->cutShare, 0.1);
}

TEST(Advice, IsNotGivenWhereNothingHelps) {
  EXPECT_FALSE(adviceOn([](glm::ivec3) { return 0.0; }, {32, 32, 48})) << "nothing is protected";
  Progress progress;
  EXPECT_FALSE(adviseMembrane(membrane::Potential({}), {}, membraneAt({0, 0, 0}, {0, 0, 1}), progress)) << "no data";
}

TEST(FirstPlace, IsNowhereWhereNothingIsProtected) {
  scene::Scene scene = blockScene();
  Progress progress;
  scene::Cut cut = membraneAt({4, 5, 110}, {0, 0, 1});
  cut.membrane->field.byValue.clear();
  EXPECT_FALSE(firstPlaceOf(scene, cut, progress));
  EXPECT_FALSE(firstPlaceOf({}, cut, progress)) << "no data";
}

}  // namespace
}  // namespace velum::session
