// Membranes over time: the sheet follows what moves.
#include <algorithm>
#include <cmath>
#include <functional>

#include "GlFixture.h"
#include "io/phantoms/Sample.h"
#include "makeVolume.h"
#include "membrane/sheet/SheetIndex.h"
#include "membrane/sheet/Simulation.h"
#include "openedHeart.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/MembraneMover.h"
#include "session/membrane/Membranes.h"

namespace velum::session {

namespace {

constexpr int kMembranesTimeSteps = 8;

class MembranesTimeGL : public GlTest {
 protected:
  static scene::Scene heart(scene::Repositioning repositioning) {
    static const Shared<Volume> volume(io::makeSample("heart", 56, sProgress, kMembranesTimeSteps).volume);
    return openedHeart(volume, repositioning);
  }
  struct Beat {
    std::vector<scene::SheetShape> shapes;
    std::vector<double> ratios;
  };
  /// A beat and the first step again.
  static Beat beat(scene::Repositioning repositioning) {
    scene::Scene scene = heart(repositioning);
    Beat beat;
    for (int step = 0; step <= kMembranesTimeSteps; ++step) {
      scene.volume.timeStep = step % kMembranesTimeSteps;
      auto reports = settleMembranes(scene, {true, false}, sProgress);
      beat.ratios.push_back(reports.at(0).kept->ratio);
      beat.shapes.push_back(scene.cuts[0].membrane->shape);
    }
    return beat;
  }
  /// Mean distance along the normal between two sheets in one frame, mm.
  static double distance(const scene::SheetShape& a, const scene::SheetShape& b) {
    membrane::HeightOver first = membrane::heightOf(a), second = membrane::heightOf(b);
    double sum = 0;
    constexpr int kPlaces = 60;
    for (int y = 0; y < kPlaces; ++y)
      for (int x = 0; x < kPlaces; ++x) {
        glm::dvec2 at = (glm::dvec2(x, y) / (kPlaces - 1.0) - 0.5) * glm::dvec2(165, 140);
        sum += std::abs(first(at) - second(at));
      }
    return sum / (kPlaces * kPlaces);
  }
  inline static Progress sProgress;
};

TEST_F(MembranesTimeGL, ASheetThatFollowsABeatCutsLittleInEachOfItsSteps) {
  Beat passive = beat(scene::Repositioning::Passive), active = beat(scene::Repositioning::Active);
  EXPECT_EQ(distance(passive.shapes[0], active.shapes[0]), 0.0) << "both start from flat";
  double passiveWay = 0, activeWay = 0;
  for (std::size_t i = 0; i < active.shapes.size(); ++i) {
    EXPECT_LT(active.ratios[i], 0.03) << "step " << i;
    EXPECT_EQ(active.shapes[i].timeStep, int(i) % kMembranesTimeSteps);
    if (i == 0) continue;
    double way = distance(active.shapes[i - 1], active.shapes[i]);
    EXPECT_GT(way, 0.01) << "it stands still while the heart beats";
    activeWay += way;
    passiveWay += distance(passive.shapes[i - 1], passive.shapes[i]);
  }
  EXPECT_LE(activeWay, passiveWay);
  EXPECT_LT(distance(active.shapes.front(), active.shapes.back()), 0.25 * activeWay) << "the beat goes round";
}

/// A ball that moves through the section. @param heightOf  of its middle, voxels, by time step
scene::Scene movingBall(scene::Repositioning repositioning, int frames, const std::function<double(int)>& heightOf) {
  glm::ivec3 dims(40, 40, 40);
  Volume volume;
  for (int frame = 0; frame < frames; ++frame) {
    Volume step = makeVolume(
        dims, SampleType::Int16,
        [&](glm::ivec3 p) {
          return glm::length(glm::dvec3(p) - glm::dvec3(20, 20, heightOf(frame))) < 6 ? 800.0 : 0.0;
        },
        centredFrame(dims));
    if (frame == 0)
      volume = step;
    else
      volume.voxels.insert(volume.voxels.end(), step.voxels.begin(), step.voxels.end());
  }
  volume.timeSteps = frames;
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(std::move(volume));
  scene::Cut cut;
  cut.id = 1;
  cut.shape = scene::CutShape::Membrane;
  cut.membrane.emplace();
  cut.axis = {0, 0, 1};
  cut.size = {38, 38, 34};
  cut.membrane->cloth.particles = {30, 30};
  cut.membrane->repositioning = repositioning;
  cut.membrane->field.byValue = {{500, 400}, {1000, 400}};
  cut.membrane->field.side = scene::MembraneSide::Nearest;
  scene.cuts = {cut};
  return scene;
}

/// A layer and a half from one time step to the next.
scene::Scene risingBall(scene::Repositioning repositioning) {
  return movingBall(repositioning, 7, [](int frame) { return 15.0 + 1.5 * frame; });
}

/// Up through the section and down again, as what beats: the shorter way round it is above at first, then below.
scene::Scene beatingBall(scene::Repositioning repositioning) {
  return movingBall(repositioning, 8, [](int frame) { return 19.5 - 4.5 * std::cos(2.0 * M_PI * frame / 8.0); });
}

TEST_F(MembranesTimeGL, AnActiveSheetStaysOnItsSideOfWhatRises) {
  // It passes over the ball at first, as the shorter way. Later that is under it: a passive sheet changes over.
  for (auto repositioning : {scene::Repositioning::Passive, scene::Repositioning::Active}) {
    scene::Scene scene = risingBall(repositioning);
    double middle = 0;
    for (int step = 0; step < scene.volume.data->timeSteps; ++step) {
      scene.volume.timeStep = step;
      auto report = settleMembranes(scene, {true, false}, sProgress).at(0);
      EXPECT_EQ(report.kept->cutAreaMembrane, 0) << enumName(repositioning) << " at step " << step;
      middle = membrane::heightOf(scene.cuts[0].membrane->shape)({0, 0});
      EXPECT_TRUE(step > 0 || middle > 1.0) << middle;
    }
    EXPECT_EQ(middle > 0, repositioning == scene::Repositioning::Active) << middle;
  }
}

TEST_F(MembranesTimeGL, AnActiveSheetKeepsItsSideOverTwoRoundsOfABeat) {
  scene::Scene scene = beatingBall(scene::Repositioning::Active);
  int steps = scene.volume.data->timeSteps;
  std::vector<double> middles;
  for (int step = 0; step < 2 * steps; ++step) {
    scene.volume.timeStep = step % steps;
    auto report = settleMembranes(scene, {true, false}, sProgress).at(0);
    EXPECT_EQ(report.kept->cutAreaMembrane, 0) << "at step " << step;
    middles.push_back(membrane::heightOf(scene.cuts[0].membrane->shape)({0, 0}));
    EXPECT_GT(middles.back(), 1.0) << "at step " << step;
  }
  // The second round is as the first one; the very first step alone began from flat.
  for (int step = 1; step < steps; ++step)
    EXPECT_NEAR(middles[std::size_t(step)], middles[std::size_t(step + steps)], 1.0) << "at step " << step;
}

TEST_F(MembranesTimeGL, WindowsFollowAsPicturesDo) {
  for (auto repositioning : {scene::Repositioning::Passive, scene::Repositioning::Active}) {
    scene::Scene picture = risingBall(repositioning), window = picture;
    MembraneMover player;
    for (int step = 0; step < 4; ++step) {
      picture.volume.timeStep = window.volume.timeStep = step;
      settleMembranes(picture, {}, sProgress);
      player.follow(window);
      EXPECT_TRUE(player.isOnItsWay());
      for (int i = 0; i < 3000 && player.isOnItsWay(); ++i) {
        if (auto work = player.nextWork()) player.endWork(work(sProgress));
        player.advance(20.0);
      }
      for (const auto& rest : player.takeRests()) scene::findCut(window, rest.cut)->membrane->shape = rest.shape;
      // A window fits what it keeps to the frame's rim, as drawing does; what is left is rounding.
      const scene::Cut& cut = picture.cuts[0];
      scene::SheetShape a = membrane::fitShape(cut.membrane->shape, cut.membrane->cloth.particles, cut.size);
      scene::SheetShape b = player.withShapes(window).cuts[0].membrane->shape;
      ASSERT_EQ(a.places.size(), b.places.size());
      float most = 0;
      for (std::size_t i = 0; i < a.places.size(); ++i) most = std::max(most, glm::length(a.places[i] - b.places[i]));
      EXPECT_LT(most, 0.01f) << enumName(repositioning) << " at step " << step;
    }
    player.releaseGpu();
  }
}

TEST_F(MembranesTimeGL, ATimeStepThatHasBeenSeenNeedsNoKernelsAgain) {
  scene::Scene scene = heart(scene::Repositioning::Passive);
  MembraneMover player;
  std::vector<double> ms;
  for (int step : {0, 1, 2, 0, 1}) {
    scene.volume.timeStep = step;
    player.follow(scene);
    auto work = player.nextWork();
    ASSERT_TRUE(work);
    player.endWork(work(sProgress));
    ms.push_back(player.status(1)->forcesMs);
  }
  EXPECT_GT(std::min({ms[0], ms[1], ms[2]}), 0.0);
  EXPECT_EQ(ms[3], 0.0);
  EXPECT_EQ(ms[4], 0.0);
  scene.volume.data = Shared<Volume>(*scene.volume.data);
  player.follow(scene);
  player.endWork(player.nextWork()(sProgress));
  EXPECT_GT(player.status(1)->forcesMs, 0.0) << "of other data";
  player.releaseGpu();
}

TEST_F(MembranesTimeGL, ASavedSheetGoesOnFromItsTimeStep) {
  scene::Scene scene = risingBall(scene::Repositioning::Active);
  settleMembranes(scene, {}, sProgress);
  scene.volume.timeStep = 1;
  MembraneMover player;
  player.follow(scene);
  EXPECT_TRUE(player.isOnItsWay()) << "the shape is of another step";
  scene.volume.timeStep = 0;
  MembraneMover same;
  same.follow(scene);
  EXPECT_FALSE(same.isOnItsWay()) << "it rests where it was saved";
}

}  // namespace
}  // namespace velum::session
