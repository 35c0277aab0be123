// The way to a picture in four steps, and what the page Pull out costs while nothing of it changes.
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>

#include "Shots.h"
#include "WindowFixture.h"
#include "gui/extrusion/ExtrusionPanel.h"
#include "scene/Finishes.h"
#include "session/extrusion/Extrusion.h"

namespace velum::gui {
namespace {

class PullGuide : public Window {
 protected:
  void open() {
    mWindow->openPaths({path("phantom.nrrd"), path("phantom_labels.seg.nrrd")});
    ASSERT_TRUE(waitForJob());
    drawSoon();
    ASSERT_TRUE(mWindow->tabs().showPage("Pull out"));
  }
  session::Document& document() { return mWindow->document(); }
  /// The name of the button that is down; of several, none.
  QString next() {
    QString name;
    for (const char* step : {"stepCut", "stepPull", "stepFinish", "stepSave"})
      if (child<QPushButton>(step)->isChecked()) name += step;
    return name;
  }
  void press(const char* step) { QTest::mouseClick(child<QPushButton>(step), Qt::LeftButton); }
  QString page() { return mWindow->tabs().tabText(mWindow->tabs().currentIndex()); }
  void pull(double distance) {
    document().edit("Pull", [&](scene::Scene& scene) { session::setExtrusion(scene.cuts[0], 1, distance); });
  }
};

TEST_F(PullGuide, EachStepDoesWhatItSaysAndLeadsToTheNext) {
  open();
  EXPECT_EQ(next(), "stepCut");
  QString before = child<QLabel>("stepText")->text();
  press("stepCut");
  ASSERT_EQ(scene().cuts.size(), 1u);
  EXPECT_EQ(page(), "Cuts");
  EXPECT_EQ(next(), "stepPull");
  EXPECT_NE(child<QLabel>("stepText")->text(), before);
  press("stepCut");
  EXPECT_EQ(scene().cuts.size(), 1u) << "there is one already";
  mWindow->tabs().showPage("Pull out");
  press("stepPull");
  ASSERT_TRUE(mWindow->toolbox().active());
  press("stepPull");
  EXPECT_TRUE(mWindow->toolbox().active()) << "it stays";
  pull(6.0);
  EXPECT_EQ(next(), "stepFinish");
  EXPECT_TRUE(child<QPushButton>("stepPull")->accessibleName().contains("done"));
  ASSERT_TRUE(settle());
  takeShot(*mWindow, "pull-steps");
  press("stepFinish");
  EXPECT_EQ(page(), "Finish");
  document().edit("Choose finish", [](scene::Scene& scene) { scene::applyFinish(scene, "plate"); });
  EXPECT_EQ(next(), "stepSave");
  pull(0.0);
  EXPECT_EQ(next(), "stepPull") << "what is undone is next again";
}

TEST_F(PullGuide, AnEmptyWindowHasNoStepToPress) {
  for (const char* step : {"stepCut", "stepPull", "stepFinish", "stepSave"})
    EXPECT_FALSE(child<QPushButton>(step)->isEnabled()) << step;
}

TEST_F(PullGuide, RowsAreMadeAnewOnlyWhenTheyChange) {
  open();
  press("stepCut");
  pull(6.0);
  auto* list = child<QListWidget>("extrusionList");
  ASSERT_EQ(list->count(), 1);
  QSignalSpy changes(list->model(), &QAbstractItemModel::dataChanged);
  document().view([](scene::Scene& scene) { scene.camera.eye.x += 3.0; });
  document().edit("Light", [](scene::Scene& scene) { scene.lighting.ambient = 0.3; });
  EXPECT_EQ(changes.count(), 0);
  pull(7.0);
  EXPECT_GT(changes.count(), 0);
  EXPECT_TRUE(list->item(0)->text().contains("7")) << list->item(0)->text().toStdString();
  document().edit("Rename", [](scene::Scene& scene) { scene.labels.structures[0].name = "Rib"; });
  EXPECT_TRUE(list->item(0)->text().startsWith("Rib"));
}

TEST_F(PullGuide, OfSeveralCutsARowSaysOutOfWhichItIs) {
  open();
  press("stepCut");
  pull(6.0);
  mWindow->tabs().showPage("Pull out");
  auto* list = child<QListWidget>("extrusionList");
  ASSERT_EQ(list->count(), 1);
  auto row = [list](int i) { return list->item(i)->text(); };
  EXPECT_FALSE(row(0).contains("Plane")) << "there is one: " << row(0).toStdString();
  QTest::mouseClick(child<QPushButton>("secondPlane"), Qt::LeftButton);
  ASSERT_EQ(scene().cuts.size(), 2u);
  EXPECT_TRUE(row(0).endsWith("6.0 mm out of Plane 1")) << row(0).toStdString();
  document().edit("Pull", [](scene::Scene& scene) { session::setExtrusion(scene.cuts[1], 1, 9.0); });
  ASSERT_EQ(list->count(), 2);
  EXPECT_TRUE(row(0).endsWith("6.0 mm out of Plane 1")) << row(0).toStdString();
  EXPECT_TRUE(row(1).endsWith("9.0 mm out of Plane 2")) << row(1).toStdString();
  document().edit("Rename", [](scene::Scene& scene) {
    scene.cuts[0].name = "Front";
    scene.cuts[1].name.clear();
    scene.labels.structures[0].name = "a name that is by far too long for a row of so narrow a panel";
  });
  takeShot(*mWindow, "pull-rows");
  auto* cuts = child<QListWidget>("cutList");
  for (int i : {0, 1})
    EXPECT_TRUE(row(i).endsWith("out of " + cuts->item(i)->text())) << "as the list of cuts: " << row(i).toStdString();
  // All of a row is in sight, and its end is drawn: one that ends in another way looks different.
  QRect first = list->visualItemRect(list->item(0));
  EXPECT_LE(first.right(), list->viewport()->width());
  QImage front = list->viewport()->grab(first).toImage();
  document().edit("Rename", [](scene::Scene& scene) { scene.cuts[0].name = "Fromm"; });
  EXPECT_NE(list->viewport()->grab(first).toImage(), front);
  document().edit("Move cut", [](scene::Scene& scene) { std::swap(scene.cuts[0], scene.cuts[1]); });
  EXPECT_TRUE(row(0).endsWith("9.0 mm out of Cut 1")) << "it has no name: " << row(0).toStdString();
}

TEST_F(PullGuide, SeveralSelectedRowsStaySelected) {
  open();
  press("stepCut");
  document().edit("Pull", [](scene::Scene& scene) {
    for (const auto& structure : scene.labels.structures) session::setExtrusion(scene.cuts[0], structure.id, 5.0);
  });
  ASSERT_TRUE(mWindow->tabs().showPage("Pull out"));
  auto* list = child<QListWidget>("extrusionList");
  ASSERT_GE(list->count(), 2);
  auto click = [&](int row, Qt::KeyboardModifiers keys) {
    QTest::mouseClick(list->viewport(), Qt::LeftButton, keys, list->visualItemRect(list->item(row)).center());
  };
  click(0, {});
  click(1, Qt::ControlModifier);
  EXPECT_EQ(list->selectedItems().size(), 2);
  child<QPushButton>("putBack")->click();
  EXPECT_EQ(session::extrusionsOf(scene()).size(), scene().labels.structures.size() - 2);
}

}  // namespace
}  // namespace velum::gui
