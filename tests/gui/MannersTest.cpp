// What a window must take without a crash, a loss or a word on the console.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QMainWindow>
#include <QSlider>
#include <QStandardPaths>
#include <QTest>

#include "Shots.h"
#include "TempFolder.h"
#include "gui/kit/Theme.h"
#include "gui/view/TimeBar.h"
#include "gui/window/MainWindow.h"
#include "io/phantoms/Sample.h"
#include "io/volumes/WriteVolume.h"
#include "patience.h"

namespace velum::gui {
namespace {

class Manners : public testing::Test {
 protected:
  void SetUp() override {
    Progress progress;
    io::Sample sample = io::makeSample("two-spheres", 24, progress);
    io::writeVolume(sample.volume, mFolder / "phantom.nrrd", progress);
    Volume series = sample.volume;
    series.timeSteps = 3;
    series.timeStepSeconds = 0.5;
    Bytes one = series.voxels;
    for (int i = 1; i < 3; ++i) {
      // Later steps are darker.
      for (auto& b : one) b = std::byte(std::to_integer<int>(b) / 2);
      series.voxels.insert(series.voxels.end(), one.begin(), one.end());
    }
    io::writeVolume(series, mFolder / "series.nii", progress);
  }
  std::unique_ptr<MainWindow> open(const char* name) {
    auto window = std::make_unique<MainWindow>();
    window->resize(760, 520);
    window->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    window->openPaths({QString::fromStdString((mFolder / name).string())});
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window->isBusy(); }, kPatience));
    return window;
  }
  static bool settle(MainWindow& window) {
    return QTest::qWaitFor([&] { return window.isSettled(); }, kPatience);
  }
  TempFolder mFolder;
};

TEST_F(Manners, ASecondWindowDrawsBesideTheFirst) {
  auto first = open("phantom.nrrd"), second = open("phantom.nrrd");
  EXPECT_TRUE(settle(*first));
  EXPECT_TRUE(settle(*second));
  first.reset();
  second->viewport().lookFrom(scene::StandardView::Left);
  EXPECT_TRUE(settle(*second));
}

TEST_F(Manners, TheViewDrawsAgainInAnotherWindow) {
  auto window = open("phantom.nrrd");
  ASSERT_TRUE(settle(*window));
  QWidget& view = window->viewport();
  QWidget* home = view.parentWidget();
  QMainWindow other;
  other.resize(500, 400);
  other.setCentralWidget(&window->viewport());
  view.show();  // the stack of pages hides what leaves it
  other.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&other));
  EXPECT_TRUE(QTest::qWaitFor([&] { return window->viewport().isConverged(); }, kPatience));
  auto pick = window->viewport().pickAt(QPointF(window->viewport().width() * 0.38, window->viewport().height() * 0.5));
  EXPECT_TRUE(pick);
  // And home again.
  other.takeCentralWidget()->setParent(home);
  view.show();
  EXPECT_TRUE(QTest::qWaitFor([&] { return window->viewport().isConverged(); }, kPatience));
}

TEST_F(Manners, ALostContextIsMadeAgainAndNothingElseIsLost) {
  auto window = open("phantom.nrrd");
  ASSERT_TRUE(settle(*window));
  window->document().edit("Add cut", [](scene::Scene& s) { s.cuts.emplace_back(); });
  ASSERT_TRUE(settle(*window));
  QImage before = window->viewport().picture();
  window->viewport().renewContext();
  ASSERT_TRUE(settle(*window));
  EXPECT_EQ(window->viewport().picture(), before);
  EXPECT_TRUE(window->document().canUndo());
}

TEST_F(Manners, TimeStepsAreShownAndPlayedAndAreNoEdit) {
  auto window = open("series.nii");
  auto* bar = window->findChild<TimeBar*>();
  auto* slider = window->findChild<QSlider*>("timeSlider");
  ASSERT_TRUE(bar && slider && bar->isVisible());
  EXPECT_EQ(slider->maximum(), 2);
  slider->setValue(2);
  EXPECT_EQ(window->document().scene().volume.timeStep, 2);
  window->document().undo();
  EXPECT_EQ(window->document().scene().volume.timeStep, 0);
  EXPECT_EQ(slider->value(), 0);
  bar->setPlaying(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window->document().scene().volume.timeStep == 2; }, kPatience));
  bar->setPlaying(false);
  EXPECT_FALSE(window->document().canUndo()) << "what plays leaves no step";
  EXPECT_FALSE(window->document().isModified());
  EXPECT_FALSE(window->isWindowModified());
  EXPECT_TRUE(settle(*window));
  takeShot(*window, "time");
}

TEST_F(Manners, TimeStepsGoRoundBothEnds) {
  auto window = open("series.nii");
  auto* bar = window->findChild<TimeBar*>();
  auto now = [&] { return window->document().scene().volume.timeStep; };
  bar->step(-1);
  EXPECT_EQ(now(), 2);
  bar->step(2);
  EXPECT_EQ(now(), 1);
  bar->step(-5);
  EXPECT_EQ(now(), 2);
}

TEST_F(Manners, AWindowWithoutTimeHasNoTimeBar) {
  auto window = open("phantom.nrrd");
  EXPECT_FALSE(window->findChild<TimeBar*>()->isVisible());
}

TEST_F(Manners, TheLightThemeReachesEveryPanel) {
  applyTheme(*qApp, ThemeKind::Light);
  auto window = open("phantom.nrrd");
  ASSERT_TRUE(settle(*window));
  QImage look = window->grab().toImage();
  takeShot(*window, "light");
  EXPECT_GT(qGray(look.pixel(look.width() - 20, look.height() - 60)), 200);
  applyTheme(*qApp, ThemeKind::Dark);
  look = window->grab().toImage();
  EXPECT_LT(qGray(look.pixel(look.width() - 20, look.height() - 60)), 80);
}

TEST_F(Manners, EveryCommandHasATipAndEveryKeyOneCommand) {
  MainWindow window;
  QHash<QString, QString> owners;
  for (QAction* action : window.actions().all()) {
    EXPECT_FALSE(action->statusTip().isEmpty()) << action->objectName().toStdString();
    for (const QKeySequence& key : action->shortcuts()) {
      QString text = key.toString();
      EXPECT_FALSE(owners.contains(text)) << text.toStdString() << ": " << owners.value(text).toStdString() << " and "
                                          << action->objectName().toStdString();
      owners.insert(text, action->objectName());
    }
  }
}

TEST_F(Manners, TheUsersKeysGoOverOurs) {
  QDir().mkpath(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation));
  QString path = QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + "/keys.json";
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(R"({"cut.addPlane": ["P"], "file.quit": []})");
  file.close();
  {
    MainWindow window;
    EXPECT_EQ(window.actions().find("cut.addPlane")->shortcut(), QKeySequence("P"));
    EXPECT_TRUE(window.actions().find("file.quit")->shortcuts().isEmpty());
    EXPECT_EQ(window.actions().find("file.open")->shortcut(), QKeySequence("Ctrl+O"));
  }
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{ not json");
  file.close();
  MainWindow window;
  EXPECT_TRUE(window.messages().text().contains("keys.json"));
  file.remove();
}

}  // namespace
}  // namespace velum::gui
