// Words of the clinic stand where there is a patient, and on nothing else.
#include <QMenuBar>
#include <QRegularExpression>
#include <QToolButton>

#include "ModelFixture.h"
#include "gui/view/SideNames.h"
#include "gui/view/ViewCube.h"

namespace velum::gui {
namespace {

class SideNames : public ModelWindow {
 protected:
  void useCuts() {
    mWindow->actions().find("cut.addPlane")->trigger();
    ASSERT_TRUE(waitForJob());
    mWindow->tabs().showPage("Cuts");
    QTest::qWait(20);
  }
  /// All texts, tips and accessible names that the window shows now, each with whose it is.
  QMap<QString, QString> texts() {
    QMap<QString, QString> all;
    for (const QAction* action : mWindow->actions().all())
      all[action->objectName()] = action->text() + "|" + action->toolTip() + "|" + action->statusTip();
    for (const QWidget* widget : mWindow->findChildren<QWidget*>()) {
      if (!widget->isVisible()) continue;
      QString text = widget->toolTip() + "|" + widget->accessibleName();
      if (auto* button = qobject_cast<const QAbstractButton*>(widget)) text += "|" + button->text();
      if (auto* label = qobject_cast<const QLabel*>(widget)) text += "|" + label->text();
      all[QString("%1 %2 %3").arg(widget->metaObject()->className(), widget->objectName()).arg(quintptr(widget))] =
          text;
    }
    return all;
  }
};

const QRegularExpression kClinic("\\b(anterior|posterior|superior|inferior|axial|coronal|sagittal|patient)",
                                 QRegularExpression::CaseInsensitiveOption);

TEST_F(SideNames, OfTheClinicStandOnNoModel) {
  openModel();
  useCuts();
  mWindow->views().setLayout(scene::Layout::FourUp);
  QTest::qWait(50);
  auto all = texts();
  EXPECT_GT(all.size(), 100);
  for (auto one = all.begin(); one != all.end(); ++one) {
    if (one.key().startsWith("file.")) continue;  // kinds of files
    EXPECT_FALSE(kClinic.match(one.value()).hasMatch()) << one.key().toStdString() << ": " << one.value().toStdString();
  }
  for (const char* letter : {"R", "L", "A", "P", "S", "I"}) {
    QString text = child<QPushButton>((std::string("align") + letter).c_str())->text();
    EXPECT_EQ(text.size(), 2) << letter << ": " << text.toStdString();
  }
  EXPECT_EQ(child<QPushButton>("alignR")->text(), "-x");
}

TEST_F(SideNames, AreFrontAndTopOfAModelAndThoseOfTheBodyOfAPatient) {
  openModel();
  auto text = [&](const char* id) { return mWindow->actions().find(id)->text().remove('&'); };
  auto& cube = *child<ViewCube>("viewCube");
  EXPECT_EQ(text("view.anterior"), "Front");
  EXPECT_EQ(text("view.posterior"), "Back");
  EXPECT_EQ(text("view.superior"), "Top");
  EXPECT_EQ(text("view.inferior"), "Bottom");
  EXPECT_EQ(text("view.left"), "Left");
  EXPECT_EQ(mWindow->actions().find("view.superior")->statusTip(), "Look from: top");
  EXPECT_TRUE(mWindow->actions().find("view.superior")->toolTip().contains("(7)")) << "keys stay";
  EXPECT_EQ(cube.nameOf({1, -1, 1}), "front, left, top");
  EXPECT_EQ(planeName(scene(), scene::SectionKind::Axial), "XY");
  openPhantom();
  EXPECT_EQ(text("view.anterior"), "Anterior");
  EXPECT_EQ(text("view.superior"), "Superior");
  EXPECT_EQ(cube.nameOf({1, -1, 1}), "anterior, left, superior");
  EXPECT_EQ(sideSign(scene(), 0, true), "L");
  useCuts();
  EXPECT_EQ(child<QPushButton>("alignR")->text(), "R");
  EXPECT_TRUE(child<QPushButton>("alignR")->toolTip().contains("patient's right"));
}

TEST_F(SideNames, NoTwoEntriesOfTheMenuHaveTheSameLetter) {
  openModel();
  QMap<QString, QString> letters;
  const QMenu* menu = nullptr;
  for (const QAction* one : mWindow->menuBar()->actions())
    if (one->text() == "&View") menu = one->menu();
  ASSERT_TRUE(menu);
  for (const QAction* action : menu->actions()) {
    QString letter = QKeySequence::mnemonic(action->text()).toString();
    if (letter.isEmpty()) continue;
    EXPECT_FALSE(letters.contains(letter)) << (action->text() + " and " + letters[letter]).toStdString();
    letters[letter] = action->text();
  }
}

}  // namespace
}  // namespace velum::gui
