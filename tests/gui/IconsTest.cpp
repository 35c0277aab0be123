// Every command has an icon of its own, that suits the theme.
#include <QDir>
#include <QImage>
#include <QListWidget>
#include <QMenuBar>
#include <QSet>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>

#include "Shots.h"
#include "WindowFixture.h"
#include "gui/kit/Icons.h"
#include "gui/kit/Theme.h"
#include "gui/window/CommandFinder.h"

namespace velum::gui {
namespace {

/// Those that no command has.
const QStringList kOthers = {"view.maximise", "view.restore", "view.menu", "view.more", "film.pause"};

class Icons : public Window {
 protected:
  void TearDown() override {
    applyTheme(*qApp);
    Window::TearDown();
  }
};

QImage imageOf(const QIcon& icon, QIcon::Mode mode = QIcon::Normal, QIcon::State state = QIcon::Off) {
  return icon.pixmap(QSize(24, 24), 1.0, mode, state).toImage();
}

/// The most there is of a colour: how dark or light the lines are.
QColor toneOf(const QImage& image) {
  QColor strongest = Qt::transparent;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (QColor color = image.pixelColor(x, y); color.alpha() > strongest.alpha()) strongest = color;
  return strongest;
}

TEST_F(Icons, EachCommandHasOneAndEachFileIsUsed) {
  QSet<QString> used(kOthers.begin(), kOthers.end());
  for (const QAction* action : mWindow->actions().all()) {
    QString name = action->objectName().section('.', 0, 1);
    EXPECT_FALSE(action->icon().isNull()) << name.toStdString() << ": resources/icons has no icon of this name";
    used.insert(name);
  }
  for (const QString& file : QDir(":/icons").entryList())
    EXPECT_TRUE(used.contains(file.chopped(4))) << file.toStdString() << " is nobody's";
  for (const QString& name : used) EXPECT_GT(toneOf(imageOf(makeIcon(name))).alpha(), 200) << name.toStdString();
}

TEST_F(Icons, AreAllOfOneKindAndDifferent) {
  QSet<QByteArray> drawings;
  for (const QString& file : QDir(":/icons").entryList()) {
    QByteArray svg = bytesOf(":/icons/" + file);
    for (const char* part : {"viewBox=\"0 0 24 24\"", "stroke=\"currentColor\"", "stroke-width=\"1.6\""})
      EXPECT_TRUE(svg.contains(part)) << file.toStdString() << ": " << part;
    for (QByteArray rest = svg; rest.contains('#'); rest = rest.mid(rest.indexOf('#') + 1))
      EXPECT_EQ(rest.mid(rest.indexOf('#'), 7), "#5fb0ea") << file.toStdString() << " has a third tone";
    EXPECT_FALSE(drawings.contains(svg)) << file.toStdString() << " is another's";
    drawings.insert(svg);
  }
}

TEST_F(Icons, FollowTheTheme) {
  QIcon icon = makeIcon("help.find");
  applyTheme(*qApp, ThemeKind::Dark);
  EXPECT_GT(toneOf(imageOf(icon)).lightness(), 150);
  applyTheme(*qApp, ThemeKind::Light);
  EXPECT_LT(toneOf(imageOf(icon)).lightness(), 110);
  EXPECT_GT(toneOf(imageOf(icon, QIcon::Normal, QIcon::On)).lightness(), 200) << "on what is chosen";
  EXPECT_NE(imageOf(icon, QIcon::Disabled), imageOf(icon));
}

TEST_F(Icons, StandInMenusAndInTheSearchForCommands) {
  openPhantom();
  for (auto kind : {ThemeKind::Light, ThemeKind::Dark}) {
    applyTheme(*qApp, kind);
    QString theme = kind == ThemeKind::Dark ? "dark" : "light";
    for (QAction* entry : mWindow->menuBar()->actions()) {
      entry->menu()->ensurePolished();
      takeShot(*entry->menu(), "menu-" + entry->text().remove('&') + "-" + theme);
    }
    QTimer::singleShot(200, [theme] {
      QWidget* menu = QApplication::activePopupWidget();
      ASSERT_TRUE(menu);
      takeShot(*menu, "menu-ticks-" + theme);
      menu->close();
    });
    mWindow->views().section(scene::SectionKind::Axial).findChild<QToolButton*>("menu")->click();
    CommandFinder finder(findCommands(mWindow->actions()), mWindow.get());
    auto* list = finder.findChild<QListWidget*>();
    ASSERT_GT(list->count(), 40);
    for (int row = 0; row < list->count(); ++row) EXPECT_FALSE(list->item(row)->icon().isNull());
    takeShot(finder, "finder-" + theme);
  }
}

TEST_F(Icons, EachToolIsReachableInASmallWindow) {
  openPhantom();
  auto* bar = mWindow->findChild<QToolBar*>("toolBar");
  for (int width : {1024, 1440, 640}) {
    mWindow->resize(width, 700);
    QTest::qWait(30);
    QStringList named;
    auto* more = bar->findChild<QToolButton*>("qt_toolbar_ext_button");
    for (QAction* action : bar->actions()) {
      auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action));
      if (!button) continue;
      EXPECT_TRUE(button->isVisible() || more->isVisible()) << action->objectName().toStdString() << " at " << width;
      if (width >= 1024) {
        EXPECT_TRUE(button->isVisible()) << action->objectName().toStdString() << " at " << width;
      }
      EXPECT_FALSE(button->toolTip().isEmpty());
      if (button->toolButtonStyle() != Qt::ToolButtonIconOnly) named << action->objectName();
    }
    if (width >= 1024) {
      EXPECT_GE(named.size(), 4) << "the program's own tools say their name";
      EXPECT_EQ(named.mid(0, 3), QStringList({"cut.addMembrane", "cut.addPlane", "look.showThis"}));
    }
    takeShot(*mWindow, QString("tools-%1").arg(width));
  }
}

}  // namespace
}  // namespace velum::gui
