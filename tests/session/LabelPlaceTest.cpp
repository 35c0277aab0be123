#include "session/document/LabelPlace.h"

#include <gtest/gtest.h>

#include <fstream>

#include "TempFolder.h"
#include "io/labels/WriteLabels.h"
#include "io/volumes/WriteVolume.h"
#include "makeVolume.h"
#include "session/document/Open.h"
#include "session/document/WorkFile.h"

namespace velum::session {
namespace {

constexpr glm::ivec3 kLabelPlaceDims(12, 10, 8);
int idAt(glm::ivec3 p) { return p.x > 3 && p.x < 9 && p.y > 2 && p.z > 1 ? 1 + p.z / 4 : 0; }

/// Labels beside a scan.
class LabelPlace : public testing::Test {
 protected:
  /// Bare ids in NRRD. @param head  what it says besides
  std::string writeIds(const char* name, const std::string& head = {}, glm::ivec3 dims = kLabelPlaceDims) {
    std::ofstream out(folder / name, std::ios::binary);
    out << "NRRD0004\ntype: uint8\ndimension: 3\nsizes: " << dims.x << " " << dims.y << " " << dims.z << "\n"
        << head << "encoding: raw\n\n";
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x) out.put(char(idAt({x, y, z})));
    return (folder / name).string();
  }
  std::string writeScan(const char* name, bool isKnown, const glm::dmat4& matrix = glm::dmat4(1.0)) {
    Volume scan = makeVolume(
        kLabelPlaceDims, SampleType::Float32, [](glm::ivec3 p) { return hashNoise(p) * 100 + p.x; }, matrix);
    scan.isSpacingKnown = scan.isOrientationKnown = isKnown;
    io::writeVolume(scan, folder / name, progress);
    return (folder / name).string();
  }
  static scene::Source sourceOf(const std::string& path, glm::dvec3 spacing = glm::dvec3(0.0)) {
    scene::Source source;
    source.path = path;
    source.spacing = spacing;
    return source;
  }
  static bool liesOnScan(const scene::Scene& scene) {
    return scene.labels.data && scene.labels.data->dims() == scene.volume.data->dims &&
           scene.labels.data->worldFromVoxel() == scene.volume.data->worldFromVoxel;
  }
  TempFolder folder;
  Progress progress;
};

/// Turned, moved, with voxels that are no cubes.
glm::dmat4 patientFrame() { return centredFrame(kLabelPlaceDims, {0.7, 0.7, -2.0}, 0.4, {30, -20, 500}); }

TEST_F(LabelPlace, LabelsThatSayNoPlaceTakeTheScans) {
  std::string scan = writeScan("scan.nrrd", true, patientFrame());
  for (const char* head : {"", "spacings: 1 1 1\n", "spacings: 0.7 0.7 2\n"}) {
    scene::Scene scene = open(sourceOf(scan), progress);
    addLabels(scene, sourceOf(writeIds("ids.nrrd", head)), progress);
    EXPECT_TRUE(liesOnScan(scene)) << head;
    for (const std::string& warning : scene.labels.data->warnings)
      EXPECT_EQ(warning.find("spacing"), warning.npos) << warning;
    EXPECT_EQ(misplacedLabels(scene), "");
  }
}

TEST_F(LabelPlace, LabelsThatSayWhereTheyAreStayThere) {
  std::string scan = writeScan("scan.nrrd", true, patientFrame());
  for (const char* head :
       {"spacings: 3 3 3\n", "space: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n",
        "space dimension: 3\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (5,6,7)\n"}) {
    scene::Scene scene = open(sourceOf(scan), progress);
    addLabels(scene, sourceOf(writeIds("ids.nrrd", head)), progress);
    EXPECT_FALSE(liesOnScan(scene)) << head;
  }
  scene::Scene scene = open(sourceOf(scan), progress);
  addLabels(scene, sourceOf(writeIds("other.nrrd", "", kLabelPlaceDims + 1)), progress);
  EXPECT_EQ(scene.labels.data->worldFromVoxel(), glm::dmat4(1.0)) << "they are of another scan";
}

TEST_F(LabelPlace, TheyFollowTheVoxelSizeThatIsSetAndComeBackWithTheScene) {
  std::string scan = writeScan("nuclei.nrrd", false), ids = writeIds("ids.nrrd");
  scene::Scene scene = open(sourceOf(scan), progress);
  addLabels(scene, sourceOf(ids), progress);
  ASSERT_TRUE(liesOnScan(scene));
  glm::dvec3 size(0.002, 0.002, 0.003);
  rereadVolume(scene, sourceOf(scan, size), progress);
  EXPECT_NEAR(glm::length(spacingOf(*scene.volume.data) - size), 0, 1e-12);
  EXPECT_TRUE(liesOnScan(scene));
  // Once more, and through a file.
  rereadVolume(scene, sourceOf(scan, {0.5, 0.5, 1.0}), progress);
  EXPECT_TRUE(liesOnScan(scene));
  saveScene(scene, folder / "scene.json");
  scene::Scene back = open(sourceOf((folder / "scene.json").string()), progress);
  EXPECT_EQ(spacingOf(*back.volume.data), glm::dvec3(0.5, 0.5, 1.0));
  EXPECT_TRUE(liesOnScan(back));
  // Opened only when the size is set already: nuclei at 2 x 2 x 3 um, labels at 1 mm.
  scene = open(sourceOf(scan, size), progress);
  addLabels(scene, sourceOf(ids), progress);
  EXPECT_TRUE(liesOnScan(scene));
}

TEST_F(LabelPlace, LabelsThatWereOpenFirstGoWhereTheirScanIs) {
  scene::Scene scene;
  addLabels(scene, sourceOf(writeIds("ids.nrrd")), progress);
  add(scene, sourceOf(writeScan("scan.nrrd", true, patientFrame())), progress);
  EXPECT_TRUE(liesOnScan(scene));
}

TEST_F(LabelPlace, LabelsBesideTheScanAreSaid) {
  std::string scan = writeScan("scan.nrrd", true, patientFrame());
  auto said = [&](glm::dvec3 spacing, glm::dvec3 centre, glm::ivec3 dims = kLabelPlaceDims) {
    LabelVolume labels = makeLabels(dims, idAt, centredFrame(dims, spacing, 0.4, centre));
    io::writeLabels(labels, folder / "labels.seg.nrrd", progress);
    scene::Scene scene = open(sourceOf(scan), progress);
    addLabels(scene, sourceOf((folder / "labels.seg.nrrd").string()), progress);
    return misplacedLabels(scene);
  };
  EXPECT_EQ(said({0.7, 0.7, -2.0}, {30, -20, 500}), "");
  EXPECT_EQ(said({1.0, 1.0, -1.0}, {31, -20, 499}), "") << "another grid in the same place";
  std::string away = said({0.7, 0.7, -2.0}, {30, -20, 900});
  EXPECT_NE(away.find("do not overlap the scan at all"), away.npos) << away;
  EXPECT_NE(away.find("8.4 x 7 x 16 mm"), away.npos) << away;
  std::string huge = said({3.5, 3.5, -10}, {30, -20, 500});
  EXPECT_NE(huge.find("what is labelled lies in the scan"), huge.npos) << huge;
  std::string tiny = said({0.007, 0.007, -0.02}, {30, -20, 500});
  EXPECT_NE(tiny.find("in a few voxels of the scan"), tiny.npos) << tiny;
}

}  // namespace
}  // namespace velum::session
