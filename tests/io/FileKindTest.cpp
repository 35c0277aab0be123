// What a file is, whatever its name: asked at every door.
#include "io/kinds/FileKind.h"

#include <gtest/gtest.h>

#include <fstream>

#include "TempFolder.h"
#include "core/Error.h"
#include "io/images/ImageFile.h"
#include "io/labels/WriteLabels.h"
#include "io/volumes/WriteVolume.h"

namespace velum::io {
namespace {

class FileKinds : public testing::Test {
 protected:
  std::filesystem::path text(const char* name, const std::string& text) {
    std::ofstream(folder / name) << text;
    return folder / name;
  }
  std::filesystem::path picture(const char* name, const char* scene) {
    writeImage({2, 2, {"R", "G", "B"}, std::vector<float>(12, 0.5f)}, folder / name, scene);
    return folder / name;
  }
  TempFolder folder;
  Progress progress;
};

}  // namespace

TEST_F(FileKinds, AreToldByContentsAndByNamesOfAnyCase) {
  EXPECT_EQ(kindOf(text("a.json", "{\"volume\": {}}")), FileKind::Scene);
  EXPECT_EQ(kindOf(text("A.JSON", "{\"volume\": {}}")), FileKind::Scene);
  EXPECT_EQ(kindOf(text("a.velum-transfer.json", "{}")), FileKind::Look);
  EXPECT_EQ(kindOf(text("a.VP", "")), FileKind::Look);
  EXPECT_EQ(kindOf(text("a.STL", "solid a\nendsolid a\n")), FileKind::Surface);
  EXPECT_EQ(kindOf(text("a.pdb", "ATOM      1  CA  ALA A   1      11.104   6.134  -6.504  1.00  0.00           C\n")),
            FileKind::Model);
  EXPECT_EQ(kindOf(picture("a.png", "{}")), FileKind::Picture);
  EXPECT_EQ(kindOf(picture("a.PNG", "{}")), FileKind::Picture);
  EXPECT_EQ(kindOf(picture("a.EXR", "{}")), FileKind::Picture);
  EXPECT_EQ(kindOf(text("a.svg", "<svg/>")), FileKind::Picture);
  EXPECT_EQ(kindOf(text("a.PDF", "")), FileKind::Picture);
  EXPECT_EQ(kindOf(picture("a.tif", "{}")), FileKind::Picture);
  EXPECT_EQ(kindOf(picture("plain.tif", "")), FileKind::Volume) << "a TIFF without a scene is one of microscopy";
}

TEST_F(FileKinds, LabelsAreThoseThatSaySo) {
  LabelVolume labels(glm::ivec3(4), glm::dmat4(1.0));
  labels.write({1, 1, 1}, {2, 2, 2}, std::vector<std::uint16_t>(8, 3));
  labels.table = {{3, "liver"}};
  writeLabels(labels, folder / "a.seg.nrrd", progress);
  EXPECT_EQ(kindOf(folder / "a.seg.nrrd"), FileKind::Labels);
  Volume volume;
  volume.dims = glm::ivec3(4);
  volume.type = SampleType::UInt8;
  volume.voxels.resize(timeStepBytes(volume));
  writeVolume(volume, folder / "b.nrrd", progress);
  EXPECT_EQ(kindOf(folder / "b.nrrd"), FileKind::Volume);
}

TEST_F(FileKinds, SamplesWithALayoutAreAVolumeWhateverTheyLookLike) {
  scene::Source source;
  source.path = text("a.json", "{\"volume\": {}}").string();
  EXPECT_EQ(kindOf(source), FileKind::Scene);
  source.raw.dims = {2, 2, 2};
  EXPECT_EQ(kindOf(source), FileKind::Volume);
}

/// Within a tick of the disk's clock, of the same size and in the same place.
TEST_F(FileKinds, AFileThatIsChangedAtOnceIsLookedAtAgain) {
  std::string atom = "ATOM      1  CA  ALA A   1      11.104   6.134  -6.504  1.00  0.00           C\n";
  for (int i = 0; i < 50; ++i) {
    ASSERT_EQ(kindOf(text("a.pdb", atom)), FileKind::Model) << i;
    ASSERT_EQ(kindOf(text("a.pdb", std::string(atom.size(), 'x'))), FileKind::Volume) << i;
  }
}

TEST_F(FileKinds, WhatIsNotThereIsToldByItsName) {
  EXPECT_EQ(kindOf(folder / "new.json"), FileKind::Scene);
  EXPECT_EQ(kindOf(folder / "new.stl"), FileKind::Surface);
  EXPECT_EQ(kindOf(folder / "new.tif"), FileKind::Volume);
}

TEST_F(FileKinds, EachEndingThatIsWrittenIsTakenByTheWriter) {
  for (const WrittenFormat& format : writable(FileKind::Volume))
    for (const std::string& ending : format.endings) EXPECT_NO_THROW(expectVolumeFormat("a" + ending)) << ending;
  for (const WrittenFormat& format : writable(FileKind::Labels))
    for (const std::string& ending : format.endings) EXPECT_NO_THROW(expectLabelFormat("a" + ending)) << ending;
  for (const WrittenFormat& format : writable(FileKind::Picture))
    for (const std::string& ending : format.endings) EXPECT_NO_THROW(expectImageFormat("a" + ending)) << ending;
  EXPECT_THROW(expectVolumeFormat("a.hdr"), InputError);
  EXPECT_THROW(expectVolumeFormat("a.nhdr"), InputError);
  EXPECT_EQ(endingsOf(FileKind::Volume), ".nii.gz, .nii, .nrrd, .vti, .vdb, .zarr, .ozx");
}

}  // namespace velum::io
