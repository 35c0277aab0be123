// Where a new membrane hangs.
#include "session/membrane/FirstPlace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "makeVolume.h"
#include "scene/Scene.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/Advice.h"
#include "session/membrane/CoarseLook.h"
#include "session/membrane/MembraneEdit.h"

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
  auto place = placedToKeep(scene, cut, progress);
  if (!place || glm::dvec2(place->centre) != glm::dvec2(cut.centre)) return false;  // along its axis only
  double behind = (face - place->centre.z) * away;
  return behind > 0.0 && behind < kReach && place->size == cut.size;
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
  auto place = placedToKeep(scene, membraneAt({32, 32, 48}, {0, 0, 1}), progress);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->centre.z, 40.0, 9.0);
}

TEST(FirstPlace, ReachesNoFartherThanKeepsEnoughWhereSomethingIsCutAtAnyReach) {
  // A dumb-bell that a sheet with reach enough gets round, and a rod that runs out of the data at both ends.
  auto isBright = [](glm::ivec3 p) {
    glm::dvec3 off = glm::abs(glm::dvec3(p) - glm::dvec3(36, 36, 80));
    bool isBell = glm::length(off - glm::dvec3(0, 0, 19)) < 15.0 || (glm::length(glm::dvec2(off)) < 6.0 && off.z < 19);
    bool isRod = p.x >= 8 && p.x < 12 && p.y >= 8 && p.y < 12;
    return isBell || isRod ? 900.0 : 0.0;
  };
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume({64, 64, 160}, SampleType::Int16, isBright, glm::dmat4(1.0)));
  scene::Cut cut = membraneAt({32, 32, 80}, {0, 0, 1});
  cut.size.z = 34.0;
  Progress progress;
  scene::Cut deep = deepenedToKeep(scene, cut, progress);
  EXPECT_EQ(deep.centre, cut.centre);
  EXPECT_EQ(deep.size.z, 3.0 * 34.0)
      << "the dumb-bell is 68 mm long; 4.5 times is tried, too, and cuts the rod as well";
}

template <class ValueAt>
std::vector<Advice> allAdviceOn(ValueAt valueAt, glm::dvec3 centre) {
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume({64, 64, 96}, SampleType::Int16, valueAt, glm::dmat4(1.0)));
  Progress progress;
  return adviseMembrane(membrane::Potential(scene), scene, membraneAt(centre, {0, 0, 1}), progress);
}
template <class ValueAt>
std::optional<Advice> adviceOn(ValueAt valueAt, glm::dvec3 centre) {
  auto all = allAdviceOn(valueAt, centre);
  return all.empty() ? std::nullopt : std::optional(all.front());
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
  EXPECT_EQ(advice->step, AdviceStep::MoveToKeep);
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

TEST(Advice, IsThatOfTheMomentThatIsShown) {
  glm::dvec3 middle(32, 32, 48);
  auto solid = [&](glm::ivec3 p) { return ball(p, middle, 8.0) > 0 ? 900.0 : 600.0; };
  Volume second = makeVolume({64, 64, 96}, SampleType::Int16, solid, glm::dmat4(1.0));
  Volume series = makeVolume(
      {64, 64, 96}, SampleType::Int16, [](glm::ivec3 p) { return p.x % 2; }, glm::dmat4(1.0));
  series.voxels.insert(series.voxels.end(), second.voxels.begin(), second.voxels.end());
  series.timeSteps = 2;
  series.range = second.range;
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(std::move(series));
  scene.volume.timeStep = 1;
  Progress progress;
  auto ofSeries = adviseMembrane(membrane::Potential(scene), scene, membraneAt(middle, {0, 0, 1}), progress);
  auto ofOne = allAdviceOn(solid, middle);
  ASSERT_FALSE(ofOne.empty());
  ASSERT_EQ(ofSeries.size(), ofOne.size());
  EXPECT_EQ(ofSeries[0].step, AdviceStep::ProtectLess);
  EXPECT_EQ(ofSeries[0].cut, ofOne[0].cut);
}

TEST(Advice, IsNotGivenWhereNothingHelps) {
  EXPECT_FALSE(adviceOn([](glm::ivec3) { return 0.0; }, {32, 32, 48})) << "nothing is protected";
  Progress progress;
  EXPECT_TRUE(adviseMembrane(membrane::Potential(scene::Scene{}), {}, membraneAt({0, 0, 0}, {0, 0, 1}), progress).empty())
      << "no data";
}

/// A skull: a shell about soft tissue in a skin, that runs out of the data below, as heads do.
scene::Scene headScene() {
  auto head = [](glm::ivec3 p) {
    double r = glm::length((glm::dvec3(p) - glm::dvec3(36, 44, 40)) / glm::dvec3(0.8, 1.0, 1.1));
    bool isNeck = p.z < 20 && glm::length(glm::dvec2(p) - glm::dvec2(36, 52)) < 7.0;
    return isNeck || (r > 30.0 && r < 33.0) ? 900.0 : r < 38.0 ? 40.0 : -1000.0;
  };
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume({72, 88, 84}, SampleType::Int16, head, glm::dmat4(1.0)));
  scene.volume.transfer.opacities = {{-1000, 0}, {300, 0.0}, {900, 1.0}, {2000, 1.0}};
  scene.camera.target = {36, 44, 42};
  scene.camera.eye = {36, -900, 42};
  scene::placeSections(scene);
  return scene;
}

membrane::Fate fateOf(const scene::Scene& scene, const scene::Cut& cut) {
  Progress progress;
  return CoarseLook(membrane::Potential(scene), cut.membrane->field, progress).outlookOf(cut, progress).fate;
}

TEST(FirstPlace, ANewMembraneKeepsWhatItProtectsFromEachSide) {
  scene::Scene scene = headScene();
  Progress progress;
  for (glm::dvec3 eye : {glm::dvec3(0, -1, 0), {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}}) {
    scene.camera.eye = scene.camera.target + 900.0 * eye;
    scene::Cut cut = newMembrane(scene, progress);
    EXPECT_FALSE(cut.membrane->field.byValue.empty());
    EXPECT_GE(fateOf(scene, cut).kept, kEnoughKept) << eye.x << ' ' << eye.y << ' ' << eye.z;
    // The plane in its place would cut it, so that it is no sheet before everything.
    CoarseLook look(membrane::Potential(scene), cut.membrane->field, progress);
    EXPECT_GT(look.outlookOf(cut, progress).planePairs, 20.0);
  }
}

TEST(FirstPlace, DataThatWasOpenedHasItsCrosshairAtRest) {
  scene::Scene scene = headScene();
  Progress progress;
  ASSERT_TRUE(scene.sections.isPlaced);
  EXPECT_TRUE(isCrosshairAtRest(scene));
  glm::dvec3 searched = newMembrane(scene, progress).centre;
  EXPECT_GT(std::abs(searched.y - 43.5), 5.0) << "not in the middle of the data";
  scene.sections.crosshair.y += 4.0;
  EXPECT_FALSE(isCrosshairAtRest(scene));
  scene::Cut put = newMembrane(scene, progress);
  EXPECT_NEAR(put.centre.y, scene.sections.crosshair.y, 1e-9) << "where hands have put it";
  EXPECT_GE(fateOf(scene, put).kept, kEnoughKept) << "with a reach that keeps it";
}

TEST(FirstPlace, AMaskThatSomebodyProtectsIsKept) {
  // A rod that leans away from the eye, too deep for a usual reach.
  scene::Scene scene = headScene();
  auto rod = [](glm::ivec3 p) {
    bool isRod = p.z >= 10 && p.z < 70 && glm::length(glm::dvec2(p.x - 30, p.y - p.z - 8)) < 4.0;
    return std::uint16_t(isRod ? 3 : 0);
  };
  scene.labels.data = Shared<LabelVolume>(makeLabels({72, 88, 84}, rod));
  Progress progress;
  scene::Cut cut = newMembrane(scene, progress);
  cut.membrane->field = {};
  protectStructure(*cut.membrane, 3);
  cut.centre = {36, 44, 42};
  cut.size.z = 10;
  ASSERT_LT(fateOf(scene, cut).kept, kEnoughKept);
  membrane::KeptWhole figures;
  figures.fate = fateOf(scene, cut);
  ASSERT_TRUE(wantsAdvice(figures, cut));
  auto all = adviseMembrane(membrane::Potential(scene), scene, cut, progress);
  auto move = std::find_if(all.begin(), all.end(), [](auto& a) { return a.step == AdviceStep::MoveToKeep; });
  ASSERT_NE(move, all.end());
  EXPECT_GE(move->fate.kept, kEnoughKept);
  EXPECT_GE(fateOf(scene, move->cut).kept, kEnoughKept);
}

TEST(Advice, WhatVanishesWholeCounts) {
  // A ball wholly in front: the plane cuts nothing, and all of it goes.
  glm::dvec3 middle(32, 32, 70);
  auto ballAt = [&](glm::ivec3 p) { return 900.0 * ball(p, middle, 9.0); };
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume({64, 64, 96}, SampleType::Int16, ballAt, glm::dmat4(1.0)));
  scene::Cut cut = membraneAt({32, 32, 40}, {0, 0, 1});
  membrane::KeptWhole figures;
  figures.fate = fateOf(scene, cut);
  EXPECT_DOUBLE_EQ(figures.fate.removed, 1.0);
  EXPECT_TRUE(wantsAdvice(figures, cut));
  auto advice = adviceOn(ballAt, cut.centre);
  ASSERT_TRUE(advice);
  EXPECT_EQ(advice->step, AdviceStep::MoveToKeep);
  EXPECT_GT(advice->fate.kept, 0.99);
  cut.membrane->field.side = scene::MembraneSide::Remove;
  EXPECT_FALSE(wantsAdvice(figures, cut)) << "that is what was asked for";
}

TEST(FirstPlace, IsNowhereWhereNothingIsProtected) {
  scene::Scene scene = blockScene();
  Progress progress;
  scene::Cut cut = membraneAt({4, 5, 110}, {0, 0, 1});
  cut.membrane->field.byValue.clear();
  EXPECT_FALSE(placedToKeep(scene, cut, progress));
  EXPECT_FALSE(placedToKeep({}, cut, progress)) << "no data";
  EXPECT_EQ(deepenedToKeep(scene, cut, progress), cut);
}

}  // namespace
}  // namespace velum::session
