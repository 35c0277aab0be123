// Ready-made films: what their keys make of a scene.
#include "session/film/ReadyFilms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "CutScene.h"
#include "makeModel.h"
#include "makeVolume.h"
#include "render/kept/KeptInstances.h"
#include "scene/timeline/SceneAt.h"
#include "session/extrusion/Extrusion.h"

namespace velum::session {

namespace {

using Kept = std::vector<std::uint8_t>;

/// A ball that takes most of a model, with rows of every kind.
scene::Scene cutScene() {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker{.types = 4, .instances = 1500}.make());
  scene::Cut ball;
  ball.id = 7;
  ball.shape = scene::CutShape::Sphere;
  ball.size = glm::dvec3(460.0);
  ball.model.spares = {{.type = "root.a", .share = 0.5},
                       {.type = pathOf(*scene.model.data, scene.model.data->types[0]), .share = 0.2, .falloff = 60.0},
                       {.type = "root", .share = 0.05, .viewShare = 0.3}};
  scene.cuts = {ball};
  return scene;
}

/// What every cut leaves when it spares nothing.
scene::Scene plainlyCut(scene::Scene scene) {
  for (scene::Cut& cut : scene.cuts) cut.model.spares.clear();
  return scene;
}

std::size_t countOf(const Kept& kept) { return std::size_t(std::count(kept.begin(), kept.end(), 1)); }

/// All of one are of the other.
bool isWithin(const Kept& a, const Kept& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] > b[i]) return false;
  return true;
}

/// A moment of a ready-made film. @param at  0: its first picture, 1: its last
scene::Scene momentOf(const scene::Scene& scene, ReadyFilm film, double at) {
  scene::Scene made = scene;
  made.timeline.framesPerSecond = 1000.0;
  addReadyFilm(made, film, {0.0, 1.0});
  scene::Scene out = scene::sceneAt(made, at * 0.999);
  out.timeline = scene.timeline;
  return out;
}

scene::Scene equalizedAt(const scene::Scene& scene, double at) { return momentOf(scene, ReadyFilm::Equalize, at); }

}  // namespace

TEST(Equalizing, GoesFromTheWholeOverPlainCutsToTheScene) {
  scene::Scene scene = cutScene();
  EXPECT_EQ(countOf(render::keptInstances(equalizedAt(scene, 0.0))), scene.model.data->instances.size());
  EXPECT_EQ(render::keptInstances(equalizedAt(scene, 1.0)), render::keptInstances(scene));
  Kept plain = render::keptInstances(plainlyCut(scene));
  EXPECT_EQ(render::keptInstances(equalizedAt(scene, 0.5)), plain);
  EXPECT_EQ(countOf(render::keptInstances(equalizedAt(scene, 1e-12))), plain.size());
  EXPECT_EQ(render::keptInstances(equalizedAt(scene, 1.0 - 1e-12)), render::keptInstances(scene));
  EXPECT_LT(countOf(plain), plain.size() / 2);
}

TEST(Equalizing, EachInstanceGoesOnceAndComesBackOnce) {
  scene::Scene scene = cutScene();
  Kept before = render::keptInstances(equalizedAt(scene, 0.0));
  std::size_t all = before.size(), plain = countOf(render::keptInstances(plainlyCut(scene)));
  for (int i = 1; i <= 20; ++i) {
    Kept now = render::keptInstances(equalizedAt(scene, i / 20.0));
    EXPECT_TRUE(i <= 10 ? isWithin(now, before) : isWithin(before, now)) << i;
    // As many in each moment: the share falls evenly.
    double expected = double(all) - double(all - plain) * i / 10.0;
    if (i <= 10) {
      EXPECT_NEAR(double(countOf(now)), expected, 3.0 * std::sqrt(double(all))) << i;
    }
    before = now;
  }
  EXPECT_GT(countOf(before), plain + 50);
}

TEST(Equalizing, RangesOfMassTakeNothingBeforeItsTurn) {
  scene::Scene scene = cutScene();
  scene.cuts[0].model.leastMass = 1e12;  // no type is spared
  EXPECT_EQ(countOf(render::keptInstances(equalizedAt(scene, 1e-12))), scene.model.data->instances.size());
  EXPECT_EQ(render::keptInstances(equalizedAt(scene, 0.8)), render::keptInstances(plainlyCut(scene)));
}

TEST(Equalizing, ACutEverywhereClearsTheViewBeforeItThinsOut) {
  scene::Scene scene = cutScene();
  scene.cuts[0].shape = scene::CutShape::Everywhere;
  const Model& model = *scene.model.data;
  scene.cuts[0].model.focus.emplace().types = {{pathOf(model, model.types[1])}};
  scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 1.0);
  auto statesAt = [&](double at) { return render::instanceStates(equalizedAt(scene, at)); };
  auto count = [](const std::vector<render::InstanceState>& states, render::InstanceState state) {
    return std::count(states.begin(), states.end(), state);
  };
  std::ptrdiff_t clearedBefore = 0;
  for (double at : {0.1, 0.3, 0.5}) {
    auto states = statesAt(at);
    EXPECT_EQ(count(states, render::InstanceState::Removed), 0) << at;
    EXPECT_GT(count(states, render::InstanceState::Cleared), clearedBefore) << at;
    clearedBefore = count(states, render::InstanceState::Cleared);
  }
  EXPECT_GT(count(statesAt(0.75), render::InstanceState::Removed), 100);
  EXPECT_EQ(statesAt(1.0 - 1e-12), render::instanceStates(scene));
  // Without a row for all what has none of its own goes like the rest.
  scene.cuts[0].model.spares.pop_back();
  EXPECT_EQ(statesAt(1.0 - 1e-12), render::instanceStates(scene));
  EXPECT_EQ(count(statesAt(0.5), render::InstanceState::Removed), 0);
}

TEST(CutsComeIn, FromWhereTheyTakeNothing) {
  scene::Scene scene = boxScene({400, 300});
  for (scene::CutShape shape : {scene::CutShape::Plane, scene::CutShape::Membrane, scene::CutShape::Box,
                                scene::CutShape::Sphere, scene::CutShape::Cylinder, scene::CutShape::Cone})
    for (bool invert : {false, true}) {
      if (invert && shape == scene::CutShape::Cone) continue;  // never holds a box
      scene::Cut cut = tiltedCut(shape);
      cut.invert = invert;
      cut.spares = {{3, 20.0}, {4, scene::Spare::kEndless}};
      scene.cuts.clear();
      scene::addCut(scene, cut);
      ReadyFilm film = shape == scene::CutShape::Membrane ? ReadyFilm::Membrane : ReadyFilm::Cut;
      auto takes = [&](double at, glm::dvec3 place) {
        return depthInCut(momentOf(scene, film, at).cuts[0], place) > 1e-6;
      };
      int atFirst = 0, before = 0, inTheEnd = 0, underSheet = 0;
      // As deep as a sheet may dip.
      double reach = scene::isMembrane(cut) ? 0.5 * cut.size.z : 0.0;
      scene::Cut atStart = momentOf(scene, film, 0.0).cuts[0];
      for (int i = 0; i < 9 * 9 * 9; ++i) {
        glm::dvec3 place = glm::dvec3(95, 195, 295) * glm::dvec3(i % 9, i / 9 % 9, i / 81) / 8.0;
        atFirst += takes(0.0, place);
        underSheet += reach > 0.0 && depthInCut(atStart, place) > 1e-6 - reach;
        inTheEnd += takes(1.0, place);
        for (double at : {0.2, 0.6, 0.9}) {
          before += takes(at, place);
          EXPECT_LE(takes(at, place), takes(at + 0.1, place)) << "nothing that is gone comes back";
        }
      }
      EXPECT_EQ(atFirst, 0) << enumName(shape) << invert;
      EXPECT_EQ(underSheet, 0) << "a sheet takes nothing where it dips" << invert;
      EXPECT_GT(inTheEnd, 0) << enumName(shape) << invert;
      EXPECT_LT(before, 3 * inTheEnd) << enumName(shape) << invert;
      EXPECT_EQ(momentOf(scene, film, 1.0), scene);
    }
}

TEST(CutsComeIn, AndGoOutAgainWhereThatIsAsked) {
  scene::Scene scene = boxScene({400, 300});
  scene::addCut(scene, tiltedCut(scene::CutShape::Plane));
  scene::Scene film = scene;
  addCutting(film, {1.0, 4.0}, scene.cuts[0].id, true);
  EXPECT_EQ(film.timeline.duration, 5.0);
  glm::dvec3 out = scene::sceneAt(film, 1.0).cuts[0].centre, mid = scene::sceneAt(film, 3.0).cuts[0].centre;
  EXPECT_LT(glm::distance(mid, scene.cuts[0].centre), 1.0);
  EXPECT_EQ(scene::sceneAt(film, 5.0).cuts[0].centre, out);
  EXPECT_THROW(addCutting(film, {}, 77, false), ArgumentError);
}

TEST(ReadyFilms, StructuresComeOutOneAfterTheOther) {
  scene::Scene scene = boxScene({400, 300});
  for (glm::dvec3 axis : {glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1)}) {
    scene::Cut plane;
    plane.centre = {45, 95, 145};
    plane.axis = axis;
    scene::addCut(scene, plane);
  }
  scene.cuts[0].spares = {{2, 7.5}, {3, scene::Spare::kEndless}, {5, 3.25}, {6, 0.0}};
  scene.cuts[1].spares = {{2, 11.0}};
  ASSERT_EQ(extrusionsOf(scene).size(), 3u);
  EXPECT_TRUE(extrusionsOf(momentOf(scene, ReadyFilm::Pull, 0.0)).empty());
  EXPECT_EQ(momentOf(scene, ReadyFilm::Pull, 1.0), scene);
  constexpr int kFrames = 61;
  auto distances = [](const scene::Scene& s) {
    std::vector<double> all;
    for (const auto& cut : s.cuts)
      for (const auto& spare : cut.spares) all.push_back(spare.distance);
    return all;
  };
  std::vector<double> before = distances(momentOf(scene, ReadyFilm::Pull, 0.0));
  int moves = 0;
  for (int i = 1; i < kFrames; ++i) {
    scene::Scene now = momentOf(scene, ReadyFilm::Pull, i / (kFrames - 1.0));
    std::vector<double> at = distances(now);
    int moved = 0;
    for (std::size_t k = 0; k < at.size(); ++k) {
      EXPECT_GE(at[k], before[k]) << "none goes back";
      moved += at[k] != before[k];
    }
    EXPECT_LE(moved, 1) << "of " << kFrames - 1 << " frames each structure has twenty";
    moves += moved;
    before = at;
    // Nothing else of the scene has changed.
    for (std::size_t c = 0; c < now.cuts.size(); ++c) now.cuts[c].spares = scene.cuts[c].spares;
    EXPECT_EQ(now, scene);
  }
  EXPECT_EQ(moves, kFrames - 1) << "and none rests";
  // Slowly at first: of the way of the first structure after a tenth of its time.
  EXPECT_LT(distances(momentOf(scene, ReadyFilm::Pull, 0.1 / 3))[0], 0.05 * 7.5);
}

TEST(ReadyFilms, ThereAreThoseThatASceneCanHave) {
  scene::Scene scene = cutScene();
  EXPECT_EQ(whyNoFilm(scene, ReadyFilm::Equalize), "");
  EXPECT_EQ(whyNoFilm(scene, ReadyFilm::Cut), "");
  scene.cuts[0].enabled = false;
  EXPECT_NE(whyNoFilm(scene, ReadyFilm::Cut), "");
  EXPECT_NE(whyNoFilm(scene, ReadyFilm::Equalize), "");
  scene.cuts[0].enabled = true;
  scene.model.data = {};
  EXPECT_NE(whyNoFilm(scene, ReadyFilm::Equalize), "");
  EXPECT_EQ(whyNoFilm(scene, ReadyFilm::Cut), "");
  EXPECT_NE(whyNoFilm(scene, ReadyFilm::Membrane), "");
  EXPECT_NE(whyNoFilm(scene, ReadyFilm::Fly), "");
  EXPECT_THROW(addReadyFilm(scene, ReadyFilm::Pull, {}), ArgumentError);
}

TEST(ReadyFilms, KeysOfOneTakeThePlaceOfThoseOfAnother) {
  scene::Scene scene = cutScene();
  addTurn(scene, {0.0, 8.0}, 1.0, false);
  addTurn(scene, {0.0, 8.0}, 2.0, true);
  ASSERT_EQ(scene.timeline.tracks.size(), 1u);
  EXPECT_EQ(scene.timeline.tracks[0].keys.size(), 2u);
  addCutting(scene, {8.0, 4.0}, 0, false);
  EXPECT_EQ(scene.timeline.tracks.size(), 2u);
  EXPECT_EQ(scene.timeline.duration, 12.0);
  EXPECT_TRUE(scene::tracksThatDoNotFit(scene).empty());
}

TEST(ReadyFilms, FramesOfATurnAreEvenlyApartAlsoTheLastFromTheFirst) {
  scene::Scene scene = cutScene();
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 1.5);
  for (int frames : {2, 3, 7, 24}) {
    auto eye = [&](int frame) {
      scene::Scene film = withReadyFilm(scene, ReadyFilm::Turn, frames);
      EXPECT_EQ(scene::framesOf(film.timeline).count, frames);
      scene::Camera camera = scene::sceneAt(film, scene::framesOf(film.timeline).timeOf(frame % frames)).camera;
      return camera.eye - camera.target;
    };
    double step = glm::length(eye(1) - eye(0));
    EXPECT_GT(step, 1.0) << frames;
    for (int frame = 0; frame < frames; ++frame) {
      EXPECT_NEAR(glm::length(eye(frame + 1) - eye(frame)), step, 1e-6 * step) << frame << " of " << frames;
      for (int other = 0; other < frame; ++other)
        EXPECT_GT(glm::length(eye(frame) - eye(other)), 0.5 * step) << frame << " and " << other << " of " << frames;
    }
    EXPECT_LT(glm::length(eye(0) - (scene.camera.eye - scene.camera.target)), 1e-6) << "it begins with the scene";
  }
}

TEST(ReadyFilms, GoesThroughAllTimeStepsAlike) {
  scene::Scene scene;
  Volume volume = makeVolume({2, 2, 2}, SampleType::UInt8, [](glm::ivec3) { return 1; });
  volume.timeSteps = 5;
  volume.voxels.resize(5 * timeStepBytes(volume));
  EXPECT_EQ(usualFilm(scene), ReadyFilm::Turn);
  EXPECT_NE(whyNoFilm(scene, ReadyFilm::Time), "");
  scene.volume.data = Shared<Volume>(std::move(volume));
  EXPECT_EQ(usualFilm(scene), ReadyFilm::Time);
  EXPECT_EQ(whyNoFilm(scene, ReadyFilm::Time), "");
  for (int frames : {5, 10, 3, 12}) {
    scene::Scene film = withReadyFilm(scene, ReadyFilm::Time, frames);
    std::vector<int> shown(5, 0);
    int before = 0;
    for (int frame = 0; frame < frames; ++frame) {
      int step = scene::sceneAt(film, scene::framesOf(film.timeline).timeOf(frame)).volume.timeStep;
      ASSERT_TRUE(step >= before && step < 5) << frame << " of " << frames;
      ++shown[std::size_t(step)];
      before = step;
    }
    EXPECT_GE(shown[0], 1) << frames;
    auto [least, most] = std::minmax_element(shown.begin(), shown.end());
    EXPECT_LE(*most - *least, 1) << frames << ": each is shown about as long";
  }
}

}  // namespace velum::session
