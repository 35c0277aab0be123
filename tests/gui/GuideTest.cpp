// The window's pictures in the user guide, made anew by `./dev guide`. Skipped without VELUM_GUIDE, the folder for
// them.
#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "gui/window/MainWindow.h"
#include "io/phantoms/Virion.h"
#include "patience.h"
#include "scene/ModelLooks.h"
#include "scene/Navigate.h"
#include "scene/Presets.h"
#include "scene/Project.h"
#include "session/extrusion/Extrusion.h"

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
    ASSERT_TRUE(QTest::qWaitFor([&] { return !mWindow->isBusy(); }, kPatience));
    ASSERT_TRUE(mWindow->document().scene().volume.data);
  }
  /// A copy of the first scene, so that the journal of that file is left alone.
  void openWelcome() {
    QString scene = mFolder.filePath("welcome.json");
    ASSERT_TRUE(QFile::copy(VELUM_SOURCE_DIR "/resources/welcome.json", scene));
    open({scene});
  }
  void keep(const char* name) {
    QTest::qWait(1500);  // thumbnails come when the views are complete
    ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->isSettled(); }, kPatience));
    QTest::qWait(1500);
    EXPECT_TRUE(mWindow->grab().save(qEnvironmentVariable("VELUM_GUIDE") + "/" + name + ".jpg", "jpg", 86));
  }
  QTemporaryDir mFolder;
  std::unique_ptr<MainWindow> mWindow;
};

TEST_F(Guide, Window) {
  openWelcome();
  keep("window");
}

// A virus that is cut open, with spikes brought back and its plasma thinned by the bars.
TEST_F(Guide, Bars) {
  Progress progress;
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(io::makeVirion(progress));
  scene::applyModelLook(scene, "plate");
  mWindow->showScene(scene, "virion");
  mWindow->actions().find("cut.addPlane")->trigger();
  mWindow->tabs().showPage("Model");
  Equalizer& equalizer = mWindow->models().equalizer();
  ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->isSettled(); }, kPatience));
  equalizer.set("root.virus.surface.spike", Equalizer::Handle::Left, 60.0);
  equalizer.set("root.plasma", Equalizer::Handle::Left, 1500.0);
  mWindow->selection().setCut(0);
  mWindow->document().view([](scene::Scene& shown) { shown.camera = scene::zoom(shown.camera, 0.6); });
  keep("bars");
}

// One drag: the skull, which has no label, out of a cut through the face.
TEST_F(Guide, PullOut) {
  open({kHead});
  session::Document& document = mWindow->document();
  mWindow->views().setLayout(scene::Layout::Volume);
  mWindow->actions().find("look.hideTable")->trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !mWindow->isBusy(); }, kPatience));
  document.edit("Cut", [](scene::Scene& scene) {
    scene::applyPreset(scene, "ct-skin-white-bone");
    scene::Cut plane;
    plane.axis = {0, -1, 0};
    plane.centre = {100, 75, 100};
    plane.size = {150, 150, 100};
    scene::addCut(scene, plane);
    scene.camera.eye = {-190, -330, 240};
    scene.camera.target = {118, 112, 72};
    scene.camera.fieldOfViewDeg = 26;
  });
  ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->isSettled(); }, kPatience));
  mWindow->actions().find("extrusion.pull")->trigger();
  Viewport& view = mWindow->viewport();
  auto pixelOf = [&](glm::dvec3 world) {
    glm::dvec2 pixel = *scene::pixelFromWorld(document.scene().camera, {view.width(), view.height()}, world);
    return QPoint(int(std::lround(pixel.x)), int(std::lround(pixel.y)));
  };
  // Bone of the forehead's face, neither its hardest nor its marrow.
  constexpr double kMiddle = 600.0;  // HU
  glm::dvec3 onBone(0.0);
  double nearest = 1e9;
  for (double x = 60; x < 185; x += 3)
    for (double z = 100; z < 150; z += 3) {
      auto pick = view.pickAt(pixelOf({x, 75, z}));
      bool isInFace = pick && pick->hit && std::abs(pick->world.y - 75) < 2.0;
      if (isInFace && std::abs(pick->value - kMiddle) < nearest)
        nearest = std::abs(pick->value - kMiddle), onBone = pick->world;
    }
  QPoint from = pixelOf(onBone), to = pixelOf(onBone + glm::dvec3(0, -60, 0));
  QTest::mousePress(&view, Qt::LeftButton, {}, from);
  for (int i = 1; i <= 4; ++i) {
    QTest::mouseMove(&view, from + (to - from) * i / 4);
    QTest::qWait(100);
  }
  QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
  ASSERT_EQ(session::extrusionsOf(document.scene()).size(), 1u);
  keep("pull-out");
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
    ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->isSettled(); }, kPatience));
  }
  mWindow->newScene();
  keep("open");
}

}  // namespace
}  // namespace velum::gui
