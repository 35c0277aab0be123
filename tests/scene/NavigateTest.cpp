#include "scene/Navigate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "scene/Scene.h"

namespace velum::scene {
namespace {

constexpr double kTiny = 1e-9;  ///< Rounding of a few double operations on hundreds of millimetres.

Camera someCamera(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-300, 300);
  Camera camera;
  camera.eye = {place(random), place(random), place(random)};
  camera.target = {place(random), place(random), place(random)};
  camera.up = {place(random), place(random), place(random)};
  camera.projection = random() % 2 ? Projection::Perspective : Projection::Orthographic;
  return camera;
}

double distance(const Camera& camera) { return glm::length(camera.eye - camera.target); }

/// Where a world point lies in the picture: fractions of the picture's height from its middle, x right, y down.
glm::dvec2 inPicture(const Camera& camera, glm::dvec3 world) {
  glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
  glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
  glm::dvec3 up = glm::cross(right, forward);
  glm::dvec3 p = world - camera.eye;
  double height = camera.projection == Projection::Orthographic
                      ? camera.height
                      : 2.0 * glm::dot(p, forward) * std::tan(glm::radians(camera.fieldOfViewDeg) * 0.5);
  return {glm::dot(p, right) / height, -glm::dot(p, up) / height};
}

TEST(Navigate, SeenFromASideKeepsPlaceAndDistanceAndStandsUpright) {
  std::mt19937 random(7);
  for (glm::dvec3 side : {glm::dvec3(0, -1, 0), glm::dvec3(1, -1, 0), glm::dvec3(1, 1, -1), glm::dvec3(0, 0, 1)}) {
    Camera before = someCamera(random), after = seenFrom(before, side);
    EXPECT_EQ(after.target, before.target);
    EXPECT_NEAR(distance(after), distance(before), kTiny);
    EXPECT_LT(glm::length(glm::normalize(after.eye - after.target) - glm::normalize(side)), kTiny);
    EXPECT_LT(inPicture(after, after.target + after.up).y, 0.0) << "up is up";
  }
}

TEST(Navigate, TheWayBetweenTwoCamerasBeginsAndEndsWithThemAndGoesRoundTheTarget) {
  std::mt19937 random(8);
  for (int i = 0; i < 50; ++i) {
    Camera from = someCamera(random), to = someCamera(random);
    to.projection = from.projection;
    EXPECT_EQ(between(from, to, 1.0), to);
    EXPECT_LT(glm::length(between(from, to, 0.0).eye - from.eye), 1e-6);
    double least = std::min(distance(from), distance(to)), most = std::max(distance(from), distance(to));
    for (double t : {0.25, 0.5, 0.75}) {
      EXPECT_GE(distance(between(from, to, t)), least - 1e-6);
      EXPECT_LE(distance(between(from, to, t)), most + 1e-6);
    }
  }
  Camera front = seenFrom(Camera(), {0, -1, 0}), back = seenFrom(Camera(), {0, 1, 0});
  EXPECT_NEAR(distance(between(front, back, 0.5)), distance(front), 1e-6) << "not through what is looked at";
}

TEST(Navigate, TheOtherProjectionLeavesTheMiddleAsLargeAsItWas) {
  std::mt19937 random(7);
  for (int i = 0; i < 100; ++i) {
    Camera camera = someCamera(random);
    bool isPerspective = camera.projection == Projection::Perspective;
    Camera other = withProjection(camera, isPerspective ? Projection::Orthographic : Projection::Perspective);
    EXPECT_NE(other.projection, camera.projection);
    glm::dvec3 right = glm::normalize(glm::cross(camera.target - camera.eye, camera.up));
    for (double off : {-20.0, 0.0, 35.0}) {
      glm::dvec3 point = camera.target + off * right;
      EXPECT_LT(glm::length(inPicture(other, point) - inPicture(camera, point)), 1e-9);
    }
    EXPECT_EQ(withProjection(camera, camera.projection), camera);
  }
  Camera inside;
  inside.eye = inside.target;
  inside.projection = Projection::Orthographic;
  EXPECT_TRUE(std::isfinite(withProjection(inside, Projection::Perspective).eye.x));
}

TEST(Navigate, OrbitKeepsDistanceAndTarget) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> drag(-2, 2);
  for (int i = 0; i < 200; ++i) {
    Camera camera = someCamera(random);
    Camera turned = orbit(camera, {drag(random), drag(random)});
    EXPECT_NEAR(distance(turned), distance(camera), 1e-9 * distance(camera));
    EXPECT_EQ(turned.target, camera.target);
    EXPECT_TRUE(std::isfinite(turned.up.x) && glm::length(turned.up) > 0.5);
  }
}

TEST(Navigate, OrbitOfAWholePictureIsHalfATurn) {
  Camera camera;
  Camera turned = orbit(camera, {1.0, 0.0});
  EXPECT_LT(glm::length(turned.eye - (2.0 * camera.target - camera.eye)), 1e-6);
  EXPECT_LT(glm::length(orbit(turned, {1.0, 0.0}).eye - camera.eye), 1e-6);
}

TEST(Navigate, OrbitHasNoPole) {
  Camera camera;
  for (int i = 0; i < 40; ++i) {
    Camera next = orbit(camera, {0.0, 0.05});
    // A twentieth of half a turn moves the eye by that arc, also over the top.
    EXPECT_NEAR(glm::length(next.eye - camera.eye), 2.0 * 500.0 * std::sin(0.05 * M_PI / 2), 1e-6) << i;
    camera = next;
  }
}

TEST(Navigate, ADragUpOrDownKeepsLeftAndRight) {
  std::mt19937 random(5);
  auto rightOf = [](const Camera& c) { return glm::normalize(glm::cross(c.target - c.eye, c.up)); };
  for (int i = 0; i < 50; ++i) {
    Camera camera = someCamera(random);
    for (double drag : {-0.9, -0.6, 0.3, 0.6, 0.9})  // over the pole, too
      EXPECT_LT(glm::length(rightOf(orbit(camera, {0, drag})) - rightOf(camera)), 1e-9) << drag;
  }
}

TEST(Navigate, TheSceneFollowsTheOrbitDrag) {
  Camera camera;
  glm::dvec3 nearPoint = camera.target + 0.1 * (camera.eye - camera.target);
  EXPECT_GT(inPicture(orbit(camera, {0.02, 0}), nearPoint).x, inPicture(camera, nearPoint).x);
  EXPECT_GT(inPicture(orbit(camera, {0, 0.02}), nearPoint).y, inPicture(camera, nearPoint).y);
}

TEST(Navigate, PanMovesTheTargetWithThePixel) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> drag(-0.4, 0.4);
  for (int i = 0; i < 200; ++i) {
    Camera camera = someCamera(random);
    glm::dvec2 by(drag(random), drag(random));
    glm::dvec2 after = inPicture(pan(camera, by), camera.target);
    EXPECT_NEAR(after.x, by.x, 1e-9);
    EXPECT_NEAR(after.y, by.y, 1e-9);
    EXPECT_NEAR(distance(pan(camera, by)), distance(camera), kTiny * 1e3);
  }
}

TEST(Navigate, ZoomScalesDistanceAndHeightAndUndoesItself) {
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    Camera camera = someCamera(random);
    Camera nearer = zoom(camera, 0.5);
    EXPECT_NEAR(distance(nearer), 0.5 * distance(camera), 1e-9 * distance(camera));
    EXPECT_NEAR(nearer.height, 0.5 * camera.height, 1e-9);
    EXPECT_LT(glm::length(zoom(nearer, 2.0).eye - camera.eye), 1e-9 * distance(camera));
  }
}

TEST(Navigate, ZoomNeverReachesTheTarget) {
  Camera camera;
  for (double factor : {0.0, -3.0, 1e-30}) EXPECT_GT(distance(zoom(camera, factor)), 1.0);
  camera.projection = Projection::Orthographic;
  for (int i = 0; i < 200; ++i) camera = zoom(camera, 0.05);
  EXPECT_GT(camera.height, 0.0);
}

TEST(Navigate, RollTurnsThePictureClockwise) {
  Camera camera;
  glm::dvec3 right = camera.target + glm::dvec3(100, 0, 0);  // to the right when seen from the front
  ASSERT_GT(inPicture(camera, right).x, 0.1);
  Camera rolled = roll(camera, M_PI / 2);
  glm::dvec2 at = inPicture(rolled, right);
  EXPECT_NEAR(at.x, 0.0, 1e-9);
  EXPECT_GT(at.y, 0.1) << "what was right is below after a clockwise quarter turn";
  EXPECT_NEAR(distance(rolled), distance(camera), kTiny);
}

TEST(Navigate, ACameraWithoutDirectionStillMoves) {
  Camera camera;
  camera.eye = camera.target;
  camera.up = {0, 0, 0};
  for (const Camera& next : {orbit(camera, {0.1, 0.2}), pan(camera, {0.1, 0.2}), roll(camera, 1.0), zoom(camera, 2.0)})
    EXPECT_TRUE(std::isfinite(next.eye.x) && std::isfinite(next.up.x) && std::isfinite(next.target.z));
}

}  // namespace
}  // namespace velum::scene
