// The side panel is as wide as the user wants it, within what its pages and the views need.
#include "gui/kit/SidePanel.h"

#include "ModelFixture.h"
#include "Shots.h"
#include "gui/kit/Preferences.h"

namespace velum::gui {
namespace {

constexpr const char* kKey = "view/sideWidth";

class Side : public ModelWindow {
 protected:
  void SetUp() override {
    Preferences().setValue(kKey, 0);
    Window::SetUp();
  }
  void TearDown() override {
    Preferences().setValue(kKey, 0);
    Window::TearDown();
  }
  SidePanel& panel() { return *child<SidePanel>("sidePanel"); }
  QWidget& handle() { return *child<QWidget>("sideHandle"); }
  void resize(int width) {
    mWindow->resize(width, 860);
    QTest::qWait(20);
  }
  /// By places of the screen, as the handle moves along.
  void dragBy(int pixels) {
    QPoint from = handle().mapToGlobal(QPoint(3, 200));
    auto send = [&](QEvent::Type type, QPoint at, Qt::MouseButton button, Qt::MouseButtons buttons) {
      QMouseEvent event(type, handle().mapFromGlobal(at), at, button, buttons, {});
      QApplication::sendEvent(&handle(), &event);
      QApplication::processEvents();
    };
    send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    for (int i = 1; i <= 4; ++i)
      send(QEvent::MouseMove, from + QPoint(pixels * i / 4, 0), Qt::NoButton, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, from + QPoint(pixels, 0), Qt::LeftButton, Qt::NoButton);
    QTest::qWait(20);
  }
};

TEST_F(Side, IsMadeWiderByTheMouseWithinHalfOfTheWindow) {
  openModel();
  resize(1500);
  int before = panel().width();
  dragBy(-120);
  EXPECT_EQ(panel().width(), before + 120);
  EXPECT_EQ(Preferences().value(kKey).toInt(), before + 120);
  EXPECT_EQ(panel().mapTo(mWindow.get(), QPoint(panel().width(), 0)).x(), mWindow->width())
      << "it ends where the window does";
  takeShot(*mWindow, "side-wide");
  dragBy(-2000);
  EXPECT_EQ(panel().width(), mWindow->width() / 2);
  dragBy(2000);
  EXPECT_EQ(panel().width(), SidePanel::kLeast);
  dragBy(-40);
  EXPECT_EQ(panel().width(), SidePanel::kLeast + 40) << "what was drawn beyond an end is not owed";
  QTest::mouseDClick(&handle(), Qt::LeftButton, {}, QPoint(3, 200));
  EXPECT_EQ(panel().width(), before) << "as wide as suits what is open";
  EXPECT_EQ(Preferences().value(kKey).toInt(), 0);
}

TEST_F(Side, IsMadeWiderByKeys) {
  openPhantom();
  resize(1400);
  handle().setFocus(Qt::TabFocusReason);
  ASSERT_TRUE(handle().hasFocus());
  int before = panel().width();
  QTest::keyClick(&handle(), Qt::Key_Left);
  QTest::keyClick(&handle(), Qt::Key_Left);
  QTest::keyClick(&handle(), Qt::Key_Right);
  EXPECT_GT(panel().width(), before);
  EXPECT_EQ(Preferences().value(kKey).toInt(), panel().width());
  QTest::keyClick(&handle(), Qt::Key_Home);
  EXPECT_EQ(panel().width(), before);
}

TEST_F(Side, IsRoomyForModelsInAWideWindowAlone) {
  resize(1440);
  openPhantom();
  EXPECT_EQ(panel().width(), SidePanel::kLeast);
  openModel();
  resize(1440);
  EXPECT_GT(panel().width(), SidePanel::kLeast);
  resize(1000);
  EXPECT_EQ(panel().width(), SidePanel::kLeast);
  resize(1440);
  openPhantom();
  resize(1440);
  EXPECT_EQ(panel().width(), SidePanel::kLeast);
}

TEST_F(Side, KeepsItsWidthForTheNextWindowAndGivesWayToANarrowOne) {
  openPhantom();
  resize(1500);
  dragBy(-200);
  int chosen = panel().width();
  ASSERT_EQ(chosen, SidePanel::kLeast + 200);
  resize(900);
  EXPECT_EQ(mWindow->width(), 900) << "the panel keeps no window wide";
  EXPECT_EQ(panel().width(), 450);
  resize(1500);
  EXPECT_EQ(panel().width(), chosen);
  MainWindow other;
  other.resize(1500, 800);
  other.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&other));
  EXPECT_EQ(other.findChild<SidePanel*>("sidePanel")->chosen(), chosen);
}

}  // namespace
}  // namespace velum::gui
