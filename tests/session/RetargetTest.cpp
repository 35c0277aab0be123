// The same scene and film of other data.
#include "session/film/Retarget.h"

#include <gtest/gtest.h>

#include "TempFolder.h"
#include "core/Error.h"
#include "io/labels/WriteLabels.h"
#include "io/phantoms/Sample.h"
#include "io/volumes/WriteVolume.h"
#include "scene/timeline/SceneAt.h"
#include "scene/timeline/Tracks.h"
#include "session/Session.h"
#include "session/command/Command.h"
#include "session/command/DocumentCommands.h"
#include "session/document/Open.h"

namespace velum::session {
namespace {

constexpr double kGrow = 1.5;
const glm::dvec3 kShift(40, -25, 300);

/// A patient, and another one who is the same patient grown and elsewhere, with other numbers of structures.
class Retarget : public testing::Test {
 protected:
  void SetUp() override {
    io::Sample sample = io::makeSample("two-spheres", 32, mProgress);
    write(sample, "one");
    for (auto* frame : {&sample.volume.worldFromVoxel}) *frame = grown(*frame);
    LabelVolume labels(sample.labels.dims(), grown(sample.labels.worldFromVoxel()));
    glm::ivec3 dims = labels.dims();
    std::vector<std::uint16_t> ids(std::size_t(dims.x) * dims.y * dims.z);
    sample.labels.read({0, 0, 0}, dims, ids);
    for (auto& id : ids) id = id == 0 ? 0 : id + 10;
    labels.write({0, 0, 0}, dims, ids);
    labels.table = sample.labels.table;
    for (auto& info : labels.table) info.id = std::uint16_t(info.id + 10);
    sample.labels = std::move(labels);
    write(sample, "two");
    scene::Source source;
    source.path = path("one.nrrd");
    mScene = open(source, mProgress);
    source.path = path("one.seg.nrrd");
    addLabels(mScene, source, mProgress);
    scene::completeStructures(mScene.labels);
    scene::addCut(mScene, {});
    mScene.cuts[0].centre = {3, 4, 5};
    mScene.cuts[0].spares = {{mScene.labels.structures[1].id, 8.0}};
    mScene.timeline.tracks.push_back({"cuts[#1].centre", true, {{0.0, {"[3,4,5]"}}, {1.0, {"[9,4,5]"}}}});
    mScene.timeline.tracks.push_back(
        {fmt("labels.structures[#{}].opacity", mScene.labels.structures[0].id), true, {{0.0, {"1"}}, {1.0, {"0"}}}});
  }
  static glm::dmat4 grown(const glm::dmat4& frame) {
    return glm::translate(glm::dmat4(1.0), kShift) * glm::scale(glm::dmat4(1.0), glm::dvec3(kGrow)) * frame;
  }
  static std::string fmt(std::string text, int id) { return text.replace(text.find("{}"), 2, std::to_string(id)); }
  void write(const io::Sample& sample, const std::string& name) {
    io::writeVolume(sample.volume, mFolder / (name + ".nrrd"), mProgress);
    io::writeLabels(sample.labels, mFolder / (name + ".seg.nrrd"), mProgress);
  }
  std::string path(const char* name) { return (mFolder / name).string(); }
  static glm::dvec3 carried(glm::dvec3 place) { return place * kGrow + kShift; }

  TempFolder mFolder;
  scene::Scene mScene;
  std::vector<std::string> mNotes;
  Progress mProgress;
};

void expectNear(glm::dvec3 a, glm::dvec3 b, double most) { EXPECT_LT(glm::distance(a, b), most); }

TEST_F(Retarget, PlacesGoByTheDatasBoxOrByAStructure) {
  for (const char* structure : {"", mScene.labels.structures[0].name.c_str()}) {
    scene::Scene other = retargeted(mScene, {path("two.nrrd"), path("two.seg.nrrd"), structure}, mProgress, mNotes);
    double most = *structure ? 2.0 : 1e-6;  // the middle of a structure is that of a voxel
    expectNear(other.cuts[0].centre, carried({3, 4, 5}), most);
    expectNear(other.camera.target, carried(mScene.camera.target), most);
    expectNear(other.camera.eye - other.camera.target, (mScene.camera.eye - mScene.camera.target) * kGrow, 1e-6);
    EXPECT_NEAR(other.cuts[0].spares.at(0).distance, 8.0 * kGrow, 1e-9);
    expectNear(scene::sceneAt(other, 1.0).cuts[0].centre, carried({9, 4, 5}), most);
    EXPECT_EQ(other.volume.source.path, path("two.nrrd"));
    EXPECT_EQ(other.volume.transfer, mScene.volume.transfer) << "the same values in another place";
  }
}

TEST_F(Retarget, StructuresAreFoundByTheirNames) {
  mScene.labels.structures[1].color = {0.1f, 0.2f, 0.3f};
  scene::Scene other = retargeted(mScene, {path("two.nrrd"), path("two.seg.nrrd"), ""}, mProgress, mNotes);
  int before = mScene.labels.structures[1].id, after = before + 10;
  EXPECT_EQ(other.cuts[0].spares.at(0).structure, after);
  for (const auto& structure : other.labels.structures)
    if (structure.id == after) {
      EXPECT_EQ(structure.color, glm::vec3(0.1f, 0.2f, 0.3f));
    }
  EXPECT_TRUE(scene::tracksThatDoNotFit(other).empty());
  EXPECT_EQ(other.timeline.tracks[1].path, fmt("labels.structures[#{}].opacity", mScene.labels.structures[0].id + 10));
}

TEST_F(Retarget, DataOfAnotherKindGetsThePresetThatFitsIt) {
  io::writeVolume(io::makeSample("ultrasound", 48, mProgress).volume, mFolder / "us.nrrd", mProgress);
  mScene.timeline.tracks.push_back({"volume.transfer.opacities", true, {{0.0, {"[]"}}}});
  Volume other = *mScene.volume.data;
  scene::Scene made = retargeted(mScene, {path("us.nrrd"), "", ""}, mProgress, mNotes);
  if (made.volume.data->modality == other.modality) GTEST_SKIP() << "both are of one kind";
  EXPECT_FALSE(scene::findTrack(made.timeline, "volume.transfer.opacities"));
  EXPECT_FALSE(mNotes.empty());
}

TEST_F(Retarget, WhatIsOfStructuresThatTheOthersLackIsLeftOut) {
  // The other labels have another structure under the number of this one.
  int lost = mScene.labels.structures[0].id + 10;
  mScene.labels.structures.push_back({.id = lost, .name = "not in the picture"});
  mScene.labels.structures[1].name = "spleen";
  mScene.timeline.tracks.push_back({fmt("labels.structures[#{}].opacity", lost), true, {{0.0, {"1"}}, {1.0, {"0.5"}}}});
  mScene.timeline.tracks.push_back({fmt("cuts[#1].spares[{}].distance", lost), true, {{0.0, {"1"}}}});
  scene::addMark(mScene.lettering.marks, {.kind = scene::MarkKind::Name, .points = {{1, 2, 3}}, .structure = lost});
  scene::addMark(mScene.lettering.marks, {.kind = scene::MarkKind::Label, .points = {{1, 2, 3}}, .text = "here"});
  mScene.surfaces.emplace_back();
  scene::Scene other = retargeted(mScene, {path("two.nrrd"), path("two.seg.nrrd"), ""}, mProgress, mNotes);
  EXPECT_EQ(other.timeline.tracks.size(), 2u);
  ASSERT_EQ(other.lettering.marks.size(), 1u);
  expectNear(other.lettering.marks[0].points[0], carried({1, 2, 3}), 1e-6);
  EXPECT_TRUE(other.surfaces.empty());
  std::string notes;
  for (const auto& note : mNotes) notes += note + "\n";
  EXPECT_NE(notes.find("do not have: spleen\n"), notes.npos) << notes;
  EXPECT_TRUE(other.cuts[0].spares.empty());
  EXPECT_NE(notes.find("surfaces"), notes.npos) << notes;
}

TEST_F(Retarget, StructuresOfBothAreOffered) {
  std::vector<std::string> names;
  for (const auto& structure : mScene.labels.structures) names.push_back(structure.name);
  EXPECT_EQ(sharedStructures(mScene.labels, path("two.seg.nrrd"), mProgress), names);
  mScene.labels.structures[0].name = "another name";
  names.erase(names.begin());
  EXPECT_EQ(sharedStructures(mScene.labels, path("two.seg.nrrd"), mProgress), names);
  EXPECT_TRUE(sharedStructures({}, path("two.seg.nrrd"), mProgress).empty());
  EXPECT_THROW(sharedStructures(mScene.labels, path("none.nrrd"), mProgress), InputError);
}

TEST_F(Retarget, TheCommandIsOneStepWhateverThePlayheadShows) {
  Session session(mScene);
  std::string line = "scene.carry " + path("two.nrrd") + " " + path("two.seg.nrrd");
  session.document().setPlayhead(1.0);
  session.document().setRecording(true);
  run(session, parseCall(line), mProgress);
  expectNear(session.scene().cuts[0].centre, carried({3, 4, 5}), 1e-6);
  expectNear(session.document().shown().cuts[0].centre, carried({9, 4, 5}), 1e-6);
  EXPECT_EQ(session.scene().timeline.tracks.size(), mScene.timeline.tracks.size()) << "nothing of it is a key";
  EXPECT_EQ(session.document().lastCommandLines(), std::vector<std::string>{line});
  EXPECT_TRUE(session.document().isRecording());
  EXPECT_EQ(session.document().undoLabels().size(), 1u);
  session.document().undo();
  EXPECT_TRUE(session.scene() == mScene);
  EXPECT_THROW(run(session, parseCall("scene.carry " + path("none.nrrd")), mProgress), InputError);
  EXPECT_THROW(run(session, CarryScene{}, mProgress), ArgumentError);
  EXPECT_TRUE(session.scene() == mScene);
}

TEST_F(Retarget, NoFileOfOtherDataIsWrittenOver) {
  std::string story = path("story.json"), other = path("other.json");
  saveScene(mScene, story);
  Session session;
  run(session, parseCall("open " + story), mProgress);
  const WorkFile& file = session.file();
  ASSERT_EQ(file.scenePath(), story);
  run(session, parseCall("scene.carry " + path("two.nrrd")), mProgress);
  EXPECT_EQ(file.scenePath(), "") << "saving asks where";
  EXPECT_EQ(file.name(), "two.nrrd");
  EXPECT_TRUE(file.isModified());
  session.document().undo();
  EXPECT_EQ(file.scenePath(), story);
  EXPECT_EQ(file.name(), "story.json");
  EXPECT_FALSE(file.isModified());
  session.document().redo();
  run(session, parseCall("save " + other), mProgress);
  EXPECT_EQ(file.scenePath(), other);
  session.document().undo();
  EXPECT_EQ(file.scenePath(), "") << "of other data than the file that was saved last";
  session.document().redo();
  EXPECT_EQ(file.scenePath(), other);
  // From one to the next: only the last one's file is known.
  run(session, parseCall("scene.carry " + path("one.nrrd")), mProgress);
  EXPECT_EQ(file.scenePath(), "");
  run(session, parseCall("open " + story), mProgress);
  EXPECT_EQ(file.scenePath(), story);
}

TEST_F(Retarget, WhatCannotBeIsSaid) {
  EXPECT_THROW(retargeted(mScene, {path("none.nrrd"), "", ""}, mProgress, mNotes), InputError);
  EXPECT_THROW(retargeted(mScene, {path("two.nrrd"), path("two.seg.nrrd"), "spleen"}, mProgress, mNotes),
               ArgumentError);
  EXPECT_THROW(retargeted({}, {path("two.nrrd"), "", ""}, mProgress, mNotes), ArgumentError);
}

}  // namespace
}  // namespace velum::session
