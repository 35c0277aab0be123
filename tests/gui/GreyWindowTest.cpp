// The grey window of sections: typed in their corner, and by name.
#include <QContextMenuEvent>
#include <QMenu>

#include "Shots.h"
#include "WindowFixture.h"
#include "gui/view/GreyWindowCorner.h"
#include "scene/GreyWindows.h"
#include "session/section/TypedWindow.h"

namespace velum::gui {
namespace {

/// A phantom of a trunk, whose values are HU, in four views.
class GreyWindows : public Window {
 protected:
  static void SetUpTestSuite() {
    Window::SetUpTestSuite();
    Progress progress;
    io::writeVolume(io::makeSample("torso", 48, progress).volume, *sFolder / "trunk.nrrd", progress);
  }
  void SetUp() override {
    Window::SetUp();
    mWindow->resize(1200, 800);
    mWindow->openPaths({path("trunk.nrrd")});
    ASSERT_TRUE(waitForJob());
    ASSERT_EQ(scene::valueUnit(*scene().volume.data), "HU");
    mWindow->views().setLayout(scene::Layout::FourUp);
    drawSoon();
    QTest::qWait(20);
  }
  SectionView& axial() { return mWindow->views().section(scene::SectionKind::Axial); }
  glm::dvec2 shown() { return scene::effectiveWindow(scene().volume); }
  GreyWindowCorner& corner() { return GreyWindowCorner::of(axial()); }
  QLineEdit* field() { return axial().findChild<QLineEdit*>("greyWindow"); }
};

TEST_F(GreyWindows, IsTypedWhereItStands) {
  EXPECT_FALSE(field()->isVisible());
  glm::dvec3 crosshair = scene().sections.crosshair;
  ASSERT_TRUE(corner().isVisible());
  EXPECT_GT(corner().geometry().right(), axial().width() - 20);
  EXPECT_GT(corner().geometry().bottom(), axial().height() - 20);
  QTest::mouseClick(&corner(), Qt::LeftButton);
  ASSERT_TRUE(field()->isVisible() && field()->hasFocus());
  EXPECT_EQ(field()->text().toStdString(), session::windowText(scene().volume));
  EXPECT_EQ(scene().sections.crosshair, crosshair) << "the click is none of the crosshair's";
  takeShot(*mWindow, "grey-window-typed");
  QTest::keyClicks(field(), "W 1500 L -600");
  QTest::keyClick(field(), Qt::Key_Return);
  EXPECT_EQ(shown(), glm::dvec2(-600, 1500));
  EXPECT_FALSE(field()->isVisible());
  EXPECT_TRUE(axial().hasFocus()) << "the keys are the view's again";
  takeShot(*mWindow, "grey-window-lung");
  mWindow->document().undo();
  EXPECT_NE(shown(), glm::dvec2(-600, 1500)) << "one step";
}

TEST_F(GreyWindows, WhatIsNotUnderstoodStaysAndChangesNothing) {
  glm::dvec2 before = shown();
  axial().setFocus();
  mWindow->actions().find("sections.window.type")->trigger();
  ASSERT_TRUE(field()->isVisible());
  QTest::keyClicks(field(), "wide");
  QTest::keyClick(field(), Qt::Key_Return);
  EXPECT_TRUE(field()->isVisible());
  EXPECT_EQ(field()->text(), "wide");
  EXPECT_FALSE(field()->accessibleDescription().isEmpty());
  EXPECT_EQ(shown(), before);
  QTest::keyClick(field(), Qt::Key_Escape);
  EXPECT_FALSE(field()->isVisible());
  EXPECT_EQ(shown(), before);
  EXPECT_FALSE(mWindow->document().isModified());
}

TEST_F(GreyWindows, HaveNamesInTheMenuOfTheUnit) {
  auto* lung = mWindow->actions().find("sections.window.lung");
  ASSERT_TRUE(lung && lung->isEnabled());
  EXPECT_FALSE(mWindow->actions().find("sections.window.suv-5")->isEnabled());
  lung->trigger();
  EXPECT_EQ(shown(), glm::dvec2(-600, 1500));
  EXPECT_EQ(mWindow->document().undoLabel(), "Change window");
}

TEST_F(GreyWindows, BeginWithThatOfWhatIsSeen) {
  EXPECT_EQ(shown(), glm::dvec2(50, 400)) << "soft tissue, whatever the 3D view shows";
}

}  // namespace
}  // namespace velum::gui
