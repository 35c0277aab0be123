// What is drawn over the picture while structures are pulled ([ACS] 4.3), by its pixels.
#include "PullFixture.h"
#include "gui/kit/Theme.h"
#include "scene/Scene.h"
#include "session/cut/CutGizmo.h"

namespace velum::gui {

namespace {

double brightness(QRgb pixel) { return (qRed(pixel) + qGreen(pixel) + qBlue(pixel)) / 3.0; }

/// As orange as the outlines of cuts, 0..1.
double orangeness(QRgb pixel) {
  return std::clamp((qRed(pixel) - qBlue(pixel)) / double(kHandle.red() - kHandle.blue()), 0.0, 1.0);
}

}  // namespace

class PullFeedback : public PullFixture {
 protected:
  /// A wedge that opens the upper of two spheres to the front and the patient's right.
  void openWedge() {
    open({path("phantom.nrrd"), path("phantom_labels.seg.nrrd")});
    document().edit("Wedge", [](scene::Scene& s) {
      scene::Cut front, right;
      front.axis = {0, -1, 0};
      right.axis = {-1, 0, 0};
      front.centre = right.centre = kMiddle;
      right.joined = true;
      scene::addCut(s, front);
      scene::addCut(s, right);
      s.camera = scene::frameCamera(s, scene::StandardView::Oblique, 1.0);
    });
    ASSERT_TRUE(settle());
  }
  /// Without anything painted over it.
  QImage bare() {
    mWindow->toolbox().stop();
    mWindow->selection().setCut(0);
    EXPECT_TRUE(settle());
    return shot();
  }
  /// How wide an outline of a plane is drawn, in pixels: the median, as other lines cross it.
  double outlineWidth(const QImage& image, const scene::Cut& of) {
    auto outline = session::makeCutGizmo(scene(), of, size()).outline;
    std::vector<double> widths;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      QPointF a = pixelOf(outline[i]), b = pixelOf(outline[(i + 1) % outline.size()]), along = b - a;
      QPointF aside = QPointF(-along.y(), along.x()) / std::hypot(along.x(), along.y());
      for (double t = 0.1; t <= 0.9; t += 0.02) {
        double width = 0.0;
        for (double off = -4.0; off <= 4.0; off += 0.25)
          width += 0.25 * orangeness(image.pixel((a + t * along + off * aside).toPoint()));
        widths.push_back(width);
      }
    }
    std::nth_element(widths.begin(), widths.begin() + std::ptrdiff_t(widths.size() / 2), widths.end());
    return widths[widths.size() / 2];
  }

  static constexpr glm::dvec3 kMiddle{-29, 0, 14};
  static constexpr glm::dvec3 kOnFront{-40, 0, 14}, kOnRight{-29, -13, 14};
  static constexpr glm::dvec3 kOnlyFront{-46, 0, 14}, kOnlyRight{-29, -16, 14};
};

TEST_F(PullFeedback, TheSupportingPlaneHasALineOfTwiceTheWidth) {
  openWedge();
  takeUp();
  for (auto [place, pulled] : {std::pair(kOnFront, 0), {kOnRight, 1}, {kOnFront, 0}}) {
    // The tool keeps to a plane while the pointer stays where both hold a structure: it comes from where one does.
    hover(pixelOf(pulled == 0 ? kOnlyFront : kOnlyRight));
    pull(pixelOf(place), place, cut(pulled), 8.0);
    ASSERT_TRUE(settle());
    EXPECT_GT(session::extrusionOf(cut(pulled), 1), 4.0);
    QImage image = shot();
    double width = outlineWidth(image, cut(pulled)), other = outlineWidth(image, cut(1 - pulled));
    EXPECT_NEAR(width / other, 2.0, 0.5) << width << " and " << other;
  }
  // It follows the pointer, so that one knows before one pulls.
  takeShot(*mWindow, "pull-double-line");
  document().edit("Put back", [](scene::Scene& s) { session::resetExtrusions(s); });
  ASSERT_TRUE(settle());
  hover(pixelOf(kOnRight));
  QImage image = shot();
  EXPECT_GT(outlineWidth(image, cut(1)), 1.5 * outlineWidth(image, cut(0)));
}

TEST_F(PullFeedback, PartsOfPlanesThatBoundNothingArePale) {
  openWedge();
  takeUp();
  hover({3, 3});
  ASSERT_TRUE(settle());
  QImage over = shot(), without = bare();
  auto brighter = [&](glm::dvec3 world) {
    QPoint pixel = pixelOf(world);
    return brightness(over.pixel(pixel)) - brightness(without.pixel(pixel));
  };
  // Of the front plane to the left of the other, and of that one behind the front plane.
  for (glm::dvec3 place : {glm::dvec3(20, 0, 52), glm::dvec3(45, 0, -52), glm::dvec3(-29, 40, 50)})
    EXPECT_GT(brighter(place), 20.0) << place.x << " " << place.y << " " << place.z;
  for (glm::dvec3 place : {glm::dvec3(-61, 0, -30), glm::dvec3(-29, -40, -58)})
    EXPECT_NEAR(brighter(place), 0.0, 12.0) << place.x << " " << place.y << " " << place.z;
}

TEST_F(PullFeedback, TheBoxOfTheDataIsDrawnInThinLines) {
  openWedge();
  takeUp();
  hover({3, 3});
  ASSERT_TRUE(settle());
  QImage over = shot(), without = bare();
  for (const auto& edge : session::boxEdges(scene())) {
    int seen = 0, count = 0;
    for (double t = 0.05; t < 0.96; t += 0.05, ++count) {
      QPoint pixel = pixelOf(glm::mix(edge[0], edge[1], t));
      bool isLine = false;
      for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
          isLine |= brightness(over.pixel(pixel + QPoint(x, y))) > brightness(without.pixel(pixel + QPoint(x, y))) + 12;
      seen += isLine;
    }
    EXPECT_GT(seen, 0.8 * count);
  }
}

TEST_F(PullFeedback, WhatBothPlanesHoldIsGreenWhileTheToolIsUp) {
  openWedge();
  document().edit("Pull", [](scene::Scene& s) {
    session::setExtrusion(s.cuts[0], 1, 40.0);
    session::setExtrusion(s.cuts[1], 1, 12.0);
  });
  takeUp();
  hover({3, 3});
  takeShot(*mWindow, "pull-overlap");
  std::vector<Seen> seen = look(5);
  QImage over = shot(), without = bare();
  int shared = 0, alone = 0, green = 0, turnedGreen = 0;
  for (const auto& [pixel, pick] : seen) {
    double deep = depthOf(pick.world);
    if (pick.structure != 1 || deep < 1.0) continue;
    double right = session::depthInCut(cut(1), pick.world);
    QRgb now = over.pixel(pixel), before = without.pixel(pixel);
    // The box's grey edges make it no green.
    bool turned = qGreen(now) - qRed(now) > qGreen(before) - qRed(before) + 25 && qGreen(now) > qRed(now);
    if (right < 9.5) ++shared, green += turned;
    if (right > 14.5) ++alone, turnedGreen += turned;
  }
  ASSERT_GT(shared, 20);
  ASSERT_GT(alone, 20);
  EXPECT_GT(green, 0.75 * shared) << "through its soft rim one sees what lies behind";
  EXPECT_LT(turnedGreen, 0.02 * alone);
}

TEST_F(PullFeedback, BesideThePointerStandsTheNameAndHowFar) {
  openWedge();
  takeUp();
  hover({3, 3});
  EXPECT_EQ(tool()->tag(), "");
  QPoint place = pixelOf(kOnFront);
  QImage before = shot();
  hover(place);
  EXPECT_EQ(tool()->tag(), "upper sphere");
  QImage over = shot();
  // To the lower right of the pointer: white words on a dark ground.
  int dark = 0, white = 0;
  for (int y = 20; y < 36; ++y)
    for (int x = 20; x < 90; ++x) {
      double now = brightness(over.pixel(place + QPoint(x, y)));
      white += now > 200.0;
      dark += now < 0.5 * brightness(before.pixel(place + QPoint(x, y)));
    }
  EXPECT_GT(white, 60);
  EXPECT_GT(dark, 300);
  QTest::mousePress(&viewport(), Qt::LeftButton, {}, place);
  QPoint to = place + pixelOf(kOnFront + glm::dvec3(0, -9, 0)) - pixelOf(kOnFront);
  QMouseEvent move(QEvent::MouseMove, QPointF(to), viewport().mapToGlobal(QPointF(to)), Qt::NoButton, Qt::LeftButton,
                   Qt::NoModifier);
  QApplication::sendEvent(&viewport(), &move);
  QString wanted = QString("upper sphere: %1 mm").arg(session::extrusionOf(cut(0), 1), 0, 'f', 1);
  EXPECT_NEAR(session::extrusionOf(cut(0), 1), 9.0, 0.5);
  EXPECT_EQ(tool()->tag(), wanted);
  takeShot(*mWindow, "pull-tag");
  QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, to);
  ASSERT_TRUE(settle());
  hover(to - QPoint(1, 1));
  EXPECT_EQ(tool()->tag(), wanted) << "and says it again when the pointer comes back";
}

}  // namespace velum::gui
