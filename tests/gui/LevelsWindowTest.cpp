// A model that is opened is seen before its levels of detail are there.
#include <QLabel>

#include "ModelFixture.h"
#include "Shots.h"
#include "model/Levels.h"
#include "session/document/Folders.h"
#include "session/model/LevelCache.h"

namespace velum::gui {
namespace {

class LevelsWindow : public ModelWindow {
 protected:
  void SetUp() override {
    ModelWindow::SetUp();
    std::filesystem::remove(session::levelFile(*mModel, session::levelFolder()));  // of another run
  }
  void showQuick() {
    Progress progress;
    scene::Scene scene;
    scene.unit = LengthUnit::Angstrom;
    scene.model.data = mModel;
    scene.model.levels = Shared<LevelSet>(model::makeQuickLevels(*mModel, progress));
    mWindow->resize(1000, 700);
    mWindow->showScene(scene, "made");
    drawSoon();
  }
  /// Of so many atoms that their levels take seconds.
  Shared<Model> mModel{
      ModelMaker{.types = 2, .atoms = 150'000, .instances = 6, .moleculeRadius = 110.0f, .halfEdge = 200.0f}.make()};
};

TEST_F(LevelsWindow, APictureIsThereBeforeTheLevelsAreAndWaitsForNone) {
  openModel();  // its programs are compiled, which takes as long as a driver likes
  ASSERT_TRUE(settle());
  int before = viewport().shownCount();
  showQuick();
  ASSERT_TRUE(QTest::qWaitFor([&] { return viewport().shownCount() > before && viewport().isVisible(); }, kPatience));
  EXPECT_TRUE(model::areQuick(*scene().model.levels)) << "the picture came first";
  EXPECT_FALSE(mWindow->isSettled()) << "what waits for the whole waits for the levels";
  takeShot(*mWindow, "quick-levels");
  ASSERT_TRUE(settle());
  EXPECT_FALSE(model::areQuick(*scene().model.levels));
  EXPECT_EQ(child<QLabel>("refined")->text(), "Complete");
  EXPECT_FALSE(mWindow->document().isModified());
}

TEST_F(LevelsWindow, ThePictureInTheEndIsTheOneWithLevelsFromTheStart) {
  showQuick();
  ASSERT_TRUE(settle());
  QImage after = viewport().grab().toImage();
  Progress progress;
  scene::Scene whole = scene();
  whole.model.levels = Shared<LevelSet>(model::computeLevels(*mModel, progress));
  mWindow->showScene(whole, "made");
  ASSERT_TRUE(settle());
  EXPECT_EQ(viewport().grab().toImage(), after);
}

}  // namespace
}  // namespace velum::gui
