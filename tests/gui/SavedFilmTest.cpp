// Films as the window writes them.
#include <QProcess>

#include "FilmFixture.h"
#include "RunBatch.h"

namespace velum::gui {
namespace {

class SavedFilm : public FilmFixture {};

TEST_F(SavedFilm, TurntableIsAVideoAfterThreeActions) {
  if (!hasFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed: apt install ffmpeg";
  openPhantom();
  drawSoon();
  run("set timeline.framesPerSecond 2");
  Preferences().setValue("film/folder", path(""));
  Preferences().setValue("film/size", QSize(96, 64));
  int actions = 1, saved = 0;
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&] {
    QWidget* modal = QApplication::activeModalWidget();
    if (auto* ready = qobject_cast<ReadyFilmDialog*>(modal); ready && actions == 1) {
      ++actions;
      in<QAbstractButton>(*ready, "addAndSaveFilm")->click();
    } else if (auto* save = qobject_cast<SaveFilmDialog*>(modal); save && actions == 2) {
      ++actions;
      in<QAbstractButton>(*save, "saveFilm")->click();
      ++saved;
    }
  });
  timer.start(20);
  action("film.turn")->trigger();
  EXPECT_EQ(saved, 1);
  EXPECT_EQ(actions, 3);
  ASSERT_TRUE(waitForJob());
  EXPECT_EQ(mWindow->lastError(), "");
  EXPECT_TRUE(mWindow->messages().text().contains("phantom.mp4: 16 frames"))
      << mWindow->messages().text().toStdString();
  EXPECT_EQ(bytesOf(path("phantom.mp4")).mid(4, 4), "ftyp");
  EXPECT_EQ(scene().timeline.tracks.size(), 1u);
}

TEST_F(SavedFilm, TheCopiedCommandMakesTheSameFrames) {
  openCutPhantom();
  run("set timeline.framesPerSecond 4");
  run("film.pull 1");
  session::FilmOutput output;
  QString command;
  scene::Scene film;
  inDialog<SaveFilmDialog>("film.save", [&](SaveFilmDialog& dialog) {
    dialog.setFormat(SaveFilmDialog::PngFrames);
    in<QSpinBox>(dialog, "filmWidth")->setValue(96);
    in<QSpinBox>(dialog, "filmHeight")->setValue(64);
    in<QSpinBox>(dialog, "filmSamples")->setValue(1);
    in<QSpinBox>(dialog, "filmBlur")->setValue(2);
    in<QLineEdit>(dialog, "filmPath")->setText(path("same.png"));
    command = dialog.command();
    output = dialog.output();
    film = dialog.filmScene();
    dialog.reject();
  });
  mWindow->films().saveFilmTo(output, film);
  ASSERT_TRUE(waitForJob());
  EXPECT_EQ(mWindow->lastError(), "");
  auto take = [&] {
    QList<QByteArray> frames;
    for (int i = 0; i < 4; ++i) {
      QString frame = path(qPrintable(QString("same-000%1.png").arg(i)));
      frames << bytesOf(frame);
      QFile::remove(frame);
    }
    QFile::remove(path("same.jsonl"));
    return frames;
  };
  QList<QByteArray> byWindow = take();
  EXPECT_FALSE(byWindow[0].isEmpty());
  EXPECT_NE(byWindow[0], byWindow[3]);
  QStringList words = QProcess::splitCommand(command);
  EXPECT_EQ(words.takeFirst(), "velum-batch");
  runBatch(words);
  EXPECT_TRUE(take() == byWindow) << command.toStdString();
}

TEST_F(SavedFilm, CancellingKeepsWhatIsThereAndSavingAgainGoesOn) {
  openPhantom();
  drawSoon();
  run("film.turn 4");
  session::FilmOutput output = smallOutput(path("stopped.png"));
  output.old = {true, true};
  mWindow->films().saveFilmTo(output, scene());
  ASSERT_TRUE(QTest::qWaitFor([&] { return QFile::exists(path("stopped-0002.png")); }, kPatience));
  // The user goes on meanwhile.
  run("cut.add plane");
  EXPECT_EQ(scene().cuts.size(), 1u);
  mWindow->cancelJob();
  ASSERT_TRUE(waitForJob());
  QString said = mWindow->messages().text();
  EXPECT_TRUE(said.startsWith("Stopped: ") && said.contains("of 120 frames")) << said.toStdString();
  EXPECT_EQ(mWindow->lastError(), "");
  run("undo");
  QByteArray third = bytesOf(path("stopped-0002.png"));
  run("set timeline.rangeEnd 0");
  mWindow->films().saveFilmTo(output, scene());
  ASSERT_TRUE(waitForJob());
  EXPECT_TRUE(mWindow->messages().text().contains("120 frames")) << mWindow->messages().text().toStdString();
  EXPECT_EQ(bytesOf(path("stopped-0002.png")), third);
}

}  // namespace
}  // namespace velum::gui
