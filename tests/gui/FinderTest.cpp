#include <QLineEdit>
#include <QListWidget>

#include "Shots.h"
#include "WindowFixture.h"
#include "gui/window/CommandFinder.h"

namespace velum::gui {
namespace {

/// Ctrl+K, as it is used: letters are typed, and Enter does what is on top.
class Finder : public Window {
 protected:
  std::unique_ptr<CommandFinder> type(const QString& letters) {
    auto finder = std::make_unique<CommandFinder>(
        findAll(mWindow->parts()), mWindow.get(),
        [this](const QString& line) { mWindow->jobs().run(session::parseCall(line.toStdString())); });
    finder->show();
    QTest::keyClicks(finder->findChild<QLineEdit*>(), letters);
    return finder;
  }
  void enter(const QString& letters) {
    auto finder = type(letters);
    QTest::keyClick(finder->findChild<QLineEdit*>(), Qt::Key_Return);
  }
  QString top(const QString& letters) {
    auto finder = type(letters);
    return finder->findChild<QListWidget*>()->item(0)->text();
  }
};

TEST_F(Finder, SetsANumberThatStandsBehindItsName) {
  openPhantom();
  enter("shadows 80");
  EXPECT_DOUBLE_EQ(scene().lighting.shadow, 0.8);
  enter("occlusion 12 %");
  EXPECT_DOUBLE_EQ(scene().lighting.occlusion, 0.12);
  mWindow->document().undo();
  mWindow->document().undo();
  EXPECT_NE(scene().lighting.shadow, 0.8) << "each is a step";
}

TEST_F(Finder, DoesACommandWithItsArguments) {
  openPhantom();
  enter("cut.add box");
  ASSERT_EQ(scene().cuts.size(), 1u);
  EXPECT_EQ(scene().cuts[0].shape, scene::CutShape::Box);
  enter("cut.flip");
  EXPECT_TRUE(scene().cuts[0].invert);
  EXPECT_TRUE(top("cut.add cube").contains("not one of")) << "it says why it does not fit";
  enter("cut.add cube");
  EXPECT_EQ(scene().cuts.size(), 1u);
}

TEST_F(Finder, GivesTheKeyboardToAFieldWithoutANumber) {
  openPhantom();
  mWindow->tabs().showPage("Finish");
  enter("shadows");
  auto* field = qobject_cast<NumberField*>(QApplication::focusWidget());
  ASSERT_TRUE(field);
  EXPECT_EQ(field->accessibleName(), "Shadows");
  EXPECT_TRUE(field->isVisible()) << "its page is shown";
}

TEST_F(Finder, RefusesANumberThatIsOutOfRange) {
  openPhantom();
  double before = scene().lighting.shadow;
  enter("shadows 800");
  EXPECT_DOUBLE_EQ(scene().lighting.shadow, before);
  auto* field = qobject_cast<NumberField*>(QApplication::focusWidget());
  ASSERT_TRUE(field);
  EXPECT_TRUE(field->isMarked());
}

TEST_F(Finder, ChoosesPresetsOfOtherKindsOfDataToo) {
  openPhantom();
  enter("preset ct: bone");
  EXPECT_EQ(scene::currentTransfer(scene().volume).preset, "ct-bone");
}

TEST_F(Finder, GoesToAStructure) {
  mWindow->openPaths({path("phantom.nrrd"), path("phantom_labels.seg.nrrd")});
  ASSERT_TRUE(waitForJob());
  ASSERT_FALSE(scene().labels.structures.empty());
  const auto& structure = scene().labels.structures.back();
  enter("structure " + QString::fromStdString(structure.name));
  EXPECT_EQ(mWindow->selection().structure(), structure.id);
}

TEST_F(Finder, SaysThatNothingIsFound) {
  openPhantom();
  EXPECT_TRUE(top("zqxjv").startsWith("Nothing"));
  enter("zqxjv");  // does nothing
  auto finder = type("shadows 80");
  takeShot(*finder, "finder-number");
}

}  // namespace
}  // namespace velum::gui
