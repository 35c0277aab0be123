#include "scene/Project.h"

#include <gtest/gtest.h>

#include "scene/Navigate.h"

namespace velum::scene {

namespace {

Camera tiltedCamera(Projection projection) {
  Camera camera;
  camera.projection = projection;
  camera.eye = {120.0, -430.0, 90.0};
  camera.target = {10.0, 20.0, -5.0};
  return roll(camera, 0.3);
}

}  // namespace

TEST(Project, PixelOfAPointOnARayIsTheRaysPixel) {
  glm::dvec2 size(640, 400);
  for (auto projection : {Projection::Perspective, Projection::Orthographic}) {
    Camera camera = tiltedCamera(projection);
    for (glm::dvec2 pixel : {glm::dvec2(0.5, 0.5), glm::dvec2(320, 200), glm::dvec2(600.25, 17.5)}) {
      PictureRay ray = rayFromPixel(camera, size, pixel);
      for (double t : {10.0, 300.0, 5000.0}) {
        auto back = pixelFromWorld(camera, size, ray.origin + ray.direction * t);
        ASSERT_TRUE(back);
        EXPECT_NEAR(back->x, pixel.x, 1e-6);
        EXPECT_NEAR(back->y, pixel.y, 1e-6);
      }
    }
  }
}

TEST(Project, TargetIsInTheMiddle) {
  for (auto projection : {Projection::Perspective, Projection::Orthographic}) {
    Camera camera = tiltedCamera(projection);
    auto pixel = pixelFromWorld(camera, {801, 300}, camera.target);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x, 400.5, 1e-6);
    EXPECT_NEAR(pixel->y, 150.0, 1e-6);
  }
}

TEST(Project, UpIsUpAndLeftOfThePatientIsRightInAnAnteriorView) {
  Camera camera;  // looks from the front
  glm::dvec2 size(100, 100);
  auto above = pixelFromWorld(camera, size, {0, 0, 50}), left = pixelFromWorld(camera, size, {50, 0, 0});
  ASSERT_TRUE(above && left);
  EXPECT_LT(above->y, 50.0);
  EXPECT_GT(left->x, 50.0);
}

TEST(Project, NothingBehindThePerspectiveEye) {
  Camera camera;
  EXPECT_FALSE(pixelFromWorld(camera, {100, 100}, camera.eye * 2.0));
}

TEST(Project, OnePixelAsideIsOnePixel) {
  glm::dvec2 size(640, 400);
  for (auto projection : {Projection::Perspective, Projection::Orthographic}) {
    Camera camera = tiltedCamera(projection);
    glm::dvec3 aside = camera.target + cameraBasis(camera).right * lengthPerPixel(camera, size, camera.target);
    auto pixel = pixelFromWorld(camera, size, aside);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x, 321.0, 1e-6);
  }
}

}  // namespace velum::scene
