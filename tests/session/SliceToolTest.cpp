#include "velum/session/section/SliceTool.h"

#include <gtest/gtest.h>

#include <numbers>

#include "makeVolume.h"

namespace velum::session {

namespace {

using scene::SliceKind;
constexpr glm::dvec2 kSize(400, 300);

scene::Scene boxScene() {
  scene::Scene scene;
  glm::ivec3 dims(20, 20, 20);
  scene.volume.data = Shared<Volume>(makeVolume(
      dims, SampleType::UInt8, [](glm::ivec3 v) { return v.x; }, centredFrame(dims)));
  scene::placeSlices(scene);
  return scene;
}

}  // namespace

TEST(SliceTool, LinesLieInBothSlicesAndEndAtTheViewsSides) {
  scene::Scene scene = boxScene();
  scene::turnSlices(scene, SliceKind::Axial, 0.4);
  scene::turnSlices(scene, SliceKind::Sagittal, -0.2);
  auto frame = scene::makeSliceFrame(scene, SliceKind::Coronal, kSize);
  auto lines = crosshairLines(scene, SliceKind::Coronal, frame);
  ASSERT_EQ(lines.size(), 2u);
  for (const auto& line : lines) {
    auto other = scene::makeSliceFrame(scene, line.other, kSize);
    for (glm::dvec2 p : {line.from, line.to, line.knobs[0], line.knobs[1]})
      EXPECT_NEAR(scene::heightOverSlice(other, scene::worldFromSlicePixel(frame, p)), 0.0, 1e-9);
    for (glm::dvec2 p : {line.from, line.to}) {
      double edge = std::min(std::min(p.x, kSize.x - p.x), std::min(p.y, kSize.y - p.y));
      EXPECT_NEAR(edge, 0.0, 1e-6);
    }
    EXPECT_TRUE(line.hasKnobs);
    EXPECT_TRUE(isOnKnob(lines, line.knobs[1] + 3.0, 8));
  }
  EXPECT_FALSE(isOnKnob(lines, kSize * 0.5, 8));
}

TEST(SliceTool, TheLineFollowsTheKnob) {
  scene::Scene scene = boxScene();
  for (auto kind : {SliceKind::Axial, SliceKind::Coronal, SliceKind::Sagittal}) {
    auto frame = scene::makeSliceFrame(scene, kind, kSize);
    glm::dvec2 cross = scene::slicePixelFromWorld(frame, scene.slices.crosshairMm);
    auto before = crosshairLines(scene, kind, frame);
    scene::Scene after = scene;
    glm::dvec2 to = cross + glm::dvec2(80, -60);
    after.slices = turnedSlices(scene, kind, frame, before[0].knobs[1], to);
    auto lines = crosshairLines(after, kind, frame);
    glm::dvec2 along = glm::normalize(lines[0].to - lines[0].from), wanted = glm::normalize(to - cross);
    EXPECT_NEAR(std::abs(along.x * wanted.y - along.y * wanted.x), 0.0, 1e-9);
    EXPECT_EQ(sliceOf(after.slices, kind), sliceOf(scene.slices, kind));
  }
}

TEST(SliceTool, AViewThatDoesNotSeeTheCrosshairHasNoKnobs) {
  scene::Scene scene = boxScene();
  scene.slices.axial.panMm = {15, 0};
  for (const auto& line :
       crosshairLines(scene, SliceKind::Axial, scene::makeSliceFrame(scene, SliceKind::Axial, kSize)))
    EXPECT_FALSE(line.hasKnobs);
  scene.slices.axial.panMm = {1000, 1000};
  auto frame = scene::makeSliceFrame(scene, SliceKind::Axial, kSize);
  EXPECT_TRUE(crosshairLines(scene, SliceKind::Axial, frame).empty());
}

TEST(SliceTool, RightIsWiderAndDownIsDarker) {
  glm::dvec2 start(40, 400);
  EXPECT_GT(draggedWindow(start, {50, 0}).y, 400);
  EXPECT_EQ(draggedWindow(start, {50, 0}).x, 40);
  EXPECT_GT(draggedWindow(start, {0, 50}).x, 40);
  EXPECT_EQ(draggedWindow(start, {0, 0}), start);
  EXPECT_GT(draggedWindow(start, {-5000, 0}).y, 0);
}

TEST(SliceTool, RulersAreRound) {
  EXPECT_DOUBLE_EQ(rulerLengthMm(99), 50);
  EXPECT_DOUBLE_EQ(rulerLengthMm(100), 100);
  EXPECT_DOUBLE_EQ(rulerLengthMm(49), 20);
  EXPECT_DOUBLE_EQ(rulerLengthMm(0.03), 0.02);
}

}  // namespace velum::session
