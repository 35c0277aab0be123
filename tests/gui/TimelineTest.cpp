// The film in the window, by hand: keys, the playhead, recording, playing.
#include <QContextMenuEvent>
#include <QElapsedTimer>
#include <QMenu>
#include <QTimer>
#include <QToolButton>
#include <QWheelEvent>

#include "Shots.h"
#include "WindowFixture.h"
#include "gui/kit/Theme.h"
#include "gui/rows/FieldForm.h"
#include "gui/rows/FieldKey.h"
#include "gui/timeline/TimelineRoom.h"
#include "gui/view/TimeBar.h"
#include "scene/Navigate.h"
#include "scene/timeline/SceneAt.h"
#include "scene/timeline/Tracks.h"
#include "session/command/Command.h"
#include "session/command/DocumentCommands.h"
#include "session/command/FilmCommands.h"

namespace velum::gui {
namespace {

class Timelines : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    mWindow->resize(1100, 760);
    openPhantom();
    drawSoon();
  }
  session::Document& document() { return mWindow->document(); }
  const scene::Timeline& film() { return scene().timeline; }
  TimelineStrip& strip() { return *mWindow->findChild<TimelineStrip*>("timeline"); }
  TrackCanvas& canvas() { return strip().canvas(); }
  QWidget& tracks() { return *canvas().viewport(); }
  void trigger(const char* id) { mWindow->actions().find(id)->trigger(); }
  void key(const std::string& path, double time, const std::string& value) {
    session::editKey(document(), session::SetFilmKey{path, time, value});
  }
  /// Two numbers, three keys each.
  void makeFilm() {
    for (double time : {0.0, 2.0, 6.0}) {
      key("lighting.specular", time, time == 2.0 ? "2" : "1");
      key("lighting.ambient", time, time == 6.0 ? "0.8" : "0.2");
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return strip().isVisible(); }, kPatience));
    QTest::qWait(30);
  }
  QPoint placeOf(const KeyName& name) { return canvas().placeOf(name).value_or(QPointF(-1, -1)).toPoint(); }
  std::vector<double> timesOf(const std::string& path) {
    std::vector<double> times;
    if (const scene::Track* track = scene::findTrack(film(), path))
      for (const scene::Key& one : track->keys) times.push_back(one.time);
    return times;
  }
  /// Chooses an entry of the menu that opens next.
  void chooseNext(const QString& text) {
    QTimer::singleShot(100, [text] {
      auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      ASSERT_TRUE(menu);
      takeShot(*menu, "timeline-menu");
      for (QAction* entry : menu->actions())
        if (entry->text() == text) {
          menu->setActiveAction(entry);
          QTest::keyClick(menu, Qt::Key_Return);
          return;
        }
      menu->close();
      ADD_FAILURE() << "no entry " << text.toStdString();
    });
  }
  void openMenu(QWidget& widget, QPoint place) {
    QContextMenuEvent event(QContextMenuEvent::Mouse, place, widget.mapToGlobal(place));
    QApplication::sendEvent(&widget, &event);
  }
  static constexpr const char* kShine = "lighting.specular";
  static constexpr const char* kAmbient = "lighting.ambient";
};

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

TEST_F(Timelines, ScrubbingAnswersWithinAHundredMilliseconds) {
  makeFilm();
  ASSERT_TRUE(settle());
  std::vector<double> times;
  QTest::mousePress(&tracks(), Qt::LeftButton, {}, canvas().onRuler(0.0).toPoint());
  for (int i = 1; i <= 30; ++i) {
    QElapsedTimer clock;
    clock.start();
    int shown = viewport().shownCount();
    QPointF place = canvas().onRuler(6.0 * i / 30.0);
    QMouseEvent move(QEvent::MouseMove, place, tracks().mapToGlobal(place), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&tracks(), &move);
    ASSERT_TRUE(QTest::qWaitFor([&] { return viewport().shownCount() > shown; }, kPatience));
    times.push_back(double(clock.nsecsElapsed()) * 1e-6);
  }
  QTest::mouseRelease(&tracks(), Qt::LeftButton, {}, canvas().onRuler(6.0).toPoint());
  std::sort(times.begin(), times.end());
  std::printf("scrubbing: median %.1f ms, worst %.1f ms\n", times[times.size() / 2], times.back());
  EXPECT_LT(times[times.size() / 2], 300.0) << "a hundred on a machine of our own, see AnswerTest";
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
  QPoint end(canvas().onRuler(film().duration).toPoint().x(), 22), start(canvas().onRuler(0.0).toPoint().x(), 22);
  drag(tracks(), end, {canvas().onRuler(5.0).toPoint().x(), 22});
  EXPECT_NEAR(film().rangeEnd, 5.0, 0.1);
  drag(tracks(), start, {canvas().onRuler(1.0).toPoint().x(), 22});
  EXPECT_NEAR(film().rangeStart, 1.0, 0.1);
  document().undo();
  EXPECT_EQ(film().rangeStart, 0.0) << "a drag is a step";
}

TEST_F(Timelines, PlayingKeepsTheTime) {
  makeFilm();
  ASSERT_TRUE(settle());
  auto& player = mWindow->timeline().player();
  QElapsedTimer clock;
  clock.start();
  QTest::keyClick(&viewport(), Qt::Key_Space);
  EXPECT_TRUE(player.isPlaying());
  QTest::qWait(3000);
  double passed = double(clock.nsecsElapsed()) * 1e-9;
  EXPECT_NEAR(*document().playhead(), passed, 0.1 * passed);
  QTest::keyClick(&viewport(), Qt::Key_Space);
  EXPECT_FALSE(player.isPlaying());
  double stopped = *document().playhead();
  QTest::qWait(100);
  EXPECT_EQ(document().playhead(), stopped);
  EXPECT_FALSE(document().undoLabel().empty());
}

TEST_F(Timelines, PlayingEndsWithTheRangeOrBeginsAnew) {
  makeFilm();
  session::edit(document(), session::SetField{"timeline.rangeEnd", "0.6"});
  auto& player = mWindow->timeline().player();
  player.setLooping(false);
  document().setPlayhead(0.3);
  player.setPlaying(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !player.isPlaying(); }, kPatience));
  EXPECT_NEAR(*document().playhead(), 0.6, 1e-9);
  player.setLooping(true);
  player.setPlaying(true);
  QTest::qWait(1500);
  EXPECT_TRUE(player.isPlaying());
  EXPECT_LT(*document().playhead(), 0.6);
  mWindow->newScene();
  EXPECT_FALSE(player.isPlaying());
}

TEST_F(Timelines, WhatIsDoneWhileRecordingBecomesKeys) {
  trigger("film.record");
  EXPECT_TRUE(strip().isVisible());
  EXPECT_TRUE(document().isRecording());
  EXPECT_TRUE(mWindow->findChild<QWidget*>("recordFrame")->isVisible());
  document().setPlayhead(2.0);
  ASSERT_TRUE(settle());
  drag({200, 200}, {320, 220});
  ASSERT_EQ(film().tracks.size(), 1u);
  EXPECT_EQ(film().tracks[0].path, "camera");
  EXPECT_EQ(timesOf("camera"), (std::vector<double>{0.0, 2.0}));
  takeShot(*mWindow, "timeline-recording");
  trigger("film.record");
  EXPECT_FALSE(document().isRecording());
  drag({200, 200}, {320, 220});
  EXPECT_EQ(timesOf("camera").size(), 2u) << "not recorded any more";
}

TEST_F(Timelines, AControlMakesAKeyOfItsFieldAndShowsIt) {
  ASSERT_TRUE(mWindow->tabs().showPage("Finish"));
  auto* contours = child<NumberRow>("contours");
  chooseNext("Key this");
  openMenu(*contours->spin(), {4, 4});
  ASSERT_EQ(film().tracks.size(), 1u);
  EXPECT_EQ(film().tracks[0].path, "finish.contours");
  ASSERT_TRUE(QTest::qWaitFor([&] { return strip().isVisible(); }, kPatience));
  FieldKey* mark = nullptr;
  for (auto* one : mWindow->findChildren<FieldKey*>())
    if (one->isVisible()) mark = one;
  ASSERT_TRUE(mark);
  document().setPlayhead(3.0);
  QTest::mouseClick(mark, Qt::LeftButton);
  EXPECT_EQ(timesOf("finish.contours"), (std::vector<double>{0.0, 3.0}));
  takeShot(*mWindow, "timeline-marks");
  QTest::mouseClick(mark, Qt::LeftButton);
  EXPECT_EQ(timesOf("finish.contours"), std::vector<double>{0.0});
}

TEST_F(Timelines, TheWayOfTheEyeIsSeenFromElsewhereAndItsKnobsAreDragged) {
  key("camera", 0.0, "");
  ASSERT_TRUE(QTest::qWaitFor([&] { return strip().isVisible(); }, kPatience));
  document().setPlayhead(4.0);
  viewport().lookFrom(scene::StandardView::Left);
  key("camera", 4.0, "");
  const CameraPath& path = mWindow->timeline().cameraPath();
  EXPECT_FALSE(path.isShown()) << "the film's own view looks along it";
  viewport().lookFrom(scene::StandardView::Superior);
  document().view([](scene::Scene& scene) { scene.camera = scene::zoom(scene.camera, 4.0); });
  ASSERT_TRUE(path.isShown());
  ASSERT_TRUE(settle());
  takeShot(*mWindow, "timeline-path");
  std::vector<glm::dvec3> eyes = path.keyEyes();
  ASSERT_EQ(eyes.size(), 2u);
  scene::Camera from = document().shown().camera;
  glm::dvec2 at = scene::pixelFromWorld(from, size(), eyes[1]).value();
  std::size_t steps = document().undoLabels().size();
  QPoint place(int(std::lround(at.x)), int(std::lround(at.y))), off(30, -20);
  drag(place, place + off);
  EXPECT_EQ(document().undoLabels().size(), steps + 1);
  EXPECT_EQ(document().shown().camera, from) << "the view stays";
  scene::CameraBasis basis = scene::cameraBasis(from);
  glm::dvec3 wanted = eyes[1] + scene::lengthPerPixel(from, size(), eyes[1]) * (basis.right * 30.0 + basis.up * 20.0);
  EXPECT_LT(glm::length(scene::sceneAt(scene(), 4.0).camera.eye - wanted), 1e-6 * glm::length(wanted));
  EXPECT_EQ(scene::sceneAt(scene(), 0.0).camera.eye, eyes[0]);
  document().undo();
  EXPECT_LT(glm::length(scene::sceneAt(scene(), 4.0).camera.eye - eyes[1]), 1e-9);
}

TEST_F(Timelines, TheStripIsNotWiderThanASmallWindow) {
  makeFilm();
  mWindow->resize(720, 560);
  QTest::qWait(60);
  EXPECT_LE(mWindow->width(), 760);
  takeShot(*mWindow, "timeline-small");
}

TEST_F(Timelines, HowItLooks) {
  mWindow->resize(1440, 900);
  makeFilm();
  key("camera", 0.0, "");
  document().setPlayhead(5.0);
  mWindow->viewport().lookFrom(scene::StandardView::Left);
  key("camera", 5.0, "");
  canvas().goToKey(-1);
  for (auto kind : {ThemeKind::Dark, ThemeKind::Light}) {
    applyTheme(*qApp, kind);
    settle();
    takeShot(*mWindow, kind == ThemeKind::Dark ? "timeline-dark" : "timeline-light");
  }
  applyTheme(*qApp);
}

}  // namespace
}  // namespace velum::gui
