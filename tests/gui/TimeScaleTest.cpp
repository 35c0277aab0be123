// Where times stand on the ruler of a film, and what becomes of keys that are moved together.
#include <gtest/gtest.h>

#include <cmath>

#include "gui/timeline/KeyEdit.h"
#include "gui/timeline/TimeScale.h"
#include "scene/timeline/Tracks.h"

namespace velum::gui {
namespace {

TEST(TimeScales, ATimeAndItsPixelAreEachOthersOwn) {
  TimeScale scale{3.0, 47.0, 200.0};
  for (double time : {0.0, 3.0, 7.25, 86'400.0}) EXPECT_NEAR(scale.timeAt(scale.xOf(time)), time, 1e-9);
  EXPECT_EQ(scale.xOf(3.0), 200.0);
}

TEST(TimeScales, NumbersOfTheRulerHaveRoomAndLieOnFrames) {
  for (double pixels = 0.003; pixels < 20'000.0; pixels *= 1.7)
    for (double rate : {24.0, 25.0, 30.0, 60.0}) {
      double step = rulerStep({0.0, pixels, 0.0}, 58.0, rate);
      EXPECT_GE(step * pixels, 58.0 * (1.0 - 1e-9)) << pixels;
      EXPECT_GE(step, 1.0 / rate - 1e-12);
    }
}

TEST(TimeScales, WhatTheRulerSaysTellsItsNumbersApart) {
  for (double step : {0.1, 0.2, 0.5, 1.0, 2.0, 10.0, 15.0, 60.0, 600.0})
    for (int i = 0; i < 20; ++i) EXPECT_NE(rulerText(i * step, step), rulerText((i + 1) * step, step)) << step;
  EXPECT_EQ(rulerText(90.0, 30.0), "1:30");
  EXPECT_EQ(rulerText(2.5, 0.5), "2.5");
}

TEST(TimeScales, AZoomKeepsTheTimeThatItIsAbout) {
  TimeScale scale{10.0, 50.0, 200.0};
  for (double factor : {0.8, 1.25, 4.0}) {
    TimeScale next = zoomed(scale, 14.0, factor);
    EXPECT_NEAR(next.xOf(14.0), scale.xOf(14.0), 1e-9);
    EXPECT_NEAR(next.pixelsPerSecond, 50.0 * factor, 1e-9);
  }
}

Tracks twoTracks() {
  scene::Timeline film;
  for (double time : {0.0, 1.0, 2.0}) scene::setKey(film, "camera", time, {std::to_string(time)});
  scene::setKey(film, "timeline.orbitDeg", 1.0, {"5"}).ease = scene::Ease::Hold;
  return film.tracks;
}

std::vector<double> timesOf(const scene::Track& track) {
  std::vector<double> times;
  for (const scene::Key& key : track.keys) times.push_back(key.time);
  return times;
}

TEST(KeyEdits, KeysThatMoveTogetherKeepTheirDistancesValuesAndEases) {
  Tracks moved = withMoved(twoTracks(), {{"camera", 1.0}, {"camera", 2.0}, {"timeline.orbitDeg", 1.0}}, 1.5, false);
  EXPECT_EQ(timesOf(moved[0]), (std::vector<double>{0.0, 2.5, 3.5}));
  EXPECT_EQ(moved[0].keys[1].value.json, std::to_string(1.0));
  EXPECT_EQ(timesOf(moved[1]), std::vector<double>{2.5});
  EXPECT_EQ(moved[1].keys[0].ease, scene::Ease::Hold);
}

TEST(KeyEdits, KeysThatMovePastOthersPassThemAndReplaceWhatTheyMeet) {
  EXPECT_EQ(timesOf(withMoved(twoTracks(), {{"camera", 0.0}}, 1.5, false)[0]), (std::vector<double>{1.0, 1.5, 2.0}));
  Tracks met = withMoved(twoTracks(), {{"camera", 0.0}}, 1.0, false);
  EXPECT_EQ(timesOf(met[0]), (std::vector<double>{1.0, 2.0}));
  EXPECT_EQ(met[0].keys[0].value.json, std::to_string(0.0));
}

TEST(KeyEdits, ACopyLeavesTheKeyAndAMoveByNothingChangesNothing) {
  EXPECT_EQ(timesOf(withMoved(twoTracks(), {{"camera", 2.0}}, 1.0, true)[0]),
            (std::vector<double>{0.0, 1.0, 2.0, 3.0}));
  EXPECT_EQ(withMoved(twoTracks(), {{"camera", 2.0}, {"camera", 0.0}}, 0.0, false), twoTracks());
}

TEST(KeyEdits, NoneIsMovedOutOfTheFilm) {
  KeyNames keys{{"camera", 1.0}, {"camera", 2.0}};
  EXPECT_EQ(movable(keys, -5.0, 8.0), -1.0);
  EXPECT_EQ(movable(keys, 50.0, 8.0), 6.0);
  EXPECT_EQ(movable(keys, 0.5, 8.0), 0.5);
  EXPECT_EQ(movable(keys, 0.5, 1.5), 0.0) << "the film is shorter than its keys";
}

TEST(KeyEdits, APasteBeginsWhereItIsAskedFor) {
  Tracks pasted = withPasted(twoTracks(), clipsOf(twoTracks(), {{"camera", 1.0}, {"camera", 2.0}}), 5.0);
  EXPECT_EQ(timesOf(pasted[0]), (std::vector<double>{0.0, 1.0, 2.0, 5.0, 6.0}));
}

TEST(KeyEdits, ATrackGoesWithItsLastKey) {
  EXPECT_EQ(withoutKeys(twoTracks(), {{"timeline.orbitDeg", 1.0}}).size(), 1u);
  EXPECT_EQ(withoutKeys(twoTracks(), {{"camera", 7.0}}), twoTracks()) << "a key that is not there";
}

}  // namespace
}  // namespace velum::gui
