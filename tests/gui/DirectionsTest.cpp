// Drags, wheels and knobs turn things the way the hand goes: which way, and how far.
#include <numbers>

#include "WindowFixture.h"
#include "scene/Navigate.h"
#include "scene/SectionPlane.h"
#include "session/cut/CutTool.h"
#include "session/section/SectionTool.h"

namespace velum::gui {

using scene::SectionKind;

class Directions : public Window {
 protected:
  static QPoint rounded(glm::dvec2 p) { return {int(std::lround(p.x)), int(std::lround(p.y))}; }
  static glm::dvec2 placeOf(QPoint p) { return {p.x(), p.y()}; }
  glm::dvec2 pixelOf(glm::dvec3 world) { return scene::pixelFromWorld(scene().camera, size(), world).value(); }
  const scene::Camera& camera() { return scene().camera; }
  double distance() { return glm::length(camera().eye - camera().target); }
  glm::dvec3 towardsEye() { return glm::normalize(camera().eye - camera().target); }
  void project(scene::Projection projection) {
    mWindow->document().view([&](scene::Scene& s) { s.camera = scene::withProjection(s.camera, projection); });
  }
  static void wheel(QWidget& view, QPointF place, int notches, Qt::KeyboardModifiers keys = {}) {
    QWheelEvent event(place, view.mapToGlobal(place), {}, QPoint(0, 120 * notches), Qt::NoButton, keys,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &event);
  }
  SectionView& section(SectionKind kind) { return mWindow->views().section(kind); }
  void showSections() {
    mWindow->resize(1100, 700);
    mWindow->views().setLayout(scene::Layout::FourUp);
    QTest::qWait(20);
  }
  static constexpr scene::Projection kProjections[] = {scene::Projection::Perspective, scene::Projection::Orthographic};
  static constexpr SectionKind kKinds[] = {SectionKind::Axial, SectionKind::Coronal, SectionKind::Sagittal};
};

TEST_F(Directions, WhatIsInFrontFollowsAnOrbitAndWhatIsBehindGoesAgainstIt) {
  openPhantom();
  for (auto projection : kProjections)
    for (QPoint way : {QPoint(40, 0), QPoint(-40, 0), QPoint(0, 30), QPoint(0, -30)}) {
      viewport().lookFrom(scene::StandardView::Oblique);
      project(projection);
      scene::Camera start = camera();
      glm::dvec3 back = towardsEye(), front = start.target + 8.0 * back, behind = start.target - 8.0 * back;
      glm::dvec2 before = pixelOf(front), beforeBehind = pixelOf(behind);
      drag({200, 200}, QPoint(200, 200) + way);
      glm::dvec2 hand = glm::normalize(placeOf(way));
      glm::dvec2 moved = pixelOf(front) - before, movedBehind = pixelOf(behind) - beforeBehind;
      EXPECT_GT(glm::dot(moved, hand), 2.5) << way.x() << ", " << way.y();
      EXPECT_LT(std::abs(moved.x * hand.y - moved.y * hand.x), 1.0) << way.x() << ", " << way.y();
      EXPECT_LT(glm::dot(movedBehind, hand), -2.5) << way.x() << ", " << way.y();
      EXPECT_EQ(camera().target, start.target);
      // The whole height is half a turn.
      double angle = std::acos(glm::dot(towardsEye(), back));
      EXPECT_NEAR(angle, std::numbers::pi * glm::length(placeOf(way)) / size().y, 0.01);
    }
}

TEST_F(Directions, ThePictureGoesWithAPan) {
  openPhantom();
  for (auto projection : kProjections)
    for (auto [button, keys] : {std::pair(Qt::MiddleButton, Qt::NoModifier), {Qt::LeftButton, Qt::ShiftModifier}}) {
      viewport().lookFrom(scene::StandardView::Oblique);
      project(projection);
      glm::dvec3 point = camera().target, back = towardsEye();
      drag({200, 200}, {237, 181}, button, keys);
      EXPECT_LT(glm::length(pixelOf(point) - size() * 0.5 - glm::dvec2(37, -19)), 0.5);
      EXPECT_LT(glm::length(towardsEye() - back), 1e-9) << "it turns nothing";
    }
}

TEST_F(Directions, TheWheelForwardAndADragUpwardsComeNearerAndBackGoAway) {
  openPhantom();
  for (auto projection : kProjections) {
    viewport().lookFrom(scene::StandardView::Anterior);
    project(projection);
    auto reach = [&] { return projection == scene::Projection::Perspective ? distance() : camera().height; };
    double start = reach();
    wheel(viewport(), {100, 100}, 1);
    double near = reach();
    EXPECT_LT(near, 0.95 * start);
    wheel(viewport(), {100, 100}, 2);
    EXPECT_LT(reach(), 0.95 * near) << "more is nearer";
    wheel(viewport(), {100, 100}, -3);
    EXPECT_NEAR(reach(), start, 1e-9 * start) << "as much back";
    drag({200, 200}, {200, 170}, Qt::RightButton);
    EXPECT_LT(reach(), 0.95 * start);
    drag({200, 170}, {200, 230}, Qt::RightButton);
    EXPECT_GT(reach(), 1.05 * start);
  }
}

TEST_F(Directions, ARollTurnsThePictureWithTheHand) {
  openPhantom();
  for (auto [from, to] : {std::pair(glm::dvec2(90, 0), glm::dvec2(60, 67)), {{0, -90}, {-60, -67}}}) {
    viewport().lookFrom(scene::StandardView::Oblique);
    glm::dvec2 centre = size() * 0.5;
    // What lies under the hand, in the plane across the line of sight through the target.
    scene::CameraBasis basis = scene::cameraBasis(camera());
    double perPixel = 2.0 * scene::halfPictureHeight(camera()) / size().y * distance();
    glm::dvec3 held = camera().target + perPixel * (from.x * basis.right - from.y * basis.up);
    ASSERT_LT(glm::length(pixelOf(held) - centre - from), 0.1);
    drag(rounded(centre + from), rounded(centre + to), Qt::LeftButton, Qt::ControlModifier);
    EXPECT_LT(glm::length(glm::normalize(pixelOf(held) - centre) - glm::normalize(to)), 0.03);
  }
}

TEST_F(Directions, AKnobOfACutFollowsThePointer) {
  openPhantom();
  using session::CutHandle;
  for (auto handle : {CutHandle::KnobRight, CutHandle::KnobTop, CutHandle::KnobLeft, CutHandle::KnobBottom})
    for (double way : {14.0, 40.0}) {
      viewport().lookFrom(scene::StandardView::Anterior);
      mWindow->document().edit("Add cut", [](scene::Scene& s) {
        s.cuts.clear();
        scene::addCut(s, session::cutFacingCamera(s));
      });
      auto gizmo = [&] { return session::makeCutGizmo(scene(), scene().cuts[0], size()); };
      glm::dvec2 before = pixelOf(handlePlace(gizmo(), handle));
      glm::dvec2 inwards = glm::normalize(pixelOf(gizmo().centre) - before);
      drag(rounded(before), rounded(before + inwards * way));
      EXPECT_EQ(mWindow->document().undoLabel(), "Tilt cut");
      // It goes over the front of a ball, whose near side the eye sees a little larger.
      glm::dvec3 knob = handlePlace(gizmo(), handle);
      glm::dvec2 moved = pixelOf(knob) - before;
      EXPECT_GT(glm::dot(moved, inwards), 0.4 * way) << int(handle);
      EXPECT_LT(glm::dot(moved, inwards), 1.1 * way) << int(handle);
      EXPECT_LT(std::abs(moved.x * inwards.y - moved.y * inwards.x), 2.0) << int(handle);
      EXPECT_GT(glm::dot(knob - gizmo().centre, towardsEye()), 0.0) << int(handle);
    }
}

TEST_F(Directions, TheCrosshairAndThePanOfASectionFollowThePointer) {
  openPhantom();
  showSections();
  for (auto kind : kKinds) {
    SectionView& view = section(kind);
    glm::dvec3 held = scene::worldFromSectionPixel(view.plane(), {60, 60});
    drag(view, {60, 60}, {83, 47}, Qt::MiddleButton);
    EXPECT_LT(glm::length(scene::sectionPixelFromWorld(view.plane(), held) - glm::dvec2(83, 47)), 1e-6) << int(kind);
    drag(view, {83, 47}, {60, 66}, Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_LT(glm::length(scene::sectionPixelFromWorld(view.plane(), held) - glm::dvec2(60, 66)), 1e-6) << int(kind);
    drag(view, {90, 90}, {101, 84});
    glm::dvec2 cross = scene::sectionPixelFromWorld(view.plane(), scene().sections.crosshair);
    EXPECT_LT(glm::length(cross - glm::dvec2(101, 84)), 1e-6) << int(kind);
  }
}

TEST_F(Directions, TheWheelForwardGoesAwayFromWhoeverLooksAtASection) {
  openPhantom();
  showSections();
  // The axial section is seen from the feet, the coronal one from the front, the sagittal one from the left.
  const glm::dvec3 kAway[] = {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};
  for (auto kind : kKinds) {
    SectionView& view = section(kind);
    double step = scene::sectionStep(scene());
    glm::dvec3 before = scene().sections.crosshair;
    wheel(view, {40, 40}, 2);
    EXPECT_NEAR(glm::dot(scene().sections.crosshair - before, kAway[int(kind)]), 2.0 * step, 1e-6) << int(kind);
    wheel(view, {40, 40}, -3);
    EXPECT_NEAR(glm::dot(scene().sections.crosshair - before, kAway[int(kind)]), -step, 1e-6) << int(kind);
    double perPixel = view.plane().lengthPerPixel;
    wheel(view, {40, 40}, 1, Qt::ControlModifier);
    EXPECT_LT(view.plane().lengthPerPixel, 0.95 * perPixel) << "with Ctrl it comes nearer";
    wheel(view, {40, 40}, -2, Qt::ControlModifier);
    EXPECT_GT(view.plane().lengthPerPixel, 1.05 * perPixel);
  }
}

TEST_F(Directions, AKnobOfASectionFollowsThePointer) {
  openPhantom();
  showSections();
  for (auto kind : kKinds)
    for (int line = 0; line < 2; ++line)
      for (int end = 0; end < 2; ++end)
        for (double turn : {0.3, -0.3}) {
          mWindow->document().view(scene::resetSections);
          SectionView& view = section(kind);
          QTest::mouseMove(&view, QPoint(30, 30));
          auto linesOf = [&] { return session::crosshairLines(scene(), kind, view.plane()); };
          auto lines = linesOf();
          ASSERT_TRUE(lines.at(std::size_t(line)).hasKnobs);
          glm::dvec2 cross = scene::sectionPixelFromWorld(view.plane(), scene().sections.crosshair);
          glm::dvec2 knob = lines[std::size_t(line)].knobs[end], arm = knob - cross;
          glm::dvec2 to = cross + glm::dvec2(arm.x * std::cos(turn) - arm.y * std::sin(turn),
                                             arm.x * std::sin(turn) + arm.y * std::cos(turn));
          drag(view, rounded(knob), rounded(to));
          lines = linesOf();
          glm::dvec2 now = lines[std::size_t(line)].to - lines[std::size_t(line)].from, wanted = to - cross;
          double across = (now.x * wanted.y - now.y * wanted.x) / (glm::length(now) * glm::length(wanted));
          EXPECT_NEAR(across, 0.0, 0.03) << int(kind) << " line " << line << " end " << end << " turn " << turn;
        }
}

TEST_F(Directions, ADragToTheRightWidensTheWindowAndADragDownDarkens) {
  openPhantom();
  showSections();
  for (auto kind : kKinds) {
    auto window = [&] { return scene::effectiveWindow(scene().volume); };
    glm::dvec2 before = window();
    drag(section(kind), {60, 60}, {100, 60}, Qt::RightButton);
    EXPECT_GT(window().y, 1.02 * before.y) << "wider";
    EXPECT_NEAR(window().x, before.x, 1e-9 * before.y);
    mWindow->document().undo();
    drag(section(kind), {60, 60}, {60, 100}, Qt::RightButton);
    EXPECT_GT(window().x, before.x + 0.02 * before.y) << "what is black reaches further up";
    mWindow->document().undo();
    EXPECT_EQ(window(), before);
  }
}

}  // namespace velum::gui
