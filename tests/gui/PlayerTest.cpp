// The clock of the window: what keeps the time, and what leaves no frame out, on views that are slow.
#include "gui/service/Player.h"

#include <gtest/gtest.h>

#include <QTest>
#include <algorithm>

namespace velum::gui {
namespace {

/// Something with frames that notes which moments it was told to show.
struct Noted {
  scene::FilmFrames frames{0.0, 50.0, 10};
  std::vector<double> shown;
  Playable played;

  Noted() {
    played.frames = [this] { return frames; };
    played.now = [this] { return shown.empty() ? 0.0 : shown.back(); };
    played.show = [this](double moment) { shown.push_back(moment); };
  }
  /// The frames that were shown, counted from the first one.
  std::vector<int> numbers() const {
    std::vector<int> out;
    for (double moment : shown) out.push_back(int(std::lround((moment - frames.start) * frames.framesPerSecond)));
    return out;
  }
};

/// Views that take some time to show what they were told.
struct SlowViews {
  Noted& of;
  int ms;
  std::size_t told = 0;
  QElapsedTimer since{};
  bool areCurrent() {
    if (told != of.shown.size()) told = of.shown.size(), since.start();
    return since.elapsed() >= ms;
  }
};

TEST(Players, WhatWaitsForTheViewsLeavesNoFrameOut) {
  Noted series;
  series.played.keepsTime = false;
  series.played.loops = true;
  SlowViews views{series, 50};
  Player player([&] { return views.areCurrent(); });
  player.setPlaying(series.played, true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return series.shown.size() > 24; }, 20000));
  std::vector<int> numbers = series.numbers();
  for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(numbers[i], int(i % 10)) << i;
}

TEST(Players, WhatWaitsHasItsRateWhereTheViewsFollow) {
  Noted series;
  series.played.keepsTime = false;
  series.played.loops = true;
  Player player([] { return true; });
  QElapsedTimer clock;
  clock.start();
  player.setPlaying(series.played, true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return series.shown.size() > 50; }, 20000));
  EXPECT_GE(clock.elapsed(), 990) << "50 steps of 20 ms";
}

TEST(Players, WhatKeepsTheTimeLeavesFramesOutAndEndsAtItsEnd) {
  Noted film;
  SlowViews views{film, 45};
  Player player([&] { return views.areCurrent(); });
  QElapsedTimer clock;
  clock.start();
  player.setPlaying(film.played, true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !player.isPlaying(); }, 20000));
  EXPECT_GE(clock.elapsed(), 199) << "10 frames of 20 ms";
  EXPECT_EQ(film.shown.back(), film.frames.timeOf(10));
  EXPECT_LT(film.shown.size(), 8u);
  EXPECT_TRUE(std::ranges::is_sorted(film.shown));
}

TEST(Players, GoOnFromWhereSomebodyHasMovedThemTo) {
  Noted film;
  film.frames.count = 1000;
  Player player([] { return true; });
  player.setPlaying(film.played, true);
  film.shown.push_back(10.0);
  std::size_t moved = film.shown.size();
  ASSERT_TRUE(QTest::qWaitFor([&] { return film.shown.size() > moved + 3; }, 20000));
  EXPECT_LT(film.shown[moved], 12.0);
  EXPECT_GE(film.shown[moved], 10.0);
}

TEST(Players, BeginAtWhatIsShownAndAtTheFirstFrameWhereThatIsTheEnd) {
  Noted film;
  film.frames = {2.0, 50.0, 10};
  Player player([] { return true; });
  auto begins = [&](double at) {
    film.shown = {at};
    player.setPlaying(film.played, true);
    player.stop();
    return film.shown.back();
  };
  EXPECT_EQ(begins(2.1), 2.1);
  for (double outside : {0.0, 1.99, 2.18, 2.2, 7.0}) EXPECT_EQ(begins(outside), 2.0) << outside;
}

TEST(Players, PlayOneThingAtATimeAndNothingWithoutFrames) {
  Noted film, series, none;
  none.frames.count = 0;
  Player player([] { return true; });
  player.setPlaying(film.played, true);
  player.setPlaying(none.played, true);
  EXPECT_TRUE(player.isPlaying(film.played)) << "nothing begins, so nothing ends";
  player.setPlaying(series.played, true);
  EXPECT_FALSE(player.isPlaying(film.played));
  player.setPlaying(film.played, false);
  EXPECT_TRUE(player.isPlaying(series.played));
  series.frames.count = 0;
  player.refresh();
  EXPECT_FALSE(player.isPlaying());
  EXPECT_TRUE(none.shown.empty());
}

}  // namespace
}  // namespace velum::gui
