#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>

#include "Shots.h"
#include "WindowFixture.h"
#include "gui/kit/Preferences.h"
#include "gui/window/RawDialog.h"
#include "gui/window/VoxelSizeDialog.h"
#include "gui/window/VoxelSizeForm.h"
#include "patience.h"
#include "scene/Presets.h"

namespace velum::gui {
namespace {

/// What is said of a volume where its file says nothing, or too much.
class VolumeWays : public Window {
 protected:
  /// A ball in noise-free air, 64 x 64 x 24 samples of 16 bits, high byte first.
  QString writeRaw(const char* name) {
    std::string bytes;
    for (int z = 0; z < 24; ++z)
      for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
          double radius = std::hypot(std::hypot(x - 32.0, y - 32.0), (z - 12.0) * 2.5);
          int value = radius < 26 ? 3000 - int(radius * 40) : 100;
          bytes += char(value >> 8);
          bytes += char(value & 255);
        }
    QString path = Window::path(name);
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(bytes.data(), qint64(bytes.size())) > 0);
    return path;
  }
  template <class Dialog>
  Dialog* waitForDialog() {
    Dialog* found = nullptr;
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
          found = mWindow->findChild<Dialog*>();
          return found && found->isVisible();
        },
        20000));
    return found;
  }
  void accept(QDialog& dialog) {
    for (auto* button : dialog.findChildren<QPushButton*>())
      if (button->isDefault()) return QTest::mouseClick(button, Qt::LeftButton);
  }
};

TEST_F(VolumeWays, AFileWithoutAHeaderOpensByAGuessThatOneSees) {
  mWindow->openPaths({writeRaw("ball.raw")});
  auto* dialog = waitForDialog<RawDialog>();
  ASSERT_TRUE(dialog);
  ASSERT_TRUE(QTest::qWaitFor([&] { return dialog->hasGuessed(); }, kPatience));
  takeShot(*dialog, "raw-dialog");
  scene::RawLayout layout = dialog->source().raw;
  EXPECT_EQ(layout.dims, glm::ivec3(64, 64, 24));
  EXPECT_TRUE(layout.bigEndian);
  EXPECT_EQ(sampleSize(layout.type), 2u);
  EXPECT_FALSE(dialog->findChild<QLabel*>("rawPicture")->pixmap().isNull());
  // What does not fit cannot be opened, and says why.
  auto* z = dialog->findChild<QSpinBox*>("rawZ");
  z->setValue(25);
  EXPECT_TRUE(dialog->findChild<QLabel*>("rawFits")->text().contains("needs"));
  for (auto* button : dialog->findChildren<QPushButton*>())
    if (button->isDefault()) {
      EXPECT_FALSE(button->isEnabled());
    }
  z->setValue(24);
  auto* form = dialog->findChild<VoxelSizeForm*>();
  form->setValue({0.0002, 0.0002, 0.0005});
  accept(*dialog);
  ASSERT_TRUE(waitForJob());
  ASSERT_TRUE(scene().volume.data);
  EXPECT_EQ(scene().volume.data->dims, glm::ivec3(64, 64, 24));
  EXPECT_NEAR(spacingOf(*scene().volume.data).z, 0.0005, 1e-12);
  EXPECT_TRUE(scene().volume.data->isSpacingKnown);
}

TEST_F(VolumeWays, TheVoxelSizeIsChangedLaterAndUndone) {
  openPhantom();
  glm::dvec3 before = spacingOf(*scene().volume.data);
  scene::Camera camera = scene().camera;
  mWindow->actions().find("edit.voxelSize")->trigger();
  auto* dialog = waitForDialog<VoxelSizeDialog>();
  ASSERT_TRUE(dialog);
  takeShot(*dialog, "voxel-size");
  dialog->findChild<VoxelSizeForm*>()->setValue(before * 0.001);
  accept(*dialog);
  ASSERT_TRUE(waitForJob());
  EXPECT_NEAR(spacingOf(*scene().volume.data).x, before.x * 0.001, 1e-9);
  EXPECT_EQ(scene().volume.source.spacing, before * 0.001);
  EXPECT_NEAR(glm::length(scene().camera.eye - scene().camera.target), glm::length(camera.eye - camera.target) * 0.001,
              1e-6)
      << "the eye stays where it was, seen from the data";
  EXPECT_EQ(VoxelSizeForm::lastAnswer(), std::optional(before * 0.001));
  mWindow->document().undo();
  EXPECT_EQ(spacingOf(*scene().volume.data), before);
  EXPECT_EQ(scene().camera.eye, camera.eye);
}

TEST_F(VolumeWays, AnUnknownVoxelSizeIsAskedForAndMayWait) {
  QString raw = writeRaw("again.raw");
  scene::Source source;
  source.path = raw.toStdString();
  source.raw = {{64, 64, 24}, SampleType::UInt16, 1, true, 0};
  Progress progress;
  session::Loaded loaded = session::read({source}, progress, {});
  mWindow->showScene(loaded.scene, "again");
  auto* dialog = waitForDialog<VoxelSizeDialog>();
  ASSERT_TRUE(dialog);
  QTest::keyClick(dialog, Qt::Key_Escape);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !mWindow->findChild<VoxelSizeDialog*>(); }, kPatience));
  EXPECT_FALSE(scene().volume.data->isSpacingKnown);
}

TEST_F(VolumeWays, KnownEdgesKeepTheirLengthAsTheUnitChanges) {
  VoxelSizeForm form(nullptr);
  form.setValue({0.0003, 0.0003, 0.001});
  auto* unit = form.findChild<QComboBox*>("voxelUnit");
  EXPECT_EQ(unit->currentText(), QString::fromUtf8("\u00b5m"));
  EXPECT_DOUBLE_EQ(form.findChild<NumberField*>("voxelSizex")->value(), 0.3);
  unit->setCurrentIndex(2);
  emit unit->activated(2);
  EXPECT_DOUBLE_EQ(form.findChild<NumberField*>("voxelSizex")->value(), 300.0);
  EXPECT_NEAR(form.value().z, 0.001, 1e-15);
  form.findChild<QCheckBox*>("voxelSame")->setChecked(true);
  EXPECT_NEAR(form.value().z, 0.0003, 1e-15);
}

TEST_F(VolumeWays, NumbersThatNobodyKnewStayAsTheUnitChanges) {
  VoxelSizeForm form(nullptr);
  form.setGuess(glm::dvec3(1.0));
  auto* unit = form.findChild<QComboBox*>("voxelUnit");
  auto choose = [&](int index) {
    unit->setCurrentIndex(index);
    emit unit->activated(index);
  };
  const char* edges[] = {"voxelSizex", "voxelSizey", "voxelSizez"};
  const char* typed[] = {"2", "2", "3"};
  for (int i = 0; i < 3; ++i) form.findChild<NumberField*>(edges[i])->enter(typed[i]);
  EXPECT_EQ(form.value(), glm::dvec3(2, 2, 3));
  choose(1);
  EXPECT_EQ(form.findChild<NumberField*>(edges[0])->text(), "2");
  EXPECT_NEAR(form.value().x, 0.002, 1e-12);
  EXPECT_NEAR(form.value().z, 0.003, 1e-12);
  // Over lengths that were known, too, what is typed is a number of the unit that stands beside it.
  form.setValue(glm::dvec3(1.0));
  form.findChild<NumberField*>(edges[0])->enter("0.5");
  choose(1);
  EXPECT_NEAR(form.value().x, 0.0005, 1e-12);
  // A unit that is typed is none of the form's: the length counts, to its last digit.
  form.setGuess(glm::dvec3(1.0));
  form.findChild<NumberField*>(edges[0])->enter("0.62 um");
  EXPECT_NEAR(form.value().x, 0.00062, 1e-12);
}

TEST_F(VolumeWays, TheQuestionBeginsWithWhatMicroscopesWriteAndOffersNoAnswerThatNobodyGave) {
  Preferences().setValue("voxelSizeMm", QVariant());
  EXPECT_FALSE(VoxelSizeForm::lastAnswer());
  EXPECT_EQ(VoxelSizeForm::firstGuess(true), glm::dvec3(1e-3));
  EXPECT_EQ(VoxelSizeForm::firstGuess(false), glm::dvec3(1.0));
  {
    VoxelSizeForm form(nullptr);
    auto* usual = form.findChild<QComboBox*>("voxelUsual");
    EXPECT_EQ(usual->currentIndex(), -1);
    for (int i = 0; i < usual->count(); ++i) EXPECT_FALSE(usual->itemText(i).contains("last")) << i;
    form.setGuess(VoxelSizeForm::firstGuess(true));
    EXPECT_EQ(form.findChild<QComboBox*>("voxelUnit")->currentText(), QString::fromUtf8("\u00b5m"));
    form.setValue({0.0003, 0.0003, 0.001});
    form.remember();
  }
  VoxelSizeForm form(nullptr);
  EXPECT_TRUE(form.findChild<QComboBox*>("voxelUsual")->itemText(0).contains("0.3"));
  EXPECT_NEAR(VoxelSizeForm::firstGuess(true).z, 0.001, 1e-12);
  // An answer in millimetres is none for a microscope's file.
  form.setValue(glm::dvec3(0.7));
  form.remember();
  EXPECT_EQ(VoxelSizeForm::firstGuess(true), glm::dvec3(1e-3));
  EXPECT_EQ(VoxelSizeForm::firstGuess(false), glm::dvec3(0.7));
}

TEST_F(VolumeWays, TabGoesFromTheNumbersToTheirUnit) {
  openPhantom();
  mWindow->actions().find("edit.voxelSize")->trigger();
  auto* dialog = waitForDialog<VoxelSizeDialog>();
  ASSERT_TRUE(dialog);
  dialog->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(dialog));
  QStringList names;
  for (int i = 0; i < 5; ++i) {
    ASSERT_TRUE(dialog->focusWidget());
    names << dialog->focusWidget()->objectName();
    QTest::keyClick(dialog->focusWidget(), Qt::Key_Tab);
  }
  EXPECT_EQ(names, QStringList({"voxelSizex", "voxelSizey", "voxelSizez", "voxelUnit", "voxelUsual"}));
}

TEST_F(VolumeWays, LabelsThatAreNotWhereTheScanIsAreSaidInRed) {
  openPhantom();
  LabelVolume labels({8, 8, 8}, glm::translate(glm::dmat4(1.0), glm::dvec3(5000, 0, 0)));
  labels.write({1, 1, 1}, {4, 4, 4}, std::vector<std::uint16_t>(64, 3));
  labels.table = {{3, "elsewhere", {1, 0, 0}, 1}};
  Progress progress;
  io::writeLabels(labels, path("elsewhere.seg.nrrd").toStdString(), progress);
  mWindow->openPaths({path("elsewhere.seg.nrrd")}, true);
  ASSERT_TRUE(waitForJob());
  ASSERT_TRUE(scene().labels.data);
  takeShot(*mWindow, "labels-elsewhere");
  EXPECT_TRUE(mWindow->messages().text().contains("do not overlap the scan"))
      << mWindow->messages().text().toStdString();
  EXPECT_EQ(mWindow->messages().property("kind").toString(), "error");
  // Those that are where it is say nothing.
  mWindow->openPaths({path("phantom_labels.seg.nrrd")}, true);
  ASSERT_TRUE(waitForJob());
  EXPECT_FALSE(mWindow->messages().isVisible()) << mWindow->messages().text().toStdString();
}

TEST_F(VolumeWays, TheTableGoesWithOneClickAndComesBack) {
  // A bone-like ball and a thin plate beside it.
  Volume volume;
  volume.dims = {64, 64, 64};
  volume.type = SampleType::Int16;
  volume.modality = Modality::CT;
  for (int i = 0; i < 3; ++i) volume.worldFromVoxel[i][i] = 4.0;
  volume.voxels.resize(64 * 64 * 64 * 2);
  auto* samples = reinterpret_cast<std::int16_t*>(volume.voxels.data());
  for (int i = 0; i < 64 * 64 * 64; ++i) {
    glm::dvec3 p(i % 64, i / 64 % 64, i / 4096);
    bool isBall = glm::length(p - glm::dvec3(32, 28, 32)) < 20, isPlate = std::abs(p.y - 56.0) < 1.0;
    samples[i] = std::int16_t(isBall ? 600 : isPlate ? 300 : -1000);
  }
  computeRange(volume);
  scene::Scene shown;
  shown.volume.data = Shared<Volume>(std::move(volume));
  scene::applyPreset(shown, "ct-bone");
  mWindow->showScene(shown, "ball on a plate");
  drawSoon();
  auto* action = mWindow->actions().find("look.hideTable");
  ASSERT_TRUE(action->isEnabled());
  action->trigger();
  ASSERT_TRUE(waitForJob());
  EXPECT_TRUE(scene().volume.bodyOnly);
  EXPECT_TRUE(action->isChecked());
  EXPECT_LT(valueAt(*scene().volume.data, {32, 56, 32}), -900.0);
  EXPECT_EQ(valueAt(*scene().volume.data, {32, 28, 32}), 600.0);
  QString said = mWindow->messages().text();
  EXPECT_TRUE(said.contains("ml that are not part of the largest body are hidden")) << said.toStdString();
  EXPECT_TRUE(said[0].isDigit()) << said.toStdString();
  mWindow->document().undo();
  EXPECT_FALSE(scene().volume.bodyOnly);
  EXPECT_FALSE(action->isChecked());
  EXPECT_EQ(valueAt(*scene().volume.data, {32, 56, 32}), 300.0);
}

TEST_F(VolumeWays, PlanesThatNoSliceGaveAreHatchedInRed) {
  Progress progress;
  io::Sample sample = io::makeSample("two-spheres", 32, progress);
  scene::Scene shown;
  auto show = [&](std::vector<glm::ivec2> gaps) {
    Volume volume = sample.volume;
    volume.gaps = std::move(gaps);
    volume.warnings = {"distances between slices run from 2.000 to 246.000 mm"};
    shown.volume.data = Shared<Volume>(std::move(volume));
    scene::applyPreset(shown, scene::choosePreset(*shown.volume.data));
    mWindow->showScene(shown, "gaps");
    mWindow->views().setLayout(scene::Layout::FourUp);
    drawSoon();
    EXPECT_TRUE(settle());
    return mWindow->views().section(scene::SectionKind::Coronal).grab().toImage();
  };
  auto reds = [](const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        QColor color = image.pixelColor(x, y);
        count += color.red() > color.green() + 60 && color.red() > color.blue() + 60;
      }
    return count;
  };
  int without = reds(show({})), with = reds(show({{10, 4}}));
  takeShot(*mWindow, "gaps");
  EXPECT_GT(with, without + 100);
  for (const char* words : {"4 are missing", "246.000 mm"})
    EXPECT_TRUE(mWindow->messages().text().contains(words)) << mWindow->messages().text().toStdString();
}

}  // namespace
}  // namespace velum::gui
