#include "session/document/Sources.h"

#include <gtest/gtest.h>

#include <fstream>

#include "TempFolder.h"
#include "core/Error.h"
#include "io/phantoms/Sample.h"
#include "io/volumes/WriteVolume.h"
#include "session/document/Open.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

scene::Source sourceOf(const fs::path& path, const std::string& fingerprint = {}) {
  scene::Source source;
  source.path = path.string();
  source.fingerprint = fingerprint;
  return source;
}

}  // namespace

class Sources : public testing::Test {
 protected:
  /// A phantom and a scene of it, saved beside it.
  void SetUp() override {
    fs::create_directories(folder / "study");
    writePhantom(folder / "study/ct.nrrd", 16);
    scene::Scene scene = open(sourceOf(folder / "study/ct.nrrd"), progress);
    saveScene(scene, folder / "study/scene.json");
  }
  void writePhantom(const fs::path& path, int voxels) {
    io::writeVolume(io::makeSample("two-spheres", voxels, progress).volume, path, progress);
  }
  scene::Scene openScene(const fs::path& path, const DataPolicy& policy = {}) {
    notes.clear();
    return open(sourceOf(path), progress, policy, &notes);
  }

  TempFolder folder;
  Progress progress;
  std::vector<std::string> notes;
};

TEST_F(Sources, FingerprintKnowsAFileByItsEnds) {
  std::string text(300'000, 'a');
  write(folder / "a", text);
  std::string first = fingerprintOf(folder / "a");
  EXPECT_EQ(first.substr(0, 7), "300000-");
  write(folder / "b", text);
  EXPECT_EQ(fingerprintOf(folder / "b"), first);
  for (std::size_t at : {0u, 65'535u, 299'999u}) {
    std::string other = text;
    other[at] = 'b';
    write(folder / "b", other);
    EXPECT_NE(fingerprintOf(folder / "b"), first) << at;
  }
  EXPECT_EQ(fingerprintOf(folder / "nothing"), "");
  EXPECT_EQ(fingerprintOf(folder / "study").substr(0, 9), "folder-2-");
}

TEST_F(Sources, AnUntouchedSceneOpensWithoutANote) {
  EXPECT_TRUE(openScene(folder / "study/scene.json").volume.data);
  EXPECT_TRUE(notes.empty());
}

TEST_F(Sources, AChangedFileIsSaid) {
  writePhantom(folder / "study/ct.nrrd", 17);
  EXPECT_TRUE(openScene(folder / "study/scene.json").volume.data);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("ct.nrrd has changed"), std::string::npos) << notes[0];
}

TEST_F(Sources, DataThatMovedIsFoundInTheTreeOfTheScene) {
  fs::create_directories(folder / "study/a/b");
  fs::rename(folder / "study/ct.nrrd", folder / "study/a/b/renamed.nrrd");
  scene::Scene scene = openScene(folder / "study/scene.json");
  EXPECT_TRUE(scene.volume.data);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("renamed.nrrd"), std::string::npos) << notes[0];
  EXPECT_EQ(fs::path(scene.volume.source.path).filename(), "renamed.nrrd");
}

TEST_F(Sources, ASceneThatMovedFindsItsDataInOtherFolders) {
  fs::create_directories(folder / "elsewhere");
  fs::rename(folder / "study/scene.json", folder / "elsewhere/scene.json");
  EXPECT_THROW(openScene(folder / "elsewhere/scene.json"), InputError);
  DataPolicy policy;
  policy.folders = {folder / "study"};
  EXPECT_TRUE(openScene(folder / "elsewhere/scene.json", policy).volume.data);
}

TEST_F(Sources, AnotherFileOfTheSameNameIsNotTaken) {
  fs::create_directories(folder / "study/other");
  fs::remove(folder / "study/ct.nrrd");
  writePhantom(folder / "study/other/ct.nrrd", 20);
  EXPECT_THROW(openScene(folder / "study/scene.json"), InputError);
}

TEST_F(Sources, WhatIsNotFoundIsNamedWithWhatToDo) {
  fs::remove(folder / "study/ct.nrrd");
  try {
    openScene(folder / "study/scene.json");
    FAIL();
  } catch (const InputError& error) {
    std::string said = error.what();
    for (const char* part : {"ct.nrrd", "scene.json", "--set volume.source.path="})
      EXPECT_NE(said.find(part), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }
}

TEST_F(Sources, ASceneCanBeKeptWithoutItsDataAndNamesItStill) {
  fs::remove(folder / "study/ct.nrrd");
  DataPolicy policy;
  policy.keepsWithoutData = true;
  scene::Scene scene = openScene(folder / "study/scene.json", policy);
  EXPECT_FALSE(scene.volume.data);
  auto missing = missingData(scene);
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(missing[0].field, "volume.source.path");
  EXPECT_EQ(fs::path(missing[0].path), folder / "study/ct.nrrd");
}

TEST_F(Sources, TheSearchIsBounded) {
  fs::remove(folder / "study/ct.nrrd");
  for (int i = 0; i < 200; ++i) write(folder / "study" / std::to_string(i % 20) / std::to_string(i), "x");
  fs::create_directory_symlink(folder / "study", folder / "study/loop");
  EXPECT_THROW(openScene(folder / "study/scene.json"), InputError);
}

TEST_F(Sources, ASceneFileThatIsTooLargeIsRefusedUnread) {
  write(folder / "large.json", "{");
  fs::resize_file(folder / "large.json", std::uintmax_t(3) << 30);  // a hole, no disk
  try {
    openScene(folder / "large.json");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("MiB is too much"), std::string::npos) << error.what();
  }
}

TEST_F(Sources, HostilePathsOfASceneEndInWords) {
  for (const char* path :
       {"/dev/zero", "/dev/null", "/proc/self/mem", "../../../../../../etc/shadow", "\\u0000", "/"}) {
    write(folder / "hostile.json",
          std::string("{\"velum\": 1, \"volume\": {\"source\": {\"path\": \"") + path + "\"}}}");
    EXPECT_THROW(openScene(folder / "hostile.json"), Error) << path;
  }
}

}  // namespace velum::session
