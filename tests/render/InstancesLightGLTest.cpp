// Models in the light: fog, shadows, and dark where they are covered.
#include "InstancesFixture.h"

namespace velum {
namespace {

using scene::Projection;

TEST_F(InstancesGL, InFullFogTheDeepestIsTheBackgroundBehindIt) {
  std::vector<glm::vec3> places{{0, -100, 0}};
  for (int i = -4; i <= 4; ++i) places.emplace_back(10.0f, 100.0f, 10.0f * float(i));
  scene::Scene scene = sceneOfModel(modelOfAtoms(places, kResidue));
  scene.camera.target = {0, 0, 0};
  scene.camera.projection = Projection::Orthographic;
  scene.camera.height = 100;
  lookAlong(scene, {0, -1, 0}, 400);
  scene.background.transparent = false;
  scene.background.top = {1, 0.2f, 0};
  scene.background.bottom = {0, 0.2f, 1};
  glm::ivec2 size(100, 100);
  Image clear = draw(scene, size, kLayers);
  scene.lighting.fog = 1.0;
  Image image = draw(scene, size, kLayers);
  int far = 0, near = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      int instance = int(sampleOf(image, {x, y}, "instance"));
      if (instance < 1) continue;
      glm::vec3 behind = glm::mix(scene.background.top, scene.background.bottom, (float(y) + 0.5f) / 100.0f);
      // Its front is not quite as deep as it reaches.
      glm::vec3 wanted = instance == 1 ? glm::vec3(colorOf(clear, {x, y})) : behind;
      EXPECT_LT(glm::length(glm::vec3(colorOf(image, {x, y})) - wanted), 0.03f) << x << ", " << y;
      ++(instance == 1 ? near : far);
    }
  EXPECT_GT(near, 20);
  EXPECT_GT(far, 200);
}

// Openness and shadows are known at every other pixel: around what is smaller than that nothing may be known.
TEST_F(InstancesGL, WhatStandsAloneInAPixelIsLitAsAnyOther) {
  std::vector<glm::vec3> places;
  for (int i = 0; i < 400; ++i) places.emplace_back(7 * (i % 20) - 66, 0, 7 * (i / 20) - 66);
  scene::Scene scene = sceneOfModel(modelOfAtoms(places, kResidue));
  scene.camera.target = {0, 0, 0};
  scene.camera.projection = Projection::Orthographic;
  scene.camera.height = 150;
  lookAlong(scene, {0, -1, 0}, 400);
  scene.background = {{0, 0, 0}, {0, 0, 0}, false};
  scene.lighting.specular = 0.0;
  scene.lighting.ambient = 0.3, scene.lighting.diffuse = 0.5;
  scene.model.types = {{.type = "root.atom", .color = glm::vec3(0.5f)}};
  for (int rows : {20, 31, 47, 80}) {
    Image image = draw(scene, {rows, rows}, kLayers);
    int shown = 0;
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < rows; ++x) {
        glm::vec3 color(colorOf(image, {x, y}));
        shown += color.r > 0.01f;
        ASSERT_TRUE(color.r <= 0.55f) << rows << " rows: " << x << ", " << y << ": " << color.r;
      }
    EXPECT_GT(shown, 20) << rows;
  }
}

/// Atoms so close on a plane across y that it is nearly flat, in a rectangle of x and z.
void addFloor(std::vector<glm::vec3>& places, float y, glm::vec2 low, glm::vec2 high) {
  for (float x = low.x; x <= high.x; x += 2.0f)
    for (float z = low.y; z <= high.y; z += 2.0f) places.emplace_back(x, y, z);
}

TEST_F(InstancesGL, AShadowFallsAwayFromTheLight) {
  std::vector<glm::vec3> places;
  addFloor(places, 0.0f, {-40, -40}, {40, 40});
  for (int i = 0; i < 27; ++i) places.emplace_back(2 * (i % 3) - 2, -20 + 2 * (i / 3 % 3) - 2, 13 + 2 * (i / 9));
  scene::Scene scene = floorScene(places);
  scene.lighting.occlusion = scene.lighting.specular = 0.0;
  scene.lighting.diffuse = 1.0;
  scene.rayCast.samplesPerPixel = 4;
  glm::ivec2 size(180, 180);
  // What hangs 20 before the floor at x = 0, z = 15 throws its shadow as far to the side.
  struct Case {
    glm::dvec3 key;
    glm::dvec2 shadow;
  };
  for (const Case& c : {Case{{-1, 0, 1}, {20, 15}}, Case{{1, 0, 1}, {-20, 15}}, Case{{0, 1, 1}, {0, -5}}}) {
    scene.lighting.keyDirection = c.key;
    scene.lighting.shadow = 0.0;
    Image plain = draw(scene, size, kLayers);
    scene.lighting.shadow = 1.0;
    Image shadowed = draw(scene, size, kLayers);
    double in = 0, beside = 0;
    int countIn = 0, countBeside = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        glm::dvec3 p(vectorOf(shadowed, {x, y}, "position"));
        double off = glm::distance(glm::dvec2(p.x, p.z), c.shadow);
        if (std::abs(p.y) > 4.0 || glm::length(glm::dvec2(p.x, p.z)) > 35) continue;
        double dark = double(sampleOf(plain, {x, y}, "G") - sampleOf(shadowed, {x, y}, "G"));
        if (off < 2.0) in += dark, ++countIn;
        if (off > 9.0) beside += dark, ++countBeside;
      }
    ASSERT_GT(countIn, 20);
    ASSERT_GT(countBeside, 1000);
    EXPECT_GT(in / countIn, 4.0 * beside / countBeside + 0.05)
        << "light from " << c.key.x << ", " << c.key.y << ": " << in / countIn << " and " << beside / countBeside;
  }
}

TEST_F(InstancesGL, WhatLiesOpenIsDarkWhereItIsCovered) {
  // A block over the middle of a floor: its shade lies around it, not half a pixel to a side.
  std::vector<glm::vec3> places;
  addFloor(places, 0.0f, {-40, -40}, {40, 40});
  for (int i = 0; i < 27; ++i) places.emplace_back(2 * (i % 3) - 2, -8 + 2 * (i / 3 % 3) - 2, 2 * (i / 9) - 2);
  scene::Scene scene = floorScene(places);
  scene.lighting.shadow = scene.lighting.specular = 0.0;
  scene.rayCast.samplesPerPixel = 16;  // places that are looked at are drawn by lot: of four it is a third of a pixel
  glm::ivec2 size(120, 120);
  scene.lighting.occlusion = 0.0;
  Image open = draw(scene, size, kLayers);
  scene.lighting.occlusion = 1.0;
  Image covered = draw(scene, size, kLayers);
  double sum = 0, x = 0, z = 0;
  for (glm::ivec2 pixel(0); pixel.y < size.y; ++pixel.y)
    for (pixel.x = 0; pixel.x < size.x; ++pixel.x) {
      glm::dvec3 p(vectorOf(covered, pixel, "position"));
      double off = glm::length(glm::dvec2(p.x, p.z));
      if (std::abs(p.y) > 4.0 || off > 30.0) continue;
      double dark = double(sampleOf(open, pixel, "G") - sampleOf(covered, pixel, "G"));
      sum += dark, x += dark * p.x, z += dark * p.z;
    }
  ASSERT_GT(sum, 10.0);
  double pixel = scene.camera.height / size.y;
  EXPECT_NEAR(x / sum / pixel, 0.0, 0.2);
  EXPECT_NEAR(z / sum / pixel, 0.0, 0.2);
}

TEST_F(InstancesGL, WhatEarlierPicturesLeftAroundAModelChangesNothing) {
  std::vector<glm::vec3> places;
  addFloor(places, 0.0f, {-20, -20}, {20, 20});
  for (int i = 0; i < 9; ++i) places.emplace_back(4 * (i % 3) - 4, -12, 4 * (i / 3) - 4);
  scene::Scene scene = floorScene(places);
  scene.camera.height = 300;
  scene.rayCast.samplesPerPixel = 2;
  // So near that the model was where there is none afterwards.
  scene::Scene before = scene;
  before.camera.height = 60;
  glm::ivec2 size(120, 120);
  draw(before, size, kLayers);
  Image image = draw(scene, size, kLayers);
  renderer().clear();
  EXPECT_EQ(image.pixels, draw(scene, size, kLayers).pixels);
  EXPECT_GT(shownIn(image).size(), 20u);
}

}  // namespace
}  // namespace velum
