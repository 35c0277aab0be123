// The page Finish, and lit spheres of structures, with real events.
#include <QListWidget>
#include <QSlider>
#include <algorithm>

#include "ModelFixture.h"
#include "Shots.h"
#include "WindowFixture.h"
#include "gui/look/FinishPanel.h"
#include "gui/rows/PictureList.h"
#include "gui/structure/StructurePanel.h"
#include "io/images/ImageFile.h"
#include "patience.h"
#include "scene/Finishes.h"
#include "scene/LitSpheres.h"

namespace velum::gui {
namespace {

class FinishPage : public Window {
 protected:
  void openPage() {
    openPhantom();
    drawSoon();
    ASSERT_TRUE(mWindow->tabs().showPage("Finish"));
  }
  std::string undoLabel() { return mWindow->document().undoLabel(); }
  static void click(QListWidget& list, const QString& name) {
    for (int i = 0; i < list.count(); ++i)
      if (list.item(i)->data(Qt::UserRole).toString() == name)
        return QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, list.visualItemRect(list.item(i)).center());
    FAIL() << name.toStdString();
  }
};

TEST_F(FinishPage, AFinishIsOneStep) {
  openPage();
  auto* list = child<QListWidget>("finish");
  EXPECT_EQ(list->currentItem()->data(Qt::UserRole).toString(), "none");
  click(*list, "pencil");
  EXPECT_EQ(scene::finishName(scene()), "pencil");
  EXPECT_EQ(undoLabel(), "Choose finish");
  mWindow->document().undo();
  EXPECT_EQ(scene::finishName(scene()), "none");
  EXPECT_EQ(list->currentItem()->data(Qt::UserRole).toString(), "none");
}

TEST_F(FinishPage, ItsPicturesShowTheData) {
  openPage();
  auto* panel = mWindow->findChild<FinishPanel*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->isSettled() && panel->isComplete(); }, kPatience));
  auto* list = child<QListWidget>("finish");
  for (int i = 0; i < list->count(); ++i)
    EXPECT_FALSE(list->item(i)->data(Qt::UserRole + 1).value<QPixmap>().isNull()) << i;
  click(*list, "plate");
  ASSERT_TRUE(settle());
  takeShot(*mWindow, "finish");
}

TEST_F(FinishPage, ItsPicturesShowAModel) {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker{.types = 5, .instances = 400, .moleculeRadius = 20.0f}.make());
  mWindow->showScene(scene, "made");
  drawSoon();
  ASSERT_TRUE(mWindow->tabs().showPage("Finish"));
  auto* panel = mWindow->findChild<FinishPanel*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->isSettled() && panel->isComplete(); }, kPatience));
  auto* list = child<QListWidget>("finish");
  QSet<QByteArray> different;
  for (int i = 0; i < list->count(); ++i) {
    QImage picture = list->item(i)->data(Qt::UserRole + 1).value<QPixmap>().toImage();
    ASSERT_FALSE(picture.isNull()) << list->item(i)->text().toStdString();
    QSet<QRgb> colors;
    for (int x = 0; x < picture.width(); ++x) colors.insert(picture.pixel(x, picture.height() / 2));
    EXPECT_GT(colors.size(), 3) << "something is seen: " << list->item(i)->text().toStdString();
    different.insert(QByteArray(reinterpret_cast<const char*>(picture.constBits()), picture.sizeInBytes()));
  }
  EXPECT_EQ(different.size(), list->count()) << "each is its own";
  takeShot(*mWindow, "finish-model");
}

TEST_F(FinishPage, ADragOfASliderIsOneStep) {
  openPage();
  auto* contours = child<NumberRow>("contours");
  auto* slider = contours->findChild<QSlider*>();
  std::vector<double> seen;
  QObject::connect(contours, &NumberRow::changed, mWindow.get(), [&] { seen.push_back(scene().finish.contours); });
  QPoint middle = slider->rect().center(), handle(8, middle.y());  // at the left end, of 0
  drag(*slider, handle, middle);
  EXPECT_GT(seen.size(), 3u) << "it answers while the hand moves";
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_NEAR(scene().finish.contours, 0.5, 0.05);
  EXPECT_NEAR(scene().finish.contours, contours->value() / 100.0, 1e-9);
  mWindow->document().undo();
  EXPECT_EQ(scene().finish.contours, 0.0);
  EXPECT_EQ(contours->value(), 0.0);
}

TEST_F(FinishPage, EveryControlChangesItsValueAndIsNamed) {
  openPage();
  for (const char* name : {"contours", "contourWidth", "contourSteps", "contourStructures", "contourCreases",
                           "litSphereShare", "hatching", "hatchWidth", "paperGrain", "paperScale"}) {
    auto* row = child<NumberRow>(name);
    ASSERT_TRUE(row) << name;
    scene::Finish before = scene().finish;
    row->spin()->setValue(row->value() > 5 ? row->value() - 3 : row->value() + 3);
    EXPECT_FALSE(before == scene().finish) << name;
    EXPECT_FALSE(row->spin()->accessibleName().isEmpty()) << name;
    EXPECT_FALSE(row->toolTip().isEmpty()) << name;
  }
}

TEST_F(FinishPage, ASphereIsChosenByItsPictureAndShown) {
  openPage();
  click(*child<QListWidget>("litSphere"), "gold");
  EXPECT_EQ(scene().finish.sphere, "gold");
  EXPECT_GT(scene().finish.litSphere, 0.0);
  EXPECT_EQ(undoLabel(), "Choose lit sphere");
}

TEST_F(FinishPage, OnesOwnSphereIsAddedAndABadOneIsOneLine) {
  openPage();
  io::writeImage(scene::makeLitSphere("velvet"), *sFolder / "mine.png");
  auto& spheres = mWindow->findChild<FinishPanel*>()->spheres();
  spheres.addOwn(path("mine.png"));
  EXPECT_EQ(scene().finish.sphere, "mine");
  auto* list = child<QListWidget>("litSphere");
  EXPECT_EQ(list->count(), int(scene::litSpheres().size()) + 1);
  EXPECT_EQ(list->currentItem()->data(Qt::UserRole).toString(), "mine");
  spheres.addOwn(path("phantom.nrrd"));
  EXPECT_FALSE(mWindow->messages().text().isEmpty());
  EXPECT_EQ(scene().finish.spheres.size(), 1u);
}

TEST_F(FinishPage, OnesOwnPaperIsTheLastOfTheListAndABadOneIsOneLine) {
  openPage();
  io::writeImage(scene::makeLitSphere("velvet"), *sFolder / "linen.png");
  auto* panel = mWindow->findChild<FinishPanel*>();
  auto* paper = child<QComboBox>("paper");
  int before = paper->count();
  panel->takePaper(path("linen.png"));
  EXPECT_EQ(scene().finish.paper, scene::Paper::Own);
  EXPECT_EQ(paper->currentText(), "linen.png");
  EXPECT_EQ(paper->count(), before + 1);
  EXPECT_EQ(undoLabel(), "Choose paper");
  panel->takePaper(path("phantom.nrrd"));
  EXPECT_FALSE(mWindow->messages().text().isEmpty());
  EXPECT_EQ(paper->currentText(), "linen.png");
  mWindow->document().undo();
  EXPECT_EQ(paper->currentText(), "None");
  EXPECT_EQ(paper->count(), before);
}

TEST_F(FinishPage, AStructuresMenuHasItsSphere) {
  mWindow->openPaths({path("phantom.nrrd"), path("phantom_labels.seg.nrrd")});
  ASSERT_TRUE(waitForJob());
  session::Document& document = mWindow->document();
  Selection selection;
  StructureCommands commands(document, selection, mWindow.get());
  QMenu menu;
  commands.fillMenu(menu, {1});
  QMenu* spheres = nullptr;
  for (QAction* action : menu.actions())
    if (action->menu() && action->text() == "Lit sphere") spheres = action->menu();
  ASSERT_TRUE(spheres);
  for (QAction* action : spheres->actions())
    if (action->text() == "Bone") action->trigger();
  EXPECT_EQ(scene().labels.structures[0].litSphere, "bone");
  EXPECT_GT(scene().finish.litSphere, 0.0);
  document.undo();
  EXPECT_EQ(scene().labels.structures[0].litSphere, "");
}

}  // namespace
}  // namespace velum::gui
