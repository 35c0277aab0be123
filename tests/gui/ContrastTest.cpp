// What the window writes can be read, as it is on the screen.
#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMap>
#include <QToolButton>
#include <cmath>

#include "Shots.h"
#include "WindowFixture.h"
#include "gui/kit/SideTabs.h"
#include "gui/kit/Theme.h"

namespace velum::gui {
namespace {

constexpr double kText = 4.5;  // WCAG 2.1 AA, 1.4.3

double luminance(const QColor& color) {
  auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}
double contrast(const QColor& a, const QColor& b) {
  double light = luminance(a), dark = luminance(b);
  return (std::max(light, dark) + 0.05) / (std::min(light, dark) + 0.05);
}

/// The ground is what there is most of; the letters are what stands out from it most.
double contrastIn(const QImage& image) {
  QMap<QRgb, int> counts;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) ++counts[image.pixel(x, y)];
  QRgb ground = 0;
  int most = 0;
  for (auto it = counts.begin(); it != counts.end(); ++it)
    if (it.value() > most) {
      most = it.value();
      ground = it.key();
    }
  double best = 1.0;
  for (auto it = counts.begin(); it != counts.end(); ++it)
    best = std::max(best, contrast(QColor(it.key()), QColor(ground)));
  return best;
}

QString textOf(const QWidget& widget) {
  if (auto* label = qobject_cast<const QLabel*>(&widget)) return label->text();
  if (auto* button = qobject_cast<const QAbstractButton*>(&widget)) return button->text();
  if (auto* box = qobject_cast<const QComboBox*>(&widget)) return box->currentText();
  if (auto* edit = qobject_cast<const QLineEdit*>(&widget))
    return edit->text().isEmpty() ? edit->placeholderText() : edit->text();
  return {};
}

class Contrast : public Window {
 protected:
  void SetUp() override {
    mFont = qApp->font();
    Window::SetUp();
    // Letters so thick that their middle has their whole colour.
    QFont thick = mFont;
    thick.setBold(true);
    qApp->setFont(thick);
  }
  void TearDown() override {
    qApp->setFont(mFont);
    applyTheme(*qApp);
    Window::TearDown();
  }
  /// @return how many texts there are
  int expectReadable(const QString& where) {
    QImage image = mWindow->grab().toImage();
    int count = 0;
    for (auto* widget : mWindow->findChildren<QWidget*>()) {
      QString text = textOf(*widget);
      bool isPicture = mWindow->views().isAncestorOf(widget) || widget->inherits("velum::gui::ColorButton");
      auto* button = qobject_cast<const QToolButton*>(widget);
      bool isWritten = text.trimmed().size() > 1 && !(button && button->toolButtonStyle() == Qt::ToolButtonIconOnly);
      bool isWhole = widget->isVisible() && widget->visibleRegion().boundingRect() == widget->rect();
      if (isPicture || !isWritten || !isWhole) continue;
      ++count;
      EXPECT_GE(contrastIn(image.copy({widget->mapTo(mWindow.get(), QPoint()), widget->size()})), kText)
          << (where + ": " + widget->metaObject()->className() + " " + widget->objectName() + " \"" + text + "\"")
                 .toStdString();
    }
    return count;
  }
  QFont mFont;
};

TEST_F(Contrast, OfAllTextInTheWindowInBothThemes) {
  mWindow->resize(1300, 900);
  for (auto kind : {ThemeKind::Dark, ThemeKind::Light}) {
    applyTheme(*qApp, kind);
    QString theme = kind == ThemeKind::Dark ? "dark" : "light";
    mWindow->newScene();
    mWindow->messages().showError("what went wrong");
    QTest::qWait(30);
    EXPECT_GT(expectReadable(theme + ", nothing open"), 8);
    mWindow->messages().showNote("what to know");
    mWindow->openPaths({path("phantom.nrrd"), path("phantom_labels.seg.nrrd")});
    ASSERT_TRUE(waitForJob());
    mWindow->messages().showNote("what to know");
    mWindow->actions().find("cut.addMembrane")->trigger();
    ASSERT_TRUE(waitForJob());
    mWindow->actions().find("film.keyCamera")->trigger();
    auto& tabs = mWindow->tabs();
    for (int page = 0; page < tabs.count(); ++page) {
      if (!tabs.isTabVisible(page)) continue;
      tabs.setCurrentIndex(page);
      QTest::qWait(60);
      EXPECT_GT(expectReadable(theme + ", " + tabs.tabText(page)), 10);
      takeShot(*mWindow, QString("contrast-%1-%2").arg(theme, tabs.tabText(page)));
    }
  }
}

}  // namespace
}  // namespace velum::gui
