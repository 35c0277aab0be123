#include "session/structure/StructureExport.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "SmallDisk.h"
#include "TempFolder.h"
#include "core/Error.h"
#include "io/labels/ReadLabels.h"
#include "io/meshes/ReadMesh.h"
#include "makeVolume.h"
#include "scene/Scene.h"
#include "session/structure/StructureSizes.h"
#include "session/structure/StructureSurface.h"

namespace velum::session {
namespace {

namespace fs = std::filesystem;

const double kPi = std::acos(-1.0);

/// Ids of a grid by place, in units of the world.
template <class IdAt>
LabelVolume labelsBy(glm::ivec3 dims, const glm::dmat4& matrix, const IdAt& idAt) {
  LabelVolume labels(dims, matrix);
  std::vector<std::uint16_t> ids;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) ids.push_back(idAt(glm::dvec3(matrix * glm::dvec4(x, y, z, 1))));
  labels.write({0, 0, 0}, dims, ids);
  return labels;
}

glm::dmat4 gridOf(glm::dvec3 spacing) {
  return glm::dmat4(spacing.x, 0, 0, 0, 0, spacing.y, 0, 0, 0, 0, spacing.z, 0, 0, 0, 0, 1);
}

/// A grid about a ball of this radius, whose middle lies between the voxels.
LabelVolume ballOf(double radius, glm::dvec3 spacing, glm::dmat3 turn = glm::dmat3(1.0)) {
  glm::dmat4 matrix = glm::dmat4(turn) * gridOf(spacing);
  glm::ivec3 dims(glm::ceil(2.0 * radius / spacing) + 5.0);
  glm::dvec3 middle(matrix * glm::dvec4(glm::dvec3(dims) * 0.5 + glm::dvec3(0.21, -0.37, 0.11), 1));
  return labelsBy(dims, matrix,
                  [=](glm::dvec3 p) { return glm::length(p - middle) < radius ? std::uint16_t(5) : std::uint16_t(0); });
}

TEST(StructureSizes, BallsHaveTheirVolumeAndSurface) {
  Progress progress;
  // Voxels of 1, and long ones: a radius of 8 voxels or more along each axis.
  for (glm::dvec3 spacing :
       {glm::dvec3(1.0), glm::dvec3(0.5, 0.5, 1.5), glm::dvec3(0.4, 1.0, 0.7), glm::dvec3(2.0, 2.0, 0.8)})
    for (double voxels : {8.0, 11.3, 20.0}) {
      double radius = voxels * std::max({spacing.x, spacing.y, spacing.z});
      StructureSize size = measureStructures(ballOf(radius, spacing), progress).at(5);
      double volume = 4.0 / 3.0 * kPi * radius * radius * radius / 1000.0,
             surface = 4.0 * kPi * radius * radius / 100.0;
      EXPECT_NEAR(size.volume, volume, 0.01 * volume) << voxels << " voxels of " << spacing.x << " " << spacing.z;
      EXPECT_NEAR(size.surface, surface, 0.03 * surface) << voxels << " voxels of " << spacing.x << " " << spacing.z;
    }
}

TEST(StructureSizes, ATurnedGridChangesNoSurface) {
  Progress progress;
  double a = 0.7;
  glm::dmat3 turn(std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a), 0, 0, 0, 1);
  double straight = measureSurfaces(ballOf(12, {0.8, 0.8, 1.2}), progress).at(5);
  EXPECT_NEAR(measureSurfaces(ballOf(12, {0.8, 0.8, 1.2}, turn), progress).at(5), straight, 0.01 * straight);
}

TEST(StructureSizes, PlanesOfAnyDirectionAreWithinTenPercent) {
  Progress progress;
  double size = 40.0;
  for (glm::dvec3 normal : {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 0), glm::dvec3(1, 1, 1),
                            glm::dvec3(1, 0.4, 0), glm::dvec3(1, 0.4, 0.2), glm::dvec3(0.3, 0.8, 0.6)}) {
    // A disc thick enough, whose rim is less than its faces: a cylinder's surface is known.
    glm::dvec3 n = glm::normalize(normal), middle(size);
    double radius = 34.0, half = 10.0;
    LabelVolume labels = labelsBy(glm::ivec3(int(2 * size) + 1), glm::dmat4(1.0), [&](glm::dvec3 p) {
      double up = glm::dot(p - middle, n), out = glm::length(p - middle - up * n);
      return std::uint16_t(std::abs(up) < half && out < radius);
    });
    double wanted = 2 * kPi * radius * radius + 4 * kPi * radius * half;
    // Faces along the axes are told 7 % too small, the sharp rim as if it were rounded.
    EXPECT_NEAR(measureSurfaces(labels, progress).at(1), wanted, 0.10 * wanted) << n.x << " " << n.y << " " << n.z;
  }
}

TEST(StructureSizes, SurfacesAreClosedAtTheBorderAndSharedBothWays) {
  Progress progress;
  // Two halves of a box that fills its grid: each has its share of the border, and the face between them.
  LabelVolume labels =
      labelsBy({40, 30, 30}, glm::dmat4(1.0), [](glm::dvec3 p) { return std::uint16_t(p.x < 20 ? 1 : 2); });
  auto areas = measureSurfaces(labels, progress);
  double wanted = 2 * 30 * 30 + 4 * 20 * 30;
  EXPECT_NEAR(areas.at(1), wanted, 0.10 * wanted) << "planes along the axes are the worst, and edges are as if rounded";
  EXPECT_NEAR(areas.at(1), areas.at(2), 1e-6 * wanted);
  progress.cancel();
  EXPECT_THROW(measureSurfaces(labels, progress), Cancelled);
}

/// Two balls and a bead.
scene::Scene threeStructures() {
  LabelVolume labels = labelsBy({40, 30, 30}, gridOf({0.5, 1, 1}), [](glm::dvec3 p) {
    if (glm::length(p - glm::dvec3(5, 15, 15)) < 4.4) return std::uint16_t(2);
    if (glm::length(p - glm::dvec3(14, 15, 15)) < 4.4) return std::uint16_t(9);
    return std::uint16_t(glm::length(p - glm::dvec3(10, 5, 5)) < 1.2 ? 300 : 0);
  });
  scene::Scene scene;
  auto add = [&](int id, const char* name, glm::vec3 color) {
    scene::Structure& structure = scene.labels.structures.emplace_back();
    structure.id = id, structure.name = name, structure.color = color;
  };
  add(2, "left one", {1, 0, 0});
  add(9, "Right / one", {0, 0, 1});
  add(300, "", {0, 1, 0});
  add(301, "nowhere", {1, 1, 1});
  scene.labels.data = Shared<LabelVolume>(std::move(labels));
  return scene;
}

std::vector<std::string> exportTo(const fs::path& path, const StructureExport& what = {}) {
  Progress progress;
  return exportStructures(threeStructures(), path, what, progress);
}

Mesh meshOf(const fs::path& path) {
  Progress progress;
  return io::readMesh(path, progress);
}

LabelVolume labelsIn(const fs::path& path) {
  Progress progress;
  scene::Source source;
  source.path = path.string();
  return io::readLabels(source, progress);
}

TEST(StructureExport, NamesAndColoursAreTheScenes) {
  TempFolder folder;
  for (const char* name : {"a.seg.nrrd", "a.nii.gz", "a.dcm"}) {
    SCOPED_TRACE(name);
    exportTo(folder / name);
    LabelVolume back = labelsIn(folder / name);
    EXPECT_EQ(back.dims(), glm::ivec3(40, 30, 30));
    EXPECT_EQ(back.at({10, 15, 15}), 2);
    EXPECT_EQ(back.at({20, 5, 5}), 300);
    auto found = std::find_if(back.table.begin(), back.table.end(), [](const LabelInfo& l) { return l.id == 9; });
    ASSERT_NE(found, back.table.end());
    EXPECT_EQ(found->name, "Right / one");
    EXPECT_LT(glm::length(found->color - glm::vec3(0, 0, 1)), 0.01f);
  }
}

TEST(StructureExport, OnlyWhatIsChosenIsInTheFile) {
  TempFolder folder;
  StructureExport what{{9, 300}};
  for (const char* name : {"a.seg.nrrd", "a.nii.gz", "a.dcm"}) {
    exportTo(folder / name, what);
    EXPECT_EQ(labelsIn(folder / name).idsInUse(), (std::vector<std::uint16_t>{9, 300})) << name;
  }
  exportTo(folder / "a.obj", what);
  std::ifstream file(folder / "a.obj");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(text.find("o left one"), std::string::npos);
  EXPECT_NE(text.find("o Right / one"), std::string::npos);
  EXPECT_NE(text.find("o structure 300"), std::string::npos);
  exportTo(folder / "a.ply", {{9}});
  EXPECT_LT(glm::length(meshOf(folder / "a.ply").color.value_or(glm::vec3(1)) - glm::vec3(0, 0, 1)), 0.01f);
}

TEST(StructureExport, ApartEachHasAFileWithItsName) {
  TempFolder folder;
  exportTo(folder / "a.stl", {{}, 0.5, true});
  exportTo(folder / "b.seg.nrrd", {{2, 9}, 0.5, true});
  for (const char* name :
       {"a-left-one.stl", "a-right-one.stl", "a-structure-300.stl", "b-left-one.seg.nrrd", "b-right-one.seg.nrrd"})
    EXPECT_TRUE(fs::is_regular_file(folder / name)) << name;
  EXPECT_FALSE(fs::exists(folder / "a.stl"));
  EXPECT_EQ(labelsIn(folder / "b-right-one.seg.nrrd").idsInUse(), (std::vector<std::uint16_t>{9}));
  Mesh mesh = meshOf(folder / "a-right-one.stl");
  glm::dvec3 sum(0.0);
  for (const auto& p : mesh.positions) sum += glm::dvec3(p);
  EXPECT_LT(glm::length(sum / double(mesh.positions.size()) - glm::dvec3(14, 15, 15)), 0.2);
}

TEST(StructureExport, SurfacesOfWhatHasGrownEndWhereItsValuesDo) {
  constexpr glm::ivec3 kDims(30);
  glm::dmat4 frame = centredFrame(kDims, glm::dvec3(0.5, 0.5, 0.8), 0.3);
  auto valueAt = [&](glm::ivec3 p) {
    glm::dvec3 world(frame * glm::dvec4(p, 1.0));
    return 500.0 + 200.0 * std::clamp(4.7 - glm::length(world), -1.5, 1.5);
  };
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume(kDims, SampleType::Float32, valueAt, frame));
  scene.labels.data = Shared<LabelVolume>(makeLabels(
      kDims, [&](glm::ivec3 p) { return valueAt(p) >= 500.0 ? 1 : 0; }, frame));
  scene::Growth step;
  step.structure = 1, step.low = 500.0, step.high = 1000.0;
  scene.labels.grown = {step};
  scene::completeStructures(scene.labels);
  TempFolder folder;
  Progress progress;
  exportStructures(scene, folder / "a.ply", {}, progress);
  Mesh mesh = meshOf(folder / "a.ply");
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    glm::dvec3 p(mesh.positions[i]);
    ASSERT_NEAR(glm::length(p), 4.7, 0.05);
    ASSERT_GT(glm::dot(glm::dvec3(mesh.normals[i]), glm::normalize(p)), 0.99);
  }
}

TEST(StructureExport, WhatHasNoVoxelsOrNoNameIsRefused) {
  TempFolder folder;
  EXPECT_THROW(exportTo(folder / "a.stl", {{301}}), ArgumentError);
  EXPECT_THROW(exportTo(folder / "a.xyz"), InputError);
  EXPECT_THROW(labelsOf(scene::Scene()), ArgumentError);
  auto table = labelsOf(threeStructures()).table;
  EXPECT_EQ(findStructures(table, {"LEFT one", "300"}), (std::vector<int>{2, 300}));
  EXPECT_THROW(findStructures(table, {"spleen"}), ArgumentError);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(StructureExport, TellsHowFarItIsAndCanBeStopped) {
  TempFolder folder;
  double last = 0;
  Progress* running = nullptr;
  Progress told([&](double fraction, const std::string&) { last = std::max(last, fraction); });
  exportStructures(threeStructures(), folder / "a.glb", {}, told);
  EXPECT_GT(last, 0.9);
  Progress stopped([&](double fraction, const std::string& what) {
    if (fraction > 0.3 && what.starts_with("Surface of")) running->cancel();
  });
  running = &stopped;
  EXPECT_THROW(exportStructures(threeStructures(), folder / "b.glb", {}, stopped), Cancelled);
  EXPECT_FALSE(fs::exists(folder / "b.glb"));
}

TEST(StructureExport, AFullDiskAndReadOnlyFilesLeaveTheOldOne) {
  TempFolder folder;
  for (const char* name : {"a.stl", "a.glb", "a.dcm"}) {
    std::ofstream(folder / name) << "old";
    {
      SmallDisk disk(1000);
      EXPECT_THROW(exportTo(folder / name), InputError) << name;
    }
    EXPECT_EQ(fs::file_size(folder / name), 3u) << name;
    fs::permissions(folder / name, fs::perms::owner_read);
    EXPECT_THROW(exportTo(folder / name), InputError) << name;
    EXPECT_EQ(fs::file_size(folder / name), 3u) << name;
  }
}

}  // namespace
}  // namespace velum::session
