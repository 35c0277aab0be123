// The window without a mouse: whatever can be clicked can be reached, is named, and shows that it has the keyboard.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QSet>
#include <QSlider>
#include <QTabWidget>
#include <QTest>
#include <QTextEdit>
#include <QToolBar>
#include <QToolButton>

#include "Shots.h"
#include "TempFolder.h"
#include "gui/kit/Theme.h"
#include "gui/look/TransferCanvas.h"
#include "gui/window/CommandFinder.h"
#include "gui/window/ExportStructuresDialog.h"
#include "gui/window/HelpWindow.h"
#include "gui/window/MainWindow.h"
#include "gui/window/PreferencesDialog.h"
#include "gui/window/RecoveryBar.h"
#include "gui/window/SavePictureDialog.h"
#include "io/labels/WriteLabels.h"
#include "io/phantoms/Sample.h"
#include "io/volumes/WriteVolume.h"
#include "patience.h"

namespace velum::gui {
namespace {

constexpr int kMostSteps = 200;

std::string nameOf(const QWidget* widget) {
  QString name =
      QString("%1 '%2' '%3'").arg(widget->metaObject()->className(), widget->objectName(), widget->accessibleName());
  if (auto* button = qobject_cast<const QAbstractButton*>(widget)) name += " " + button->text();
  return name.toStdString();
}

/// The inside of another control, which has its own way to be worked.
bool isPart(const QWidget* widget) {
  const QWidget* parent = widget->parentWidget();
  return widget->objectName().startsWith("qt_") || qobject_cast<const QScrollBar*>(widget) ||
         qobject_cast<const QAbstractSpinBox*>(parent) || qobject_cast<const QComboBox*>(parent) ||
         qobject_cast<const QLineEdit*>(parent) || qobject_cast<const QTabBar*>(parent);
}

bool isControl(const QWidget* widget) {
  return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QComboBox*>(widget) ||
         qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QLineEdit*>(widget) ||
         qobject_cast<const QAbstractSlider*>(widget) || qobject_cast<const QAbstractItemView*>(widget) ||
         qobject_cast<const QTabBar*>(widget) || ((widget->focusPolicy() & Qt::TabFocus) && !widget->focusProxy());
}

/// A picture of a command that menus and keys have, too.
bool isCommand(const QWidget* widget, const MainWindow& window) {
  auto* button = qobject_cast<const QToolButton*>(widget);
  return button && qobject_cast<QToolBar*>(button->parentWidget()) && button->defaultAction() &&
         window.findChildren<QAction*>().contains(button->defaultAction());
}

/// What can be worked in a window now.
QList<QWidget*> controlsOf(QWidget& window) {
  QList<QWidget*> controls;
  for (QWidget* widget : window.findChildren<QWidget*>())
    if (widget->window() == &window && widget->isVisible() && widget->isEnabled() && isControl(widget) &&
        !isPart(widget) && !qobject_cast<QScrollArea*>(widget))
      controls << widget;
  return controls;
}

/// Where Tab (or Shift+Tab) goes, once round, from what has the keyboard.
QList<QWidget*> walk(QWidget& window, bool back) {
  QList<QWidget*> places;
  for (int i = 0; i < kMostSteps; ++i) {
    QTest::keyClick(window.focusWidget() ? window.focusWidget() : &window, Qt::Key_Tab,
                    back ? Qt::ShiftModifier : Qt::NoModifier);
    QWidget* now = window.focusWidget();
    if (!now || (places.size() > 1 && now == places.first())) return places;
    // A page goes through its links first.
    if (places.isEmpty() || now != places.last()) places << now;
  }
  EXPECT_EQ(places.size(), 1) << "Tab never comes back to " << nameOf(places.first());
  return places;
}

QString tipOf(const QWidget* widget) {
  // A row of slider and number has one tip for both.
  if (!widget->toolTip().isEmpty()) return widget->toolTip();
  if (auto* list = qobject_cast<const QAbstractItemView*>(widget))
    return list->model()->index(0, 0).data(Qt::ToolTipRole).toString();  // a tip for each
  return widget->parentWidget()->toolTip();
}

void expectNamed(const QWidget* widget) {
  QAccessibleInterface* face = QAccessible::queryAccessibleInterface(const_cast<QWidget*>(widget));
  ASSERT_TRUE(face) << nameOf(widget);
  EXPECT_FALSE(face->text(QAccessible::Name).isEmpty()) << "no accessible name: " << nameOf(widget);
  auto* button = qobject_cast<const QAbstractButton*>(widget);
  bool says = button && !button->text().isEmpty() && qobject_cast<const QDialog*>(widget->window());
  bool isView = widget->inherits("velum::gui::Viewport") || widget->inherits("velum::gui::SectionView");
  bool tips = !tipOf(widget).isEmpty() || says || isView || qobject_cast<const QTabBar*>(widget) ||
              qobject_cast<const QTextEdit*>(widget) || widget->inherits("QColorDialog");
  EXPECT_TRUE(tips) << "no tooltip: " << nameOf(widget);
}

/// From above to below, and from left to right in a row.
void expectReadingOrder(const QList<QWidget*>& places, const QWidget& panel) {
  const QWidget* last = nullptr;
  for (const QWidget* widget : places) {
    if (!panel.isAncestorOf(widget)) continue;
    if (last) {
      QRect a(last->mapTo(&panel, QPoint()), last->size()), b(widget->mapTo(&panel, QPoint()), widget->size());
      bool isAbove = b.bottom() <= a.top();
      bool isBefore = b.top() < a.bottom() && a.top() < b.bottom() && b.right() <= a.left();
      EXPECT_FALSE(isAbove || isBefore) << nameOf(last) << " comes before " << nameOf(widget);
    }
    last = widget;
  }
}

class Keyboard : public testing::TestWithParam<ThemeKind> {
 protected:
  static void SetUpTestSuite() {
    sFolder = new TempFolder;
    Progress progress;
    io::Sample sample = io::makeSample("two-spheres", 24, progress);
    io::writeVolume(sample.volume, *sFolder / "phantom.nrrd", progress);
    io::writeLabels(sample.labels, *sFolder / "phantom_labels.seg.nrrd", progress);
    Volume series = sample.volume;
    series.timeSteps = 2;
    series.timeStepSeconds = 0.5;
    Bytes one = series.voxels;
    series.voxels.insert(series.voxels.end(), one.begin(), one.end());
    io::writeVolume(series, *sFolder / "series.nii", progress);
  }
  static void TearDownTestSuite() { delete sFolder; }
  void SetUp() override {
    applyTheme(*qApp, GetParam());
    mWindow = std::make_unique<MainWindow>();
    mWindow->resize(1440, 960);
    mWindow->show();
    activate(*mWindow);
  }
  void TearDown() override {
    mWindow.reset();
    applyTheme(*qApp, ThemeKind::Dark);
  }
  static void activate(QWidget& window) {
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    // Without a window manager nobody else gives it the keyboard.
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.isActiveWindow(); }, kPatience));
  }
  void open(const QStringList& names) {
    QStringList paths;
    for (const auto& name : names) paths << QString::fromStdString((*sFolder / name.toStdString()).string());
    mWindow->openPaths(paths);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !mWindow->isBusy(); }, kPatience));
    mWindow->document().view([](scene::Scene& scene) { scene.rayCast.samplesPerPixel = 1; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->isSettled(); }, kPatience));
  }
  SideTabs& tabs() { return mWindow->tabs(); }
  QWidget& side() { return *mWindow->findChild<QWidget*>("sidePanel"); }
  QWidget& panel() { return *qobject_cast<QScrollArea*>(tabs().currentWidget())->widget(); }

  /// All of the laws for what a window shows now.
  void expectKeysReachAll(QWidget& window) {
    QList<QWidget*> places = walk(window, false);
    ASSERT_FALSE(places.isEmpty());
    for (QWidget* widget : controlsOf(window)) {
      if (!isCommand(widget, *mWindow)) expectNamed(widget);
      QWidget* proxy = widget->focusProxy();
      // A slider beside its number: Tab stops once.
      auto* number = qobject_cast<QSlider*>(widget) ? widget->parentWidget()->findChild<QDoubleSpinBox*>() : nullptr;
      bool reached = places.contains(widget) || places.contains(number) || (proxy && places.contains(proxy)) ||
                     isCommand(widget, *mWindow);
      bool isOnView = widget->parentWidget() && widget->parentWidget()->inherits("velum::gui::SectionView");
      EXPECT_TRUE(reached || isOnView) << "Tab never comes to " << nameOf(widget);
    }
    for (QWidget* place : places) expectFocusIsSeen(*place);
    if (!window.isActiveWindow()) activate(window);
    places.first()->setFocus(Qt::TabFocusReason);
    QList<QWidget*> back = walk(window, true);
    std::reverse(back.begin(), back.end());
    back.prepend(back.takeLast());
    EXPECT_EQ(QSet<QWidget*>(back.begin(), back.end()), QSet<QWidget*>(places.begin(), places.end()));
  }
  /// A picture of it differs from one without the keyboard in as many pixels as a frame has, about.
  void expectFocusIsSeen(QWidget& widget) {
    QWidget* window = widget.window();
    QRect place(widget.mapTo(window, QPoint()), widget.size());
    place = place.adjusted(-4, -4, 4, 4) & window->rect();
    if (widget.visibleRegion().isEmpty()) return;  // beyond what the panel shows; it scrolls when the keyboard comes
    if (!window->isActiveWindow()) activate(*window);
    widget.setFocus(Qt::TabFocusReason);
    ASSERT_TRUE(widget.hasFocus()) << nameOf(&widget);
    QCoreApplication::processEvents();
    place = QRect(widget.mapTo(window, QPoint()), widget.size()).adjusted(-4, -4, 4, 4) & window->rect();
    QImage with = window->grab(place).toImage();
    widget.clearFocus();
    QCoreApplication::processEvents();
    QImage without = window->grab(place).toImage();
    widget.setFocus(Qt::TabFocusReason);
    int changed = 0;
    for (int y = 0; y < with.height(); ++y)
      for (int x = 0; x < with.width(); ++x)
        changed += std::abs(qGray(with.pixel(x, y)) - qGray(without.pixel(x, y))) > 25;
    int least = std::min(place.width(), place.height());
    EXPECT_GE(changed, least) << "nobody sees that it has the keyboard: " << nameOf(&widget);
  }

  inline static TempFolder* sFolder = nullptr;
  std::unique_ptr<MainWindow> mWindow;
};

TEST_P(Keyboard, ReachesTheEmptyWindow) { expectKeysReachAll(*mWindow); }

TEST_P(Keyboard, ReachesAllOfTheLook) {
  open({"series.nii"});
  mWindow->document().edit("Look", [](scene::Scene& scene) {
    scene.rayCast.mode = scene::RenderMode::Iso;
    scene.volume.transfer.gradientOpacities = {{0.0, 1.0}, {100.0, 1.0}};
  });
  ASSERT_TRUE(tabs().showPage("Look"));
  mWindow->viewport().setFocus();
  expectKeysReachAll(*mWindow);
  expectReadingOrder(walk(*mWindow, false), panel());
}

TEST_P(Keyboard, ReachesAllOfTheFinish) {
  open({"phantom.nrrd"});
  ASSERT_TRUE(tabs().showPage("Finish"));
  mWindow->viewport().setFocus();
  expectKeysReachAll(*mWindow);
  expectReadingOrder(walk(*mWindow, false), panel());
}

TEST_P(Keyboard, ReachesAllOfTheStructures) {
  open({"phantom.nrrd", "phantom_labels.seg.nrrd"});
  ASSERT_TRUE(tabs().showPage("Structures"));
  mWindow->selection().setStructure(1);
  mWindow->viewport().setFocus();
  expectKeysReachAll(*mWindow);
  expectReadingOrder(walk(*mWindow, false), panel());
}

TEST_P(Keyboard, ReachesAllOfTheCuts) {
  open({"phantom.nrrd", "phantom_labels.seg.nrrd"});
  for (auto shape : {scene::CutShape::Plane, scene::CutShape::Box})
    mWindow->document().edit("Add cut", [&](scene::Scene& scene) {
      scene::addCut(scene, {});
      scene.cuts.back().shape = shape;
      scene.cuts.back().face = scene::CutFace::Section;
    });
  ASSERT_TRUE(tabs().showPage("Cuts"));
  for (int cut : {0, 1}) {
    mWindow->selection().setCut(mWindow->document().scene().cuts[std::size_t(cut)].id);
    mWindow->viewport().setFocus();
    expectKeysReachAll(*mWindow);
    expectReadingOrder(walk(*mWindow, false), panel());
  }
}

/// The pages above have a test of their own, in which all that they can show is there.
TEST_P(Keyboard, ReachesAllOfEveryPage) {
  open({"phantom.nrrd"});
  mWindow->actions().find("film.keyCamera")->trigger();  // the film is reached, too
  for (int page = 0; page < tabs().count(); ++page) {
    if (!tabs().isTabVisible(page)) continue;  // of data that is not open
    tabs().setCurrentIndex(page);
    mWindow->viewport().setFocus();
    expectKeysReachAll(*mWindow);
  }
}

TEST_P(Keyboard, ReachesTheBars) {
  auto* bar = mWindow->findChild<RecoveryBar*>();
  session::LostWork work;
  work.title = "head";
  work.isReadable = true;
  bar->offer({work, work});
  mWindow->messages().showNote("A note");
  ASSERT_TRUE(bar->isVisible());
  expectKeysReachAll(*mWindow);
}

TEST_P(Keyboard, ReachesAllOfTheDialogs) {
  open({"phantom.nrrd"});
  SavePictureDialog picture({640, 480}, {640, 480}, mWindow->document().scene(), mWindow.get());
  PreferencesDialog preferences(mWindow->actions(), mWindow.get());
  CommandFinder finder(findCommands(mWindow->actions()), mWindow.get());
  for (QDialog* dialog :
       {static_cast<QDialog*>(&picture), static_cast<QDialog*>(&preferences), static_cast<QDialog*>(&finder)}) {
    activate(*dialog);
    expectKeysReachAll(*dialog);
    QTest::keyClick(dialog->focusWidget(), Qt::Key_Escape);
    EXPECT_FALSE(dialog->isVisible()) << "Esc leaves " << dialog->windowTitle().toStdString();
  }
}

TEST_P(Keyboard, ReachesTheGuide) {
  HelpWindow guide(mWindow.get());
  activate(guide);
  expectKeysReachAll(guide);
  QTest::keyClick(&guide, Qt::Key_Escape);
  EXPECT_FALSE(guide.isVisible());
}

INSTANTIATE_TEST_SUITE_P(Themes, Keyboard, testing::Values(ThemeKind::Dark, ThemeKind::Light),
                         [](const auto& one) { return one.param == ThemeKind::Dark ? "Dark" : "Light"; });

class KeyboardUse : public Keyboard {};
INSTANTIATE_TEST_SUITE_P(Window, KeyboardUse, testing::Values(ThemeKind::Dark));

TEST_P(KeyboardUse, EscGoesFromAPanelToTheViews) {
  open({"phantom.nrrd", "phantom_labels.seg.nrrd"});
  int asked = 0;
  for (int tab = 0; tab < tabs().count(); ++tab) {
    if (!tabs().isTabVisible(tab)) continue;
    tabs().setCurrentIndex(tab);
    for (QWidget* control : controlsOf(*mWindow)) {
      if (!side().isAncestorOf(control) || !(control->focusPolicy() & Qt::TabFocus)) continue;
      control->setFocus(Qt::TabFocusReason);
      QTest::keyClick(mWindow->focusWidget(), Qt::Key_Escape);
      EXPECT_TRUE(mWindow->views().isAncestorOf(mWindow->focusWidget())) << nameOf(control);
      ++asked;
    }
  }
  EXPECT_GT(asked, 20);
}

TEST_P(KeyboardUse, SpaceIsTheButtonsAndOtherwisePlays) {
  open({"series.nii"});
  ASSERT_TRUE(tabs().showPage("Look"));
  auto* gradients = mWindow->findChild<QCheckBox*>("usesGradients");
  gradients->setFocus(Qt::TabFocusReason);
  QTest::keyClick(gradients, Qt::Key_Space);
  EXPECT_FALSE(mWindow->document().scene().volume.transfer.gradientOpacities.empty());
  EXPECT_EQ(mWindow->document().scene().volume.timeStep, 0);
  QTest::keyClick(&mWindow->viewport(), Qt::Key_Space);
  EXPECT_TRUE(QTest::qWaitFor([&] { return mWindow->document().scene().volume.timeStep == 1; }, kPatience));
}

TEST_P(KeyboardUse, ACurveIsMadeWithoutAMouse) {
  open({"phantom.nrrd"});
  auto* canvas = mWindow->findChild<TransferCanvas*>("transferCanvas");
  auto transfer = [&]() -> const scene::TransferFunction& { return mWindow->document().scene().volume.transfer; };
  std::size_t points = transfer().opacities.size(), stops = transfer().colors.size();
  canvas->setFocus(Qt::TabFocusReason);
  QTest::keyClick(canvas, Qt::Key_PageDown);
  EXPECT_EQ(canvas->selection(), (TransferCanvas::Selection{TransferCanvas::Selection::Part::Point, 0}));
  QTest::keyClick(canvas, Qt::Key_Insert);
  EXPECT_EQ(transfer().opacities.size(), points + 1);
  double before = transfer().opacities[1].opacity;
  QTest::keyClick(canvas, Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_NEAR(transfer().opacities[1].opacity, std::min(1.0, before + 0.1), 1e-6);
  for (std::size_t i = 0; i < points + stops + 1; ++i) QTest::keyClick(canvas, Qt::Key_PageDown);
  EXPECT_EQ(canvas->selection().part, TransferCanvas::Selection::Part::Stop);
  EXPECT_EQ(canvas->selection().index, int(stops) - 1);
  QTest::keyClick(canvas, Qt::Key_Insert);
  EXPECT_EQ(transfer().colors.size(), stops + 1);
  QTest::keyClick(canvas, Qt::Key_Delete);
  EXPECT_EQ(transfer().colors.size(), stops);
}

TEST_P(KeyboardUse, NoTwoEntriesOfAMenuHaveTheSameLetter) {
  open({"phantom.nrrd"});
  int entries = 0;
  auto letterOf = [](const QString& text) { return QKeySequence::mnemonic(text).toString(); };
  auto expectDifferent = [&](const QList<QAction*>& actions, const QString& where) {
    QMap<QString, QString> letters;
    for (const QAction* action : actions) {
      QString letter = letterOf(action->text());
      if (letter.isEmpty()) continue;
      ++entries;
      EXPECT_FALSE(letters.contains(letter))
          << (where + ": " + action->text() + " and " + letters[letter]).toStdString();
      letters[letter] = action->text();
    }
  };
  expectDifferent(mWindow->menuBar()->actions(), "the bar");
  for (const QAction* menu : mWindow->menuBar()->actions()) expectDifferent(menu->menu()->actions(), menu->text());
  EXPECT_GT(entries, 40);
}

TEST_P(KeyboardUse, NoButtonHasTheLetterOfAMenuOrOfAnother) {
  open({"phantom.nrrd"});
  QMap<QString, QString> letters;
  auto expectFree = [&](const QString& text, const QString& where) {
    QString letter = QKeySequence::mnemonic(text).toString();
    if (letter.isEmpty()) return;
    EXPECT_FALSE(letters.contains(letter)) << (where + ": " + text + " and " + letters[letter]).toStdString();
    letters[letter] = text;
  };
  auto expectFreeButtons = [&](const QWidget& owner) {
    for (const auto* button : owner.findChildren<QAbstractButton*>())
      if (button->window() == &owner) expectFree(button->text(), owner.windowTitle());
    for (const auto* label : owner.findChildren<QLabel*>())
      if (label->buddy() && label->window() == &owner) expectFree(label->text(), owner.windowTitle());
  };
  for (const QAction* menu : mWindow->menuBar()->actions()) expectFree(menu->text(), "the bar");
  expectFreeButtons(*mWindow);
  SavePictureDialog picture({640, 480}, {640, 480}, mWindow->document().scene(), mWindow.get());
  PreferencesDialog preferences(mWindow->actions(), mWindow.get());
  ExportStructuresDialog structures(mWindow->document().scene(), {}, mWindow.get());
  for (const QWidget* dialog :
       {static_cast<QWidget*>(&picture), static_cast<QWidget*>(&preferences), static_cast<QWidget*>(&structures)}) {
    letters.clear();
    expectFreeButtons(*dialog);
  }
}

TEST_P(KeyboardUse, TheMouseMakesNoRing) {
  open({"phantom.nrrd"});
  auto* gradients = mWindow->findChild<QCheckBox*>("usesGradients");
  auto isRinged = [&] {
    auto* ring = mWindow->findChild<QWidget*>("focusRing");
    return ring && ring->isVisible();
  };
  QTest::mouseClick(gradients, Qt::LeftButton);
  EXPECT_FALSE(isRinged());
  QTest::keyClick(gradients, Qt::Key_Tab);
  EXPECT_TRUE(isRinged());
}

}  // namespace
}  // namespace velum::gui
