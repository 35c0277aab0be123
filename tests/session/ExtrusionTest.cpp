// Pulling structures out of cuts: the drag, its values, and the steps of growth that it leaves.
#include "session/extrusion/Extrusion.h"

#include <gtest/gtest.h>

#include <random>

#include "CutScene.h"
#include "scene/Project.h"
#include "session/cut/CutEdit.h"
#include "session/extrusion/MaterialRange.h"
#include "session/extrusion/Pull.h"
#include "session/growth/Growths.h"

namespace velum::session {

namespace {

const glm::dvec2 kExtrusionSize(800, 600);

scene::Cut planeOf(glm::dvec3 centre, glm::dvec3 axis) {
  scene::Cut cut;
  cut.centre = centre;
  cut.axis = axis;
  return cut;
}

/// Bone of 1000 in flesh of 50 in air of -1000: shells about the middle, 40 voxels of 2 mm.
scene::Scene boneScene() {
  scene::Scene scene;
  Volume volume;
  volume.dims = {40, 40, 40};
  volume.type = SampleType::Int16;
  volume.worldFromVoxel = glm::dmat4(2.0);
  volume.worldFromVoxel[3] = {-39, -39, -39, 1};
  volume.voxels.resize(std::size_t(40) * 40 * 40 * 2);
  auto* values = reinterpret_cast<std::int16_t*>(volume.voxels.data());
  for (int z = 0; z < 40; ++z)
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) {
        double r = glm::length(glm::dvec3(x, y, z) - 19.5);
        *values++ = std::int16_t(r < 8 ? 1000 : r < 16 ? 50 : -1000);
      }
  volume.range = {-1000, 1000};
  scene.volume.data = Shared<Volume>(std::move(volume));
  scene.volume.transfer.opacities = {{-100, 0}, {0, 0.5}, {100, 0.5}, {300, 0.2}, {500, 1}, {2000, 1}};
  scene.volume.transfer.colors = {{0, glm::vec3(1, 0, 0)}, {1000, glm::vec3(1)}};
  scene::addCut(scene, planeOf({0, 0, 0}, {0, -1, 0}));
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, kExtrusionSize.x / kExtrusionSize.y);
  return scene;
}

}  // namespace

TEST(Extrusion, TheDragFollowsThePointerALengthForALength) {
  std::mt19937 random(5);
  auto number = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  scene::Scene scene = boxScene(kExtrusionSize);
  int tried = 0;
  for (int i = 0; i < 200; ++i) {
    scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, kExtrusionSize.x / kExtrusionSize.y);
    scene.camera.projection = i % 2 ? scene::Projection::Perspective : scene::Projection::Orthographic;
    scene::Cut cut =
        planeOf({number(-5, 5), number(-5, 5), number(-5, 5)}, {number(-1, 1), number(-1, 1), number(-1, 1)});
    cut.invert = i % 3 == 0;
    glm::dvec3 out = pullDirection(cut, cut.centre);
    glm::dvec3 line = glm::normalize(scene.camera.eye - cut.centre);
    if (std::abs(glm::dot(out, line)) > 0.9) continue;  // it points at the eye: the height counts there
    ViewSpace space(scene.camera, kExtrusionSize);
    double distance = number(0.5, 12), before = number(0, 4);
    auto from = space.pixelFromWorld(cut.centre), to = space.pixelFromWorld(cut.centre + distance * out);
    ASSERT_TRUE(from && to);
    EXPECT_NEAR(ExtrusionDrag(space, *from, cut, cut.centre, before).distanceAt(*to), before + distance, 1e-6);
    EXPECT_EQ(ExtrusionDrag(space, *to, cut, cut.centre + distance * out, 0.0).distanceAt(*from), 0.0)
        << "nothing goes in behind the face";
    ++tried;
  }
  EXPECT_GT(tried, 100);
}

TEST(Extrusion, OnASectionTheDragFollowsThePartOfTheNormalThatLiesInIt) {
  scene::SectionPlane section;
  section.size = kExtrusionSize;
  section.lengthPerPixel = 0.5;
  scene::Cut cut = planeOf({0, 0, 0}, {3, 4, 0});
  ExtrusionDrag drag(ViewSpace(section), {400, 300}, cut, {0, 0, 0}, 1.0);
  // 10 lengths along the normal are 6 to the right and 8 up: 12 and 16 pixels.
  EXPECT_NEAR(drag.distanceAt({412, 284}), 11.0, 1e-9);
}

TEST(Extrusion, WhatStandsOutIsAListByCutAndStructure) {
  scene::Scene scene = boneScene();
  scene::Cut& cut = scene.cuts[0];
  setExtrusion(cut, 7, 3.0);
  setExtrusion(cut, 2, 5.0);
  setExtrusion(cut, 7, 4.0);
  setSpared(cut, 9, true);
  EXPECT_EQ(extrusionsOf(scene), (std::vector<Extrusion>{{cut.id, 2, 5.0}, {cut.id, 7, 4.0}}));
  EXPECT_EQ(extrusionOf(cut, 9), scene::Spare::kEndless);
  EXPECT_EQ(extrusionOf(cut, 1), 0.0);
  resetExtrusions(scene);
  EXPECT_TRUE(extrusionsOf(scene).empty());
  EXPECT_TRUE(isSpared(scene.cuts[0], 9)) << "what is left whole stays whole";
}

TEST(Extrusion, AClickPullsOutOfTheFaceThatItIsOnAndOutOfEitherWhereTwoOverlap) {
  scene::Scene scene = boneScene();
  int first = scene.cuts[0].id;
  scene.cuts[0].face = scene::CutFace::Section;
  scene.cuts[0].faceOpacity = 0.5;
  auto second = addJoinedPlane(scene, first);
  ASSERT_TRUE(second);
  EXPECT_EQ(scene.cuts[1].id, *second);
  EXPECT_TRUE(scene.cuts[1].joined);
  EXPECT_EQ(scene.cuts[1].name, "Plane 2");
  EXPECT_EQ(scene.cuts[1].face, scene::CutFace::Section) << "they are one face to the eye";
  EXPECT_EQ(scene.cuts[1].faceOpacity, 0.5);
  glm::dvec3 a = pullDirection(scene.cuts[0], {}), b = pullDirection(scene.cuts[1], {});
  EXPECT_NEAR(glm::dot(a, b), 0.0, 1e-9) << "across each other";
  EXPECT_EQ(cutsUnder(scene, 20.0 * b, 0, 1.0), std::vector<int>{first}) << "on the first face, far before the second";
  EXPECT_EQ(cutsUnder(scene, 20.0 * a, 0, 1.0), std::vector<int>{*second});
  setExtrusion(scene.cuts[0], 3, 10.0);
  setExtrusion(scene.cuts[1], 3, 6.0);
  EXPECT_EQ(cutsUnder(scene, 5.0 * a + 4.0 * b, 3, 1.0).size(), 2u);
  EXPECT_EQ(cutsUnder(scene, 5.0 * a + 9.0 * b, 3, 1.0), std::vector<int>{first});
  EXPECT_TRUE(cutsUnder(scene, 5.0 * a + 9.0 * b, 4, 1.0).empty()) << "another structure does not stand there";
}

TEST(Extrusion, APlaneOfAWedgeIsPaleWhereTheOtherLeavesAll) {
  scene::Scene scene = boneScene();
  addJoinedPlane(scene, scene.cuts[0].id);
  glm::dvec3 b = pullDirection(scene.cuts[1], {}), c = glm::cross(pullDirection(scene.cuts[0], {}), b);
  std::vector<glm::dvec3> square{10.0 * b + 10.0 * c, -10.0 * b + 10.0 * c, -10.0 * b - 10.0 * c, 10.0 * b - 10.0 * c};
  auto parts = partsLeftByOthers(scene, scene.cuts[0], square);
  ASSERT_EQ(parts.size(), 1u);
  for (const auto& corner : parts[0]) EXPECT_LE(glm::dot(corner, b), 1e-9);
  scene.cuts[1].enabled = false;
  EXPECT_TRUE(partsLeftByOthers(scene, scene.cuts[0], square).empty()) << "one that is off leaves and removes nothing";
  scene.cuts[1].enabled = true;
  scene.cuts[1].joined = false;
  EXPECT_TRUE(partsLeftByOthers(scene, scene.cuts[0], square).empty());
}

TEST(Extrusion, TheBoxHasItsTwelveEdges) {
  scene::Scene scene = boneScene();
  auto edges = boxEdges(scene);
  ASSERT_EQ(edges.size(), 12u);
  for (const auto& edge : edges) EXPECT_NEAR(glm::distance(edge[0], edge[1]), 80.0, 1e-9);
}

TEST(MaterialRange, ASegmentOfTheCurveGoesFromValleyToValley) {
  scene::TransferFunction transfer;
  transfer.opacities = {{0, 0}, {10, 1}, {20, 0}, {30, 0}, {40, 0.8}, {50, 0.2}, {60, 0.9}, {70, 0.9}};
  glm::dvec2 range(-100, 100);
  auto first = segmentOf(transfer, 12, range);
  ASSERT_TRUE(first);
  EXPECT_NEAR(first->low, 0.0, 0.2);
  EXPECT_NEAR(first->high, 20.0, 0.2);
  auto second = segmentOf(transfer, 42, range);
  ASSERT_TRUE(second);
  EXPECT_NEAR(second->low, 30.0, 0.2);
  EXPECT_NEAR(second->high, 50.0, 0.2) << "a valley that is not empty parts two materials, too";
  auto last = segmentOf(transfer, 65, range);
  ASSERT_TRUE(last);
  EXPECT_NEAR(last->low, 50.0, 0.2);
  EXPECT_EQ(last->high, 100.0);
  EXPECT_FALSE(segmentOf(transfer, 25, range)) << "what is hidden is no segment";
}

TEST(MaterialRange, AClickOnBoneMeansBone) {
  scene::Scene scene = boneScene();
  auto bone = materialRangeAt(scene.volume, {0, 0, 0}), flesh = materialRangeAt(scene.volume, {24, 0, 0});
  ASSERT_TRUE(bone && flesh);
  EXPECT_GT(bone->low, 100.0);
  EXPECT_LT(bone->low, 900.0);
  EXPECT_EQ(bone->high, 1000.0);
  EXPECT_GT(flesh->low, -600.0);
  EXPECT_LT(flesh->high, 600.0);
  EXPECT_LT(flesh->low, 50.0);
  EXPECT_GT(flesh->high, 50.0);
  EXPECT_FALSE(materialRangeAt(scene.volume, {1000, 0, 0}));
}

TEST(Extrusion, TheWayOutIsWhereADragPullsMost) {
  scene::Scene scene = boneScene();
  for (auto side : {scene::StandardView::Anterior, scene::StandardView::Left, scene::StandardView::Right,
                    scene::StandardView::Oblique, scene::StandardView::Superior}) {
    scene.camera = scene::frameCamera(scene, side, kExtrusionSize.x / kExtrusionSize.y);
    glm::dvec2 from = 0.5 * kExtrusionSize;
    ExtrusionDrag drag(ViewSpace(scene.camera, kExtrusionSize), from, scene.cuts[0], {0, 0, 0}, 50.0);
    double most = drag.distanceAt(from + 10.0 * drag.wayOut()) - 50.0;
    EXPECT_GT(most, 0.0) << enumName(side);
    for (glm::dvec2 way : {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)})
      EXPECT_LE(drag.distanceAt(from + 10.0 * way) - 50.0, most * 1.2) << enumName(side);
  }
}

TEST(Pull, AStructureGrowsFromASpotThatNoiseHasPutOutOfItsRange) {
  scene::Scene scene = boneScene();
  Volume volume = *scene.volume.data;
  auto* values = reinterpret_cast<std::int16_t*>(volume.voxels.data());
  // All voxels on the way out of the face from the place, and one beside them that hangs together with nothing.
  auto darken = [&](int x, int y, int z) { values[x + 40 * (y + 40 * z)] = 120; };
  for (int y = 14; y < 20; ++y) darken(20, y, 20);
  for (int axis : {0, 2})
    for (int step : {-1, 1}) darken(21 + (axis == 0 ? step : 0), 19, 20 + (axis == 2 ? step : 0));
  darken(21, 18, 20);
  scene.volume.data = Shared<Volume>(std::move(volume));
  auto pull = beginPull(scene, scene.cuts[0].id, {1, 0, 1}, 0);
  ASSERT_TRUE(pull && pull->growth);
  EXPECT_GT(pull->growth->low, 120.0);
  EXPECT_GT(depthInCut(scene.cuts[0], pull->growth->seeds[0]), 0.0);
  pullTo(scene, *pull, 7.0);
  Progress progress;
  settleGrowths(scene, progress);
  std::size_t count = 0;
  for (int z = 0; z < 40; ++z)
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) count += scene.labels.data->at({x, y, z}) == pull->structure;
  EXPECT_GT(count, 300u);
}

TEST(Pull, AClickOnWhatHasNoLabelMakesAStructureThatGrowsAsFarAsItIsPulled) {
  scene::Scene scene = boneScene();
  int cut = scene.cuts[0].id;
  auto pull = beginPull(scene, cut, {0, 0, 0}, 0);
  ASSERT_TRUE(pull && pull->added && pull->growth);
  scene.labels.visible = false;
  for (double distance : {2.0, 7.0, 4.0}) pullTo(scene, *pull, distance);
  EXPECT_TRUE(scene.labels.visible) << "what somebody pulls is to be seen";
  EXPECT_EQ(extrusionOf(scene.cuts[0], pull->structure), 4.0);
  ASSERT_EQ(scene.labels.growths.size(), 1u) << "one drag is one step";
  EXPECT_EQ(scene.labels.growths[0].distance, 7.0) << "what has grown stays";
  EXPECT_EQ(scene.labels.growths[0].seeds.size(), 1u);
  ASSERT_EQ(scene.labels.structures.size(), 1u);
  EXPECT_EQ(scene.labels.structures[0].tint, 0.0) << "it keeps the material's colour";
  Progress progress;
  settleGrowths(scene, progress);
  EXPECT_TRUE(isGrown(scene));
  // Bone that lies before the plane, which removes what is anterior (y < 0), no deeper than 7.
  int wrong = 0;
  for (int z = 0; z < 40; ++z)
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) {
        double depth = -(2.0 * y - 39.0);
        bool isBone = glm::length(glm::dvec3(x, y, z) - 19.5) < 8;
        bool wanted = isBone && depth > 0 && depth <= 7.0;
        bool isSeed = y == 20 && depth < 0;  // the voxel that was clicked on counts, wherever it lies
        if (!isSeed) wrong += (scene.labels.data->at({x, y, z}) == pull->structure) != wanted;
      }
  EXPECT_EQ(wrong, 0);
  auto again = beginPull(scene, cut, {0, -3, 0}, pull->structure);
  ASSERT_TRUE(again);
  EXPECT_FALSE(again->added);
  pullTo(scene, *again, 9.0);
  EXPECT_EQ(scene.labels.growths.size(), 1u) << "it goes on where it stands";
  scene.cuts[0].centre.y = 2.0;
  pullTo(scene, *beginPull(scene, cut, {0, 2, 0}, pull->structure), 5.0);
  EXPECT_EQ(scene.labels.growths.size(), 2u) << "out of a plane that has moved it is another step";
  removeGrown(scene, pull->structure);
  settleGrowths(scene, progress);
  EXPECT_TRUE(scene.labels.growths.empty() && scene.labels.structures.empty() && extrusionsOf(scene).empty());
  EXPECT_FALSE(scene.labels.data) << "nothing was given";
}

TEST(Pull, WhatStandsOutOfAPlaneThatMovesStandsOutOfWhereItIsNow) {
  scene::Scene scene = boneScene();
  int cut = scene.cuts[0].id;
  scene.cuts[0].centre.y = 4.0;
  auto pull = beginPull(scene, cut, {0, 4, 0}, 0);
  ASSERT_TRUE(pull && pull->growth);
  pullTo(scene, *pull, 6.0);
  scene::Scene begin = scene;
  Progress progress;
  auto moveTo = [&](double y) {
    scene::Cut moved = scene.cuts[0];
    moved.centre.y = y;
    moveCut(scene, moved);
  };
  // Outwards, inwards, and through where it was; bone before the plane that stands out is all of it found.
  for (double y : {2.0, -3.0, 9.0, 6.5}) {
    moveTo(y);
    EXPECT_EQ(extrusionOf(scene.cuts[0], pull->structure), 6.0);
    EXPECT_LE(scene.labels.growths.size(), 2u) << "steps do not become more with each move";
    settleGrowths(scene, progress);
    int missing = 0, bone = 0;
    for (int z = 0; z < 40; ++z)
      for (int yy = 0; yy < 40; ++yy)
        for (int x = 0; x < 40; ++x) {
          double depth = y - (2.0 * yy - 39.0);
          if (glm::length(glm::dvec3(x, yy, z) - 19.5) >= 8 || depth <= 0.0 || depth > 6.0) continue;
          ++bone;
          missing += scene.labels.data->at({x, yy, z}) != pull->structure;
        }
    EXPECT_GT(bone, 300);
    EXPECT_EQ(missing, 0) << "the plane at " << y;
  }
  moveTo(4.0);
  EXPECT_EQ(scene.labels.growths, begin.labels.growths) << "back where it was nothing has changed";
}

TEST(Pull, WhatWasHeldIsHeldWhereItWasWhenThePlaneMoves) {
  scene::Scene scene = boneScene();
  int cut = scene.cuts[0].id;
  auto pull = beginPull(scene, cut, {0, 0, 0}, 0);
  ASSERT_TRUE(pull && pull->growth);
  pullTo(scene, *pull, 9.0);
  holdGrowth(scene, {.structure = pull->structure, .distance = 5.0});
  scene::Cut moved = scene.cuts[0];
  moved.centre.y = -2.0;
  moveCut(scene, moved);
  EXPECT_EQ(scene.labels.growths.size(), 1u) << "nothing to be found";
  moved.centre.y = 3.0;
  moveCut(scene, moved);
  ASSERT_EQ(scene.labels.growths.size(), 2u);
  EXPECT_NEAR(3.0 - scene.labels.growths[1].distance, -5.0, 1e-12);
  growOn(scene, pull->structure);
  EXPECT_NEAR(3.0 - scene.labels.growths[1].distance, -6.0, 1e-12) << "as far as it stands out of where the plane is";
}

TEST(Pull, ThePlaneOfAnotherCutAndOtherChangesOfACutMoveNothing) {
  scene::Scene scene = boneScene();
  int cut = scene.cuts[0].id;
  pullTo(scene, *beginPull(scene, cut, {0, 0, 0}, 0), 6.0);
  auto steps = scene.labels.growths;
  scene::Cut other = scene.cuts[0];
  int second = scene::addCut(scene, other);
  scene::Cut moved = *scene::findCut(scene, second);
  moved.spares.clear();
  moved.centre.y = 5.0;
  moveCut(scene, moved);
  scene::Cut faced = *scene::findCut(scene, cut);
  faced.faceOpacity = 0.5;
  moveCut(scene, faced);
  EXPECT_EQ(scene.labels.growths, steps);
}

TEST(Pull, WhereAnotherCutLiesDoesNotSayHowFarItGrowsOn) {
  scene::Scene scene = boneScene();
  auto pull = beginPull(scene, scene.cuts[0].id, {0, 0, 0}, 0);
  ASSERT_TRUE(pull && pull->growth);
  pullTo(scene, *pull, 6.0);
  scene::Cut across = planeOf({0, -30, 0}, {1, 0, 0});
  across.spares = {{pull->structure, 4.0}};
  scene::addCut(scene, across);
  growOn(scene, pull->structure);
  EXPECT_EQ(scene.labels.growths[0].distance, 6.0);
}

TEST(Pull, WhatIsHeldGoesOnAsFarAsItStandsOutOfASheetWhereverThatLies) {
  scene::Scene scene = boneScene();
  scene::Cut& cut = scene.cuts[0];
  cut.shape = scene::CutShape::Membrane;
  cut.size = {60, 60, 20};
  auto pull = beginPull(scene, cut.id, {0, 0, 0}, 0);
  ASSERT_TRUE(pull && pull->growth);
  pullTo(scene, *pull, 6.0);
  double whole = scene.labels.growths[0].distance;
  EXPECT_NEAR(whole, 26.0, 1e-12) << "from the farthest behind to 6 before the farthest in front";
  holdGrowth(scene, {.structure = pull->structure, .distance = 2.0});
  growOn(scene, pull->structure);
  EXPECT_NEAR(scene.labels.growths[0].distance, whole, 1e-12);
}

TEST(Pull, WhatHasALabelIsPulledAsItIs) {
  scene::Scene scene = boneScene();
  LabelVolume labels({40, 40, 40}, scene.volume.data->worldFromVoxel);
  scene.labels.data = Shared<LabelVolume>(std::move(labels));
  scene.labels.structures = {{3, "Femur"}};
  auto pull = beginPull(scene, scene.cuts[0].id, {0, 0, 0}, 3);
  ASSERT_TRUE(pull);
  EXPECT_FALSE(pull->added || pull->growth);
  pullTo(scene, *pull, 6.0);
  EXPECT_TRUE(scene.labels.growths.empty());
  EXPECT_EQ(extrusionOf(scene.cuts[0], 3), 6.0);
}

TEST(Extrusion, ANewStructureHasANumberThatNobodyHasNorWillGrow) {
  scene::Scene scene;
  EXPECT_EQ(freeStructureId(scene), 1);
  scene.labels.structures.resize(2);
  scene.labels.structures[0].id = 4, scene.labels.structures[1].id = 2;
  EXPECT_EQ(freeStructureId(scene), 5);
  scene.labels.growths.resize(1);
  scene.labels.growths[0].structure = 9;
  EXPECT_EQ(freeStructureId(scene), 10) << "of a step that has not grown yet";
  LabelVolume labels({2, 2, 2}, glm::dmat4(1.0));
  labels.table = {{30, "of the file", glm::vec3(1.0f), 1.0f}};
  scene.labels.data = Shared<LabelVolume>(std::move(labels));
  EXPECT_EQ(freeStructureId(scene), 31);
  scene.labels.structures[0].id = 65535;
  EXPECT_EQ(freeStructureId(scene), 1) << "the least where the largest is taken";
  scene.labels.structures[1].id = 1;
  EXPECT_EQ(freeStructureId(scene), 2);
}

TEST(Extrusion, OfALabelThePartThatIsJoinedToThePlaceIsPulledAlone) {
  // One label, two blocks of it that stand apart before the cut and meet behind it.
  scene::Scene scene = boneScene();
  const Volume& volume = *scene.volume.data;
  LabelVolume labels(volume.dims, volume.worldFromVoxel);
  std::vector<std::uint16_t> ids;
  for (int z = 0; z < 40; ++z)
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) {
        bool isLeft = x >= 8 && x < 16, isRight = x >= 24 && x < 32, isBehind = y >= 24;
        ids.push_back(
            z >= 12 && z < 28 && y >= 4 && y < 36 && (isLeft || isRight || (isBehind && x >= 8 && x < 32)) ? 5 : 0);
      }
  labels.write({0, 0, 0}, volume.dims, ids);
  labels.table = {{5, "lungs", {0.9f, 0.6f, 0.6f}, 1.0f}};
  scene.labels.data = Shared<LabelVolume>(std::move(labels));
  scene::completeStructures(scene.labels);
  scene.labels.structures[0].showAs = scene::ShowAs::Solid;

  auto pull = beginPartPull(scene, scene.cuts[0].id, {-15, 0, 0}, 5);
  ASSERT_TRUE(pull && pull->added && pull->growth);
  EXPECT_EQ(pull->growth->within, 5);
  EXPECT_EQ(pull->added->name, "lungs, a part");
  EXPECT_EQ(pull->added->color, scene.labels.structures[0].color) << "it looks as the whole does";
  EXPECT_EQ(pull->added->showAs, scene::ShowAs::Solid);
  pullTo(scene, *pull, 20.0);
  Progress progress;
  settleGrowths(scene, progress);
  const LabelVolume& grown = *scene.labels.data;
  EXPECT_EQ(grown.at({12, 15, 20}), pull->structure) << "before the cut";
  EXPECT_EQ(grown.at({28, 15, 20}), 5) << "the other block";
  EXPECT_EQ(grown.at({12, 30, 20}), 5) << "behind the cut";
  EXPECT_FALSE(beginPartPull(scene, scene.cuts[0].id, {0, 0, 35}, 5)) << "no such label there";
}

}  // namespace velum::session
