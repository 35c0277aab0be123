// What the layers and picking call the front: where a ray has become half opaque, by a formula.
#include <fmt/format.h>

#include "RenderFixture.h"

namespace velum {
namespace {

constexpr glm::ivec3 kFrontDims(40, 60, 40);
constexpr glm::ivec2 kFrontSize(24, 24);
const double kHalf = std::log(2.0);

class FrontGL : public RenderTest {
 protected:
  /// A block of one value, of `extinction` a millimetre.
  static scene::Scene fog(double extinction, const glm::dmat4& frame = centredFrame(kFrontDims)) {
    scene::Scene scene = sceneOf(makeVolume(
        kFrontDims, SampleType::UInt8, [](glm::ivec3) { return 100.0; }, frame));
    scene.volume.transfer.colors = {{0, {1.0f, 0.5f, 0.25f}}};
    double opacity = 1.0 - std::exp(-extinction);
    scene.volume.transfer.opacities = {{0, opacity}, {200, opacity}};
    scene.rayCast.stepVoxels = kStep;
    scene.camera.target = centreOf(*scene.volume.data);
    scene.camera.height = 30;
    scene.camera.fieldOfViewDeg = 9;
    return scene;
  }
  static constexpr double kStep = 0.1;  ///< voxels
  /// Thin segments are taken together eight at a time, and the middle of what they make stands for all of it.
  static constexpr double kRounding = 0.5 * 8 * kStep + 0.01;

  /// Visits (pixel, its ray, the ray's way through the box) where that is longer than a little.
  template <class Visit>
  static int eachRay(const scene::Scene& scene, Visit visit) {
    int count = 0;
    for (int y = 0; y < kFrontSize.y; ++y)
      for (int x = 0; x < kFrontSize.x; ++x) {
        TestRay ray = rayThrough(scene.camera, kFrontSize, {x + 0.5, y + 0.5});
        glm::dvec2 box = boxInterval(*scene.volume.data, ray);
        if (box.y - box.x < 2.0) continue;
        visit(glm::ivec2(x, y), ray, box);
        ++count;
      }
    return count;
  }
  static double alongRay(const Image& image, glm::ivec2 pixel, const TestRay& ray) {
    return glm::dot(glm::dvec3(vectorOf(image, pixel, "position")) - ray.origin, ray.direction);
  }
};

TEST_F(FrontGL, LiesWhereHalfOfTheLightIsLeft) {
  for (auto projection : {scene::Projection::Orthographic, scene::Projection::Perspective})
    for (double extinction : {0.05, 0.12, 0.6, 4.0})
      for (double turn : {0.0, 0.4}) {
        scene::Scene scene = fog(extinction, centredFrame(kFrontDims, {1, 1, 1}, turn, {12, -7, 30}));
        scene.camera.projection = projection;
        lookAlong(scene, {0.2, -1, 0.3}, 200);
        Image image = draw(scene, kFrontSize, kAllLayers);
        int halves = 0;
        eachRay(scene, [&](glm::ivec2 pixel, const TestRay& ray, glm::dvec2 box) {
          double front = box.x + kHalf / extinction;
          if (front > box.y - 1.0) return;
          ++halves;
          ASSERT_NEAR(alongRay(image, pixel, ray), front, kRounding)
              << fmt::format("{} a mm, pixel {}, {}", extinction, pixel.x, pixel.y);
          if (projection == scene::Projection::Perspective) {
            ASSERT_NEAR(sampleOf(image, pixel, "Z"), front, kRounding);
          }
          render::Pick pick = renderer().pick(pixel);
          ASSERT_TRUE(pick.hit);
          ASSERT_LT(glm::length(pick.world - ray.at(front)), kRounding + 0.01);
        });
        EXPECT_GT(halves, 200) << extinction;
      }
}

TEST_F(FrontGL, OfWhatNeverIsHalfOpaqueIsWhereItBegins) {
  scene::Scene scene = fog(0.005);
  lookAlong(scene, {0, -1, 0}, 200);
  Image image = draw(scene, kFrontSize, kAllLayers);
  int rays = eachRay(scene, [&](glm::ivec2 pixel, const TestRay& ray, glm::dvec2 box) {
    ASSERT_LT(sampleOf(image, pixel, "A"), 0.5f);
    ASSERT_NEAR(alongRay(image, pixel, ray), box.x, 2.0 * kRounding);
  });
  EXPECT_GT(rays, 300);
}

TEST_F(FrontGL, IdAndPlaceAreThoseOfTheStructureThatMakesTheHalf) {
  // Slabs of 5 mm of two structures by turns, one of them a third as opaque.
  const double kSlab = 5.0;
  for (double extinction : {0.07, 0.17, 0.5}) {
    scene::Scene scene = fog(extinction);
    scene.labels.data = Shared<LabelVolume>(makeLabels(
        kFrontDims, [&](glm::ivec3 p) { return p.y / int(kSlab) % 2 == 0 ? 3 : 8; }, centredFrame(kFrontDims)));
    scene::completeStructures(scene.labels);
    scene.labels.structures[0].opacity = 1.0 / 3.0;
    for (double side : {-1.0, 1.0}) {
      scene.camera.projection = scene::Projection::Orthographic;
      lookAlong(scene, {0, side, 0}, 200);
      // The place by a plain loop: the fog is the same all over a picture. Slabs end between two voxels.
      double depth = 0, place = 0;
      int id = 0;
      for (int slab = 0; slab < 12 && depth < kHalf; ++slab) {
        int fromFront = side < 0 ? slab : 11 - slab;
        id = fromFront % 2 == 0 ? 3 : 8;
        double each = extinction * (id == 3 ? 1.0 / 3.0 : 1.0);
        double length = std::min(kSlab, (kHalf - depth) / each);
        depth += each * length;
        place += length;
      }
      double toBorder = std::abs(place / kSlab - std::round(place / kSlab)) * kSlab;
      ASSERT_GT(toBorder, kRounding) << "the test is not about a border";
      Image image = draw(scene, kFrontSize, kAllLayers);
      int rays = eachRay(scene, [&](glm::ivec2 pixel, const TestRay& ray, glm::dvec2 box) {
        ASSERT_EQ(sampleOf(image, pixel, "id"), float(id)) << extinction << " from " << side;
        ASSERT_NEAR(alongRay(image, pixel, ray), box.x + place, kRounding) << extinction << " from " << side;
      });
      EXPECT_GT(rays, 300);
      EXPECT_EQ(renderer().pick(kFrontSize / 2).structure, id);
    }
  }
}

TEST_F(FrontGL, BehindACutItCountsFromTheFace) {
  double extinction = 0.2;
  scene::Scene scene = fog(extinction);
  scene.camera.projection = scene::Projection::Orthographic;
  lookAlong(scene, {0, -1, 0}, 200);
  scene::Cut cut;
  cut.centre = {0, -11, 0};
  cut.axis = {0.2, -1, 0.1};
  scene::addCut(scene, cut);
  Image image = draw(scene, kFrontSize, kAllLayers);
  int rays = eachRay(scene, [&](glm::ivec2 pixel, const TestRay& ray, glm::dvec2) {
    double face = glm::dot(cut.centre - ray.origin, cut.axis) / glm::dot(ray.direction, cut.axis);
    ASSERT_NEAR(alongRay(image, pixel, ray), face + kHalf / extinction, kRounding);
  });
  EXPECT_GT(rays, 300);
}

}  // namespace
}  // namespace velum
