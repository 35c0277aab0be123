// Sketching the force field in the real window: strokes with the mouse, their list, forces of structures, exports.
#include <QComboBox>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>

#include "Shots.h"
#include "WindowFixture.h"
#include "gui/membrane/BrushTool.h"
#include "gui/membrane/MembraneForm.h"
#include "gui/structure/StructureCommands.h"
#include "membrane/forces/Kernels.h"

namespace velum::gui {

class SketchWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    mWindow->resize(1100, 960);
  }
  session::Document& document() { return mWindow->document(); }
  Sketch& tool() { return mWindow->sketch(); }
  bool isBrushing() { return qobject_cast<BrushTool*>(mWindow->toolbox().active()); }
  const scene::ForceField& field() { return scene().cuts[0].membrane->field; }
  SectionView& axial() { return mWindow->views().section(scene::SectionKind::Axial); }
  void addMembrane() {
    drawSoon();
    mWindow->actions().find("cut.addMembrane")->trigger();
    ASSERT_TRUE(waitForJob());
    ASSERT_EQ(scene().cuts.size(), 1u);
    mWindow->views().setLayout(scene::Layout::FourUp);
    ASSERT_TRUE(settle());
  }
  void openWithMembrane() {
    openPhantom();
    addMembrane();
  }
  QPoint placeOf(glm::dvec3 world) {
    glm::dvec2 p = scene::sectionPixelFromWorld(axial().plane(), world);
    return {int(std::lround(p.x)), int(std::lround(p.y))};
  }
  /// Through the middle of the phantom's larger ball, or what is in the middle of the volume.
  void strokeOver(const char* brush, glm::dvec3 way = {6, 0, 0}) {
    QTest::mouseClick(child<QPushButton>(brush), Qt::LeftButton);
    ASSERT_TRUE(isBrushing());
    glm::dvec3 middle = scene().sections.crosshair;
    drag(axial(), placeOf(middle), placeOf(middle + way));
    QTest::qWait(60);  // the panel makes room for the stroke
  }
};

TEST_F(SketchWindow, AStrokeOnASectionFitsTheCurveInOneStep) {
  openWithMembrane();
  auto before = field();
  glm::dvec3 crosshair = scene().sections.crosshair;
  strokeOver("sketchKeep");
  ASSERT_EQ(field().strokes.size(), 1u);
  EXPECT_FALSE(field().strokes[0].avoid);
  EXPECT_GE(field().strokes[0].path.size(), 2u);
  EXPECT_NEAR(field().strokes[0].path[0].z, crosshair.z, 1e-6) << "in the section's plane";
  EXPECT_EQ(field().byValueBefore, before.byValue);
  EXPECT_EQ(scene().sections.crosshair, crosshair) << "the brush moves nothing else";
  double inside = valueAt(*scene().volume.data, scene().volume.data->dims / 2);
  EXPECT_GT(membrane::strengthAt(field().byValue, inside), 0);
  EXPECT_EQ(document().undoLabel(), "Sketch what to protect");
  EXPECT_TRUE(isBrushing()) << "the next stroke may follow";
  takeShot(*mWindow, "sketch-keep");
  QTest::keyClick(&axial(), Qt::Key_Escape);
  EXPECT_FALSE(isBrushing());
  EXPECT_FALSE(child<QPushButton>("sketchKeep")->isChecked());
  ASSERT_TRUE(settle());
  document().undo();
  EXPECT_EQ(field(), before);
}

TEST_F(SketchWindow, AnAvoidingStrokeTakesItBackAndItsRemovalGivesIt) {
  openWithMembrane();
  strokeOver("sketchKeep");
  auto kept = field();
  ASSERT_FALSE(kept.byValue.empty());
  strokeOver("sketchAvoid");
  ASSERT_EQ(field().strokes.size(), 2u);
  EXPECT_TRUE(field().strokes[1].avoid);
  double inside = valueAt(*scene().volume.data, scene().volume.data->dims / 2);
  EXPECT_EQ(membrane::strengthAt(field().byValue, inside), 0);
  auto* list = child<QListWidget>("sketchList");
  ASSERT_EQ(list->count(), 2);
  list->setCurrentRow(1);
  EXPECT_EQ(tool().selected(), 1);
  QTest::qWait(60);
  takeShot(*mWindow, "sketch-avoid");
  QTest::keyClick(list, Qt::Key_Delete);
  EXPECT_EQ(document().undoLabel(), "Remove stroke");
  EXPECT_EQ(field(), kept);
  EXPECT_EQ(list->count(), 1);
  EXPECT_EQ(scene().cuts.size(), 1u) << "the key was not for the cut";
}

TEST_F(SketchWindow, KeysAndWheelChangeTheBrushAndTheMarkedStroke) {
  openWithMembrane();
  strokeOver("sketchKeep");
  double radius = tool().radius();
  EXPECT_GT(radius, 0);
  QTest::keyClick(&axial(), Qt::Key_BracketRight);
  EXPECT_GT(tool().radius(), radius);
  EXPECT_EQ(field().strokes[0].radius, radius) << "no stroke is marked";
  QWheelEvent wheel(QPointF(50, 50), axial().mapToGlobal(QPointF(50, 50)), {}, QPoint(-120, 0), Qt::NoButton,
                    Qt::AltModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&axial(), &wheel);
  EXPECT_NEAR(tool().radius(), radius, 0.06 * radius);
  auto fitted = field().byValue;
  child<QListWidget>("sketchList")->setCurrentRow(0);
  for (int i = 0; i < 4; ++i) QTest::keyClick(&axial(), Qt::Key_BracketRight);
  EXPECT_GT(field().strokes[0].radius, 1.5 * radius);
  EXPECT_EQ(document().undoLabel(), "Change stroke's radius");
  document().undo();
  EXPECT_EQ(field().strokes[0].radius, radius);
  EXPECT_EQ(field().byValue, fitted);
  QTest::keyClick(&axial(), Qt::Key_Delete);
  EXPECT_TRUE(field().strokes.empty());
}

TEST_F(SketchWindow, AStrokeOnThePictureLiesInTheData) {
  openWithMembrane();
  QTest::mouseClick(child<QPushButton>("sketchKeep"), Qt::LeftButton);
  // Beside the cut's handles.
  QPoint middle(viewport().width() / 2, viewport().height() / 2);
  std::size_t strokes = 0;
  for (int x = -60; x <= 60 && strokes == 0; x += 12) {
    drag(middle + QPoint(x, 22), middle + QPoint(x + 8, 26));
    strokes = field().strokes.size();
  }
  ASSERT_EQ(strokes, 1u);
  for (glm::dvec3 p : field().strokes[0].path)
    EXPECT_LT(glm::distance(p, centreOf(*scene().volume.data)), radiusOf(*scene().volume.data));
  takeShot(*mWindow, "sketch-3d");
}

TEST_F(SketchWindow, StructuresHaveForcesInATable) {
  mWindow->openPaths({path("phantom.nrrd"), path("phantom_labels.seg.nrrd")});
  ASSERT_TRUE(waitForJob());
  addMembrane();
  auto* table = child<QTableWidget>("strengthTable");
  auto* add = child<QComboBox>("strengthAdd");
  ASSERT_TRUE(table && add);
  document().edit("Clear", [](scene::Scene& scene) { scene.cuts[0].membrane->field = {}; });
  ASSERT_EQ(table->rowCount(), 0);
  ASSERT_EQ(add->count(), int(scene().labels.structures.size()) + 1);
  add->setCurrentIndex(1);
  emit add->activated(1);
  ASSERT_EQ(table->rowCount(), 1);
  int id = field().byLabel[0].id;
  table->item(0, 1)->setData(Qt::EditRole, -40.0);
  QApplication::processEvents();
  ASSERT_EQ(field().byLabel.size(), 1u);
  EXPECT_EQ(field().byLabel[0], (scene::LabelStrength{id, -40.0}));
  takeShot(*mWindow, "sketch-structures");
  document().undo();
  EXPECT_GT(field().byLabel[0].strength, 0);
  QMenu menu;
  mWindow->structures().fillMenu(menu, {id});
  auto find = [&](const QString& text) {
    for (auto* action : menu.actions())
      if (action->text() == text) return action;
    return static_cast<QAction*>(nullptr);
  };
  ASSERT_TRUE(find("Protect by membrane") && find("Draw membrane to it"));
  EXPECT_TRUE(find("Protect by membrane")->isChecked());
  find("Draw membrane to it")->trigger();
  EXPECT_LT(field().byLabel[0].strength, 0);
  table->selectRow(0);
  QTest::keyClick(table, Qt::Key_Delete);
  EXPECT_TRUE(field().byLabel.empty());
  EXPECT_EQ(scene().cuts.size(), 1u);
}

TEST_F(SketchWindow, ExportsTheSheetThatIsShownAndTheClippedVolume) {
  openWithMembrane();
  mWindow->exports().exportSheetTo(path("sheet.obj"));
  ASSERT_TRUE(waitForJob());
  EXPECT_TRUE(mWindow->lastError().isEmpty()) << mWindow->lastError().toStdString();
  scene::SheetShape shape = viewport().membranes().withShapes(scene()).cuts[0].membrane->shape;
  EXPECT_EQ(bytesOf(path("sheet.obj")).count("\nv "), shape.particles.x * shape.particles.y);
  mWindow->exports().exportClippedTo(path("clipped.nrrd"));
  ASSERT_TRUE(waitForJob());
  EXPECT_TRUE(mWindow->lastError().isEmpty());
  EXPECT_GT(bytesOf(path("clipped.nrrd")).size(), 1000);
  mWindow->exports().exportSheetTo(path("sheet.xyz"));
  ASSERT_TRUE(waitForJob());
  EXPECT_TRUE(mWindow->lastError().contains(".ply"));
}

}  // namespace velum::gui
