#include <gtest/gtest.h>

#include <cmath>

#include "ChangeFields.h"
#include "scene/Navigate.h"
#include "scene/Units.h"
#include "scene/json/FieldFacts.h"
#include "scene/json/Json.h"
#include "scene/json/Paths.h"
#include "scene/timeline/SceneAt.h"
#include "scene/timeline/Tracks.h"

/// Laws of films: what a scene is at a time.
namespace velum::scene {
namespace {

Scene withTrack(Scene scene, const std::string& path, std::vector<Key> keys) {
  scene.timeline.tracks.push_back({path, true, std::move(keys)});
  return scene;
}

Scene withNumbers(const std::string& path, const std::vector<std::pair<double, double>>& points, Ease ease) {
  std::vector<Key> keys;
  for (auto [time, value] : points) keys.push_back({time, {std::to_string(value)}, ease});
  return withTrack({}, path, keys);
}

TEST(Timeline, ATurnHasTheAnglesThatItSays) {
  Scene scene;
  scene.camera.eye = {30, -400, 120};
  scene.camera.target = {5, 10, -20};
  scene.timeline.duration = 10.0, scene.timeline.framesPerSecond = 24.0;
  scene = withTrack(scene, "timeline.orbitDeg", {{0.0, {"0"}, Ease::Linear}, {10.0, {"810"}, Ease::Linear}});
  FilmFrames frames = framesOf(scene.timeline);
  ASSERT_EQ(frames.count, 240);
  double step = glm::radians(810.0 / 240);
  for (int i = 0; i < frames.count; ++i) {
    Scene shown = sceneAt(scene, frames.timeOf(i));
    glm::dvec3 arm = shown.camera.eye - shown.camera.target, first = scene.camera.eye - scene.camera.target;
    double angle = std::atan2(first.x * arm.y - first.y * arm.x, first.x * arm.x + first.y * arm.y);
    EXPECT_LT(std::abs(std::remainder(angle - i * step, 2.0 * 3.14159265358979323846)), 1e-6 * step) << i;
    EXPECT_NEAR(glm::length(arm), glm::length(first), 1e-9);
    EXPECT_EQ(shown.timeline.orbitDeg, 0.0);
  }
}

TEST(Timeline, EveryFieldGoesFromItsFirstValueToItsLast) {
  Scene base = changedScene();
  base.timeline.orbitDeg = 0.0;
  base.timeline.tracks.clear();
  int fields = 0, between = 0;
  for (int n = 0;; ++n) {
    Scene other = base;
    std::string path;
    int countdown = n;
    changeNthField(other, countdown, "", path);
    if (path.empty()) break;
    if (path.starts_with("timeline.") || !canChange(path) || getField(base, path) == getField(other, path)) continue;
    ++fields;
    SCOPED_TRACE(path);
    Scene film =
        withTrack(base, path, {{0.0, valueAt(base, path), Ease::Linear}, {2.0, valueAt(other, path), Ease::Linear}});
    ASSERT_TRUE(tracksThatDoNotFit(film).empty()) << tracksThatDoNotFit(film).front();
    EXPECT_EQ(getField(sceneAt(film, 0.0), path), getField(base, path));
    EXPECT_EQ(getField(sceneAt(film, 2.0), path), getField(other, path));
    EXPECT_EQ(getField(sceneAt(film, 5.0), path), getField(other, path));
    std::string half = getField(sceneAt(film, 1.0), path);
    if (fieldFacts(path).kind != FieldKind::Number && fieldFacts(path).kind != FieldKind::Color) continue;
    EXPECT_NE(half, getField(base, path));
    EXPECT_NE(half, getField(other, path));
    ++between;
    Scene rest = sceneAt(film, 1.0);
    rest.timeline.tracks.clear();
    setField(rest, path, getField(base, path));
    EXPECT_EQ(toJson(rest), toJson(sceneAt(base, 0.0))) << "nothing else changes";
  }
  EXPECT_GT(fields, 200);
  EXPECT_GT(between, 120);
}

TEST(Timeline, EasesAreWhatTheyAreCalled) {
  auto at = [](Ease ease, double time) {
    return sceneAt(withNumbers("lighting.ambient", {{1.0, 1.0}, {3.0, 2.0}}, ease), time).lighting.ambient;
  };
  for (Ease ease : {Ease::Hold, Ease::Linear, Ease::In, Ease::Out, Ease::Both, Ease::Smooth}) {
    EXPECT_DOUBLE_EQ(at(ease, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(at(ease, 1.0), 1.0);
    EXPECT_DOUBLE_EQ(at(ease, 3.0), 2.0);
    for (double t = 1.0; t < 3.0; t += 0.01) EXPECT_LE(at(ease, t), at(ease, t + 0.01));
  }
  EXPECT_DOUBLE_EQ(at(Ease::Hold, 2.99), 1.0);
  EXPECT_DOUBLE_EQ(at(Ease::Linear, 1.5), 1.25);
  EXPECT_LT(at(Ease::In, 1.2), 1.02);
  EXPECT_GT(at(Ease::Out, 1.2), 1.15);
  EXPECT_DOUBLE_EQ(at(Ease::Both, 2.0), 1.5);
  EXPECT_DOUBLE_EQ(at(Ease::Smooth, 2.0), 1.5);
}

TEST(Timeline, SmoothPathsPassKeysWithoutAStopAndStayBetweenThem) {
  Scene film =
      withNumbers("camera.fieldOfViewDeg", {{0, 10}, {1, 20}, {2, 22}, {4, 60}, {5, 60}, {6, 30}}, Ease::Smooth);
  auto at = [&](double t) { return sceneAt(film, t).camera.fieldOfViewDeg; };
  double h = 1e-4;
  for (double key : {1.0, 2.0, 4.0, 5.0}) {
    double before = (at(key) - at(key - h)) / h, after = (at(key + h) - at(key)) / h;
    EXPECT_NEAR(before, after, 0.05) << key;
    if (key < 4.0) {
      EXPECT_GT(after, 1.0) << "no stop at " << key;
    }
  }
  EXPECT_NEAR((at(h) - at(0)) / h, 0.0, 0.05);
  for (double t = 0.0; t < 4.0; t += 0.01) EXPECT_LE(at(t), at(t + 0.01) + 1e-12);
  for (double t = 4.0; t < 5.0; t += 0.01) EXPECT_DOUBLE_EQ(at(t), 60.0);
}

TEST(Timeline, ACameraTurnsAboutItsTargetAndKeepsItsDistance) {
  Scene scene;
  Camera a = scene.camera, b = turntable(a, 2.0);
  b = zoom(b, 0.5);
  Scene other = scene;
  other.camera = b;
  for (Ease ease : {Ease::Linear, Ease::Smooth, Ease::Both}) {
    Scene film =
        withTrack(scene, "camera", {{0.0, valueAt(scene, "camera"), ease}, {4.0, valueAt(other, "camera"), ease}});
    EXPECT_EQ(sceneAt(film, 4.0).camera, b);
    Camera half = sceneAt(film, 2.0).camera;
    Camera wanted = zoom(turntable(a, 1.0), std::sqrt(0.5));
    EXPECT_LT(glm::distance(half.eye, wanted.eye), 1e-6);
    EXPECT_LT(glm::distance(glm::normalize(half.up), glm::normalize(wanted.up)), 1e-9);
  }
}

TEST(Timeline, ADirectionTurnsEvenlyAndNeverVanishes) {
  Scene scene;
  scene.cuts.emplace_back();
  completeItems(scene);
  scene = withTrack(scene, "cuts[#1].axis", {{0.0, {"[0,-2,0]"}, Ease::Linear}, {1.0, {"[0,2,0]"}, Ease::Linear}});
  for (double t = 0.0; t <= 1.0; t += 0.125) {
    glm::dvec3 axis = sceneAt(scene, t).cuts[0].axis;
    EXPECT_NEAR(glm::length(axis), 2.0, 1e-9);
    EXPECT_NEAR(std::acos(glm::clamp(-axis.y / 2.0, -1.0, 1.0)), t * 3.14159265358979, 1e-6);
  }
}

TEST(Timeline, CurvesOfOtherPointsAreMixedAsCurves) {
  Scene scene;
  scene = withTrack(
      scene, "volume.transfer.opacities",
      {{0.0, {R"([{"value":0,"opacity":0},{"value":100,"opacity":1}])"}, Ease::Linear},
       {1.0, {R"([{"value":0,"opacity":0},{"value":50,"opacity":0},{"value":100,"opacity":1}])"}, Ease::Linear}});
  ASSERT_TRUE(tracksThatDoNotFit(scene).empty()) << tracksThatDoNotFit(scene).front();
  auto half = sceneAt(scene, 0.5).volume.transfer.opacities;
  for (double value : {0.0, 20.0, 50.0, 75.0, 100.0}) {
    double a = value / 100.0, b = value < 50.0 ? 0.0 : (value - 50.0) / 50.0;
    EXPECT_NEAR(opacityAt(half, value), 0.5 * (a + b), 1e-9) << value;
  }
}

TEST(Timeline, TracksFollowTheirItemsByIdAndKey) {
  Scene scene;
  for (const char* name : {"Front", "Side"}) {
    scene.cuts.emplace_back();
    scene.cuts.back().name = name;
  }
  completeItems(scene);
  scene.labels.structures.push_back({5, "aorta"});
  scene.cuts[1].spares.push_back({5, 10.0});
  EXPECT_EQ(stablePath(scene, "cuts[Side].centre"), "cuts[#2].centre");
  EXPECT_EQ(stablePath(scene, "cuts.1.spares.0.distance"), "cuts[#2].spares[5].distance");
  EXPECT_EQ(stablePath(scene, "labels.structures[aorta].opacity"), "labels.structures[#5].opacity");
  EXPECT_THROW(stablePath(scene, "cuts.7.centre"), ArgumentError);
  EXPECT_EQ(trackTitle(scene, "cuts[#2].spares[5].distance"), "Side: aorta: distance");
  EXPECT_EQ(trackTitle(scene, "cuts[#2].faceOpacity"), "Side: face opacity");
  scene = withTrack(scene, "cuts[#2].spares[5].distance", {{0.0, {"0"}, Ease::Linear}, {1.0, {"20"}, Ease::Linear}});
  std::swap(scene.cuts[0], scene.cuts[1]);
  EXPECT_DOUBLE_EQ(sceneAt(scene, 0.5).cuts[0].spares[0].distance, 10.0);
  EXPECT_TRUE(sceneAt(scene, 0.5).cuts[1].spares.empty());
  scene.cuts.erase(scene.cuts.begin());
  EXPECT_EQ(tracksThatDoNotFit(scene).size(), 1u);
  EXPECT_EQ(sceneAt(scene, 0.5).cuts, scene.cuts);
  dropLostTracks(scene);
  EXPECT_TRUE(scene.timeline.tracks.empty());
  // A type of a model needs no row of its own.
  Scene model = withTrack({}, "model.types[root.A].visible", {{1.0, {"false"}}});
  EXPECT_EQ(sceneAt(model, 2.0).model.types.at(0).type, "root.A");
  EXPECT_FALSE(sceneAt(model, 2.0).model.types.at(0).visible);
}

TEST(Timeline, WhatDoesNotFitIsToldAndChangesNothing) {
  Scene scene;
  for (auto [path, value] : {std::pair{"nothing", "1"},
                             {"camera.eye", "[1,2]"},
                             {"camera.fieldOfViewDeg", "1e9"},
                             {"volume.source.path", "\"x\""},
                             {"cuts[#4].centre", "[0,0,0]"},
                             {"timeline.duration", "3"},
                             {"rayCast.mode", "\"nonsense\""},
                             {"cuts[", "1"}}) {
    Scene film = withTrack(scene, path, {{0.0, {value}}});
    EXPECT_EQ(tracksThatDoNotFit(film).size(), 1u) << path;
    film.timeline.tracks[0].enabled = true;
    Scene shown = sceneAt(film, 1.0);
    shown.timeline = {};
    EXPECT_EQ(shown, scene) << path;
  }
}

TEST(Timeline, FilesKeepItAsItIs) {
  Scene scene;
  scene.camera.eye = {1.0 / 3.0, 2e-7, -400};
  scene = withTrack(scene, "camera", {{0.1, valueAt(scene, "camera"), Ease::In}, {7.25, valueAt(scene, "camera")}});
  scene.timeline.rangeEnd = 3.0;
  Scene back = fromJson(toJson(scene));
  EXPECT_EQ(back.timeline, scene.timeline);
  EXPECT_NE(toJson(scene).find("\"value\": {"), std::string::npos) << "as itself, not as a text";
  EXPECT_EQ(toJson(Scene()).find("timeline"), std::string::npos) << "scenes without a film say nothing of one";
  setField(scene, "timeline.tracks[camera].keys.0.time", "0.5");
  EXPECT_EQ(scene.timeline.tracks[0].keys[0].time, 0.5);
  setField(scene, "timeline.tracks[cuts[#3].centre].keys", R"([{"time":1,"value":[1,2,3]}])");
  EXPECT_EQ(scene.timeline.tracks[1].path, "cuts[#3].centre");
  EXPECT_EQ(getField(scene, "timeline.tracks[cuts[#3].centre].keys.0.time"), "1");
}

TEST(Timeline, KeysOfAFileThatStandInNoOrderAreBroughtIntoIt) {
  Scene scene = withNumbers("camera.fieldOfViewDeg", {{3.0, 60.0}, {1.0, 20.0}}, Ease::Linear);
  Scene back = fromJson(toJson(scene));
  EXPECT_EQ(back.timeline.tracks[0].keys[0].time, 1.0);
  EXPECT_EQ(sceneAt(back, 2.0).camera.fieldOfViewDeg, 40.0);
}

TEST(Timeline, RecordingMakesKeysOfWhatChanges) {
  Scene before;
  before.cuts.emplace_back();
  completeItems(before);
  Scene after = before;
  after.camera = orbit(after.camera, {0.1, 0.2});
  after.cuts[0].centre.y = 40.0;
  after.cuts[0].name = "new";
  after.sections.layout = Layout::FourUp;
  after.timeline = recorded(before, after, 3.0);
  ASSERT_EQ(after.timeline.tracks.size(), 2u);
  for (const Track& track : after.timeline.tracks) {
    ASSERT_EQ(track.keys.size(), 2u) << track.path;
    EXPECT_EQ(track.keys[0].time, 0.0);
    EXPECT_EQ(track.keys[1].time, 3.0);
  }
  EXPECT_EQ(sceneAt(after, 0.0).camera, before.camera);
  EXPECT_EQ(sceneAt(after, 3.0).camera, after.camera);
  // What tracks say stays theirs where a scene takes over what else has changed.
  Scene kept = after;
  kept.lighting.ambient = 1.5;
  keepTracked(kept, before);
  EXPECT_EQ(kept.camera, before.camera);
  EXPECT_EQ(kept.cuts[0].centre, before.cuts[0].centre);
  EXPECT_EQ(kept.lighting.ambient, 1.5);
}

TEST(Timeline, LengthsInKeysAreScaledWithTheScene) {
  Scene scene = withTrack({}, "camera", {{0.0, {R"({"eye":[1,2,3],"target":[0,0,0],"fieldOfViewDeg":30})"}}});
  scene = withTrack(scene, "sections.crosshair", {{0.0, {"[1,2,3]"}}});
  scaleKeys(scene, 10.0);
  EXPECT_EQ(sceneAt(scene, 0.0).camera.eye, glm::dvec3(10, 20, 30));
  EXPECT_EQ(sceneAt(scene, 0.0).camera.fieldOfViewDeg, 30.0);
  EXPECT_EQ(sceneAt(scene, 0.0).sections.crosshair, glm::dvec3(10, 20, 30));
}

TEST(Timeline, KeysAreMovedAndRemoved) {
  Timeline timeline;
  for (double time : {0.0, 1.0, 2.0}) setKey(timeline, "camera.fieldOfViewDeg", time, {std::to_string(10 + time)});
  timeline.tracks[0].keys[0].ease = Ease::Linear;
  EXPECT_EQ(setKey(timeline, "camera.fieldOfViewDeg", 0.5, {"3"}).ease, Ease::Linear) << "as the key before";
  EXPECT_EQ(timeline.tracks[0].keys.size(), 4u);
  EXPECT_EQ(moveKey(timeline.tracks[0], 0, 1.5), 2u);
  EXPECT_EQ(moveKey(timeline.tracks[0], 0, 2.0), 2u) << "in the place of the one there";
  EXPECT_EQ(timeline.tracks[0].keys.size(), 3u);
  removeKeys(timeline, "camera.fieldOfViewDeg", 0.0, 1.7);
  EXPECT_EQ(timeline.tracks[0].keys.size(), 1u);
  removeKeys(timeline, "camera.fieldOfViewDeg", 2.0, 2.0);
  EXPECT_TRUE(timeline.tracks.empty());
}

}  // namespace
}  // namespace velum::scene
