// The menu Film: ready-made films and what the dialogs say.
#include "FilmFixture.h"

namespace velum::gui {
namespace {

class FilmDialogs : public FilmFixture {};

TEST_F(FilmDialogs, EachReadyMadeFilmIsOneStepThatUndoTakesBack) {
  mWindow->resize(1000, 700);
  auto add = [&](const char* kind, std::size_t tracks) {
    SCOPED_TRACE(kind);
    scene::Scene before = scene();
    std::string id = std::string("film.") + kind;
    ASSERT_TRUE(action(id.c_str())->isEnabled()) << action(id.c_str())->statusTip().toStdString();
    int shown = inDialog<ReadyFilmDialog>(id.c_str(), [&](ReadyFilmDialog& dialog) {
      EXPECT_TRUE(isDrawn(dialog.preview()));
      for (auto theme : {ThemeKind::Dark, ThemeKind::Light}) {
        applyTheme(*qApp, theme);
        takeShot(dialog, QString("film-%1-%2").arg(kind, theme == ThemeKind::Dark ? "dark" : "light"));
      }
      in<QAbstractButton>(dialog, "addFilm")->click();
    });
    EXPECT_EQ(shown, 1);
    ASSERT_TRUE(waitForJob());
    EXPECT_EQ(scene().timeline.tracks.size(), tracks);
    mWindow->actions().find("edit.undo")->trigger();
    EXPECT_TRUE(scene() == before);
  };
  openCutPhantom();
  add("turn", 1);
  add("cut", 1);
  add("compare", 1);
  add("pull", 1);
  add("fly", 1);
  add("title", 1);
  EXPECT_FALSE(action("film.time")->isEnabled());
  EXPECT_TRUE(action("film.time")->statusTip().contains("time steps"));
  EXPECT_FALSE(action("film.equalize")->isEnabled());
  EXPECT_FALSE(action("film.membrane")->isEnabled());
  run("membrane.hang");
  ASSERT_TRUE(settle());
  add("membrane", 1);
  openModel();
  run("cut.add plane");
  add("equalize", 1);
  scene::Scene beating;
  beating.volume.data = Shared<Volume>([] {
    Volume volume;
    volume.dims = glm::ivec3(8);
    volume.timeSteps = 3;
    volume.type = SampleType::UInt8;
    volume.voxels.resize(timeStepBytes(volume) * 3, std::byte(200));
    return volume;
  }());
  mWindow->showScene(beating, "beating");
  add("time", 1);
}

TEST_F(FilmDialogs, WhatCannotBeDoneIsSaidBeforeAnythingIsDrawn) {
  openCutPhantom();
  inDialog<ReadyFilmDialog>("film.title", [&](ReadyFilmDialog& dialog) {
    in<QLineEdit>(dialog, "text")->clear();
    EXPECT_TRUE(isDrawn(dialog.preview()));
    QTest::qWait(50);
    EXPECT_TRUE(in<QLabel>(dialog, "readyFilmSaid")->text().contains("words"));
    EXPECT_FALSE(in<QAbstractButton>(dialog, "addFilm")->isEnabled());
    dialog.reject();
  });
  QByteArray programs = qgetenv("PATH");
  qputenv("PATH", "/nowhere");
  inDialog<SaveFilmDialog>("film.save", [&](SaveFilmDialog& dialog) {
    auto* note = in<QLabel>(dialog, "filmNote");
    EXPECT_TRUE(note->text().contains("apt install ffmpeg")) << note->text().toStdString();
    EXPECT_FALSE(in<QAbstractButton>(dialog, "saveFilm")->isEnabled());
    EXPECT_TRUE(isDrawn(dialog.preview()));
    takeShot(dialog, "save-film-without-ffmpeg");
    dialog.setFormat(SaveFilmDialog::PngFrames);
    EXPECT_TRUE(in<QAbstractButton>(dialog, "saveFilm")->isEnabled());
    dialog.reject();
  });
  qputenv("PATH", programs);
}

TEST_F(FilmDialogs, TheDialogKnowsHowLongItIsAndRemembers) {
  openCutPhantom();
  run("film.turn 4");
  run("set timeline.rangeStart 1");
  run("set timeline.rangeEnd 3");
  inDialog<SaveFilmDialog>("film.save", [&](SaveFilmDialog& dialog) {
    auto* facts = in<QLabel>(dialog, "filmFacts");
    EXPECT_TRUE(facts->text().contains("60 frames, 2 s at 30 frames a second")) << facts->text().toStdString();
    in<QComboBox>(dialog, "filmRange")->setCurrentIndex(0);
    EXPECT_TRUE(facts->text().contains("120 frames, 4 s")) << facts->text().toStdString();
    EXPECT_TRUE(QTest::qWaitFor([&] { return facts->text().contains("to draw"); }, kPatience));
    for (auto theme : {ThemeKind::Dark, ThemeKind::Light}) {
      applyTheme(*qApp, theme);
      takeShot(dialog, QString("save-film-%1").arg(theme == ThemeKind::Dark ? "dark" : "light"));
    }
    dialog.setFormat(SaveFilmDialog::ExrFrames);
    in<QAbstractButton>(dialog, "filmLayers")->setChecked(true);
    in<QAbstractButton>(dialog, "filmSixteenBits")->setChecked(true);
    in<QSpinBox>(dialog, "filmBlur")->setValue(3);
    EXPECT_TRUE(in<QLineEdit>(dialog, "filmPath")->text().endsWith("phantom.exr"));
    EXPECT_TRUE(facts->text().contains("phantom-0000.exr")) << facts->text().toStdString();
    takeShot(dialog, "save-film-frames");
    dialog.remember();
    dialog.reject();
  });
  inDialog<SaveFilmDialog>("film.save", [&](SaveFilmDialog& dialog) {
    session::FilmOutput output = dialog.output();
    EXPECT_EQ(output.blur, 3);
    EXPECT_EQ(output.picture.bits, 16);
    EXPECT_TRUE(output.picture.layers);
    EXPECT_TRUE(output.old.resume) << "frames that are there are kept";
    dialog.setFormat(SaveFilmDialog::Mp4);
    EXPECT_FALSE(dialog.output().picture.layers) << "a video has none";
    dialog.reject();
  });
}

TEST_F(FilmDialogs, ASceneWithoutAFilmGoesOnceRound) {
  openPhantom();
  inDialog<SaveFilmDialog>("film.save", [&](SaveFilmDialog& dialog) {
    EXPECT_TRUE(in<QLabel>(dialog, "filmFacts")->text().contains("once round"));
    EXPECT_EQ(dialog.filmScene().timeline.tracks.size(), 1u);
    dialog.reject();
  });
  EXPECT_TRUE(scene().timeline.tracks.empty());
}

TEST_F(FilmDialogs, TheFilmCanBeCleared) {
  openPhantom();
  EXPECT_FALSE(action("film.clear")->isEnabled());
  run("film.turn");
  EXPECT_TRUE(action("film.clear")->isEnabled());
  action("film.clear")->trigger();
  EXPECT_TRUE(scene().timeline.tracks.empty());
  mWindow->actions().find("edit.undo")->trigger();
  EXPECT_EQ(scene().timeline.tracks.size(), 1u);
}

}  // namespace
}  // namespace velum::gui
