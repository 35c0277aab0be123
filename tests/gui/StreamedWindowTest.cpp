// Volumes of any size in the window: what is asked, offered and said of them.
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <fstream>

#include "WindowFixture.h"
#include "core/BrickCache.h"
#include "gui/kit/Preferences.h"
#include "gui/window/PreferencesDialog.h"
#include "io/labels/LabelStore.h"
#include "io/stores/WriteStore.h"

namespace velum::gui {
namespace {

class StreamedWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    Progress progress;
    io::Sample sample = io::makeSample("torso", 160, progress);
    mLarge = mFolder / "large.nii";
    io::writeVolume(sample.volume, mLarge, progress);
    io::writeStore(VolumeSource(sample.volume), mFolder / "large.zarr", {}, progress);
    setMemoryBudget({.wholeBytes = 100e3});
  }
  void TearDown() override {
    Preferences().setMemory({});
    Preferences().setLevel(-1);
    Preferences().setValue("volumes/pyramidOffered", {});
    Window::TearDown();
  }
  static QString text(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }
  void open(const std::filesystem::path& path) {
    mWindow->openPaths({text(path)});
    ASSERT_TRUE(waitForJob());
    ASSERT_TRUE(scene().volume.data);
    drawSoon();
  }
  QMessageBox* waitForOffer() {
    QMessageBox* offer = nullptr;
    bool came =
        QTest::qWaitFor([&] { return (offer = child<QMessageBox>("pyramidOffer")) && offer->isVisible(); }, kPatience);
    return came ? offer : nullptr;
  }
  /// Presses a button by the beginning of its text.
  static bool press(QMessageBox& box, const QString& start) {
    for (auto* button : box.buttons())
      if (button->text().remove('&').startsWith(start)) return button->click(), true;
    return false;
  }

  TempFolder mFolder;
  std::filesystem::path mLarge;
};

TEST_F(StreamedWindow, TheStatusLineSaysWhatIsAtWhichLevel) {
  open(mFolder / "large.zarr");
  ASSERT_TRUE(scene().volume.data->finer);
  ASSERT_TRUE(settle());
  auto* label = child<QLabel>("streaming");
  EXPECT_TRUE(label->text().startsWith("level ")) << label->text().toStdString();
  EXPECT_FALSE(label->text().contains("to come")) << label->text().toStdString();
  EXPECT_TRUE(label->toolTip().contains("MiB of the graphics memory")) << label->toolTip().toStdString();
  mWindow->newScene();
  EXPECT_TRUE(label->text().isEmpty());
}

TEST_F(StreamedWindow, BudgetsCountAtOnce) {
  open(mFolder / "large.zarr");
  ASSERT_TRUE(settle());
  int before = viewport().shownCount();
  PreferencesDialog dialog(mWindow->actions(), mWindow.get());
  QObject::connect(&dialog, &PreferencesDialog::changed, mWindow.get(), [this] { mWindow->takePreferences(); });
  auto set = [&](const char* name, int value) {
    auto* box = dialog.findChild<QSpinBox*>(name);
    ASSERT_TRUE(box) << name;
    box->setValue(value);
    EXPECT_TRUE(box->text().contains("MiB")) << box->text().toStdString();
    EXPECT_FALSE(box->toolTip().isEmpty());
  };
  set("brickMemory", 64);
  EXPECT_EQ(scene().volume.data->finer->bricks->mostBytes(), std::size_t(64) << 20);
  set("gpuBrickMemory", 128);
  EXPECT_TRUE(QTest::qWaitFor([&] { return viewport().shownCount() > before; }, kPatience)) << "it is drawn anew";
  ASSERT_TRUE(settle());
  EXPECT_DOUBLE_EQ(viewport().stats().streaming.budgetBytes, double(128 << 20));
  set("wholeSize", 4000);
  EXPECT_DOUBLE_EQ(Preferences().memory().wholeBytes, 4000.0 * (1 << 20));
  open(mFolder / "large.zarr");
  EXPECT_FALSE(scene().volume.data->finer) << "it is small now";
  auto* level = dialog.findChild<QComboBox*>("volumeLevel");
  level->setCurrentIndex(2);
  emit level->activated(2);
  open(mFolder / "large.zarr");
  EXPECT_EQ(scene().volume.source.level, 1);
}

TEST_F(StreamedWindow, APyramidIsOfferedOnceMadeBesideAndUsed) {
  open(mLarge);
  QMessageBox* offer = waitForOffer();
  ASSERT_TRUE(offer);
  EXPECT_TRUE(offer->informativeText().contains("large.ome.zarr")) << offer->informativeText().toStdString();
  EXPECT_TRUE(offer->informativeText().contains("MiB"));
  ASSERT_TRUE(press(*offer, "Make"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return bool(scene().volume.data->finer); }, kPatience));
  ASSERT_TRUE(waitForJob());
  EXPECT_TRUE(scene().volume.source.path.ends_with("large.ome.zarr"));
  EXPECT_TRUE(mWindow->document().canUndo());
  EXPECT_EQ(mWindow->document().undoLabel(), "Use the pyramid");
  mWindow->document().undo();
  EXPECT_TRUE(scene().volume.source.path.ends_with("large.nii"));
  // Opened again it is not offered again; who asks is told that it is there.
  mWindow->newScene();
  open(mLarge);
  QTest::qWait(300);
  EXPECT_FALSE(child<QMessageBox>("pyramidOffer"));
  mWindow->actions().find("edit.makePyramid")->trigger();
  offer = waitForOffer();
  ASSERT_TRUE(offer);
  ASSERT_TRUE(press(*offer, "Use it"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return bool(scene().volume.data->finer); }, kPatience));
}

TEST_F(StreamedWindow, WhatIsTooLargeIsNotReadUnasked) {
  scene::Source source;
  std::filesystem::path huge = mFolder / "huge.nrrd";
  auto edge = std::uintmax_t(std::cbrt(machineBytes()));
  std::ofstream(huge) << "NRRD0004\ntype: uint8\ndimension: 3\nsizes: " << edge << " " << edge << " " << edge
                      << "\nspacings: 1 1 1\nencoding: raw\n\n";
  std::filesystem::resize_file(huge, std::filesystem::file_size(huge) + edge * edge * edge);  // takes no room
  mWindow->openPaths({text(huge)});
  ASSERT_TRUE(waitForJob());
  QMessageBox* offer = waitForOffer();
  ASSERT_TRUE(offer);
  EXPECT_FALSE(scene().volume.data);
  EXPECT_FALSE(press(*offer, "Read it")) << "it does not fit";
  EXPECT_TRUE(press(*offer, "Not now") || press(*offer, "Close"));
}

TEST_F(StreamedWindow, ImagesOfAStoreAreAskedFor) {
  std::filesystem::path store = mFolder / "all.zarr";
  std::filesystem::create_directories(store / "0" / "labels");
  std::filesystem::copy(mFolder / "large.zarr", store / "0", std::filesystem::copy_options::recursive);
  std::filesystem::copy(mFolder / "large.zarr", store / "1", std::filesystem::copy_options::recursive);
  std::ofstream(store / "zarr.json") << R"({"zarr_format":3,"node_type":"group","attributes":{"ome":)"
                                     << R"({"version":"0.5","bioformats2raw.layout":3}}})";
  bool asked = false;
  QTimer answer;
  QObject::connect(&answer, &QTimer::timeout, [&] {
    auto* list = child<QListWidget>("seriesList");
    if (!list || !list->isVisible()) return;
    asked = list->count() == 2;
    list->setCurrentRow(1);
    emit list->itemActivated(list->item(1));
  });
  answer.start(50);
  mWindow->openPaths({text(store)});
  ASSERT_TRUE(QTest::qWaitFor([&] { return asked && !mWindow->isBusy() && scene().volume.data; }, kPatience));
  EXPECT_EQ(scene().volume.source.series, "1");
}

}  // namespace
}  // namespace velum::gui
