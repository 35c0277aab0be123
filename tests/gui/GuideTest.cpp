// The window's pictures in the user guide, made anew by `./dev guide`. Skipped without VELUM_GUIDE, the folder for
// them.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTest>

#include "window/MainWindow.h"

namespace velum::gui {
namespace {

constexpr const char* kHead = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3";
constexpr const char* kBrain = "/usr/share/mricron/templates/ch2.nii.gz";
constexpr const char* kRegions = "/usr/share/mricron/templates/aal.nii.gz";
constexpr const char* kCortex = "/usr/share/mricron/templates/ch2bet.nii.gz";

class Guide : public testing::Test {
 protected:
  void SetUp() override {
    if (!qEnvironmentVariableIsSet("VELUM_GUIDE")) GTEST_SKIP() << "set VELUM_GUIDE to the folder for the pictures";
    for (const char* file : {kHead, kBrain, kRegions, kCortex})
      if (!QFile::exists(file)) GTEST_SKIP() << file << ": install mricron-data and invesalius-examples";
    mWindow = std::make_unique<MainWindow>();
    mWindow->resize(1440, 900);
    mWindow->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(mWindow.get()));
  }
  void open(const QStringList& paths) {
    mWindow->openPaths(paths);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !mWindow->isBusy(); }, 60000));
    ASSERT_TRUE(mWindow->document().scene().volume.data);
  }
  void keep(const char* name) {
    QTest::qWait(1500);  // thumbnails come when the views are complete
    ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->isSettled(); }, 180000));
    QTest::qWait(1500);
    EXPECT_TRUE(mWindow->grab().save(qEnvironmentVariable("VELUM_GUIDE") + "/" + name + ".jpg", "jpg", 86));
  }
  std::unique_ptr<MainWindow> mWindow;
};

TEST_F(Guide, Window) {
  QString scene = QDir::temp().filePath("velum-guide.json");
  QFile::remove(scene);
  ASSERT_TRUE(QFile::copy(VELUM_SOURCE_DIR "/resources/welcome.json", scene));
  open({scene});
  keep("window");
  QFile::remove(scene);
}

TEST_F(Guide, Sections) {
  mWindow->views().setLayout(scene::Layout::FourUp);
  open({kBrain, kRegions});
  mWindow->document().edit("Add cut", [](scene::Scene& scene) {
    scene::Cut cut;
    cut.shape = scene::CutShape::Box;
    cut.name = "Window to the regions";
    cut.axis = {0, 0, 1};
    cut.centre = {-45, -50, 60};
    cut.size = {90, 110, 90};
    for (const auto& structure : scene.labels.structures) cut.spares.push_back({structure.id});
    scene.cuts.push_back(cut);
  });
  mWindow->viewport().lookFrom(scene::StandardView::Oblique);
  keep("sections");
}

TEST_F(Guide, Open) {
  for (const char* file : {kCortex, kBrain, kHead}) {
    open({file});
    ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->isSettled(); }, 180000));
  }
  mWindow->newScene();
  keep("open");
}

}  // namespace
}  // namespace velum::gui
