// A bar means the same in the dark window, in the light one, and in files; and its key says what.
#include "gui/rows/CountBar.h"

#include <QLabel>
#include <cmath>

#include "ModelFixture.h"
#include "Shots.h"
#include "gui/kit/Theme.h"
#include "gui/rows/CountKey.h"
#include "session/cut/CutEdit.h"
#include "session/model/CountFiles.h"

namespace velum::gui {
namespace {

double lightOf(const QColor& color) {
  auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}
double contrastOf(const QColor& a, const QColor& b) {
  double light = lightOf(a), dark = lightOf(b);
  return (std::max(light, dark) + 0.05) / (std::min(light, dark) + 0.05);
}

class CountBars : public ModelWindow {
 protected:
  void TearDown() override {
    applyTheme(*qApp);
    Window::TearDown();
  }
};

TEST(CountColours, AreToldApartWithoutHueAndStandOutInBothThemes) {
  for (std::size_t i = 0; i < kCountKinds.size(); ++i) {
    QColor one = countColor(CountOf(i));
    ASSERT_TRUE(one.isValid());
    EXPECT_GE(contrastOf(one, QColor(QString::fromStdString(std::string(kCountKinds[i].letter)))), 4.5) << i;
    for (auto kind : {ThemeKind::Dark, ThemeKind::Light})
      EXPECT_GE(contrastOf(one, themeColor(kind, "ground")), i == 0 ? 3.0 : 1.8) << i;
    for (std::size_t k = 0; k < i; ++k) EXPECT_GE(contrastOf(one, countColor(CountOf(k))), 1.45) << i << ", " << k;
  }
  EXPECT_LT(lightOf(countColor(CountOf::Visible)), lightOf(countColor(CountOf::Hidden))) << "dark, light";
  EXPECT_LT(countColor(CountOf::Clipped).hsvSaturation(), 40) << "and grey";
}

TEST_F(CountBars, HaveTheSameColoursInBothThemesAndInFiles) {
  openDenseModel();
  mWindow->document().edit("Cut", [](scene::Scene& scene) {
    scene::Cut cut = session::makeCut(scene, scene::CutShape::Plane);
    scene::addCut(scene, cut);
  });
  ASSERT_TRUE(settle());
  Counts counts = list().tree().countOf(list().tree().rows()[0]);
  for (std::uint64_t part : counts.parts) ASSERT_GT(part, counts.total() / 20) << "each part is wide enough to be seen";
  std::string svg = session::countsSvg({{"root", "root", true, 0, counts}}, "bars");
  for (auto theme : {ThemeKind::Dark, ThemeKind::Light}) {
    applyTheme(*qApp, theme);
    QTest::qWait(50);
    QImage image = list().viewport()->grab().toImage();
    CountBar bar = list().barOf(0);
    for (std::size_t i = 0; i < kCountKinds.size(); ++i) {
      double from = i > 0 ? bar.ends[i - 1] : 0.0;
      QPointF middle(bar.box.left() + 0.5 * (from + bar.ends[i]), bar.box.center().y());
      QColor seen = image.pixelColor((middle * image.devicePixelRatio()).toPoint());
      EXPECT_EQ(seen.name(), countColor(CountOf(i)).name()) << i << (theme == ThemeKind::Dark ? " dark" : " light");
      EXPECT_NE(svg.find("fill=\"" + seen.name().toStdString() + "\""), std::string::npos) << i;
    }
    takeShot(*mWindow, theme == ThemeKind::Dark ? "bars-dark" : "bars-light");
  }
}

TEST_F(CountBars, HaveAKeyBesideThem) {
  openModel();
  QList<CountKey*> seen;
  for (auto* one : mWindow->findChildren<CountKey*>())
    if (one->isVisible()) seen << one;
  ASSERT_EQ(seen.size(), 1) << "that of the page that is shown";
  QStringList words;
  for (auto* label : seen[0]->findChildren<QLabel*>()) words << label->text();
  EXPECT_EQ(words, (QStringList{"seen", "hidden", "removed"}));
  EXPECT_FALSE(seen[0]->toolTip().isEmpty());
  QImage image = seen[0]->grab().toImage();
  QSet<QString> colors;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) colors.insert(image.pixelColor(x, y).name());
  for (std::size_t i = 0; i < kCountKinds.size(); ++i) EXPECT_TRUE(colors.contains(countColor(CountOf(i)).name())) << i;
}

TEST_F(CountBars, OfStructuresHaveTheirKeyWhileTheyAreShown) {
  mWindow->openPaths({path("phantom.nrrd"), path("phantom_labels.seg.nrrd")});
  ASSERT_TRUE(waitForJob());
  mWindow->tabs().showPage("Structures");
  auto shown = [&] {
    int count = 0;
    for (auto* one : mWindow->findChildren<CountKey*>()) count += one->isVisible();
    return count;
  };
  EXPECT_EQ(shown(), 0);
  child<QToolButton>("structureBars")->click();
  EXPECT_EQ(shown(), 1);
  child<QToolButton>("structureBars")->click();
  EXPECT_EQ(shown(), 0);
}

}  // namespace
}  // namespace velum::gui
