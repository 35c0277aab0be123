// A PET, from its files to the numbers of a lesion.
#include <QLabel>
#include <QStatusBar>
#include <QToolButton>

#include "DicomSeries.h"
#include "Shots.h"
#include "WindowFixture.h"
#include "gui/structure/StructureList.h"
#include "gui/structure/StructurePanel.h"
#include "makeVolume.h"
#include "patience.h"
#include "scene/GreyWindows.h"

namespace velum::gui {
namespace {

constexpr int kSize = 32;

/// A body of uptake 1 with a lesion of 8 whose middle is 12, and a bladder of 60.
double uptakeAt(glm::ivec3 p) {
  double r = glm::length(glm::dvec3(p) - 15.5), lesion = glm::length(glm::dvec3(p) - glm::dvec3(10, 16, 20));
  if (lesion < 0.5) return 12.0;
  if (lesion < 3.2) return 8.0;
  if (glm::length(glm::dvec3(p) - glm::dvec3(22, 16, 6)) < 2.2) return 60.0;
  return r < 14.5 ? 1.0 : 0.0;
}

class Pet : public Window {
 protected:
  static void SetUpTestSuite() {
    Window::SetUpTestSuite();
    PetDose dose;
    double one = dose.activityOfOne();
    Volume activity = makeVolume(
        {kSize, kSize, kSize}, SampleType::Int16, [&](glm::ivec3 p) { return uptakeAt(p) * one; },
        centredFrame({kSize, kSize, kSize}, glm::dvec3(4.0)), one / 100.0);
    ASSERT_TRUE(writePetSeries(activity, *sFolder / "pet", dose));
    LabelVolume lesion = makeLabels(
        activity.dims, [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - glm::dvec3(10, 16, 20)) < 3.2 ? 7 : 0; },
        activity.worldFromVoxel);
    lesion.table = {{7, "lesion", {1, 0.5f, 0}, 1}};
    Progress progress;
    io::writeLabels(lesion, *sFolder / "lesion.seg.nrrd", progress);
  }
};

TEST_F(Pet, SaysUptakeUnderThePointerAndOfEachStructure) {
  mWindow->resize(1300, 850);
  mWindow->openPaths({path("pet"), path("lesion.seg.nrrd")});
  ASSERT_TRUE(waitForJob());
  const Volume& volume = *scene().volume.data;
  EXPECT_EQ(volume.unit, "SUVbw");
  EXPECT_TRUE(mWindow->messages().text().contains("280 MBq")) << mWindow->messages().text().toStdString();
  glm::dvec2 window = scene::effectiveWindow(scene().volume);
  EXPECT_LT(window.y, 20.0) << "the bladder does not make all else black";
  EXPECT_GT(window.y, 1.0);
  mWindow->views().setLayout(scene::Layout::FourUp);
  drawSoon();
  // Under the pointer.
  mWindow->document().view([&](scene::Scene& scene) {
    scene.sections.crosshair = glm::dvec3(volume.worldFromVoxel * glm::dvec4(10, 16, 20, 1));
  });
  QTest::qWait(50);
  SectionView& axial = mWindow->views().section(scene::SectionKind::Axial);
  glm::dvec2 at = scene::sectionPixelFromWorld(axial.plane(), scene().sections.crosshair);
  QTest::mouseMove(&axial, QPoint(int(at.x), int(at.y)));
  QTest::qWait(20);
  bool isSaid = false;
  for (auto* label : mWindow->statusBar()->findChildren<QLabel*>()) isSaid |= label->text().startsWith("12 SUVbw");
  EXPECT_TRUE(isSaid);
  // In the table.
  mWindow->actions().find("structure.list")->trigger();
  auto* list = child<StructureList>("structureList");
  ASSERT_TRUE(list && QTest::qWaitFor([&] { return list->isVisible(); }, 5000));
  EXPECT_TRUE(list->isColumnHidden(StructureModel::Mean));
  child<QToolButton>("structureValues")->click();
  StructureModel& rows = list->rows();
  auto text = [&](StructureModel::Column column) {
    return rows.data(rows.index(rows.rowOf(7), column), Qt::DisplayRole).toString();
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return !text(StructureModel::Most).isEmpty(); }, kPatience));
  EXPECT_FALSE(list->isColumnHidden(StructureModel::Mean));
  EXPECT_FALSE(list->isHeaderHidden());
  EXPECT_EQ(rows.headerData(StructureModel::Most, Qt::Horizontal, Qt::DisplayRole).toString(), "SUVmax");
  EXPECT_EQ(rows.headerData(StructureModel::Mean, Qt::Horizontal, Qt::DisplayRole).toString(), "SUVmean");
  EXPECT_EQ(text(StructureModel::Most), "12");
  double mean = text(StructureModel::Mean).toDouble();
  EXPECT_GT(mean, 8.0);
  EXPECT_LT(mean, 8.1);
  takeShot(*mWindow, "pet-values");
  // Bars take their place.
  child<QToolButton>("structureBars")->click();
  EXPECT_TRUE(list->isColumnHidden(StructureModel::Mean));
  EXPECT_FALSE(child<QToolButton>("structureValues")->isChecked());
}

}  // namespace
}  // namespace velum::gui
