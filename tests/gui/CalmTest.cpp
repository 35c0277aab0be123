// What comes and goes moves nothing that is under the pointer.
#include "Shots.h"
#include "WindowFixture.h"
#include "gui/kit/Messages.h"
#include "gui/window/RecoveryBar.h"
#include "scene/Scene.h"

namespace velum::gui {
namespace {

class Calm : public Window {
 protected:
  QRect placeOf(QWidget& widget) { return {widget.mapToGlobal(QPoint()), widget.size()}; }
};

TEST_F(Calm, BarsThatComeAndGoLeaveTheViewsWhereTheyAre) {
  openPhantom();
  QRect before = placeOf(viewport());
  auto* recovery = mWindow->findChild<RecoveryBar*>("recoveryBar");
  auto* progress = mWindow->findChild<ProgressStrip*>("progressStrip");
  session::LostWork work;
  work.isReadable = true;
  const std::pair<QWidget*, std::function<void()>> bars[] = {
      {&mWindow->messages(),
       [&] { mWindow->messages().showError(QString("what went wrong, at length ").repeated(12)); }},
      {recovery, [&] { recovery->offer({work}); }},
      {progress, [&] { progress->begin("Drawing"); }}};
  for (const auto& [bar, show] : bars) {
    show();
    QTest::qWait(30);
    ASSERT_TRUE(bar->isVisible());
    EXPECT_EQ(placeOf(viewport()), before) << bar->objectName().toStdString();
    EXPECT_TRUE(placeOf(*bar->parentWidget()).contains(placeOf(*bar))) << bar->objectName().toStdString();
    EXPECT_GE(bar->height(), bar->minimumSizeHint().height());
  }
  EXPECT_FALSE(placeOf(mWindow->messages()).intersects(placeOf(*recovery))) << "one hides the other";
  takeShot(*mWindow, "bars");
  recovery->next();
  for (const auto& [bar, show] : bars) bar->hide();
  QTest::qWait(30);
  EXPECT_EQ(placeOf(viewport()), before);
}

TEST_F(Calm, AListOfCutsThatGrowsMovesNoButtonAboutIt) {
  openPhantom();
  mWindow->actions().find("cut.addPlane")->trigger();
  QTest::qWait(30);
  for (const char* name : {"cutDuplicate", "cutRemove", "addPlane"}) {
    auto* button = child<QPushButton>(name);
    QRect before = placeOf(*button);
    mWindow->actions().find("cut.duplicate")->trigger();
    QTest::qWait(30);
    EXPECT_EQ(placeOf(*button), before) << name;
  }
}

}  // namespace
}  // namespace velum::gui
