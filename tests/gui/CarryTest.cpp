// The scene and its film over other data, by the dialog of the File menu.
#include "FilmFixture.h"
#include "gui/window/CarryDialog.h"
#include "io/phantoms/Sample.h"

namespace velum::gui {
namespace {

class Carries : public FilmFixture {
 protected:
  /// The same phantom twice as large and elsewhere.
  void SetUp() override {
    FilmFixture::SetUp();
    Progress progress;
    io::Sample sample = io::makeSample("two-spheres", 32, progress);
    glm::dmat4 frame = sample.volume.worldFromVoxel;
    for (int i = 0; i < 3; ++i) frame[i] *= 2.0;
    frame[3] = glm::dvec4(glm::dvec3(frame[3]) * 2.0 + glm::dvec3(100, 0, 0), 1.0);
    sample.volume.worldFromVoxel = frame;
    io::writeVolume(sample.volume, *sFolder / "other.nrrd", progress);
    LabelVolume labels(sample.labels.dims(), frame);
    std::vector<std::uint16_t> ids(std::size_t(labels.dims().x) * labels.dims().y * labels.dims().z);
    sample.labels.read({0, 0, 0}, labels.dims(), ids);
    labels.write({0, 0, 0}, labels.dims(), ids);
    labels.table = sample.labels.table;
    io::writeLabels(labels, *sFolder / "other_labels.seg.nrrd", progress);
  }
  static void fill(CarryDialog& dialog, const char* volume, const char* labels) {
    in<QLineEdit>(dialog, "carryVolume")->setText(path(volume));
    in<QLineEdit>(dialog, "carryLabels")->setText(path(labels));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !dialog.isReading(); }, kPatience));
  }
};

TEST_F(Carries, OneStepThatUndoTakesBackAndThatNoFileIsOverwrittenBy) {
  openCutPhantom();
  run("set cuts.0.centre 1,2,3");
  run("film.key cuts.0.centre 2 5,6,7");
  QString file = path("story.json");
  mWindow->saveSceneTo(file);
  run("film.at 2");
  scene::Scene before = scene();
  std::string structure = before.labels.structures[0].name;
  int shown = inDialog<CarryDialog>("file.carry", [&](CarryDialog& dialog) {
    auto* carry = in<QAbstractButton>(dialog, "carry");
    EXPECT_FALSE(carry->isEnabled()) << "there is no volume yet";
    fill(dialog, "other.nrrd", "other_labels.seg.nrrd");
    auto* by = in<QComboBox>(dialog, "carryStructure");
    EXPECT_EQ(by->count(), 1 + int(before.labels.structures.size()));
    for (auto theme : {ThemeKind::Dark, ThemeKind::Light}) {
      applyTheme(*qApp, theme);
      takeShot(dialog, QString("carry-%1").arg(theme == ThemeKind::Dark ? "dark" : "light"));
    }
    by->setCurrentIndex(by->findData(QString::fromStdString(structure)));
    EXPECT_TRUE(carry->isEnabled());
    by->setCurrentIndex(0);
    carry->click();
  });
  EXPECT_EQ(shown, 1);
  ASSERT_TRUE(waitForJob());
  EXPECT_EQ(mWindow->lastError(), "");
  EXPECT_EQ(scene().volume.source.path, path("other.nrrd").toStdString());
  EXPECT_LT(glm::distance(scene().cuts[0].centre, glm::dvec3(102, 4, 6)), 1e-6);
  EXPECT_LT(glm::distance(document().shown().cuts[0].centre, glm::dvec3(110, 12, 14)), 1e-6) << "still at the playhead";
  EXPECT_EQ(document().lastCommandLines(), std::vector<std::string>{"scene.carry " + path("other.nrrd").toStdString() +
                                                                    " " + path("other_labels.seg.nrrd").toStdString()});
  // The file of the scene before is not this one's.
  session::WorkFile& work = mWindow->session().file();
  EXPECT_EQ(work.scenePath(), "");
  EXPECT_EQ(work.name(), "other.nrrd");
  action("edit.undo")->trigger();
  EXPECT_TRUE(scene() == before);
  EXPECT_EQ(work.scenePath(), file.toStdString());
  action("edit.redo")->trigger();
  EXPECT_EQ(work.scenePath(), "");
  mWindow->saveSceneTo(path("other.json"));
  EXPECT_EQ(work.scenePath(), path("other.json").toStdString());
  action("edit.undo")->trigger();
  EXPECT_EQ(work.scenePath(), "") << "of other data than either file";
}

TEST_F(Carries, WhatCannotBeIsSaidAndChangesNothing) {
  EXPECT_FALSE(action("file.carry")->isEnabled()) << "nothing is open";
  openPhantom();
  scene::Scene before = scene();
  QFile notes(path("notes.txt"));
  ASSERT_TRUE(notes.open(QIODevice::WriteOnly) && notes.write("words") == 5);
  notes.close();
  inDialog<CarryDialog>("file.carry", [&](CarryDialog& dialog) {
    auto* carry = in<QAbstractButton>(dialog, "carry");
    in<QLineEdit>(dialog, "carryVolume")->setText(path("nothing.nrrd"));
    EXPECT_FALSE(carry->isEnabled());
    EXPECT_TRUE(in<QLabel>(dialog, "carrySaid")->text().contains("nothing.nrrd"));
    in<QLineEdit>(dialog, "carryVolume")->setText(notes.fileName());
    carry->click();
  });
  ASSERT_TRUE(waitForJob());
  EXPECT_TRUE(mWindow->lastError().contains("notes.txt")) << mWindow->lastError().toStdString();
  EXPECT_TRUE(scene() == before);
  EXPECT_FALSE(document().canUndo());
}

}  // namespace
}  // namespace velum::gui
