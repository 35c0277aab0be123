// Handles come with a cut that one turns to, and can be put away.
#include "WindowFixture.h"

#include <QListWidget>

#include "scene/Project.h"

namespace velum::gui {
namespace {

class Handles : public Window {
 protected:
  void openCut(const char* id) {
    openPhantom();
    drawSoon();
    mWindow->actions().find(id)->trigger();
    ASSERT_TRUE(settle());
  }
  bool areShown() { return mWindow->toolbox().handlesShown(); }
  /// The middle of the cut's handles, where there is always one.
  QPoint middleOfCut() {
    auto pixel = viewport().space().pixelFromWorld(scene().cuts.back().centre);
    return {int(pixel->x), int(pixel->y)};
  }
};

TEST_F(Handles, AreShownWithANewCutAndPutAwayByTheKey) {
  openCut("cut.addSphere");
  EXPECT_TRUE(areShown());
  glm::dvec3 centre = scene().cuts[0].centre;
  QTest::keyClick(&viewport(), Qt::Key_G);
  EXPECT_FALSE(areShown());
  EXPECT_FALSE(mWindow->actions().find("cut.handles")->isChecked());
  drag(middleOfCut(), middleOfCut() + QPoint(20, 10));
  EXPECT_EQ(scene().cuts[0].centre, centre) << "a handle that is away was taken hold of";
  QTest::keyClick(&viewport(), Qt::Key_G);
  EXPECT_TRUE(areShown());
}

TEST_F(Handles, AClickBesideTheDataPutsThemAwayAndTheListBringsThemBack) {
  openCut("cut.addSphere");
  QTest::mouseClick(&viewport(), Qt::LeftButton, {}, QPoint(4, viewport().height() - 4));
  EXPECT_FALSE(areShown());
  auto* list = child<QListWidget>("cutList");
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
  EXPECT_TRUE(areShown());
  mWindow->actions().find("cut.handles")->trigger();
  EXPECT_FALSE(areShown());
  mWindow->actions().find("cut.addBox")->trigger();
  EXPECT_TRUE(areShown()) << "a new cut has handles";
}

TEST_F(Handles, TheFirstOfEachShapeIsNumberOneAndIsSeenAtOnce) {
  openCut("cut.addPlane");
  mWindow->actions().find("cut.remove")->trigger();
  for (const char* id : {"cut.addBox", "cut.addSphere", "cut.addCylinder"}) {
    SCOPED_TRACE(id);
    ASSERT_TRUE(settle());
    QImage whole = viewport().picture();
    mWindow->actions().find(id)->trigger();
    EXPECT_TRUE(QString::fromStdString(scene().cuts.back().name).endsWith(" 1")) << scene().cuts.back().name;
    ASSERT_TRUE(settle());
    EXPECT_NE(viewport().picture(), whole) << "it cuts nothing that is seen";
    mWindow->document().undo();
  }
}

}  // namespace
}  // namespace velum::gui
