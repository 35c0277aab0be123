// A document at the playhead of its film: what is seen, what is saved, what becomes a key.
#include <gtest/gtest.h>

#include "scene/Navigate.h"
#include "scene/timeline/SceneAt.h"
#include "scene/timeline/Tracks.h"
#include "session/Session.h"
#include "session/command/Command.h"
#include "session/command/CutCommands.h"
#include "session/command/FilmCommands.h"

namespace velum::session {
namespace {

scene::Scene filmScene() {
  scene::Scene scene;
  scene.cuts.emplace_back();
  scene.cuts[0].name = "Front";
  scene::completeItems(scene);
  scene.timeline.tracks = {
      {"cuts[#1].faceOpacity", true, {{0.0, {"0"}, scene::Ease::Linear}, {4.0, {"1"}, scene::Ease::Linear}}},
      {"timeline.orbitDeg", true, {{0.0, {"0"}, scene::Ease::Linear}, {4.0, {"400"}, scene::Ease::Linear}}}};
  return scene;
}

struct Playhead : testing::Test {
  Session session{filmScene()};
  Document& document = session.document();
  void run(const std::string& line) {
    Progress progress;
    session::run(session, parseCall(line), progress);
  }
};

TEST_F(Playhead, ShowsAndDoesNotEdit) {
  scene::Scene saved = document.scene();
  std::uint64_t changes = document.changeCount();
  int heard = 0;
  session.setListener([&] { ++heard; });
  for (double time : {0.0, 1.0, 3.5, 0.25}) {
    document.setPlayhead(time);
    EXPECT_EQ(document.shown(), scene::sceneAt(saved, time));
    EXPECT_EQ(document.scene(), saved);
  }
  EXPECT_EQ(heard, 4);
  EXPECT_EQ(document.changeCount(), changes);
  EXPECT_FALSE(document.canUndo());
  EXPECT_FALSE(document.isModified());
  document.setPlayhead({});
  EXPECT_EQ(document.shown(), saved);
}

TEST_F(Playhead, ChangesOfOtherFieldsGoIntoTheSceneAndNothingElseDoes) {
  document.setPlayhead(1.0);
  scene::Scene before = document.scene();
  document.edit("Move cut", [](scene::Scene& scene) { scene.cuts[0].centre = {1, 2, 3}; });
  EXPECT_EQ(document.scene().cuts[0].centre, glm::dvec3(1, 2, 3));
  EXPECT_EQ(document.scene().cuts[0].faceOpacity, before.cuts[0].faceOpacity) << "that is the track's";
  EXPECT_EQ(document.scene().camera, before.camera) << "turned for the eye alone";
  EXPECT_EQ(document.shown().cuts[0].centre, glm::dvec3(1, 2, 3));
  EXPECT_DOUBLE_EQ(document.shown().cuts[0].faceOpacity, 0.25);
  document.undo();
  EXPECT_EQ(document.scene(), before);
  EXPECT_EQ(document.shown(), scene::sceneAt(before, 1.0));
}

TEST_F(Playhead, ATrackedFieldIsSeenChangedUntilThePlayheadMoves) {
  document.setPlayhead(1.0);
  scene::Scene before = document.scene();
  document.edit("Opacity", [](scene::Scene& scene) { scene.cuts[0].faceOpacity = 0.9; });
  EXPECT_EQ(document.scene(), before);
  EXPECT_FALSE(document.canUndo());
  EXPECT_EQ(document.shown().cuts[0].faceOpacity, 0.9);
  run("film.key cuts[Front].faceOpacity");
  EXPECT_EQ(scene::sceneAt(document.scene(), 1.0).cuts[0].faceOpacity, 0.9) << "Key this keeps what is seen";
  document.setPlayhead(2.0);
  EXPECT_NE(document.shown().cuts[0].faceOpacity, 0.9);
}

TEST_F(Playhead, ACameraThatIsMovedWhileItTurnsIsKeptUnturned) {
  document.setPlayhead(1.0);
  scene::Camera moved = scene::zoom(document.shown().camera, 0.5);
  document.view([&](scene::Scene& scene) { scene.camera = moved; });
  EXPECT_EQ(document.shown().camera, moved);
  EXPECT_LT(glm::distance(scene::sceneAt(document.scene(), 1.0).camera.eye, moved.eye), 1e-9);
}

TEST_F(Playhead, RecordingMakesKeysAndUndoTakesThemBack) {
  scene::Scene before = document.scene();
  document.setPlayhead(2.0);
  document.setRecording(true);
  for (double x : {1.0, 2.0, 3.0})
    document.edit(
        "Move cut", [&](scene::Scene& scene) { scene.cuts[0].centre.x = x; }, true);
  document.endMerge();
  const scene::Track* track = scene::findTrack(document.scene().timeline, "cuts[#1].centre");
  ASSERT_TRUE(track);
  ASSERT_EQ(track->keys.size(), 2u);
  EXPECT_EQ(document.scene().cuts[0].centre, before.cuts[0].centre);
  EXPECT_EQ(scene::sceneAt(document.scene(), 0.0).cuts[0].centre.x, before.cuts[0].centre.x);
  EXPECT_EQ(document.shown().cuts[0].centre.x, 3.0);
  document.view([](scene::Scene& scene) { scene.camera = scene::zoom(scene.camera, 0.5); });
  EXPECT_TRUE(scene::findTrack(document.scene().timeline, "camera"));
  EXPECT_TRUE(document.isModified());
  document.undo();
  document.undo();
  EXPECT_EQ(document.scene(), before);
}

TEST_F(Playhead, WhoeverListensIsToldOfRecordingOnceEachTime) {
  document.setPlayhead(2.0);
  int told = 0;
  document.setListener([&] { ++told; });
  for (bool recording : {true, true, false, false}) {
    document.setRecording(recording);
    EXPECT_EQ(document.isRecording(), recording);
    EXPECT_EQ(told, recording ? 1 : 2);
  }
  EXPECT_FALSE(document.canUndo());
}

TEST_F(Playhead, WhatRestsAtAMomentDoesNotBecomeTheFilm) {
  document.setPlayhead(1.0);
  scene::Scene before = document.scene();
  document.complete([](scene::Scene& scene) { scene.cuts[0].faceOpacity = 0.5; });
  EXPECT_EQ(document.scene(), before);
}

TEST_F(Playhead, RemovingATrackKeepsWhatIsSeen) {
  document.setPlayhead(3.0);
  run("film.removeTrack cuts[Front].faceOpacity");
  EXPECT_DOUBLE_EQ(document.scene().cuts[0].faceOpacity, 0.75);
}

TEST_F(Playhead, WithACutItsTracksGo) {
  document.setPlayhead(1.0);
  run("cut.remove Front");
  ASSERT_EQ(document.scene().timeline.tracks.size(), 1u);
  EXPECT_EQ(document.scene().timeline.tracks[0].path, "timeline.orbitDeg");
  document.undo();
  EXPECT_EQ(document.scene().timeline.tracks.size(), 2u);
}

TEST_F(Playhead, CommandsEditTheFilm) {
  run("film.key sections.crosshair 1 1,2,3");
  run("film.key sections.crosshair 5 4,5,6");
  run("film.ease sections.crosshair 1 linear");
  EXPECT_EQ(scene::sceneAt(document.scene(), 3.0).sections.crosshair, glm::dvec3(2.5, 3.5, 4.5));
  run("film.moveKey sections.crosshair 5 3 copy=true");
  EXPECT_EQ(scene::findTrack(document.scene().timeline, "sections.crosshair")->keys.size(), 3u);
  run("film.removeKey sections.crosshair 5");
  EXPECT_EQ(scene::sceneAt(document.scene(), 9.0).sections.crosshair, glm::dvec3(4, 5, 6));
  for (const char* wrong : {"film.key volume.source.path 1 x", "film.key nothing 1", "film.removeKey camera 3",
                            "film.ease sections.crosshair 7 both", "film.key cuts[Back].centre 1", "film.fly aorta"}) {
    scene::Scene before = document.scene();
    EXPECT_THROW(run(wrong), ArgumentError) << wrong;
    EXPECT_EQ(document.scene(), before);
  }
  run("film.clear");
  EXPECT_TRUE(document.scene().timeline.tracks.empty());
  // Lines of a script do all of it again.
  Session again{filmScene()};
  Progress progress;
  std::string script;
  for (const auto& line : document.commandLines()) script += line + "\n";
  runScript(again, script, "script", progress, [](const Call&, const std::string&) {});
  EXPECT_EQ(again.scene(), document.scene());
}

}  // namespace
}  // namespace velum::session
