#pragma once
#include <QFileDialog>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QTimer>
#include <functional>
#include <map>

#include "DicomSeries.h"
#include "WindowFixture.h"
#include "scene/SectionPlane.h"
#include "session/cut/CutTool.h"

namespace velum::gui {

/// Keys pressed in the real window.
class Keys : public Window {
 protected:
  using Key = QKeySequence;
  using Check = std::function<void(Keys&, const Key&)>;

  static void SetUpTestSuite() {
    Window::SetUpTestSuite();
    Progress progress;
    io::Sample sample = io::makeSample("two-spheres", 32, progress);
    Volume series = sample.volume;
    series.timeSteps = 3;
    series.timeStepSeconds = 0.05;
    Bytes one = series.voxels;
    for (int i = 1; i < 3; ++i) series.voxels.insert(series.voxels.end(), one.begin(), one.end());
    io::writeVolume(series, *sFolder / "series.nii", progress);
    Volume scan;
    scan.dims = {8, 7, 6};
    scan.type = SampleType::Int16;
    scan.voxels.resize(timeStepBytes(scan));
    ASSERT_TRUE(writeDicomSeries(scan, *sFolder / "scan"));
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);  // so that they can be answered
  }

  session::Document& document() { return mWindow->document(); }

  /// A window as it was before the first key: a series with two structures, in four views.
  void renew() {
    TearDown();
    Window::SetUp();
    mWindow->openPaths({path("series.nii"), path("phantom_labels.seg.nrrd")});
    ASSERT_TRUE(waitForJob());
    ASSERT_GE(scene().labels.structures.size(), 2u);
    mWindow->views().setLayout(scene::Layout::FourUp);
    drawSoon();
  }
  void press(const Key& key) {
    viewport().setFocus();
    QTest::keySequence(&viewport(), key);
  }
  /// Presses a key that brings up a dialog, and answers that.
  template <class Dialog>
  void pressAndAnswer(const Key& key, const std::function<void(Dialog&)>& answer) {
    bool isSeen = false;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
      auto* modal = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      if (!modal) return;
      timer.stop();
      auto* dialog = dynamic_cast<Dialog*>(modal);
      EXPECT_TRUE(dialog) << modal->metaObject()->className() << " came up";
      if (dialog) {
        isSeen = true;
        answer(*dialog);
      }
      if (modal->isVisible()) modal->reject();
    });
    timer.start(20);
    press(key);
    EXPECT_TRUE(QTest::qWaitFor([&] { return isSeen; }, 2000)) << "no dialog came up";
  }
  void chooseFile(const Key& key, const QString& chosen, const std::function<void(QFileDialog&)>& look = {}) {
    pressAndAnswer<QFileDialog>(key, [&](QFileDialog& dialog) {
      if (look) look(dialog);
      auto* name = dialog.findChild<QLineEdit*>("fileNameEdit");
      ASSERT_TRUE(name);
      name->setText(chosen);
      static_cast<QDialog&>(dialog).accept();
    });
    ASSERT_TRUE(waitForJob());
  }
  void pressForDialog(const Key& key, const char* className) {
    pressAndAnswer<QDialog>(key, [&](QDialog& dialog) { EXPECT_TRUE(dialog.inherits(className)); });
  }

  glm::dvec3 towardsEye() { return glm::normalize(scene().camera.eye - scene().camera.target); }
  static Check looksFrom(glm::dvec3 side) {
    return [side](Keys& keys, const Key& key) {
      keys.document().view([](scene::Scene& s) { s.camera.eye = s.camera.target + glm::dvec3(31, 77, -53); });
      keys.press(key);
      EXPECT_LT(glm::length(keys.towardsEye() - side), 1e-6);
    };
  }
  static Check laysOut(scene::Layout layout) {
    return [layout](Keys& keys, const Key& key) {
      auto other = layout == scene::Layout::FourUp ? scene::Layout::Volume : scene::Layout::FourUp;
      keys.mWindow->views().setLayout(other);
      keys.press(key);
      EXPECT_EQ(keys.scene().sections.layout, layout);
    };
  }
  /// @param planes  by which the axial section moves to the head
  static Check scrolls(double planes) {
    return [planes](Keys& keys, const Key& key) {
      glm::dvec3 before = keys.scene().sections.crosshair;
      keys.press(key);
      glm::dvec3 moved = keys.scene().sections.crosshair - before;
      EXPECT_LT(glm::length(moved - glm::dvec3(0, 0, planes * scene::sectionStep(keys.scene()))), 1e-6);
    };
  }
  static Check stepsTime(int from, int to) {
    return [from, to](Keys& keys, const Key& key) {
      keys.document().edit("Time", [&](scene::Scene& s) { s.volume.timeStep = from; });
      keys.press(key);
      EXPECT_EQ(keys.scene().volume.timeStep, to);
    };
  }

  /// Two planes, the first of which is selected.
  void addCuts() {
    int first = 0;
    document().edit("Add cuts", [&](scene::Scene& s) {
      first = scene::addCut(s, session::cutFacingCamera(s));
      scene::addCut(s, session::cutFacingCamera(s));
    });
    mWindow->selection().setCut(first);
  }
  void checkCutRemains(const Key& key, const std::function<void(std::vector<scene::Cut>)>& look) {
    addCuts();
    std::vector<scene::Cut> before = scene().cuts;
    press(key);
    look(before);
  }
  /// A membrane whose sheet hangs, in the 3D view alone.
  void hangSheet() {
    mWindow->views().setLayout(scene::Layout::Volume);
    mWindow->actions().find("cut.addMembrane")->trigger();
    ASSERT_TRUE(waitForJob());
    ASSERT_EQ(scene().cuts.size(), 1u);
    ASSERT_TRUE(settle());
  }
  void clickMiddle() {
    QTest::mouseClick(&viewport(), Qt::LeftButton, {}, viewport().rect().center() + QPoint(30, -20));
  }
  static Check putsKernel(bool pushes) {
    return [pushes](Keys& keys, const Key& key) {
      keys.hangSheet();
      keys.press(key);
      keys.clickMiddle();
      const auto& kernels = keys.scene().cuts[0].membrane->field.kernels;
      ASSERT_EQ(kernels.size(), 1u);
      EXPECT_EQ(kernels[0].strength > 0, pushes);
      EXPECT_NE(kernels[0].strength, 0.0);
    };
  }

  /// Selects a structure, presses the key, and says which structures show then.
  std::vector<bool> shownAfter(const Key& key, int selected, const std::vector<bool>& before) {
    document().edit("Show", [&](scene::Scene& s) {
      for (std::size_t i = 0; i < before.size(); ++i) s.labels.structures[i].visible = before[i];
    });
    mWindow->selection().setStructure(selected);
    press(key);
    std::vector<bool> now;
    for (const auto& structure : scene().labels.structures) now.push_back(structure.visible);
    return now;
  }
  int idOf(int place) { return scene().labels.structures[std::size_t(place)].id; }

  static std::map<QString, Check> checks();
  static std::map<QString, Check> filmChecks();
  static std::map<QString, Check> markChecks();
  static QJsonObject keyTable() { return QJsonDocument::fromJson(bytesOf(":/velum/keys.json")).object(); }
};

}  // namespace velum::gui
