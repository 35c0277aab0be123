#include <QComboBox>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTreeWidget>
#include <QWheelEvent>

#include "Shots.h"
#include "WindowFixture.h"
#include "gui/kit/Preferences.h"
#include "gui/window/PreferencesDialog.h"

namespace velum::gui {
namespace {

/// What is chosen for the program counts at once, and in the next window.
class PreferencesUse : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    mDialog = std::make_unique<PreferencesDialog>(mWindow->actions(), mWindow.get());
    mDialog->show();
  }
  void TearDown() override {
    Preferences().setHabits({});
    Preferences().setFirstLayout({});
    QFile::remove(Preferences::keysPath());
    mDialog.reset();
    Window::TearDown();
  }
  void choose(const char* name, int index) {
    auto* choice = mDialog->findChild<QComboBox*>(name);
    ASSERT_TRUE(choice) << name;
    choice->setCurrentIndex(index);
    emit choice->activated(index);
  }
  QTreeWidgetItem* rowOf(const QString& id) {
    auto* table = mDialog->findChild<QTreeWidget*>("keyTable");
    for (int i = 0; i < table->topLevelItemCount(); ++i)
      if (table->topLevelItem(i)->data(0, Qt::UserRole).toString() == id) return table->topLevelItem(i);
    return nullptr;
  }
  void giveKey(const QString& id, const QKeySequence& key) {
    mDialog->findChild<QTreeWidget*>("keyTable")->setCurrentItem(rowOf(id));
    auto* edit = mDialog->findChild<QKeySequenceEdit*>("keyEdit");
    edit->setKeySequence(key);
    emit edit->editingFinished();
  }
  double wheel(int notches) {
    double before = glm::length(scene().camera.eye - scene().camera.target);
    QPointF middle(viewport().width() / 2.0, viewport().height() / 2.0);
    QWheelEvent event(middle, viewport().mapToGlobal(middle), {}, QPoint(0, 120 * notches), Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&viewport(), &event);
    return glm::length(scene().camera.eye - scene().camera.target) / before;
  }

  std::unique_ptr<PreferencesDialog> mDialog;
};

TEST_F(PreferencesUse, AKeyIsGivenTakenFromAnotherAndKept) {
  QAction* duplicate = mWindow->actions().find("cut.duplicate");
  QAction* flip = mWindow->actions().find("cut.flip");
  mDialog->findChild<QTabWidget*>("preferencePages")->setCurrentIndex(2);
  takeShot(*mDialog, "preferences-keys");
  giveKey("cut.flip", QKeySequence("Ctrl+D"));
  EXPECT_EQ(flip->shortcut(), QKeySequence("Ctrl+D"));
  EXPECT_TRUE(duplicate->shortcut().isEmpty()) << "no key does two things";
  EXPECT_EQ(rowOf("cut.duplicate")->text(1), "");
  EXPECT_TRUE(flip->toolTip().contains("Ctrl+D"));
  // The next window has it, too.
  MainWindow next;
  EXPECT_EQ(next.actions().find("cut.flip")->shortcut(), QKeySequence("Ctrl+D"));
  EXPECT_TRUE(next.actions().find("cut.duplicate")->shortcut().isEmpty());
  // And back.
  giveKey("cut.flip", QKeySequence("X"));
  giveKey("cut.duplicate", QKeySequence("Ctrl+D"));
  QFile file(Preferences::keysPath());
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_EQ(file.readAll().simplified(), "{ }") << "what is as usual is not written";
}

TEST_F(PreferencesUse, AKeyIsFoundByWordsOrByItself) {
  auto* words = mDialog->findChild<QLineEdit*>("keyWords");
  words->setText("ctrl+d");
  EXPECT_FALSE(rowOf("cut.duplicate")->isHidden());
  EXPECT_TRUE(rowOf("cut.flip")->isHidden());
  words->setText("flip");
  EXPECT_FALSE(rowOf("cut.flip")->isHidden());
}

TEST_F(PreferencesUse, TheWheelTurnsRound) {
  openPhantom();
  double usual = wheel(1);
  EXPECT_LT(usual, 1.0);
  choose("wheelVolume", 1);
  EXPECT_NEAR(wheel(1), 1.0 / usual, 1e-9);
}

TEST_F(PreferencesUse, TheLeftButtonMovesInsteadOfTurning) {
  openPhantom();
  auto direction = [&] { return glm::normalize(scene().camera.target - scene().camera.eye); };
  glm::dvec3 before = direction();
  choose("mouseLeft", 1);
  drag({200, 200}, {260, 230});
  EXPECT_NEAR(glm::dot(before, direction()), 1.0, 1e-9);
  drag({200, 200}, {260, 230}, Qt::MiddleButton);
  EXPECT_LT(glm::dot(before, direction()), 0.9999);
}

TEST_F(PreferencesUse, LengthsAreToldInTheChosenUnit) {
  openPhantom();
  EXPECT_EQ(Length(scene()).unit(), "mm");
  QString before = Length(scene()).text(1.5);
  choose("lengthUnit", 2);
  EXPECT_EQ(Length(scene()).unit(), QString::fromUtf8("\u00b5m"));
  EXPECT_TRUE(Length(scene()).text(1.5).startsWith("1500")) << before.toStdString();
}

TEST_F(PreferencesUse, DataOpensInTheChosenViews) {
  choose("firstLayout", 3);
  EXPECT_EQ(ViewGrid::layoutFor([] {
              scene::Scene scene;
              Volume volume;
              volume.dims = {8, 8, 8};
              volume.voxels.resize(512);
              scene.volume.data = Shared<Volume>(std::move(volume));
              return scene;
            }()),
            scene::Layout::VolumeAndSection);
}

TEST_F(PreferencesUse, EveryPageCanBeLookedAt) {
  auto* pages = mDialog->findChild<QTabWidget*>("preferencePages");
  EXPECT_GE(pages->count(), 2);
  for (int i = 0; i < pages->count(); ++i) {
    pages->setCurrentIndex(i);
    int controls = 0;
    for (auto* control : pages->currentWidget()->findChildren<QWidget*>())
      if (control->isVisible() && control->focusPolicy() & Qt::TabFocus) {
        QRect place(control->mapTo(mDialog.get(), QPoint()), control->size());
        EXPECT_TRUE(mDialog->rect().contains(place)) << control->objectName().toStdString();
        ++controls;
      }
    EXPECT_GT(controls, 0) << pages->tabText(i).toStdString();
    takeShot(*mDialog, QString("preferences-%1").arg(i).toUtf8().constData());
  }
}

}  // namespace
}  // namespace velum::gui
