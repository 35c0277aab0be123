#include "session/section/SectionTool.h"

#include <gtest/gtest.h>

#include <numbers>

#include "makeVolume.h"

namespace velum::session {

namespace {

using scene::SectionKind;
constexpr glm::dvec2 kSectionToolSize(400, 300);

scene::Scene boundedScene() {
  scene::Scene scene;
  glm::ivec3 dims(20, 20, 20);
  scene.volume.data = Shared<Volume>(makeVolume(
      dims, SampleType::UInt8, [](glm::ivec3 v) { return v.x; }, centredFrame(dims)));
  scene::placeSections(scene);
  return scene;
}

}  // namespace

TEST(SectionTool, LinesLieInBothSectionsAndEndAtTheViewsSides) {
  scene::Scene scene = boundedScene();
  scene::turnSections(scene, SectionKind::Axial, 0.4);
  scene::turnSections(scene, SectionKind::Sagittal, -0.2);
  auto plane = scene::makeSectionPlane(scene, SectionKind::Coronal, kSectionToolSize);
  auto lines = crosshairLines(scene, SectionKind::Coronal, plane);
  ASSERT_EQ(lines.size(), 2u);
  for (const auto& line : lines) {
    auto other = scene::makeSectionPlane(scene, line.other, kSectionToolSize);
    for (glm::dvec2 p : {line.from, line.to, line.knobs[0], line.knobs[1]})
      EXPECT_NEAR(scene::heightOverSection(other, scene::worldFromSectionPixel(plane, p)), 0.0, 1e-9);
    for (glm::dvec2 p : {line.from, line.to}) {
      double edge = std::min(std::min(p.x, kSectionToolSize.x - p.x), std::min(p.y, kSectionToolSize.y - p.y));
      EXPECT_NEAR(edge, 0.0, 1e-6);
    }
    EXPECT_TRUE(line.hasKnobs);
    EXPECT_TRUE(isOnKnob(lines, line.knobs[1] + 3.0, 8));
  }
  EXPECT_FALSE(isOnKnob(lines, kSectionToolSize * 0.5, 8));
}

TEST(SectionTool, TheLineFollowsTheKnob) {
  scene::Scene scene = boundedScene();
  for (auto kind : {SectionKind::Axial, SectionKind::Coronal, SectionKind::Sagittal}) {
    auto plane = scene::makeSectionPlane(scene, kind, kSectionToolSize);
    glm::dvec2 cross = scene::sectionPixelFromWorld(plane, scene.sections.crosshair);
    auto before = crosshairLines(scene, kind, plane);
    scene::Scene after = scene;
    glm::dvec2 to = cross + glm::dvec2(80, -60);
    after.sections = turnedSections(scene, kind, plane, before[0].knobs[1], to);
    auto lines = crosshairLines(after, kind, plane);
    glm::dvec2 along = glm::normalize(lines[0].to - lines[0].from), wanted = glm::normalize(to - cross);
    EXPECT_NEAR(std::abs(along.x * wanted.y - along.y * wanted.x), 0.0, 1e-9);
    EXPECT_EQ(sectionOf(after.sections, kind), sectionOf(scene.sections, kind));
  }
}

TEST(SectionTool, AViewThatDoesNotSeeTheCrosshairHasNoKnobs) {
  scene::Scene scene = boundedScene();
  scene.sections.axial.pan = {15, 0};
  for (const auto& line :
       crosshairLines(scene, SectionKind::Axial, scene::makeSectionPlane(scene, SectionKind::Axial, kSectionToolSize)))
    EXPECT_FALSE(line.hasKnobs);
  scene.sections.axial.pan = {1000, 1000};
  auto plane = scene::makeSectionPlane(scene, SectionKind::Axial, kSectionToolSize);
  EXPECT_TRUE(crosshairLines(scene, SectionKind::Axial, plane).empty());
}

TEST(SectionTool, RightIsWiderAndDownIsDarker) {
  glm::dvec2 start(40, 400);
  EXPECT_GT(draggedWindow(start, {50, 0}).y, 400);
  EXPECT_EQ(draggedWindow(start, {50, 0}).x, 40);
  EXPECT_GT(draggedWindow(start, {0, 50}).x, 40);
  EXPECT_EQ(draggedWindow(start, {0, 0}), start);
  EXPECT_GT(draggedWindow(start, {-5000, 0}).y, 0);
}

TEST(SectionTool, RulersAreRound) {
  EXPECT_DOUBLE_EQ(rulerLength(99), 50);
  EXPECT_DOUBLE_EQ(rulerLength(100), 100);
  EXPECT_DOUBLE_EQ(rulerLength(49), 20);
  EXPECT_DOUBLE_EQ(rulerLength(0.03), 0.02);
}

}  // namespace velum::session
