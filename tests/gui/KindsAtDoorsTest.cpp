// What a file is, is asked once: each kind of file opens to the same by every door, or is refused by every door with
// words.
#include <fstream>

#include "DicomSeries.h"
#include "RunBatch.h"
#include "WindowFixture.h"
#include "core/Error.h"
#include "io/meshes/WriteMesh.h"
#include "io/volumes/ReadVolume.h"
#include "session/Session.h"
#include "session/command/Command.h"
#include "session/document/Open.h"

namespace velum::gui {
namespace {

/// What a scene holds, in words.
std::string contentsOf(const scene::Scene& scene) {
  std::string words;
  if (scene.volume.data) words += "volume ";
  if (scene.labels.data) words += "labels ";
  if (scene.model.data) words += "model ";
  if (!scene.surfaces.empty()) words += "surface ";
  if (!scene.cuts.empty()) words += "cut ";
  return words + std::string(enumName(scene.unit));
}

class KindsAtDoors : public Window {
 protected:
  std::string text(const std::string& name) const { return (*sFolder / name).string(); }

  /// By the window.
  std::string byWindow(const std::string& file) {
    mWindow->newScene();
    mWindow->openPaths({QString::fromStdString(file)});
    EXPECT_TRUE(waitForJob());
    return mWindow->session().file().isOpen() ? contentsOf(scene()) : "refused";
  }
  /// By velum-batch render, which saves what it has opened.
  std::string byRender(const std::string& file) {
    std::filesystem::remove(text("saved.json"));
    std::string command = std::string(VELUM_BATCH) + " render '" + file + "' -o '" + text("p.png") +
                          "' --size 16x12 --samples 1 --save-scene '" + text("saved.json") + "' >/dev/null 2>&1";
    return std::system(command.c_str()) == 0 ? contentsOf(reopened()) : "refused";
  }
  /// By a line of a script.
  std::string byScript(const std::string& file) {
    session::Session session;
    try {
      session::runScript(session, "open " + file + "\n", "script", mProgress, [](auto&&...) {});
    } catch (const Error&) {
      return "refused";
    }
    return contentsOf(session.scene());
  }
  scene::Scene reopened() {
    scene::Source source;
    source.path = text("saved.json");
    return session::open(source, mProgress);
  }
  void expectEverywhere(const std::string& name, const std::string& contents) {
    SCOPED_TRACE(name);
    EXPECT_EQ(byScript(text(name)), contents);
    EXPECT_EQ(byRender(text(name)), contents);
    EXPECT_EQ(byWindow(text(name)), contents);
  }
  Progress mProgress;
};

TEST_F(KindsAtDoors, EachOpensToTheSame) {
  expectEverywhere("phantom.nrrd", "volume mm");
  expectEverywhere("phantom_labels.seg.nrrd", "labels mm");
  scene::Source source;
  source.path = text("phantom.nrrd");
  Volume slices = io::readVolume(source, mProgress);
  slices.type = SampleType::Int16;
  slices.voxels.assign(timeStepBytes(slices), std::byte{1});
  ASSERT_TRUE(writeDicomSeries(slices, text("dicom")));
  expectEverywhere("dicom", "volume mm");
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.indices = {0, 1, 2, 0, 1, 3, 0, 2, 3, 1, 2, 3};
  io::writeMesh(mesh, text("surface.stl"));
  expectEverywhere("surface.stl", "surface mm");
  std::ofstream(text("model.pdb"))
      << "ATOM      1  CA  ALA A   1      11.104   6.134  -6.504  1.00  0.00           C\n"
         "ATOM      2  CB  ALA A   1      12.104   7.134  -5.504  1.00  0.00           C\n";
  expectEverywhere("model.pdb", "model angstrom");
  // Scenes: in a file of their own, and in pictures, whatever the case of their endings.
  session::Session session;
  session.file().open(session::readPaths({text("phantom.nrrd")}, mProgress, {}), text("phantom.nrrd"));
  session::runScript(session, "cut.add box\n", "script", mProgress, [](auto&&...) {});
  session::runScript(session, "set lighting.shadow 0\nset lighting.occlusion 0\n", "script", mProgress,
                     [](auto&&...) {});
  session.file().save(text("scene.json"));
  expectEverywhere("scene.json", "volume cut mm");
  for (const char* name : {"picture.png", "picture.tif", "picture.exr"}) {
    runBatch({"render", path("scene.json"), "-o", path(name), "--size", "16x12", "--samples", "1"});
    expectEverywhere(name, "volume cut mm");
  }
  std::filesystem::copy_file(text("picture.tif"), text("OTHER.TIF"));
  expectEverywhere("OTHER.TIF", "volume cut mm");
}

TEST_F(KindsAtDoors, WhatIsNoDataIsRefusedByEach) {
  std::ofstream(text("look.velum-transfer.json")) << "{\"velumTransfer\": 1}";
  expectEverywhere("look.velum-transfer.json", "refused");
  std::ofstream(text("samples.raw")) << std::string(4096, 'x');
  EXPECT_EQ(byScript(text("samples.raw")), "refused");  // the window asks what the samples are
  EXPECT_EQ(byRender(text("samples.raw")), "refused");
  expectEverywhere("nothing.nrrd", "refused");
  std::filesystem::create_directory(text("empty"));
  expectEverywhere("empty", "refused");
}

}  // namespace
}  // namespace velum::gui
