// Names of films: they go from place to place, and depend on the film and the number of the frame alone.
#include "session/film/FilmNames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "makeVolume.h"
#include "scene/Project.h"

namespace velum::session {

namespace {

constexpr glm::ivec2 kFilmSize(640, 480);
constexpr int kFilmStep = 4, kFilmFrames = 101;

/// Eight balls on a ring that turns once.
glm::dvec2 ballAt(int ball, int frame) {
  double angle = 6.283185307179586 * (ball / 8.0 + double(frame) / kFilmFrames);
  return glm::dvec2(320, 240) + 110.0 * glm::dvec2(std::cos(angle), 0.8 * std::sin(angle));
}

FilmNames::Look lookAt(int frame) {
  FilmNames::Look look;
  look.scene.lettering.names = true;
  look.scene.labels.data = Shared<LabelVolume>(makeLabels({2, 2, 2}, [](glm::ivec3) { return 1; }));
  glm::ivec2 size = kFilmSize / kFilmStep;
  look.image = {size.x, size.y, {"id", "instance", "position.X", "position.Y", "position.Z"}, {}};
  for (int ball = 0; ball < 8; ++ball)
    look.scene.labels.structures.push_back({ball + 1, "ball " + std::to_string(ball + 1)});
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      glm::dvec2 at = (glm::dvec2(x, y) + 0.5) * double(kFilmStep);
      int id = 0;
      for (int ball = 0; ball < 8; ++ball)
        if (glm::distance(at, ballAt(ball, frame)) < 30.0) id = ball + 1;
      look.image.pixels.insert(look.image.pixels.end(),
                               {float(id), id > 0 ? 0.0f : -1.0f, float(at.x), 0.0f, -float(at.y)});
    }
  return look;
}

FilmNames namesOfRing() {
  scene::FilmFrames frames;
  frames.count = kFilmFrames;
  frames.framesPerSecond = 25.0;
  return {frames, kFilmSize, kFilmStep, {}, [](int frame, Progress&) { return lookAt(frame); }};
}

scene::Scene frontOf(int frame) {
  scene::Scene scene = lookAt(frame).scene;
  scene.camera.projection = scene::Projection::Orthographic;
  return scene;
}

/// The ring with labels whose words stand at pixels; before their places things stand that are so far from the eye, at
/// 500 mm.
FilmNames namesBeside(std::vector<glm::dvec2> labels, float before) {
  scene::FilmFrames frames;
  frames.count = kFilmFrames;
  frames.framesPerSecond = 25.0;
  auto look = [labels, before](int frame, Progress&) {
    FilmNames::Look made = lookAt(frame);
    made.scene.camera.projection = scene::Projection::Orthographic;
    std::size_t channels = made.image.channels.size();
    std::vector<float> pixels;
    for (std::size_t i = 0; i < made.image.pixels.size(); i += channels) {
      pixels.insert(pixels.end(), &made.image.pixels[i], &made.image.pixels[i] + channels);
      pixels.push_back(before);
    }
    made.image.channels.push_back("Z");
    made.image.pixels = std::move(pixels);
    for (glm::dvec2 label : labels) {
      scene::PictureRay ray = scene::rayFromPixel(made.scene.camera, glm::dvec2(kFilmSize), label);
      scene::addMark(made.scene.lettering.marks, {.kind = scene::MarkKind::Label,
                                                  .points = {ray.origin + 500.0 * ray.direction},
                                                  .text = "here it is",
                                                  .wordsAt = glm::dvec2(0.0)});
    }
    return made;
  };
  return {frames, kFilmSize, kFilmStep, {}, look};
}

bool areSame(const NamesBetween& a, const NamesBetween& b) {
  auto same = [](const std::vector<NamePlace>& x, const std::vector<NamePlace>& y) {
    return std::ranges::equal(x, y, [](const NamePlace& p, const NamePlace& q) {
      return p.key == q.key && p.block.low == q.block.low && p.strength == q.strength;
    });
  };
  return a.share == b.share && same(a.from, b.from) && same(a.to, b.to);
}

}  // namespace

TEST(FilmNames, AFrameHasTheSameNamesWhateverWasDrawnBefore) {
  Progress progress;
  FilmNames inOrder = namesOfRing();
  std::vector<NamesBetween> all;
  for (int frame = 0; frame < kFilmFrames; ++frame) all.push_back(inOrder.at(frame, 0.0, frontOf(frame), progress));
  for (int frame : {99, 3, 60, 26, 100, 0}) {
    FilmNames alone = namesOfRing();
    EXPECT_TRUE(areSame(alone.at(frame, 0.0, frontOf(frame), progress), all[std::size_t(frame)])) << frame;
    EXPECT_TRUE(areSame(inOrder.at(frame, 0.0, frontOf(frame), progress), all[std::size_t(frame)])) << frame;
  }
}

TEST(FilmNames, NothingJumps) {
  Progress progress;
  FilmNames names = namesOfRing();
  constexpr double kEm = 18.0 * 0.48;
  std::vector<NamePlace> before;
  double most = 0.0, mostStrength = 0.0;
  std::size_t seen = 0;
  for (int frame = 0; frame < kFilmFrames; ++frame) {
    std::vector<NamePlace> now = placesBetween(names.at(frame, 0.0, frontOf(frame), progress), kEm);
    seen += now.size();
    for (const NamePlace& place : now) {
      auto same = std::ranges::find_if(before, [&](const NamePlace& other) {
        return other.key == place.key && glm::distance(other.block.low, place.block.low) < 12.0 * kEm;
      });
      if (same == before.end()) {
        mostStrength = std::max(mostStrength, frame == 0 ? 0.0 : place.strength);
        continue;
      }
      most = std::max(most, glm::distance(same->block.low, place.block.low));
      mostStrength = std::max(mostStrength, std::abs(place.strength - same->strength));
    }
    before = std::move(now);
  }
  EXPECT_GT(seen, std::size_t(6 * kFilmFrames)) << "of eight names";
  EXPECT_LT(most, 12.0 * kEm * 1.6 / 25.0) << "the longest way of a second, at its fastest";
  EXPECT_LT(mostStrength, 0.2) << "what comes or goes fades";
}

TEST(FilmNames, ALabelTakesThePlacesOfNamesWhereItIsDrawnOnly) {
  Progress progress;
  NamesBetween plain = namesBeside({}, 100.0f).at(0, 0.0, frontOf(0), progress);
  ASSERT_FALSE(plain.from.empty());
  glm::dvec2 at = 0.5 * (plain.from[0].block.low + plain.from[0].block.high);
  EXPECT_TRUE(areSame(namesBeside({at}, 100.0f).at(0, 0.0, frontOf(0), progress), plain)) << "it is hidden";
  EXPECT_FALSE(areSame(namesBeside({at}, 1000.0f).at(0, 0.0, frontOf(0), progress), plain)) << "it is seen";
}

}  // namespace velum::session
