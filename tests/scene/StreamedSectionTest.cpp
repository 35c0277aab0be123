// Sections of volumes larger than memory.
#include <gtest/gtest.h>

#include "PyramidSource.h"
#include "makeVolume.h"
#include "scene/SectionPlane.h"

namespace velum::scene {

TEST(StreamedSection, PlanesAreThoseOfItsFinestLevel) {
  Volume whole = makeVolume(
      {40, 30, 20}, SampleType::UInt8, [](glm::ivec3 v) { return v.x + v.y; },
      centredFrame({40, 30, 20}, {1, 2, 3}, 0.0, {100, -50, 20}));
  Scene scene;
  scene.volume.data = Shared<Volume>(streamedVolume(std::make_shared<PyramidSource>(whole, 3, glm::ivec3(16)), 2));
  placeSections(scene);
  EXPECT_EQ(sectionIndex(scene, SectionKind::Axial)->count, 20);
  EXPECT_EQ(sectionIndex(scene, SectionKind::Sagittal)->count, 40);
  // A step is a plane of the level that is seen: of the finest where voxels are wider than pixels, of the coarsest
  // where four of them have one.
  SectionPlane plane = makeSectionPlane(scene, SectionKind::Axial, {320, 200});
  for (auto [pixel, planes] : {std::pair(0.1, 1), {0.7, 1}, {1.5, 2}, {3.0, 4}, {100.0, 4}}) {
    plane.lengthPerPixel = pixel;
    EXPECT_EQ(planesPerStep(scene, plane), planes) << pixel;
  }
  auto before = sectionIndex(scene, SectionKind::Axial);
  scrollSection(scene, SectionKind::Axial, -1);
  EXPECT_EQ(std::abs(sectionIndex(scene, SectionKind::Axial)->index - before->index), 1);
  EXPECT_NEAR(finestStep(scene), 1.0, 1e-9);
  EXPECT_NEAR(sectionStep(scene), 4.0, 1e-9);
  // In memory each plane is a step.
  Scene inMemory;
  inMemory.volume.data = Shared<Volume>(std::move(whole));
  plane.lengthPerPixel = 100;
  EXPECT_EQ(planesPerStep(inMemory, plane), 1);
}

}  // namespace velum::scene
