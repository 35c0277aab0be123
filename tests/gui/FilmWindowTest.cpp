// A film in the window: played, recorded, keyed from controls, seen in the 3D view.
#include <QDockWidget>
#include <QSet>
#include <QStatusBar>

#include "TimelineFixture.h"

namespace velum::gui {
namespace {

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

TEST_F(Timelines, PlayingKeepsTheTime) {
  makeFilm();
  ASSERT_TRUE(settle());
  TimelineRoom& room = mWindow->timeline();
  QElapsedTimer clock;
  clock.start();
  QTest::keyClick(&viewport(), Qt::Key_Space);
  EXPECT_TRUE(room.isPlaying());
  QTest::qWait(3000);
  double passed = double(clock.nsecsElapsed()) * 1e-9;
  EXPECT_NEAR(*document().playhead(), passed, 0.1 * passed);
  QTest::keyClick(&viewport(), Qt::Key_Space);
  EXPECT_FALSE(room.isPlaying());
  double stopped = *document().playhead();
  QTest::qWait(100);
  EXPECT_EQ(document().playhead(), stopped);
  EXPECT_FALSE(document().undoLabel().empty());
}

TEST_F(Timelines, PlayingEndsWithTheRangeOrBeginsAnew) {
  makeFilm();
  session::edit(document(), session::SetField{"timeline.rangeEnd", "0.6"});
  TimelineRoom& room = mWindow->timeline();
  document().setPlayhead(0.3);
  room.setPlaying(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !room.isPlaying(); }, kPatience));
  EXPECT_NEAR(*document().playhead(), 0.6, 1e-9);
  trigger("film.loop");
  room.setPlaying(true);
  QTest::qWait(1500);
  EXPECT_TRUE(room.isPlaying());
  EXPECT_LT(*document().playhead(), 0.6);
  trigger("film.loop");
  mWindow->newScene();
  EXPECT_FALSE(room.isPlaying());
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

TEST_F(Timelines, RecordingByACommandIsSeenAtOnce) {
  makeFilm();
  QStatusBar* bar = mWindow->statusBar();
  auto* frame = mWindow->findChild<QWidget*>("recordFrame");
  QAction* record = mWindow->actions().find("film.record");
  bar->clearMessage();
  mWindow->jobs().run(session::parseCall("film.record"));
  EXPECT_TRUE(record->isChecked());
  EXPECT_TRUE(frame->isVisible());
  EXPECT_EQ(bar->currentMessage(), "") << "these keys were there before";
  key(kShine, 1.0, "1.5");
  EXPECT_TRUE(bar->currentMessage().startsWith("Recorded at")) << bar->currentMessage().toStdString();
  mWindow->jobs().run(session::parseCall("film.record false"));
  EXPECT_FALSE(record->isChecked());
  EXPECT_FALSE(frame->isVisible());
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
  for (QWidget* above = mark; above; above = above->parentWidget())
    if (auto* page = qobject_cast<QScrollArea*>(above)) page->ensureWidgetVisible(mark);
  ASSERT_TRUE(settle());
  takeShot(*mWindow, "timeline-marks");
  QTest::mouseClick(mark, Qt::LeftButton);
  EXPECT_EQ(timesOf("finish.contours"), std::vector<double>{0.0});
}

TEST_F(Timelines, AControlWithoutARowOfItsOwnShowsItsKeyOverItsEnd) {
  Progress progress;
  session::run(mWindow->session(), session::parseCall("cut.add plane"), progress);
  mWindow->selection().setCut(scene().cuts[0].id);
  struct Control {
    const char *page, *path;
  };
  for (auto [page, path] : {Control{"Look", "background.top"},
                            {"Finish", "finish.structureSpheres"},
                            {"Cuts", "cuts.0.face"},
                            {"Cuts", "cuts.0.joined"}}) {
    SCOPED_TRACE(path);
    key(path, 0.0, "");
    ASSERT_TRUE(mWindow->tabs().showPage(page));
    document().setPlayhead(3.0);
    ASSERT_TRUE(settle());
    std::string track = scene::stablePath(scene(), path);
    FieldKey* mark = nullptr;
    for (auto* one : mWindow->findChildren<FieldKey*>())
      if (one->isVisible() && !one->parentWidget()->layout()) mark = one;
    ASSERT_TRUE(mark);
    QWidget& control = *mark->parentWidget();
    EXPECT_TRUE(control.rect().contains(mark->geometry()));
    for (QWidget* above = mark; above; above = above->parentWidget())
      if (auto* area = qobject_cast<QScrollArea*>(above)) area->ensureWidgetVisible(mark);
    takeShot(*mWindow, QString("key-over-%1").arg(QString(path).section('.', -1)));
    if (control.isEnabled()) {
      QTest::mouseClick(mark, Qt::LeftButton);
      EXPECT_EQ(timesOf(track), (std::vector<double>{0.0, 3.0}));
      QTest::mouseClick(mark, Qt::LeftButton);
      EXPECT_EQ(timesOf(track), std::vector<double>{0.0});
    }
    session::run(mWindow->session(), session::parseCall("film.clear"), progress);
    EXPECT_FALSE(mark->isVisible());
  }
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

TEST_F(Timelines, WhatHasNoRoomInTheStripIsInItsMenus) {
  makeFilm();
  auto* dock = mWindow->findChild<QDockWidget*>("sideDock");
  for (int width : {1100, 620, 390, 300, 210}) {
    mWindow->resize(width + dock->width() + 20, 620);
    QTest::qWait(60);
    mWindow->resizeDocks({dock}, {mWindow->width() - width}, Qt::Horizontal);
    QTest::qWait(60);
    SCOPED_TRACE(strip().width());
    takeShot(*mWindow, QString("timeline-%1").arg(width));
    QSet<QString> listed;
    for (auto* more : strip().findChildren<QToolButton*>("more")) {
      if (!more->isVisible()) continue;
      emit more->menu()->aboutToShow();
      for (QAction* entry : more->menu()->actions()) listed << entry->text().remove('&');
    }
    for (auto* line : strip().findChildren<StripLine*>())
      for (QWidget* control : line->findChildren<QWidget*>(Qt::FindDirectChildrenOnly)) {
        if (!control->isHidden()) {
          EXPECT_GE(control->width(), control->minimumSizeHint().width()) << control->accessibleName().toStdString();
          EXPECT_TRUE(strip().rect().contains(QRect(control->mapTo(&strip(), QPoint()), control->size())))
              << control->accessibleName().toStdString();
        } else if (auto* button = qobject_cast<QToolButton*>(control); button && button->menu() == nullptr) {
          EXPECT_TRUE(listed.contains(button->accessibleName())) << button->accessibleName().toStdString();
          EXPECT_FALSE(button->toolTip().isEmpty());
        }
      }
    EXPECT_EQ(listed.isEmpty(), width > 600) << "only what has no room is there";
  }
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
