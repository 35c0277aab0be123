// Cuts in the real window: the list and its numbers, handles, three points, sections, what is left whole.
#include <QListView>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>

#include "Shots.h"
#include "StructureFixture.h"
#include "gui/cut/CutPanel.h"
#include "gui/cut/ThreePointTool.h"
#include "scene/Project.h"
#include "scene/SectionPlane.h"
#include "session/cut/SectionCutTool.h"

namespace velum::gui {

class CutWindow : public StructureWindow {
 protected:
  static void drag(QWidget& view, QPoint from, QPoint to) {
    QTest::mousePress(&view, Qt::LeftButton, {}, from);
    QTest::mouseMove(&view, (from + to) / 2);
    QTest::mouseMove(&view, to);
    QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
  }
};

TEST_F(CutWindow, ACutKeepsAStructureWholeFromListAndMenu) {
  openWithLabels();
  mWindow->actions().find("cut.addPlane")->trigger();
  ASSERT_EQ(scene().cuts.size(), 1u);
  int first = structures()[0].id, second = structures()[1].id;
  auto* kept = child<QListView>("spareList");
  ASSERT_TRUE(kept);
  kept->model()->setData(kept->model()->index(0, 0), Qt::Checked, Qt::CheckStateRole);
  EXPECT_EQ(scene().cuts[0].spares, std::vector<scene::Spare>{{first}});
  EXPECT_EQ(document().undoLabel(), "Spare " + structures()[0].name);
  QMenu menu;
  mWindow->structures().fillMenu(menu, {second});
  QStringList texts;
  for (QAction* action : menu.actions()) {
    texts << action->text();
    if (action->text().startsWith("Spare")) action->trigger();
  }
  EXPECT_TRUE(texts.contains("Hidden")) << texts.join(", ").toStdString();
  EXPECT_TRUE(texts.contains("Solo"));
  EXPECT_EQ(scene().cuts[0].spares, (std::vector<scene::Spare>{{first}, {second}}));
  EXPECT_EQ(kept->model()->index(1, 0).data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
}

TEST_F(CutWindow, AClickAnywhereOnTheEyeOfACutTurnsItOnOrOffOnce) {
  openWithLabels();
  mWindow->actions().find("cut.addPlane")->trigger();
  auto* cuts = child<QListWidget>("cutList");
  QRect row = cuts->visualItemRect(cuts->item(0));
  for (int x = 2; x < 27; x += 3)
    for (int y = 2; y < row.height() - 1; y += 4) {
      bool before = scene().cuts[0].enabled;
      QTest::mouseClick(cuts->viewport(), Qt::LeftButton, {}, row.topLeft() + QPoint(x, y));
      EXPECT_EQ(scene().cuts[0].enabled, !before) << x << ", " << y;
      EXPECT_EQ(document().undoLabel(), before ? "Turn cut off" : "Turn cut on");
      document().undo();
      EXPECT_EQ(scene().cuts[0].enabled, before) << "and is one step";
    }
}

TEST_F(CutWindow, UndoAfterEnterInAFieldTakesBackWhatWasEntered) {
  openWithLabels();
  mWindow->actions().find("cut.addBox")->trigger();
  auto* field = child<QDoubleSpinBox>("cutSize1");
  double before = scene().cuts[0].size.y;
  auto type = [&](const char* text) {
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
  };
  type("12.5");
  QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(scene().cuts[0].size.y, 12.5);
  QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(scene().cuts[0].size.y, before);
  EXPECT_NEAR(field->value(), before, 0.051) << "as it is shown";
  QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(scene().cuts[0].size.y, 12.5) << "and redo brings it back";
  // The same number as it is shown: the text has its own memory of that.
  type("12.5 mm");
  QTest::keyClick(field, Qt::Key_Return);
  QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(scene().cuts[0].size.y, before);
  // What is being typed is the field's.
  type("7");
  QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(scene().cuts[0].size.y, before);
  EXPECT_NE(field->text().trimmed(), "7");
}

TEST_F(CutWindow, EveryShapeIsAddedNamedEditedAndMoved) {
  openWithLabels();
  for (const char* id : {"cut.addBox", "cut.addSphere", "cut.addCylinder", "cut.addCone", "cut.alongView"})
    mWindow->actions().find(id)->trigger();
  ASSERT_EQ(scene().cuts.size(), 5u);
  EXPECT_EQ(scene().cuts[1].shape, scene::CutShape::Sphere);
  EXPECT_EQ(scene().cuts[1].name, "Sphere 1");
  EXPECT_EQ(mWindow->selection().cut(), scene().cuts[4].id);
  auto* cuts = child<QListWidget>("cutList");
  cuts->setCurrentRow(0);
  int window = scene().cuts[0].id;
  EXPECT_EQ(mWindow->selection().cut(), window);
  child<QDoubleSpinBox>("cutSize1")->setValue(12.5);
  child<QDoubleSpinBox>("cutCentre2")->setValue(-3.5);
  child<QDoubleSpinBox>("cutAzimuth")->setValue(90.0);
  EXPECT_EQ(scene().cuts[0].size.y, 12.5);
  EXPECT_EQ(scene().cuts[0].centre.z, -3.5);
  QTest::mouseClick(child<QPushButton>("alignL"), Qt::LeftButton);
  EXPECT_EQ(scene().cuts[0].axis, glm::dvec3(1, 0, 0));
  cuts->item(0)->setText("window");
  EXPECT_EQ(scene().cuts[0].name, "window");
  cuts->item(0)->setCheckState(Qt::Unchecked);
  EXPECT_FALSE(scene().cuts[0].enabled);
  QTest::mouseClick(child<QPushButton>("cutDown"), Qt::LeftButton);
  EXPECT_EQ(scene().cuts[1].name, "window");
  EXPECT_EQ(scene().cuts[1].id, window);
  EXPECT_EQ(mWindow->selection().cut(), window);
  QTest::mouseClick(child<QPushButton>("cutDuplicate"), Qt::LeftButton);
  EXPECT_EQ(scene().cuts[2].name, "window copy");
  EXPECT_EQ(mWindow->selection().cut(), scene().cuts[2].id);
  QTest::mouseClick(child<QPushButton>("cutRemove"), Qt::LeftButton);
  EXPECT_EQ(scene().cuts.size(), 5u);
  EXPECT_EQ(mWindow->selection().cut(), scene().cuts[2].id) << "what stands there now";
  mWindow->selection().setCut(window);
  document().undo();
  document().undo();
  document().undo();
  EXPECT_EQ(scene().cuts[0].id, window);
  EXPECT_EQ(mWindow->selection().cut(), window) << "undo brings places back, and ids stay";
}

TEST_F(CutWindow, AFaceIsDraggedWithItsHandle) {
  openWithLabels();
  mWindow->actions().find("cut.addBox")->trigger();
  viewport().lookFrom(scene::StandardView::Left);
  scene::Cut before = scene().cuts[0];
  glm::dvec2 size(viewport().width(), viewport().height());
  auto gizmo = session::makeCutGizmo(scene(), before, size);
  glm::dvec3 face = session::handlePlace(gizmo, session::CutHandle::FaceZMax);
  auto from = scene::pixelFromWorld(scene().camera, size, face);
  auto to = scene::pixelFromWorld(scene().camera, size, face + glm::dvec3(0, 0, 4));
  ASSERT_TRUE(from && to);
  QPoint a(int(from->x), int(from->y)), b(int(to->x), int(to->y));
  drag(viewport(), a, b);
  const scene::Cut& now = scene().cuts[0];
  EXPECT_GT(now.size.z, before.size.z + 1.0);
  EXPECT_NEAR(now.centre.z - now.size.z * 0.5, before.centre.z - before.size.z * 0.5, 1e-9);
  EXPECT_EQ(document().undoLabel(), "Resize cut");
  document().undo();
  EXPECT_EQ(scene().cuts[0], before);
}

TEST_F(CutWindow, ThreeClicksMakeAPlaneThroughWhatWasClickedAndEscGivesUp) {
  openWithLabels();
  ASSERT_TRUE(settle());
  auto hint = [&] { return mWindow->toolbox().active() ? mWindow->toolbox().active()->hint() : QString(); };
  mWindow->actions().find("cut.threePoints")->trigger();
  EXPECT_TRUE(hint().contains("first"));
  QPoint middle = viewport().rect().center();
  QTest::mouseClick(&viewport(), Qt::LeftButton, {}, middle);
  EXPECT_TRUE(hint().contains("second"));
  QTest::mouseClick(&viewport(), Qt::LeftButton, {}, QPoint(3, 3));
  EXPECT_TRUE(hint().contains("Nothing is there") && hint().contains("second")) << hint().toStdString();
  QTest::keyClick(&viewport(), Qt::Key_Escape);
  EXPECT_FALSE(mWindow->toolbox().active());
  EXPECT_TRUE(scene().cuts.empty());
  mWindow->actions().find("cut.threePoints")->trigger();
  std::vector<glm::dvec3> places;
  for (QPoint off : {QPoint(0, -10), QPoint(-14, 8), QPoint(14, 10)}) {
    auto pick = viewport().pickAt(QPointF(middle + off));
    ASSERT_TRUE(pick && pick->hit);
    places.push_back(pick->world);
    if (places.size() == 3) takeShot(*mWindow, "three-points");
    QTest::mouseClick(&viewport(), Qt::LeftButton, {}, middle + off);
  }
  ASSERT_EQ(scene().cuts.size(), 1u);
  for (glm::dvec3 p : places) EXPECT_NEAR(glm::dot(p - scene().cuts[0].centre, scene().cuts[0].axis), 0.0, 1e-3);
  EXPECT_EQ(document().undoLabel(), "Plane through three points");
  EXPECT_FALSE(mWindow->toolbox().active());
}

TEST_F(CutWindow, WhatAToolHasBegunEndsWithItsData) {
  openWithLabels();
  ASSERT_TRUE(settle());
  mWindow->actions().find("cut.threePoints")->trigger();
  QTest::mouseClick(&viewport(), Qt::LeftButton, {}, viewport().rect().center());
  ASSERT_TRUE(mWindow->toolbox().active());
  mWindow->openPaths({path("phantom.nrrd")});
  ASSERT_TRUE(wait([&] { return !mWindow->isBusy(); }));
  EXPECT_FALSE(mWindow->toolbox().active());
  ASSERT_TRUE(settle());
  mWindow->actions().find("cut.threePoints")->trigger();
  mWindow->actions().find("file.new")->trigger();
  EXPECT_FALSE(mWindow->toolbox().active());
}

TEST_F(CutWindow, OnASectionACutIsDraggedByItsLine) {
  openWithLabels();
  mWindow->resize(1000, 800);
  mWindow->views().setLayout(scene::Layout::FourUp);
  mWindow->actions().find("cut.addPlane")->trigger();
  ASSERT_TRUE(settle());
  SectionView& axial = mWindow->views().section(scene::SectionKind::Axial);
  scene::SectionPlane plane = axial.plane();
  scene::Cut before = scene().cuts[0];
  auto handles = session::sectionHandles(plane, before);
  ASSERT_FALSE(handles.empty());
  glm::dvec2 place = handles.back().place, out = handles.back().outwards;
  QPoint from(int(std::lround(place.x)), int(std::lround(place.y)));
  QPoint way(int(std::lround(out.x * 20.0)), int(std::lround(out.y * 20.0)));
  QTest::mouseMove(&axial, from);
  EXPECT_NE(axial.cursor().shape(), axial.restCursor());
  drag(axial, from, from + way);
  glm::dvec3 moved = scene().cuts[0].centre - before.centre;
  EXPECT_NEAR(glm::dot(moved, before.axis), 20.0 * plane.lengthPerPixel, 1e-9);
  EXPECT_EQ(document().undoLabel(), "Move cut");
  glm::dvec3 crosshair = scene().sections.crosshair;
  drag(axial, {2, 2}, {6, 4});
  EXPECT_NE(scene().sections.crosshair, crosshair) << "beside the cut the view has the pointer";
}

}  // namespace velum::gui
