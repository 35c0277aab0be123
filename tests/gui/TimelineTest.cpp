// The tracks and keys of a film under the hand.
#include <cmath>

#include "TimelineFixture.h"

namespace velum::gui {
namespace {

TEST_F(Timelines, TheStripComesByItselfAndTheFilmIsSeenWhileItIsOpen) {
  EXPECT_FALSE(strip().isVisible());
  makeFilm();
  EXPECT_EQ(document().playhead(), 0.0);
  document().setPlayhead(2.0);
  EXPECT_NEAR(document().shown().lighting.specular, 2.0, 1e-12);
  trigger("film.timeline");
  EXPECT_FALSE(strip().isVisible());
  EXPECT_FALSE(document().playhead());
  trigger("film.timeline");
  EXPECT_TRUE(strip().isVisible());
  EXPECT_EQ(document().playhead(), 2.0) << "where it was";
  mWindow->newScene();
  QTest::qWait(30);
  EXPECT_FALSE(strip().isVisible());
}

TEST_F(Timelines, ADragOverTheRulerMovesThePlayheadAndIsNoStep) {
  makeFilm();
  std::string before = document().undoLabel();
  drag(tracks(), canvas().onRuler(0.0).toPoint(), canvas().onRuler(4.0).toPoint());
  QTest::qWait(30);
  ASSERT_TRUE(document().playhead());
  EXPECT_NEAR(*document().playhead(), 4.0, 0.05);
  EXPECT_EQ(document().undoLabel(), before);
  double frames = *document().playhead() * film().framesPerSecond;
  EXPECT_NEAR(frames, std::round(frames), 1e-6) << "it goes to frames";
}

TEST_F(Timelines, ADragOfAKeyIsOneStepAndGoesToFrames) {
  makeFilm();
  std::size_t steps = document().undoLabels().size();
  drag(tracks(), placeOf({kShine, 2.0}), placeOf({kShine, 2.0}) + QPoint(83, 0));
  std::vector<double> times = timesOf(kShine);
  ASSERT_EQ(times.size(), 3u);
  EXPECT_GT(times[1], 2.3);
  EXPECT_NEAR(times[1] * 30.0, std::round(times[1] * 30.0), 1e-6);
  EXPECT_EQ(document().undoLabels().size(), steps + 1);
  EXPECT_EQ(document().undoLabel(), "Move key");
  EXPECT_EQ(canvas().selected(), (KeyNames{{kShine, times[1]}}));
  document().undo();
  EXPECT_EQ(timesOf(kShine), (std::vector<double>{0.0, 2.0, 6.0}));
}

TEST_F(Timelines, ADragWithAltCopies) {
  makeFilm();
  drag(tracks(), placeOf({kShine, 2.0}), placeOf({kShine, 2.0}) + QPoint(120, 0), Qt::LeftButton, Qt::AltModifier);
  EXPECT_EQ(timesOf(kShine).size(), 4u);
  EXPECT_EQ(timesOf(kShine)[1], 2.0);
}

TEST_F(Timelines, ABandSelectsAndDeleteRemovesInOneStep) {
  makeFilm();
  drag(tracks(), placeOf({kShine, 2.0}) - QPoint(40, 9), placeOf({kAmbient, 6.0}) + QPoint(9, 9));
  EXPECT_EQ(canvas().selected().size(), 4u);
  takeShot(strip(), "timeline-selected");
  canvas().setFocus();
  QTest::keyClick(&canvas(), Qt::Key_Delete);
  EXPECT_EQ(timesOf(kShine), std::vector<double>{0.0});
  EXPECT_EQ(timesOf(kAmbient), std::vector<double>{0.0});
  document().undo();
  EXPECT_EQ(timesOf(kAmbient).size(), 3u);
}

TEST_F(Timelines, TheMenuOfAKeySaysHowItGoesOn) {
  makeFilm();
  chooseNext("Hold");
  openMenu(tracks(), placeOf({kShine, 2.0}));
  const scene::Track* track = scene::findTrack(film(), kShine);
  EXPECT_EQ(track->keys[1].ease, scene::Ease::Hold);
  EXPECT_EQ(track->keys[0].ease, scene::Ease::Smooth);
  chooseNext("Go there");
  openMenu(tracks(), placeOf({kShine, 6.0}));
  EXPECT_EQ(document().playhead(), 6.0);
  chooseNext("Remove track");
  openMenu(tracks(), canvas().onTitle(1).toPoint());
  EXPECT_EQ(film().tracks.size(), 1u);
}

TEST_F(Timelines, ADoubleClickOnARowMakesAKeyOfWhatIsShownThere) {
  makeFilm();
  double time = 4.0, there = scene::sceneAt(scene(), time).lighting.specular;
  QPoint place(canvas().onRuler(time).toPoint().x(), placeOf({kShine, 2.0}).y());
  QTest::mouseDClick(&tracks(), Qt::LeftButton, {}, place);
  EXPECT_EQ(timesOf(kShine).size(), 4u);
  ASSERT_TRUE(document().playhead());
  EXPECT_NEAR(*document().playhead(), time, 0.05);
  EXPECT_NEAR(document().shown().lighting.specular, there, 0.05);
}

TEST_F(Timelines, KeysWithoutAMouse) {
  makeFilm();
  canvas().setFocus(Qt::TabFocusReason);
  QTest::keyClick(&canvas(), Qt::Key_Tab);
  QTest::keyClick(&canvas(), Qt::Key_Tab);
  EXPECT_EQ(canvas().selected(), (KeyNames{{kShine, 2.0}}));
  QTest::keyClick(&canvas(), Qt::Key_Right);
  QTest::keyClick(&canvas(), Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_NEAR(timesOf(kShine)[1], 2.0 + 11.0 / 30.0, 1e-9);
  QTest::keyClick(&canvas(), Qt::Key_Escape);
  document().setPlayhead(3.0);
  QTest::keyClick(&canvas(), Qt::Key_K);
  EXPECT_EQ(timesOf(kShine).size(), 4u);
  QTest::keyClick(&canvas(), Qt::Key_Period);
  EXPECT_EQ(document().playhead(), 6.0);
  trigger("film.previousKey");
  EXPECT_EQ(document().playhead(), 3.0);
  trigger("film.start");
  EXPECT_EQ(document().playhead(), 0.0);
}

TEST_F(Timelines, AnEyeSwitchesATrackOff) {
  makeFilm();
  document().setPlayhead(2.0);
  QTest::mouseClick(&tracks(), Qt::LeftButton, {}, canvas().onEye(0).toPoint());
  EXPECT_FALSE(film().tracks[0].enabled);
  EXPECT_EQ(document().shown().lighting.specular, scene().lighting.specular);
}

TEST_F(Timelines, TheEndsOfTheRangeAreDragged) {
  makeFilm();
  QPoint end(canvas().onRuler(film().duration).toPoint().x(), 26), start(canvas().onRuler(0.0).toPoint().x(), 26);
  drag(tracks(), end, {canvas().onRuler(5.0).toPoint().x(), 26});
  EXPECT_NEAR(film().rangeEnd, 5.0, 0.1);
  drag(tracks(), start, {canvas().onRuler(2.0).toPoint().x(), 26});
  // The playhead, which stands on the range's start, comes first.
  ASSERT_TRUE(QTest::qWaitFor([&] { return std::abs(document().playhead().value() - 2.0) < 0.1; }, 2000));
  EXPECT_EQ(film().rangeStart, 0.0);
  drag(tracks(), start, {canvas().onRuler(1.0).toPoint().x(), 26});
  EXPECT_NEAR(film().rangeStart, 1.0, 0.1);
  document().undo();
  EXPECT_EQ(film().rangeStart, 0.0) << "a drag is a step";
}

}  // namespace
}  // namespace velum::gui
