// Structures of a volume that is streamed look as they do in memory, as fine as the finest level.
#include "StreamedFixture.h"
#include "render/upload/LabelBricks.h"

namespace velum {
namespace {

/// Labels as fine as the finest level, in bricks of which some are one structure's alone.
Shared<LabelVolume> labelsOn(const Volume& volume) {
  LabelVolume labels(volume.dims, volume.worldFromVoxel);
  std::vector<std::uint16_t> ids;
  glm::ivec3 p;
  for (p.z = 0; p.z < volume.dims.z; ++p.z)
    for (p.y = 0; p.y < volume.dims.y; ++p.y)
      for (p.x = 0; p.x < volume.dims.x; ++p.x) {
        bool isBall = glm::length(glm::dvec3(p) - glm::dvec3(30, 40, 30)) < 21.0;
        double tube = std::hypot(p.y - 45.0 - 20.0 * std::sin(p.x / 14.0), p.z - 38.0 - 15.0 * std::cos(p.x / 11.0));
        ids.push_back(tube < 4.0 ? 2 : isBall ? 1 : p.x > 66 ? 3 : 0);
      }
  labels.write(glm::ivec3(0), volume.dims, ids);
  return Shared<LabelVolume>(std::move(labels));
}

/// Structures of the finest level: tinted, hidden, spared by a cut, shown as surfaces.
TEST_F(StreamedGL, StructuresAreThoseInMemory) {
  auto source = makeSource(SampleType::UInt8);
  scene::Scene scene = lookOf(streamedVolume(source, 2), scene::RenderMode::Volume);
  scene.labels.data = labelsOn(source->level(0));
  scene.labels.structures = {
      {1, "ball", {0.9f, 0.3f, 0.2f}}, {2, "tube", {0.2f, 0.7f, 0.9f}}, {3, "rest", {0.6f, 0.8f, 0.3f}}};
  expectSameAs(source->level(0), scene, {160, 160}, "tinted", 0.05, 3);
  scene.labels.structures[2].visible = false;
  expectSameAs(source->level(0), scene, {160, 160}, "one is hidden", 0.05, 3);
  scene::Cut cut;
  cut.shape = scene::CutShape::Plane;
  cut.centre = scene.camera.target;
  cut.axis = {0.2, -1.0, 0.1};
  cut.spares = {{2}};
  scene.cuts = {cut};
  expectSameAs(source->level(0), scene, {160, 160}, "a tube is spared", 0.05, 3);
  scene.labels.structures[1].showAs = scene::ShowAs::Solid;
  expectSameAs(source->level(0), scene, {160, 160}, "as a surface", 0.05, 3);
}

/// Slots follow edits: what is drawn after one is what is drawn of the edited labels by themselves.
TEST_F(StreamedGL, EditedStructuresAreThoseInMemory) {
  auto source = makeSource(SampleType::UInt8);
  scene::Scene scene = lookOf(streamedVolume(source, 2), scene::RenderMode::Volume);
  scene.labels.data = labelsOn(source->level(0));
  scene.labels.structures = {
      {1, "ball", {0.9f, 0.3f, 0.2f}}, {2, "tube", {0.2f, 0.7f, 0.9f}}, {3, "rest", {0.6f, 0.8f, 0.3f}}};
  draw(scene, {160, 160}, kAllLayers);
  LabelVolume edited = *scene.labels.data;
  std::vector<std::uint16_t> ids(36 * 34 * 20, 1);
  edited.write({40, 20, 30}, {36, 34, 20}, ids);
  std::fill(ids.begin(), ids.end(), 0);
  edited.write({10, 24, 20}, {36, 34, 20}, ids);
  scene.labels.data = Shared<LabelVolume>(std::move(edited));
  expectSameAs(source->level(0), scene, {160, 160}, "edited", 0.05, 3);
}

/// Specks of a voxel are lost where labels are halved: then there are few borders, but the labels still have no room.
TEST_F(StreamedGL, StructuresWithoutRoomAreNotTriedAnewForEachPicture) {
  LabelVolume labels(glm::ivec3(256), glm::dmat4(1.0));
  glm::ivec3 p;
  for (p.z = 4; p.z < 256; p.z += 32)
    for (p.y = 4; p.y < 256; p.y += 32)
      for (p.x = 4; p.x < 256; p.x += 32) labels.write(p, glm::ivec3(1), std::vector<std::uint16_t>{1});
  scene::Scene scene = lookOf(streamedVolume(makeSource(SampleType::UInt8), 2), scene::RenderMode::Volume);
  scene.labels.data = Shared<LabelVolume>(std::move(labels));
  gpu::Limits limits = context().limits();
  limits.memoryBytes = std::size_t(400) << 20;
  render::LabelBricks bricks(limits);
  bricks.begin(scene, false);
  while (!bricks.step()) {
  }
  EXPECT_EQ(bricks.labels().dims(), glm::ivec3(128));
  EXPECT_LT(bricks.slotCount(), 8u);
  bricks.begin(scene, false);
  EXPECT_TRUE(bricks.step());
  EXPECT_EQ(bricks.bytesSent(), 0u);
  EXPECT_EQ(bricks.labels().dims(), glm::ivec3(128));
}

/// Where borders have no room structures are drawn coarser, and that is said; when there are few again, they are not.
TEST_F(StreamedGL, StructuresWithoutRoomAreDrawnCoarserAndThatIsSaid) {
  glm::ivec3 dims(256);
  auto labelled = [&](int edge) {
    LabelVolume labels(dims, glm::dmat4(1.0));
    std::vector<std::uint16_t> ids;
    glm::ivec3 p;
    for (p.z = 0; p.z < edge; ++p.z)
      for (p.y = 0; p.y < edge; ++p.y)
        for (p.x = 0; p.x < edge; ++p.x) ids.push_back(std::uint16_t((p.x / 10 + p.y / 10 + p.z / 10) % 2));
    labels.write(glm::ivec3(0), glm::ivec3(edge), ids);
    return Shared<LabelVolume>(std::move(labels));
  };
  scene::Scene scene = lookOf(streamedVolume(makeSource(SampleType::UInt8), 2), scene::RenderMode::Volume);
  scene.labels.data = labelled(256);
  gpu::Limits limits = context().limits();
  limits.memoryBytes = std::size_t(400) << 20;  // 256 slots, or a few more
  render::LabelBricks bricks(limits);
  bricks.begin(scene, false);
  while (!bricks.step()) {
  }
  EXPECT_EQ(bricks.labels().dims(), dims / 2);
  EXPECT_NE(bricks.shortfall().find("2 times coarser"), std::string::npos) << bricks.shortfall();
  bricks.begin(scene, false);
  EXPECT_TRUE(bricks.step());
  EXPECT_EQ(bricks.bytesSent(), 0u) << "the same labels are not placed again for each picture";
  scene.labels.data = labelled(20);
  bricks.begin(scene, false);
  EXPECT_EQ(bricks.labels().dims(), dims);
  EXPECT_EQ(bricks.shortfall(), "");
}

}  // namespace
}  // namespace velum
