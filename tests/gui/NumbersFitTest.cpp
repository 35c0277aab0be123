// Numbers are seen whole, however long they are.
#include <QLineEdit>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStyle>
#include <QStyleOptionFrame>

#include "ModelFixture.h"
#include "Shots.h"
#include "WindowFixture.h"
#include "gui/kit/NumberField.h"
#include "gui/kit/SideTabs.h"
#include "gui/kit/Theme.h"
#include "scene/Scene.h"

namespace velum::gui {
namespace {

constexpr double kLong = 1234.5;

/// What a field leaves for its text, in pixels.
int roomOf(const QLineEdit& edit) {
  QStyleOptionFrame option;
  option.initFrom(&edit);
  option.lineWidth = 0;
  int margins = 2 * 2;  // QLineEdit keeps two pixels free at each end
  return edit.style()->subElementRect(QStyle::SE_LineEditContents, &option, &edit).width() - margins;
}

/// Shows the longest number there may be of a kind, in the unit that is shown.
void showLongest(NumberField& field) {
  const QSignalBlocker quiet(&field);
  double most = field.maximum(), least = field.minimum();
  auto widthOf = [&](double value) { return field.fontMetrics().horizontalAdvance(field.textFromValue(value)); };
  double value = least <= -kLong ? -kLong : widthOf(least) > widthOf(most) ? least : std::min(most, kLong);
  field.setValue(value);
}

/// Of all numbers that are seen in the side panel. @return how many there are
int expectNumbersFit(MainWindow& window, const QString& where) {
  int count = 0;
  for (auto* field : window.tabs().findChildren<NumberField*>()) {
    if (!field->isVisible()) continue;
    ++count;
    showLongest(*field);
    auto* edit = field->findChild<QLineEdit*>();
    int room = roomOf(*edit), text = edit->fontMetrics().horizontalAdvance(edit->text());
    EXPECT_GE(room, text)
        << (where + ", " + field->objectName() + " " + field->accessibleName() + ": " + edit->text()).toStdString();
    QRect inPanel(field->mapTo(&window.tabs(), QPoint()), field->size());
    EXPECT_LE(inPanel.right(), window.tabs().width()) << field->objectName().toStdString();
  }
  return count;
}

int expectAllPagesFit(MainWindow& window, const QString& where) {
  int count = 0;
  SideTabs& tabs = window.tabs();
  for (int page = 0; page < tabs.count(); ++page) {
    if (!tabs.isTabVisible(page)) continue;
    tabs.setCurrentIndex(page);
    QTest::qWait(10);
    count += expectNumbersFit(window, where + ", " + tabs.tabText(page));
  }
  return count;
}

class NumbersFit : public ModelWindow {
 protected:
  void TearDown() override {
    applyTheme(*qApp);
    Window::TearDown();
  }
};

TEST_F(NumbersFit, InEveryPanelForEveryShapeInBothThemes) {
  mWindow->openPaths({path("phantom.nrrd"), path("phantom_labels.seg.nrrd")});
  ASSERT_TRUE(waitForJob());
  mWindow->resize(1024, 700);
  const char* const shapes[] = {"cut.addPlane",    "cut.addBox",  "cut.addSphere",
                                "cut.addCylinder", "cut.addCone", "cut.addMembrane"};
  for (auto kind : {ThemeKind::Dark, ThemeKind::Light}) {
    applyTheme(*qApp, kind);
    for (const char* id : shapes) {
      mWindow->actions().find(id)->trigger();
      ASSERT_TRUE(waitForJob());
      QTest::qWait(30);
      EXPECT_GT(expectAllPagesFit(*mWindow, id), 10);
      mWindow->tabs().showPage("Cuts");
      takeShot(*mWindow, QString("numbers-%1-%2").arg(QString(id).mid(7), kind == ThemeKind::Dark ? "dark" : "light"));
      mWindow->document().undo();
    }
  }
}

TEST_F(NumbersFit, OfModels) {
  openModel();
  mWindow->resize(1024, 700);
  for (const char* id : {"cut.addPlane", "cut.addBox", "cut.addMembrane", "cut.addEverywhere"}) {
    mWindow->actions().find(id)->trigger();
    ASSERT_TRUE(waitForJob());
    QTest::qWait(30);
    EXPECT_GT(expectAllPagesFit(*mWindow, id), 5);
    mWindow->document().undo();
  }
}

}  // namespace
}  // namespace velum::gui
