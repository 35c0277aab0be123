// Structures and cuts in the real window: the lists, clicks in the picture, tools.
#include <gtest/gtest.h>

#include <QApplication>
#include <QImage>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QTest>

#include "CutPanel.h"
#include "MainWindow.h"
#include "Shots.h"
#include "SliceCutOverlay.h"
#include "StructurePanel.h"
#include "TempFolder.h"
#include "ThreePointTool.h"
#include "velum/io/Sample.h"
#include "velum/io/WriteVolume.h"
#include "velum/scene/Project.h"
#include "velum/scene/SliceFrame.h"

namespace velum::gui {

namespace {

class StructureWindow : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    sFolder = new TempFolder;
    Progress progress;
    io::Sample sample = io::makeSample("two-spheres", 32, progress);
    io::writeVolume(sample.volume, *sFolder / "phantom.nrrd", progress);
    io::writeLabels(sample.labels, *sFolder / "phantom_labels.seg.nrrd", progress);
  }
  static void TearDownTestSuite() { delete sFolder; }

  void SetUp() override {
    mWindow = std::make_unique<MainWindow>();
    mWindow->resize(900, 700);
    mWindow->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(mWindow.get()));
    mWindow->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(mWindow.get()));
  }

  static QString path(const char* name) { return QString::fromStdString((*sFolder / name).string()); }
  session::Document& document() { return mWindow->document(); }
  const scene::Scene& scene() { return document().scene(); }
  const std::vector<scene::Structure>& structures() { return scene().labels.structures; }
  Viewport& viewport() { return mWindow->viewport(); }
  StructureList& list() { return *child<StructureList>("structureList"); }
  template <class T>
  T* child(const char* name) {
    return mWindow->findChild<T*>(name);
  }
  bool wait(const std::function<bool()>& until) { return QTest::qWaitFor(until, 60000); }

  void openWithLabels() {
    mWindow->openPaths({path("phantom.nrrd"), path("phantom_labels.seg.nrrd")});
    ASSERT_TRUE(wait([&] { return !mWindow->isBusy(); }));
    ASSERT_GE(structures().size(), 2u);
    document().amend([](scene::Scene& scene) { scene.rayCast.samplesPerPixel = 1; });  // enough to pick from
    mWindow->actions().find("structure.list")->trigger();
    ASSERT_TRUE(wait([&] { return list().isVisible(); }));
  }
  /// As many structures as one likes, without a file.
  void openMany(int count) {
    openWithLabels();
    document().edit("Many", [&](scene::Scene& scene) {
      scene.labels.structures.clear();
      for (int i = 1; i <= count; ++i)
        scene.labels.structures.push_back({i, "region " + std::to_string(i), {0.3f, 0.5f, 0.7f}});
    });
  }
  void clickCell(int id, StructureModel::Column column, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseClick(list().viewport(), Qt::LeftButton, keys, list().cellOf(id, column).center());
  }
  bool settle() {
    return wait([&] { return mWindow->isSettled(); });
  }
  /// A place of the picture where a structure is seen.
  std::optional<QPoint> placeOf(int id) {
    for (int y = 10; y < viewport().height(); y += 12)
      for (int x = 10; x < viewport().width(); x += 12)
        if (auto pick = viewport().pickAt(QPointF(x, y)); pick && pick->hit && pick->structure == id)
          return QPoint(x, y);
    return std::nullopt;
  }

  inline static TempFolder* sFolder = nullptr;
  std::unique_ptr<MainWindow> mWindow;
};

using Column = StructureModel::Column;

}  // namespace

TEST_F(StructureWindow, WithoutLabelsThePanelSaysWhatToDoAndOpensThemBeside) {
  mWindow->openPaths({path("phantom.nrrd")});
  ASSERT_TRUE(wait([&] { return !mWindow->isBusy(); }));
  mWindow->actions().find("structure.list")->trigger();
  EXPECT_FALSE(list().isVisible());
  takeShot(*mWindow, "structures-empty");
  mWindow->openLabels(path("phantom_labels.seg.nrrd"));
  ASSERT_TRUE(wait([&] { return !mWindow->isBusy(); }));
  EXPECT_TRUE(list().isVisible());
  EXPECT_EQ(list().listedIds().size(), structures().size());
}

TEST_F(StructureWindow, TheEyeHidesUnderAName) {
  openWithLabels();
  int id = structures()[0].id;
  clickCell(id, StructureModel::Eye);
  EXPECT_FALSE(structures()[0].visible);
  EXPECT_EQ(document().undoLabel(), "Hide " + structures()[0].name);
  document().undo();
  EXPECT_TRUE(structures()[0].visible);
}

TEST_F(StructureWindow, SoloBySAndByAltOnTheEyeRestoresWhatWasVisible) {
  openWithLabels();
  clickCell(structures()[0].id, StructureModel::Eye);
  scene::LabelLayer before = scene().labels;
  clickCell(structures()[1].id, StructureModel::Eye, Qt::AltModifier);
  EXPECT_EQ(session::soloStructure(scene()), structures()[1].id);
  EXPECT_EQ(document().undoLabel(), "Solo " + structures()[1].name);
  clickCell(structures()[1].id, StructureModel::Solo);
  EXPECT_EQ(scene().labels, before);
}

TEST_F(StructureWindow, ADragOfTheOpacityIsOneStep) {
  openWithLabels();
  int id = structures()[0].id;
  QRect cell = list().cellOf(id, StructureModel::Opacity);
  QWidget* port = list().viewport();
  QTest::mousePress(port, Qt::LeftButton, {}, cell.center());
  for (int x = cell.center().x(); x > cell.left() + 12; x -= 4) QTest::mouseMove(port, {x, cell.center().y()});
  QTest::mouseRelease(port, Qt::LeftButton, {}, {cell.left() + 12, cell.center().y()});
  EXPECT_LT(structures()[0].opacity, 0.4);
  EXPECT_GT(structures()[0].opacity, 0.0);
  document().undo();
  EXPECT_EQ(structures()[0].opacity, 1.0);
  EXPECT_FALSE(document().canUndo());
}

TEST_F(StructureWindow, F2RenamesAndSpaceHides) {
  openWithLabels();
  int id = structures()[1].id;
  clickCell(id, StructureModel::Name);
  EXPECT_EQ(mWindow->selection().structure(), id);
  QTest::keyClick(&list(), Qt::Key_F2);
  auto* editor = list().findChild<QLineEdit*>();
  ASSERT_TRUE(editor);
  editor->setText("aorta");
  QTest::keyClick(editor, Qt::Key_Return);
  EXPECT_TRUE(wait([&] { return structures()[1].name == "aorta" && list().hasFocus(); }));
  QTest::keyClick(&list(), Qt::Key_Space);
  EXPECT_EQ(document().undoLabel(), "Hide aorta");
}

TEST_F(StructureWindow, ANameThatIsBeingTypedOutlivesTheCountAndClosesWithTheWindow) {
  openWithLabels();
  clickCell(structures()[1].id, StructureModel::Name);
  QTest::keyClick(&list(), Qt::Key_F2);
  auto* editor = list().findChild<QLineEdit*>();
  ASSERT_TRUE(editor);
  editor->setText("aorta");
  emit mWindow->structures().meter().measured();
  EXPECT_EQ(editor->text(), "aorta");
  mWindow.reset();
}

TEST_F(StructureWindow, SearchFindsByNameAndNumberAndTheButtonsActOnWhatIsListed) {
  openMany(1200);
  QTest::keyClick(mWindow.get(), Qt::Key_F, Qt::ControlModifier);
  auto* search = child<QLineEdit>("structureSearch");
  EXPECT_TRUE(search->hasFocus());
  QTest::keyClicks(search, "region 77");
  EXPECT_EQ(list().listedIds().size(), 21u);  // 77, 177 and so on, 770 to 779
  search->setText("1007");
  EXPECT_EQ(list().listedIds(), std::vector<int>{1007});
  search->setText("region 120");
  QTest::mouseClick(child<QPushButton>("hideAll"), Qt::LeftButton);
  EXPECT_FALSE(structures()[119].visible);
  EXPECT_FALSE(structures()[1199].visible);
  EXPECT_TRUE(structures()[0].visible);
  EXPECT_FALSE(structures()[1119].visible);
  EXPECT_EQ(document().undoLabel(), "Hide 3 structures");
  // What is selected elsewhere is shown, even where the search hides it.
  mWindow->selection().setStructure(5);
  EXPECT_TRUE(search->text().isEmpty());
  EXPECT_EQ(list().selectedIds(), std::vector<int>{5});
}

TEST_F(StructureWindow, ThousandsOfRowsCostNothingWhileTheCameraMoves) {
  openMany(3000);
  int resets = 0, changes = 0;
  QObject::connect(&list().rows(), &QAbstractItemModel::modelReset, [&] { ++resets; });
  QObject::connect(&list().rows(), &QAbstractItemModel::dataChanged, [&] { ++changes; });
  for (int i = 0; i < 50; ++i) document().amend([i](scene::Scene& scene) { scene.camera.eyeMm.x = i; });
  EXPECT_EQ(resets + changes, 0);
  clickCell(3, StructureModel::Eye);
  EXPECT_EQ(resets, 0);
  EXPECT_EQ(changes, 1);
}

TEST_F(StructureWindow, AClickInThePictureSelectsAndItsRowIsSeen) {
  openWithLabels();
  ASSERT_TRUE(settle());
  for (const auto& structure : structures()) {
    auto place = placeOf(structure.id);
    if (!place) continue;
    QTest::mouseClick(&viewport(), Qt::LeftButton, {}, *place);
    EXPECT_EQ(mWindow->selection().structure(), structure.id);
    EXPECT_EQ(list().selectedIds(), std::vector<int>{structure.id});
    EXPECT_TRUE(list().viewport()->rect().intersects(list().cellOf(structure.id, StructureModel::Name)));
  }
  QTest::mouseClick(&viewport(), Qt::LeftButton, {}, {3, 3});
  EXPECT_EQ(mWindow->selection().structure(), 0);
  EXPECT_FALSE(document().canUndo());  // selecting is no edit
}

TEST_F(StructureWindow, ADoubleClickGoesThere) {
  openWithLabels();
  ASSERT_TRUE(wait([&] { return !mWindow->structures().meter().isMeasuring(); }));
  int id = structures().back().id;
  const auto* size = mWindow->structures().meter().find(id);
  ASSERT_TRUE(size);
  glm::dvec3 middle = session::middleOfStructure(*scene().labels.data, id, *size);
  QTest::mouseDClick(list().viewport(), Qt::LeftButton, {}, list().cellOf(id, StructureModel::Name).center());
  EXPECT_EQ(scene().slices.crosshairMm, middle);
  EXPECT_TRUE(wait([&] { return glm::length(scene().camera.targetMm - middle) < 1e-9; }));
  EXPECT_FALSE(document().canUndo());
}

TEST_F(StructureWindow, ACutKeepsAStructureWholeFromListAndMenu) {
  openWithLabels();
  mWindow->actions().find("cut.addPlane")->trigger();
  ASSERT_EQ(scene().cuts.size(), 1u);
  int first = structures()[0].id, second = structures()[1].id;
  auto* kept = child<QListView>("keepWholeList");
  ASSERT_TRUE(kept);
  kept->model()->setData(kept->model()->index(0, 0), Qt::Checked, Qt::CheckStateRole);
  EXPECT_EQ(scene().cuts[0].exempt, std::vector<int>{first});
  EXPECT_EQ(document().undoLabel(), "Keep whole " + structures()[0].name);
  QMenu menu;
  mWindow->structures().fillMenu(menu, {second});
  QStringList texts;
  for (QAction* action : menu.actions()) {
    texts << action->text();
    if (action->text().startsWith("Keep whole")) action->trigger();
  }
  EXPECT_TRUE(texts.contains("Hide")) << texts.join(", ").toStdString();
  EXPECT_TRUE(texts.contains("Solo"));
  EXPECT_EQ(scene().cuts[0].exempt, (std::vector<int>{first, second}));
  EXPECT_EQ(kept->model()->index(1, 0).data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
}

TEST_F(StructureWindow, EveryShapeIsAddedNamedEditedAndMoved) {
  openWithLabels();
  for (const char* id : {"cut.addBox", "cut.addSphere", "cut.addCylinder", "cut.addCone", "cut.alongView"})
    mWindow->actions().find(id)->trigger();
  ASSERT_EQ(scene().cuts.size(), 5u);
  EXPECT_EQ(scene().cuts[1].shape, scene::CutShape::Sphere);
  EXPECT_EQ(scene().cuts[1].name, "Sphere 2");
  EXPECT_EQ(mWindow->selection().cut(), 4);
  auto* cuts = child<QListWidget>("cutList");
  cuts->setCurrentRow(0);
  EXPECT_EQ(mWindow->selection().cut(), 0);
  EXPECT_EQ(viewport().selectedCut(), 0);
  child<QDoubleSpinBox>("cutSize1")->setValue(12.5);
  child<QDoubleSpinBox>("cutCentre2")->setValue(-3.5);
  child<QDoubleSpinBox>("cutAzimuth")->setValue(90.0);
  EXPECT_EQ(scene().cuts[0].sizeMm.y, 12.5);
  EXPECT_EQ(scene().cuts[0].centreMm.z, -3.5);
  QTest::mouseClick(child<QPushButton>("alignL"), Qt::LeftButton);
  EXPECT_EQ(scene().cuts[0].axis, glm::dvec3(1, 0, 0));
  cuts->item(0)->setText("window");
  EXPECT_EQ(scene().cuts[0].name, "window");
  cuts->item(0)->setCheckState(Qt::Unchecked);
  EXPECT_FALSE(scene().cuts[0].enabled);
  QTest::mouseClick(child<QPushButton>("cutDown"), Qt::LeftButton);
  EXPECT_EQ(scene().cuts[1].name, "window");
  EXPECT_EQ(mWindow->selection().cut(), 1);
  QTest::mouseClick(child<QPushButton>("cutDuplicate"), Qt::LeftButton);
  EXPECT_EQ(scene().cuts[2].name, "window copy");
  QTest::mouseClick(child<QPushButton>("cutRemove"), Qt::LeftButton);
  EXPECT_EQ(scene().cuts.size(), 5u);
}

TEST_F(StructureWindow, AFaceIsDraggedWithItsHandle) {
  openWithLabels();
  mWindow->actions().find("cut.addBox")->trigger();
  viewport().lookFrom(scene::StandardView::Left);
  scene::Cut before = scene().cuts[0];
  glm::dvec2 size(viewport().width(), viewport().height());
  auto gizmo = session::makeCutGizmo(scene(), before, size);
  glm::dvec3 face = session::handlePlaceMm(gizmo, session::CutHandle::FaceZMax);
  auto from = scene::pixelFromWorld(scene().camera, size, face);
  auto to = scene::pixelFromWorld(scene().camera, size, face + glm::dvec3(0, 0, 4));
  ASSERT_TRUE(from && to);
  QPoint a(int(from->x), int(from->y)), b(int(to->x), int(to->y));
  QTest::mousePress(&viewport(), Qt::LeftButton, {}, a);
  QTest::mouseMove(&viewport(), (a + b) / 2);
  QTest::mouseMove(&viewport(), b);
  QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, b);
  const scene::Cut& now = scene().cuts[0];
  EXPECT_GT(now.sizeMm.z, before.sizeMm.z + 1.0);
  EXPECT_NEAR(now.centreMm.z - now.sizeMm.z * 0.5, before.centreMm.z - before.sizeMm.z * 0.5, 1e-9);
  EXPECT_EQ(document().undoLabel(), "Resize cut");
  document().undo();
  EXPECT_EQ(scene().cuts[0], before);
}

TEST_F(StructureWindow, ThreeClicksMakeAPlaneThroughWhatWasClickedAndEscGivesUp) {
  openWithLabels();
  ASSERT_TRUE(settle());
  ThreePointTool& tool = mWindow->threePoints();
  mWindow->actions().find("cut.threePoints")->trigger();
  EXPECT_TRUE(tool.isActive());
  QPoint middle = viewport().rect().center();
  QTest::mouseClick(&viewport(), Qt::LeftButton, {}, middle);
  EXPECT_EQ(tool.points().size(), 1u);
  QTest::keyClick(&viewport(), Qt::Key_Escape);
  EXPECT_FALSE(tool.isActive());
  EXPECT_TRUE(scene().cuts.empty());
  mWindow->actions().find("cut.threePoints")->trigger();
  std::vector<glm::dvec3> places;
  for (QPoint off : {QPoint(0, -10), QPoint(-14, 8), QPoint(14, 10)}) {
    auto pick = viewport().pickAt(QPointF(middle + off));
    ASSERT_TRUE(pick && pick->hit);
    places.push_back(pick->worldMm);
    if (places.size() == 3) takeShot(*mWindow, "three-points");
    QTest::mouseClick(&viewport(), Qt::LeftButton, {}, middle + off);
  }
  ASSERT_EQ(scene().cuts.size(), 1u);
  for (glm::dvec3 p : places) EXPECT_NEAR(glm::dot(p - scene().cuts[0].centreMm, scene().cuts[0].axis), 0.0, 1e-3);
  EXPECT_EQ(document().undoLabel(), "Plane through three points");
  EXPECT_FALSE(tool.isActive());
}

TEST_F(StructureWindow, OnASliceACutIsDraggedByItsLine) {
  openWithLabels();
  mWindow->actions().find("cut.addPlane")->trigger();
  SliceCutOverlay overlay(document(), mWindow->selection());
  scene::SliceFrame frame = scene::makeSliceFrame(scene(), scene::SliceKind::Axial, {300, 300});
  scene::Cut before = scene().cuts[0];
  auto handles = session::sliceHandles(frame, before);
  ASSERT_FALSE(handles.empty());
  glm::dvec2 place = handles.back().place, out = handles.back().outwards;
  QPointF from(place.x, place.y), to = from + QPointF(out.x, out.y) * 20.0;
  EXPECT_TRUE(overlay.move(from, frame, false));
  EXPECT_NE(overlay.cursor(), Qt::ArrowCursor);
  EXPECT_TRUE(overlay.press(from, frame));
  EXPECT_TRUE(overlay.move(to, frame, false));
  EXPECT_TRUE(overlay.release());
  glm::dvec3 moved = scene().cuts[0].centreMm - before.centreMm;
  EXPECT_NEAR(glm::dot(moved, before.axis), 20.0 * frame.mmPerPixel, 1e-9);
  EXPECT_EQ(document().undoLabel(), "Move cut");
  EXPECT_FALSE(overlay.press({2, 2}, frame));
  // What is removed is darker, what is kept is as it was.
  QImage image(300, 300, QImage::Format_RGB32);
  image.fill(Qt::gray);
  QPainter painter(&image);
  overlay.paint(painter, frame);
  painter.end();
  glm::dvec2 line = session::sliceOutline(frame, scene().cuts[0]).points[0];
  QPointF gone = QPointF(150, line.y) + QPointF(60, 0) + QPointF(out.x, out.y) * 60;
  QPointF kept = QPointF(150, line.y) + QPointF(60, 0) - QPointF(out.x, out.y) * 60;
  EXPECT_LT(qGray(image.pixel(gone.toPoint())), qGray(image.pixel(kept.toPoint())));
}

}  // namespace velum::gui
