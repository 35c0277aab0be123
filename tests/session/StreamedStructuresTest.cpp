// Structures of volumes larger than memory: what is measured of them and exported is what it is in memory.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "PyramidSource.h"
#include "TempFolder.h"
#include "io/labels/LabelStore.h"
#include "io/labels/ReadLabels.h"
#include "io/meshes/ReadMesh.h"
#include "makeVolume.h"
#include "scene/Scene.h"
#include "session/document/Open.h"
#include "session/structure/StructureExport.h"
#include "session/structure/StructureValues.h"

namespace velum::session {

namespace {

constexpr glm::ivec3 kStreamedDims(90, 75, 70);

double streamedValue(glm::ivec3 p) {
  double wave = 14.0 * std::sin(p.x / 9.0) + 11.0 * std::cos(p.y / 7.0);
  return 500.0 + 30.0 * std::clamp(26.0 + 0.2 * wave - glm::length(glm::dvec3(p) - glm::dvec3(44, 36, 35)), -9.0, 9.0) +
         (p.x * 31 + p.y * 17 + p.z * 7) % 5;
}

Volume wholeVolume() {
  glm::dmat4 frame = centredFrame(kStreamedDims, glm::dvec3(0.5, 0.6, 0.8), 0.3);
  Volume volume = makeVolume(kStreamedDims, SampleType::UInt16, streamedValue, frame);
  computeRange(volume);
  return volume;
}

/// Something that has grown, with borders by values, and a tube that crosses it.
scene::Scene grownScene(bool isStreamed) {
  Volume volume = wholeVolume();
  glm::dmat4 frame = volume.worldFromVoxel;
  scene::Scene scene;
  scene.labels.data = Shared<LabelVolume>(makeLabels(
      kStreamedDims,
      [](glm::ivec3 p) {
        if (std::hypot(p.y - 30 - 0.2 * p.x, p.z - 40.0) < 3.0) return 2;
        return streamedValue(p) >= 500.0 ? 1 : 0;
      },
      frame));
  scene.volume.data = Shared<Volume>(std::move(volume));
  scene::Growth step;
  step.structure = 1, step.low = 500.0, step.high = 2000.0;
  scene.labels.grown = {step};
  scene::completeStructures(scene.labels);
  if (isStreamed) {
    auto source = std::make_shared<PyramidSource>(*scene.volume.data, 3, glm::ivec3(24, 40, 16));
    scene.volume.data = Shared<Volume>(streamedVolume(source, 2));
  }
  return scene;
}

std::string bytesIn(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST(StreamedStructures, SurfacesAndLabelsAreThoseInMemoryToTheByte) {
  TempFolder whole, streamed;
  Progress progress;
  scene::Scene inMemory = grownScene(false), inBricks = grownScene(true);
  inMemory.labels.grown.clear(), inBricks.labels.grown.clear();
  for (const char* name : {"all.ply", "all.stl", "all.nrrd"}) {
    exportStructures(inMemory, whole / name, {}, progress);
    exportStructures(inBricks, streamed / name, {}, progress);
    std::string bytes = bytesIn(whole / name);
    EXPECT_GT(bytes.size(), 5'000u) << name;
    EXPECT_TRUE(bytes == bytesIn(streamed / name)) << name;
  }
}

TEST(StreamedStructures, SurfacesByValuesEndWhereTheValuesOfTheFinestLevelDo) {
  TempFolder folder;
  Progress progress;
  Mesh meshes[2];
  for (bool isStreamed : {false, true}) {
    exportStructures(grownScene(isStreamed), folder / "a.ply", {{1}}, progress);
    meshes[isStreamed] = io::readMesh(folder / "a.ply", progress);
  }
  ASSERT_EQ(meshes[0].positions.size(), meshes[1].positions.size());
  EXPECT_EQ(meshes[0].indices, meshes[1].indices);
  double farthest = 0.0, sum = 0.0;  // how steep values are is asked of the level in memory: hundredths of a voxel
  for (std::size_t i = 0; i < meshes[0].positions.size(); ++i) {
    double apart = glm::length(glm::dvec3(meshes[0].positions[i]) - glm::dvec3(meshes[1].positions[i]));
    farthest = std::max(farthest, apart);
    sum += apart;
  }
  EXPECT_LT(farthest, 0.1);
  EXPECT_LT(sum / double(meshes[0].positions.size()), 0.005);
}

TEST(StreamedStructures, ValuesAreThoseOfTheFinestLevelOnWhateverGridTheLabelsAre) {
  scene::Scene whole = grownScene(false), streamed = grownScene(true);
  Progress progress;
  glm::dmat4 twice(1.0);  // labels in voxels twice as long, turned round along y and shifted
  twice[0][0] = 2.0, twice[1][1] = -2.0, twice[2][2] = 1.7;
  twice[3] = glm::dvec4(-3.2, 73.0, 4.4, 1.0);
  LabelVolume coarse = makeLabels(
      {45, 37, 36}, [](glm::ivec3 p) { return (p.x / 9 + p.y / 8 + p.z / 7) % 4; },
      whole.volume.data->worldFromVoxel * twice);
  for (const LabelVolume* labels : {&*whole.labels.data, static_cast<const LabelVolume*>(&coarse)}) {
    auto expected = measureValues(*labels, *whole.volume.data, 0, 0, progress);
    auto found = measureValues(*labels, *streamed.volume.data, 0, 0, progress);
    ASSERT_EQ(found.size(), expected.size());
    for (const auto& [id, values] : expected) {
      EXPECT_EQ(found[id].voxels, values.voxels) << id;
      EXPECT_EQ(found[id].least, values.least) << id;
      EXPECT_EQ(found[id].most, values.most) << id;
      EXPECT_NEAR(found[id].mean, values.mean, 1e-9) << id;
      EXPECT_NEAR(found[id].deviation, values.deviation, 1e-6) << id;
    }
  }
}

TEST(StreamedStructures, ASceneKeepsTheIdsOfWideNumbersWhateverElseTheFileGets) {
  TempFolder folder;
  Progress progress;
  auto write = [&](const char* name, std::vector<LabelInfo> table) {
    LabelVolume labels(glm::ivec3(40), glm::dmat4(1.0));
    std::vector<std::uint16_t> ids(8000, 0);
    for (const LabelInfo& info : table) {
      std::fill(ids.begin(), ids.end(), info.id);
      labels.write(glm::ivec3(20, 20, 0) * glm::ivec3(info.id & 1, info.id >> 1 & 1, 0), glm::ivec3(20), ids);
    }
    labels.table = std::move(table);
    std::filesystem::remove_all(folder / name);
    io::writeLabelStore(labels, folder / name, io::OmeVersion::V05, progress);
  };
  constexpr std::uint64_t kAxon = 864691135000000001ull;
  write("seg.zarr", {{1, "axon", {1, 0, 0}, 1, kAxon}, {2, "dendrite", {0, 1, 0}, 1, kAxon + 9}});
  scene::Scene scene = open({.path = (folder / "seg.zarr").string()}, progress);
  ASSERT_EQ(scene.labels.structures.size(), 2u);
  EXPECT_EQ(scene.labels.structures[0].fileId, std::to_string(kAxon));
  EXPECT_EQ(scene.labels.structures[0].name, "axon");
  scene.labels.structures[1].name = "mine";
  saveScene(scene, folder / "a.json");
  write("seg.zarr",
        {{1, "axon", {1, 0, 0}, 1, kAxon}, {2, "dendrite", {0, 1, 0}, 1, kAxon + 9}, {3, "new", {0, 0, 1}, 1, 70'000}});
  scene::Scene again = open({.path = (folder / "a.json").string()}, progress);
  ASSERT_EQ(again.labels.structures.size(), 3u);
  EXPECT_EQ(again.labels.structures[1].name, "mine");
  EXPECT_EQ(again.labels.structures[1].fileId, std::to_string(kAxon + 9));
  EXPECT_EQ(again.labels.data->at({5, 25, 5}), 2);
  EXPECT_EQ(again.labels.structures[2].fileId, "70000");
  EXPECT_EQ(again.labels.data->at({25, 25, 5}), 3);
}

TEST(StreamedStructures, LabelsWithoutAPlaceLieOnTheGridOfTheFinestLevel) {
  Volume whole = wholeVolume();
  auto source = std::make_shared<PyramidSource>(whole, 3, glm::ivec3(24, 40, 16));
  io::LabelGrid grid = io::gridOf(streamedVolume(source, 2));
  EXPECT_EQ(grid.dims, kStreamedDims);
  for (int column = 0; column < 4; ++column)
    EXPECT_LT(glm::length(grid.worldFromVoxel[column] - whole.worldFromVoxel[column]), 1e-12);
}

}  // namespace velum::session
