// What is on the screen while the next picture is made: never an older one that could be taken for it.
#include <QLabel>

#include "Shots.h"
#include "WindowFixture.h"
#include "gui/view/PreparingVeil.h"
#include "patience.h"
#include "scene/Finishes.h"
#include "scene/Presets.h"
#include "scene/VisibleFrame.h"

namespace velum::gui {
namespace {

class Preparing : public Window {
 protected:
  QString told() { return child<QLabel>("refined")->text(); }
  PreparingVeil::Kind veil() { return child<PreparingVeil>("preparingVeil")->kind(); }
  QImage seen() { return viewport().grab().toImage(); }
  /// A scan of somebody: a ball, or two that are far apart, with nothing where the one is.
  static scene::Scene patient(const char* name, bool isPair) {
    Volume volume;
    volume.dims = glm::ivec3(40);
    volume.type = SampleType::UInt8;
    volume.voxels.resize(40 * 40 * 40);
    for (int i = 0; i < 40 * 40 * 40; ++i) {
      glm::dvec3 at(i % 40, i / 40 % 40, i / 1600);
      double off = isPair
                       ? std::min(glm::length(at - glm::dvec3(6, 20, 20)), glm::length(at - glm::dvec3(33, 20, 20))) + 4
                       : glm::length(at - 20.0);
      volume.voxels[std::size_t(i)] = std::byte(off < 9.0 ? 200 : 0);
    }
    computeRange(volume);
    scene::Scene scene;
    scene.volume.source.path = name;
    scene.volume.data = Shared<Volume>(std::move(volume));
    scene::applyPreset(scene, "grey");
    scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 1.3);
    scene.rayCast.samplesPerPixel = 1;
    scene.lighting.shadow = scene.lighting.occlusion = 0.0;
    return scene;
  }
  /// How much two pictures differ where the first one shows something, per pixel, of 255.
  static double difference(const QImage& before, const QImage& now) {
    double sum = 0;
    int count = 0;
    for (int y = 0; y < before.height(); y += 2)
      for (int x = 0; x < before.width(); x += 2) {
        int a = qGray(before.pixel(x, y));
        if (a < 90 || !now.valid(x, y)) continue;
        sum += std::abs(a - qGray(now.pixel(x, y)));
        ++count;
      }
    return count > 0 ? sum / count : 255.0;
  }
  static QElapsedTimer started() {
    QElapsedTimer clock;
    clock.start();
    return clock;
  }
  void show(scene::Scene scene, const QString& name) {
    mWindow->showScene(std::move(scene), name);
    mWindow->views().setLayout(scene::Layout::Volume);
  }
};

TEST_F(Preparing, APatientsPictureIsNeverSeenUnderAnothersName) {
  show(patient("one.nrrd", false), "one");
  ASSERT_TRUE(settle());
  EXPECT_EQ(told(), "Complete");
  EXPECT_EQ(veil(), PreparingVeil::Kind::None);
  QImage one = seen();
  show(patient("two.nrrd", true), "two");
  EXPECT_EQ(told(), "Preparing") << "at once";
  int looks = 0;
  for (QElapsedTimer clock = started(); clock.elapsed() < kPatience; ++looks) {
    QImage now = seen();
    if (looks == 0) takeShot(*mWindow, "preparing");
    EXPECT_GT(difference(one, now), 25.0) << "look " << looks << ", " << told().toStdString();
    EXPECT_TRUE(told() != "Complete" || viewport().isConverged());
    if (mWindow->isSettled()) break;
    QApplication::processEvents(QEventLoop::AllEvents, 5);
  }
  EXPECT_EQ(told(), "Complete");
  EXPECT_EQ(veil(), PreparingVeil::Kind::None);
  EXPECT_GT(looks, 1);
  EXPECT_GT(difference(seen(), one), 25.0);
}

TEST_F(Preparing, NothingIsCompleteBetweenAnEditAndItsPicture) {
  show(patient("one.nrrd", false), "one");
  ASSERT_TRUE(settle());
  const std::pair<const char*, std::function<void(scene::Scene&)>> edits[] = {
      {"a finish", [](scene::Scene& scene) { scene::applyFinish(scene, "pencil"); }},
      {"a preset", [](scene::Scene& scene) { scene::applyPreset(scene, "mr-head"); }},
      {"a turn", [](scene::Scene& scene) { scene.camera.eye += glm::dvec3(30, 0, 10); }},
      {"a cut", [](scene::Scene& scene) { scene::addCut(scene, {}); }}};
  for (const auto& [what, edit] : edits) {
    SCOPED_TRACE(what);
    mWindow->document().edit("Change", edit);
    EXPECT_EQ(told(), "Preparing") << "at once";
    for (QElapsedTimer clock = started(); clock.elapsed() < kPatience;) {
      EXPECT_TRUE(told() != "Complete" || viewport().isConverged());
      if (mWindow->isSettled()) break;
      QApplication::processEvents(QEventLoop::AllEvents, 5);
    }
    EXPECT_EQ(told(), "Complete");
    EXPECT_EQ(veil(), PreparingVeil::Kind::None);
  }
}

/// A program that has to be compiled first holds the window up: the picture that goes is dimmed before that.
TEST_F(Preparing, APictureIsDimmedBeforeTheNextOnesProgramIsCompiled) {
  show(patient("one.nrrd", false), "one");
  ASSERT_TRUE(settle());
  QImage bright = seen();
  // No program of this scene is known yet: iso surfaces with a finish.
  mWindow->document().edit("Change", [](scene::Scene& scene) {
    scene.rayCast.mode = scene::RenderMode::Iso;
    scene.rayCast.isoValue = 100;
    scene::applyFinish(scene, "pencil");
  });
  bool wasDim = false;
  for (QElapsedTimer clock = started(); clock.elapsed() < kPatience && !mWindow->isSettled();) {
    if (veil() == PreparingVeil::Kind::Dim && !wasDim) {
      wasDim = true;
      EXPECT_GT(difference(bright, seen()), 40.0) << "and it is the old one that is dimmed";
    }
    QApplication::processEvents(QEventLoop::AllEvents, 1);
  }
  EXPECT_TRUE(wasDim);
  EXPECT_EQ(veil(), PreparingVeil::Kind::None);
}

TEST_F(Preparing, SectionsAreOfTheNewDataTheFirstTimeTheyAreSeen) {
  mWindow->resize(1000, 700);
  auto showAll = [&](const char* name, bool isPair) {
    mWindow->showScene(patient(name, isPair), name);
    mWindow->views().setLayout(scene::Layout::FourUp);
    QTest::qWait(1);
  };
  showAll("one.nrrd", false);
  ASSERT_TRUE(settle());
  showAll("two.nrrd", true);
  std::vector<QImage> first;
  for (auto kind : {scene::SectionKind::Axial, scene::SectionKind::Coronal})
    first.push_back(mWindow->views().section(kind).grab().toImage());
  ASSERT_TRUE(settle());
  std::size_t i = 0;
  for (auto kind : {scene::SectionKind::Axial, scene::SectionKind::Coronal})
    EXPECT_LT(difference(mWindow->views().section(kind).grab().toImage(), first[i++]), 2.0) << int(kind);
}

}  // namespace
}  // namespace velum::gui
