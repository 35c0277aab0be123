// What each key of keys.json does.
#include "KeysFixture.h"
#include "gui/view/GreyWindowCorner.h"
#include "gui/view/TimeBar.h"
#include "patience.h"
#include "scene/Navigate.h"
#include "session/extrusion/Extrusion.h"

namespace velum::gui {

std::map<QString, Keys::Check> Keys::checks() {
  using scene::Layout;
  std::map<QString, Check> all;
  // Files.
  all["file.new"] = [](Keys& keys, const Key& key) {
    keys.press(key);
    EXPECT_FALSE(keys.scene().volume.data);
  };
  all["file.open"] = [](Keys& keys, const Key& key) {
    keys.chooseFile(key, path("phantom.nrrd"));
    EXPECT_EQ(keys.scene().volume.data->timeSteps, 1);
    EXPECT_FALSE(keys.scene().labels.data) << "what was open goes";
  };
  all["file.openFolder"] = [](Keys& keys, const Key& key) {
    keys.chooseFile(key, path("scan"),
                    [](QFileDialog& dialog) { EXPECT_EQ(dialog.fileMode(), QFileDialog::Directory); });
    EXPECT_EQ(keys.scene().volume.data->dims, glm::ivec3(8, 7, 6));
  };
  all["file.add"] = [](Keys& keys, const Key& key) {
    keys.mWindow->openPaths({path("phantom.nrrd")});
    ASSERT_TRUE(keys.waitForJob());
    ASSERT_FALSE(keys.scene().labels.data);
    auto volume = keys.scene().volume.data;
    keys.chooseFile(key, path("phantom_labels.seg.nrrd"));
    EXPECT_TRUE(keys.scene().labels.data);
    EXPECT_EQ(keys.scene().volume.data.id(), volume.id()) << "what is open stays";
  };
  all["file.saveScene"] = [](Keys& keys, const Key& key) {
    QString file = path("saved.json");
    keys.mWindow->saveSceneTo(file);
    keys.document().edit("Level", [](scene::Scene& s) { s.volume.windowLevel = 4711; });
    EXPECT_FALSE(bytesOf(file).contains("4711"));
    keys.press(key);
    EXPECT_TRUE(bytesOf(file).contains("4711"));
    EXPECT_FALSE(keys.document().isModified());
  };
  all["file.saveSceneAs"] = [](Keys& keys, const Key& key) {
    keys.mWindow->saveSceneTo(path("saved.json"));
    QFile::remove(path("other.json"));
    keys.chooseFile(key, path("other.json"),
                    [](QFileDialog& dialog) { EXPECT_EQ(dialog.acceptMode(), QFileDialog::AcceptSave); });
    EXPECT_TRUE(QFile::exists(path("other.json")));
  };
  all["file.savePicture"] = [](Keys& keys, const Key& key) {
    keys.pressForDialog(key, "velum::gui::SavePictureDialog");
  };
  all["file.cancel"] = [](Keys& keys, const Key& key) {
    scene::Scene before = keys.scene();
    keys.mWindow->openPhantom("torso", 256);
    ASSERT_TRUE(keys.mWindow->isBusy());
    QTest::qWait(50);
    keys.press(key);
    ASSERT_TRUE(keys.waitForJob());
    EXPECT_EQ(keys.scene(), before);
  };
  all["file.quit"] = [](Keys& keys, const Key& key) {
    keys.press(key);
    EXPECT_FALSE(keys.mWindow->isVisible());
  };
  all["file.newWindow"] = [](Keys& keys, const Key& key) {
    keys.press(key);
    int others = 0;
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (auto* other = qobject_cast<MainWindow*>(widget); other && other != keys.mWindow.get() && other->isVisible()) {
        ++others;
        EXPECT_FALSE(other->document().scene().volume.data) << "with a scene of its own";
        other->close();
      }
    EXPECT_EQ(others, 1);
    EXPECT_TRUE(keys.scene().volume.data);
    QTest::qWait(20);
  };
  // What was done.
  all["edit.undo"] = [](Keys& keys, const Key& key) {
    scene::Scene before = keys.scene();
    keys.addCuts();
    keys.press(key);
    EXPECT_EQ(keys.scene(), before);
  };
  all["edit.redo"] = [](Keys& keys, const Key& key) {
    keys.addCuts();
    scene::Scene done = keys.scene();
    keys.document().undo();
    keys.press(key);
    EXPECT_EQ(keys.scene(), done);
  };
  all["edit.preferences"] = [](Keys& keys, const Key& key) {
    keys.pressForDialog(key, "velum::gui::PreferencesDialog");
  };
  // Time.
  all["time.play"] = [](Keys& keys, const Key& key) {
    auto* bar = keys.mWindow->findChild<TimeBar*>();
    keys.mWindow->views().setLayout(Layout::Section);  // soon drawn
    keys.mWindow->views().section(scene::SectionKind::Axial).setFocus();
    QTest::keySequence(&keys.mWindow->views().section(scene::SectionKind::Axial), key);
    EXPECT_TRUE(QTest::qWaitFor([&] { return keys.scene().volume.timeStep > 0; }, kPatience));
    QTest::keySequence(&keys.mWindow->views().section(scene::SectionKind::Axial), key);
    EXPECT_FALSE(bar->isPlaying()) << "and pauses";
  };
  all["time.next"] = stepsTime(0, 1);
  all["time.previous"] = stepsTime(2, 1);
  // Help.
  all["help.guide"] = [](Keys& keys, const Key& key) {
    keys.press(key);
    int guides = 0;
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (widget->inherits("velum::gui::HelpWindow") && widget->isVisible()) ++guides, widget->close();
    EXPECT_EQ(guides, 1);
  };
  all["help.find"] = [](Keys& keys, const Key& key) { keys.pressForDialog(key, "velum::gui::CommandFinder"); };
  // Views.
  all["view.anterior"] = looksFrom({0, -1, 0});
  all["view.posterior"] = looksFrom({0, 1, 0});
  all["view.left"] = looksFrom({1, 0, 0});
  all["view.right"] = looksFrom({-1, 0, 0});
  all["view.superior"] = looksFrom({0, 0, 1});
  all["view.inferior"] = looksFrom({0, 0, -1});
  all["view.oblique"] = [](Keys& keys, const Key& key) {
    keys.press(key);
    glm::dvec3 eye = keys.towardsEye();
    EXPECT_LT(eye.y, -0.2) << "from the front";
    EXPECT_GT(eye.z, 0.2) << "and from above";
    EXPECT_GT(std::abs(eye.x), 0.2) << "and from a side";
  };
  all["view.parallel"] = [](Keys& keys, const Key& key) {
    keys.press(key);
    EXPECT_EQ(keys.scene().camera.projection, scene::Projection::Orthographic);
    keys.press(key);
    EXPECT_EQ(keys.scene().camera.projection, scene::Projection::Perspective);
  };
  all["view.reset"] = [](Keys& keys, const Key& key) {
    keys.document().view([](scene::Scene& s) { s.camera.target += glm::dvec3(40, 3, 9), s.camera.eye = {7, 900, 3}; });
    keys.press(key);
    EXPECT_LT(glm::length(keys.towardsEye() - glm::dvec3(0, -1, 0)), 1e-6) << "from the front";
    // So near that what shows fills the view; VisibleFrame's own tests say what that is.
    scene::Camera wanted = keys.mWindow->viewport().frame(keys.scene(), scene::defaultView(keys.scene()));
    EXPECT_LT(glm::length(keys.scene().camera.eye - wanted.eye), 1e-6);
    EXPECT_LT(glm::length(keys.scene().camera.target - wanted.target), 1e-6);
    // All of what is bright lies in it.
    const Volume& volume = *keys.scene().volume.data;
    double bright = 0.5 * (volume.range.x + volume.range.y);
    int outside = 0;
    for (int z = 0; z < volume.dims.z; ++z)
      for (int y = 0; y < volume.dims.y; ++y)
        for (int x = 0; x < volume.dims.x; ++x) {
          if (valueAt(volume, {x, y, z}) < bright) continue;
          glm::dvec3 world(volume.worldFromVoxel * glm::dvec4(x, y, z, 1.0));
          auto pixel = scene::pixelFromWorld(keys.scene().camera, keys.size(), world);
          outside += !pixel || glm::any(glm::lessThan(*pixel, glm::dvec2(0))) ||
                     glm::any(glm::greaterThan(*pixel, keys.size()));
        }
    EXPECT_EQ(outside, 0);
  };
  all["layout.four"] = laysOut(Layout::FourUp);
  all["layout.volume"] = laysOut(Layout::Volume);
  all["layout.beside"] = laysOut(Layout::VolumeAndSection);
  all["layout.section"] = laysOut(Layout::Section);
  // The axial section is seen from the feet: what is nearer is lower.
  all["sections.next"] = scrolls(-1.0);
  all["sections.previous"] = scrolls(1.0);
  for (const scene::GreyWindow& window : scene::greyWindows())
    all["sections.window." + QString::fromStdString(std::string(window.name))] = [window](Keys& keys, const Key& key) {
      keys.document().edit("Unit", [&](scene::Scene& s) {
        Volume volume = *s.volume.data;
        volume.unit = window.unit;
        s.volume.data = Shared<Volume>(std::move(volume));
      });
      keys.press(key);
      EXPECT_EQ(scene::effectiveWindow(keys.scene().volume), glm::dvec2(window.level, window.width));
      EXPECT_EQ(keys.document().undoLabel(), "Change window");
    };
  all["sections.window.type"] = [](Keys& keys, const Key& key) {
    keys.press(key);
    auto* field = QApplication::focusWidget();
    ASSERT_TRUE(field && field->objectName() == "greyWindow");
    EXPECT_TRUE(field->isVisible());
    QTest::keyClicks(field, "300 20");
    QTest::keyClick(field, Qt::Key_Return);
    EXPECT_EQ(scene::effectiveWindow(keys.scene().volume), glm::dvec2(20, 300));
  };
  all["look.showThis"] = [](Keys& keys, const Key& key) {
    keys.mWindow->views().setLayout(Layout::Volume);
    ASSERT_TRUE(keys.settle());
    keys.press(key);
    ASSERT_TRUE(keys.mWindow->toolbox().active());
    keys.clickMiddle();
    EXPECT_EQ(keys.document().undoLabel(), "Show this tissue");
    keys.press(key);
    EXPECT_FALSE(keys.mWindow->toolbox().active()) << "again lays it down";
  };
  // Cuts.
  all["cut.addPlane"] = [](Keys& keys, const Key& key) {
    keys.press(key);
    ASSERT_EQ(keys.scene().cuts.size(), 1u);
    EXPECT_EQ(keys.scene().cuts[0].shape, scene::CutShape::Plane);
    EXPECT_EQ(keys.mWindow->selection().cut(), keys.scene().cuts[0].id);
  };
  all["cut.addMembrane"] = [](Keys& keys, const Key& key) {
    keys.mWindow->views().setLayout(Layout::Section);
    keys.press(key);
    ASSERT_TRUE(keys.waitForJob());
    ASSERT_EQ(keys.scene().cuts.size(), 1u);
    EXPECT_TRUE(scene::isMembrane(keys.scene().cuts[0]));
  };
  all["cut.alongView"] = [](Keys& keys, const Key& key) {
    keys.viewport().lookFrom(scene::StandardView::Oblique);
    keys.press(key);
    ASSERT_EQ(keys.scene().cuts.size(), 1u);
    EXPECT_EQ(keys.scene().cuts[0].shape, scene::CutShape::Plane);
    EXPECT_GT(glm::dot(glm::normalize(keys.scene().cuts[0].axis), keys.towardsEye()), 0.999) << "it faces the eye";
  };
  all["cut.duplicate"] = [](Keys& keys, const Key& key) {
    keys.checkCutRemains(key, [&](const auto& before) {
      ASSERT_EQ(keys.scene().cuts.size(), 3u);
      EXPECT_EQ(keys.scene().cuts[0], before[0]);
      EXPECT_EQ(keys.scene().cuts[1].axis, before[0].axis);
      EXPECT_EQ(keys.scene().cuts[2], before[1]);
    });
  };
  all["cut.handles"] = [](Keys& keys, const Key& key) {
    bool before = keys.mWindow->toolbox().handlesShown();
    keys.press(key);
    EXPECT_NE(keys.mWindow->toolbox().handlesShown(), before);
    keys.press(key);
    EXPECT_EQ(keys.mWindow->toolbox().handlesShown(), before);
  };
  all["cut.flip"] = [](Keys& keys, const Key& key) {
    keys.checkCutRemains(key, [&](auto before) {
      before[0].invert = !before[0].invert;
      EXPECT_EQ(keys.scene().cuts, before);
    });
  };
  all["cut.remove"] = [](Keys& keys, const Key& key) {
    keys.checkCutRemains(key, [&](const auto& before) {
      ASSERT_EQ(keys.scene().cuts.size(), 1u);
      EXPECT_EQ(keys.scene().cuts[0], before[1]);
    });
  };
  all["extrusion.pull"] = [](Keys& keys, const Key& key) {
    keys.press(key);
    ASSERT_EQ(keys.scene().cuts.size(), 1u) << "it makes a plane where there is none";
    EXPECT_TRUE(keys.mWindow->toolbox().active());
    EXPECT_TRUE(keys.mWindow->actions().find("extrusion.pull")->isChecked());
    keys.press(key);
    EXPECT_FALSE(keys.mWindow->toolbox().active()) << "again lays it down";
  };
  all["extrusion.secondPlane"] = [](Keys& keys, const Key& key) {
    keys.addCuts();
    keys.press(key);
    const auto& cuts = keys.scene().cuts;
    ASSERT_EQ(cuts.size(), 3u);
    EXPECT_TRUE(cuts[1].joined) << "to the one that was selected, not to the last";
    EXPECT_FALSE(cuts[2].joined);
    glm::dvec3 first = session::pullDirection(cuts[0], {}), second = session::pullDirection(cuts[1], {});
    EXPECT_NEAR(glm::dot(first, second), 0.0, 1e-6) << "across";
    EXPECT_EQ(keys.mWindow->selection().cut(), cuts[1].id);
  };
  all["membrane.pin"] = [](Keys& keys, const Key& key) {
    keys.hangSheet();
    keys.press(key);
    keys.clickMiddle();
    EXPECT_EQ(keys.scene().cuts[0].membrane->pins.size(), 1u);
  };
  all["membrane.push"] = putsKernel(true);
  all["membrane.pull"] = putsKernel(false);
  // Structures.
  all["structure.find"] = [](Keys& keys, const Key& key) {
    keys.press(key);
    auto* search = keys.child<QLineEdit>("structureSearch");
    ASSERT_TRUE(search);
    EXPECT_TRUE(search->isVisible() && search->hasFocus());
  };
  all["structure.toggle"] = [](Keys& keys, const Key& key) {
    EXPECT_EQ(keys.shownAfter(key, keys.idOf(1), {true, true}), (std::vector<bool>{true, false}));
    EXPECT_EQ(keys.shownAfter(key, keys.idOf(1), {true, false}), (std::vector<bool>{true, true}));
  };
  all["structure.solo"] = [](Keys& keys, const Key& key) {
    EXPECT_EQ(keys.shownAfter(key, keys.idOf(1), {true, true}), (std::vector<bool>{false, true}));
  };
  all["structure.showAll"] = [](Keys& keys, const Key& key) {
    EXPECT_EQ(keys.shownAfter(key, keys.idOf(0), {false, false}), (std::vector<bool>{true, true}));
  };
  all["structure.goTo"] = [](Keys& keys, const Key& key) {
    int id = keys.idOf(1);
    const LabelVolume& labels = *keys.scene().labels.data;
    auto atCrosshair = [&] {
      glm::dvec3 voxel(glm::inverse(labels.worldFromVoxel()) * glm::dvec4(keys.scene().sections.crosshair, 1.0));
      return int(labels.at(glm::clamp(glm::ivec3(glm::round(voxel)), glm::ivec3(0), labels.dims() - 1)));
    };
    ASSERT_NE(atCrosshair(), id);
    keys.document().view([](scene::Scene& s) { s.camera = scene::zoom(s.camera, 4.0); });
    double before = glm::length(keys.scene().camera.eye - keys.scene().camera.target);
    keys.mWindow->selection().setStructure(id);
    keys.press(key);
    EXPECT_TRUE(QTest::qWaitFor([&] { return atCrosshair() == id; }, kPatience));
    // It flies there.
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return glm::length(keys.scene().camera.target - keys.scene().sections.crosshair) < 1e-6; }, 10000));
    EXPECT_LT(glm::length(keys.scene().camera.eye - keys.scene().camera.target), 0.6 * before) << "nearer";
  };
  all["structure.spare"] = [](Keys& keys, const Key& key) {
    keys.addCuts();
    keys.mWindow->selection().setStructure(keys.idOf(1));
    keys.press(key);
    EXPECT_EQ(keys.scene().cuts[0].spares, std::vector<scene::Spare>{{keys.idOf(1)}});
    EXPECT_TRUE(keys.scene().cuts[1].spares.empty()) << "the selected cut alone";
    keys.press(key);
    EXPECT_TRUE(keys.scene().cuts[0].spares.empty()) << "again cuts it";
  };
  return all;
}

}  // namespace velum::gui
