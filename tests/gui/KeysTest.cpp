// Every key of keys.json, pressed in the real window, does what the guide says. A key without a row here fails.
#include <QFileDialog>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>
#include <QTimer>
#include <functional>
#include <map>

#include "DicomSeries.h"
#include "WindowFixture.h"
#include "velum/scene/Navigate.h"
#include "velum/scene/SectionPlane.h"
#include "velum/session/cut/CutTool.h"
#include "view/TimeBar.h"

namespace velum::gui {

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
  static QJsonObject keyTable() { return QJsonDocument::fromJson(bytesOf(":/velum/keys.json")).object(); }
};

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
    EXPECT_TRUE(QTest::qWaitFor([&] { return keys.scene().volume.timeStep > 0; }, 20000));
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
    scene::Bounds bounds = scene::computeBounds(keys.scene());
    for (int i = 0; i < 8; ++i) {
      glm::dvec3 corner(i & 1 ? bounds.max.x : bounds.min.x, i & 2 ? bounds.max.y : bounds.min.y,
                        i & 4 ? bounds.max.z : bounds.min.z);
      glm::dvec2 pixel = scene::pixelFromWorld(keys.scene().camera, keys.size(), corner).value();
      EXPECT_TRUE(glm::all(glm::greaterThan(pixel, glm::dvec2(0))) && glm::all(glm::lessThan(pixel, keys.size())));
    }
  };
  all["layout.four"] = laysOut(Layout::FourUp);
  all["layout.volume"] = laysOut(Layout::Volume);
  all["layout.beside"] = laysOut(Layout::VolumeAndSection);
  all["layout.section"] = laysOut(Layout::Section);
  // The axial section is seen from the feet: what is nearer is lower.
  all["sections.next"] = scrolls(-1.0);
  all["sections.previous"] = scrolls(1.0);
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
    EXPECT_TRUE(QTest::qWaitFor([&] { return atCrosshair() == id; }, 10000));
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

TEST_F(Keys, EachDoesWhatTheGuideSays) {
  auto known = checks();
  QJsonObject table = keyTable();
  ASSERT_GT(table.size(), 40);
  for (auto row = table.begin(); row != table.end(); ++row) {
    auto check = known.find(row.key());
    if (check == known.end()) {
      ADD_FAILURE() << row.key().toStdString() << " has keys that nobody has tried: give it a row in Keys::checks()";
      continue;
    }
    EXPECT_FALSE(row.value().toArray().isEmpty()) << row.key().toStdString();
    for (const auto& text : row.value().toArray()) {
      SCOPED_TRACE(row.key().toStdString() + " by " + text.toString().toStdString());
      renew();
      if (HasFatalFailure()) return;
      check->second(*this, QKeySequence(text.toString(), QKeySequence::PortableText));
    }
  }
}

TEST_F(Keys, AreThoseOfTheGuide) {
  // What the guide says of each command; %1: its keys.
  const std::map<QString, QString> kWords = {
      {"file.new", "| %1 | close what is open |"},
      {"file.open", "| %1 | open files |"},
      {"file.openFolder", "| %1 | open a folder |"},
      {"file.add", "| %1 | add labels or surfaces |"},
      {"file.saveScene", "| %1 | save the scene |"},
      {"file.saveSceneAs", "| %1 | save the scene as |"},
      {"file.savePicture", "| %1 | save a picture |"},
      {"file.cancel", "| %1 | stop a load or a picture |"},
      {"file.quit", "| %1 | quit |"},
      {"file.newWindow", "New window* (%1)"},
      {"edit.undo", "| %1 | undo |"},
      {"edit.redo", "| %1 | redo |"},
      {"edit.preferences", "Preferences* (%1)"},
      {"time.play", "%1 plays and pauses"},
      {"time.next", "step with %1 and "},
      {"time.previous", "and %1 (full stop and comma)"},
      {"help.guide", "%1 opens this guide"},
      {"help.find", "%1 finds any command"},
      {"view.anterior", "| %1 | look from anterior |"},
      {"view.posterior", "| %1 | from posterior |"},
      {"view.left", "| %1 | from the left |"},
      {"view.right", "| %1 | from the right |"},
      {"view.superior", "| %1 | from superior |"},
      {"view.inferior", "| %1 | from inferior |"},
      {"view.oblique", "| %1 | obliquely |"},
      {"view.parallel", "| %1 | parallel or perspective |"},
      {"view.reset", "| %1 | see all of it from the front |"},
      {"layout.four", "four views (%1)"},
      {"layout.volume", "3D alone (%1)"},
      {"layout.beside", "3D and one section (%1)"},
      {"layout.section", ", one section (%1)"},
      {"sections.next", "forward is away from you | PgUp, %1, Shift: ten |"},
      {"sections.previous", "forward is away from you | %1, PgDown, Shift: ten |"},
      {"look.showThis", "| %1 | show tissue by clicking it |"},
      {"cut.addPlane", "| %1 | add a cut |"},
      {"cut.addMembrane", "Add one with *Membrane* (%1)"},
      {"cut.alongView", "| %1 | cut along the view |"},
      {"cut.duplicate", "| %1 | duplicate the selected cut |"},
      {"cut.flip", "| %1 | flip the selected cut |"},
      {"cut.remove", "| %1 | remove the selected cut |"},
      {"membrane.pin", "*Pin* (%1)"},
      {"membrane.push", "*Push kernel* (%1)"},
      {"membrane.pull", "*Pull kernel* (%1)"},
      {"structure.find", "| %1 | find a structure |"},
      {"structure.toggle", "| %1 | hide or show the selected structure |"},
      {"structure.solo", "| %1 | show it alone |"},
      {"structure.showAll", "| %1 | show all structures |"},
      {"structure.goTo", "| %1 | go to it |"},
      {"structure.spare", "| %1 | keep it whole in the selected cut |"},
  };
  QString guide = QString::fromUtf8(bytesOf(VELUM_SOURCE_DIR "/docs/USER-GUIDE.md")).simplified();
  QJsonObject table = keyTable();
  for (auto row = table.begin(); row != table.end(); ++row) {
    QStringList keys;
    for (const auto& key : row.value().toArray()) keys << key.toString();
    auto words = kWords.find(row.key());
    ASSERT_TRUE(words != kWords.end()) << "what does the guide say of " << row.key().toStdString() << "?";
    QString wanted = words->second.arg(keys.join(", "));
    EXPECT_TRUE(guide.contains(wanted)) << "the guide does not say: " << wanted.toStdString();
  }
}

TEST_F(Keys, OfASectionMoveTheCrosshairOnTheScreen) {
  using scene::SectionKind;
  renew();
  mWindow->resize(1100, 700);
  QTest::qWait(20);
  for (auto kind : {SectionKind::Axial, SectionKind::Coronal, SectionKind::Sagittal}) {
    SectionView& view = mWindow->views().section(kind);
    view.setFocus();
    double step = scene::sectionStep(scene());
    for (auto keys : {Qt::NoModifier, Qt::ShiftModifier})
      for (auto [key, right, up, near] : {std::tuple(Qt::Key_Right, 1.0, 0.0, 0.0),
                                          {Qt::Key_Left, -1.0, 0.0, 0.0},
                                          {Qt::Key_Up, 0.0, 1.0, 0.0},
                                          {Qt::Key_Down, 0.0, -1.0, 0.0},
                                          {Qt::Key_PageDown, 0.0, 0.0, 1.0},
                                          {Qt::Key_PageUp, 0.0, 0.0, -1.0}}) {
        QTest::keyClick(&view, Qt::Key_Home);
        glm::dvec3 before = scene().sections.crosshair;
        scene::SectionPlane plane = view.plane();
        QTest::keyClick(&view, key, keys);
        glm::dvec3 wanted = step * (right * plane.right + up * plane.up + near * plane.normal);
        if (keys) wanted *= 10.0;
        EXPECT_LT(glm::length(scene().sections.crosshair - before - wanted), 1e-6)
            << int(kind) << " key " << int(key) << (keys ? " with Shift" : "");
      }
  }
}

}  // namespace velum::gui
