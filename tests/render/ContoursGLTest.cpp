// The lines around what is seen.
#include "FinishFixture.h"

namespace velum {
namespace {

/// Squares that face the eye, one surface, white before white.
class ContoursGL : public FinishFixture {
 protected:
  /// @param squares  their y, and half an edge of each
  static scene::Scene squares(const std::vector<std::pair<float, float>>& squares) {
    Mesh mesh;
    for (auto [y, half] : squares) {
      auto first = std::uint32_t(mesh.positions.size());
      for (auto [x, z] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
        mesh.positions.push_back({half * float(x), y, half * float(z)});
      for (std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
    }
    scene::Scene scene;
    scene::Surface surface;
    surface.data = Shared<Mesh>(std::move(mesh));
    surface.color = glm::vec3(1.0f);
    scene.surfaces = {surface};
    scene.lighting.shaded = false;
    scene.background = ball().background;
    scene.camera.target = {0, 0, 0};
    lookAlong(scene, {0, -1, 0});
    seenFromFront(scene);
    scene.finish.contours = 1.0;
    scene.finish.contourCreases = 0.0;
    return scene;
  }
};

TEST_F(ContoursGL, StrengthIsTheShareOfTheLine) {
  scene::Scene scene = ball();
  scene.finish.contours = 1.0;
  Image full = intensity(scene, {100, 100});
  scene.finish.contours = 0.5;
  Image half = intensity(scene, {100, 100});
  for (std::size_t i = 0; i < full.pixels.size(); ++i)
    EXPECT_NEAR(1.0f - half.pixels[i], 0.5f * (1.0f - full.pixels[i]), 0.012f);
}

TEST_F(ContoursGL, ABallHasOneClosedLineOfTheRightWidth) {
  for (int rows : {200, 400, 800}) {
    scene::Scene scene = ball();
    scene.rayCast.samplesPerPixel = 16;
    scene.finish.contours = 1.0;
    scene.finish.contourWidth = 5.0;
    Image left = intensity(scene, {rows, rows});
    double pixelsPerLength = rows / kHeight, width = 5.0 * rows / 1000.0;
    for (glm::ivec2 way : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1), glm::ivec2(1, 1),
                           glm::ivec2(-1, 1), glm::ivec2(1, -1), glm::ivec2(-1, -1)}) {
      Line line = lineAlong(left, {rows / 2, rows / 2}, way);
      double along = glm::length(glm::dvec2(way));
      EXPECT_EQ(line.runs, 1) << rows << " rows, towards " << way.x << ", " << way.y;
      EXPECT_NEAR(line.ink * along, width, 0.25 * width + 0.35) << rows << " rows, towards " << way.x << ", " << way.y;
      EXPECT_NEAR(line.at * along, kRadius * pixelsPerLength, 1.0 + 0.4 * width) << rows << " rows";
    }
  }
}

TEST_F(ContoursGL, AStraightSurfaceSeenAslantHasNone) {
  for (bool isOrthographic : {true, false}) {
    scene::Scene scene = halves();
    scene.labels = {};
    lookAlong(scene, {0.2, -0.3, 1.0});
    scene.camera.projection = isOrthographic ? scene::Projection::Orthographic : scene::Projection::Perspective;
    scene.camera.eye = scene.camera.target + glm::normalize(glm::dvec3(0.1, -1.0, 0.25)) * 120.0;
    scene.camera.height = 20;
    scene.camera.fieldOfViewDeg = 8;
    scene.finish.contours = 1.0;
    Image left = intensity(scene, {120, 120});
    EXPECT_LT(meanInk(left, {10, 30}, {110, 90}), 0.004) << isOrthographic;
  }
}

TEST_F(ContoursGL, NeighboursHaveOneLineBetweenThem) {
  scene::Scene scene = halves();
  scene.finish.contours = 1.0;
  scene.finish.contourWidth = 10.0;
  Image left = intensity(scene, {200, 200});
  for (int y = 40; y < 160; y += 20) {
    Line line = lineAlong(left, {20, y}, {1, 0});
    EXPECT_EQ(line.runs, 1);
    EXPECT_NEAR(line.ink, 2.0, 0.5);
    EXPECT_NEAR(line.at, 80.0, 3.0);
  }
  scene.finish.contourStructures = 0.0;
  EXPECT_LT(meanInk(intensity(scene, {200, 200}), {20, 20}, {180, 180}), 0.002);
}

TEST_F(ContoursGL, APartOfASurfaceBeforeAnotherPartOfItHasALine) {
  scene::Scene scene = squares({{0.0f, 20.0f}, {-3.0f, 8.0f}});
  scene.finish.contourWidth = 10.0;
  Image left = intensity(scene, {200, 200});
  for (glm::ivec2 way : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
    Line line = lineAlong(left, {100, 100}, way);
    EXPECT_EQ(line.runs, 2) << "at its own edge and at that of the part behind: " << way.x << ", " << way.y;
    EXPECT_NEAR(line.ink, 4.0, 1.0) << way.x << ", " << way.y;
  }
  scene.finish.contourSteps = 0.0;
  EXPECT_LT(meanInk(intensity(scene, {200, 200}), {30, 30}, {170, 170}), 0.002);
}

TEST_F(ContoursGL, WhatIsSmallerThanALineIsNotInkedAroundItself) {
  const std::pair<float, float> wall(0.0f, 20.0f), speck(-3.0f, 0.6f * float(kHeight) / 200.0f);  // over a pixel
  for (bool hasWall : {false, true}) {
    scene::Scene scene = hasWall ? squares({wall, speck}) : squares({speck});
    scene.finish.contourWidth = 30.0;
    EXPECT_LT(meanInk(intensity(scene, {200, 200}), {80, 80}, {120, 120}) * 40 * 40, 3.0)
        << "pixels of ink" << (hasWall ? " before a wall" : "");
  }
}

TEST_F(ContoursGL, AnOutlineHasTheSameLineHoweverSteepTheSurfaceIsThere) {
  // A disc, and a cone over it with its tip towards the eye: whatever the outline, they have the same.
  auto seen = [&](float height) {
    constexpr int kCorners = 90;
    Mesh mesh;
    mesh.positions = {{0, -height, 0}};
    for (int i = 0; i < kCorners; ++i) {
      float turn = 6.2831853f * float(i) / kCorners;
      mesh.positions.push_back({16 * std::cos(turn), 0, 16 * std::sin(turn)});
      mesh.indices.insert(mesh.indices.end(), {0u, std::uint32_t(i + 1), std::uint32_t((i + 1) % kCorners + 1)});
    }
    scene::Scene scene;
    scene::Surface surface;
    surface.data = Shared<Mesh>(mesh);
    surface.color = glm::vec3(1.0f);
    scene.surfaces = {surface};
    scene.lighting.shaded = false;
    scene.background = ball().background;
    scene.camera.target = {0, 0, 0};
    lookAlong(scene, {0, -1, 0});
    seenFromFront(scene);
    scene.finish.contours = 1.0;
    scene.finish.contourWidth = 10.0;
    scene.finish.contourCreases = 0.0;
    return intensity(scene, {200, 200});
  };
  Image flat = seen(0.0f), steep = seen(160.0f);
  int inked = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) {
      // Of the tip there is a line, too.
      if (glm::length(glm::dvec2(x, y) - 99.5) < 45.0) continue;
      inked += sampleOf(flat, {x, y}, "G") < 0.9f;
      EXPECT_NEAR(sampleOf(flat, {x, y}, "G"), sampleOf(steep, {x, y}, "G"), 0.02f) << x << ", " << y;
    }
  EXPECT_GT(inked, 300);
}

TEST_F(ContoursGL, WithoutBackgroundTheyAreAsBeforeWhiteOnceItIsThere) {
  scene::Scene scene = ball();
  glm::ivec2 size(120, 120);
  scene.background.transparent = true;
  Image plain = draw(scene, size);
  scene.finish.contours = 0.8;
  scene.finish.contourWidth = 40.0;
  scene.finish.contourColor = {0.5f, 0.2f, 0.1f};
  Image alone = draw(scene, size);
  scene.background.transparent = false;
  Image white = draw(scene, size);
  int outside = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      glm::vec4 color = colorOf(alone, {x, y});
      glm::vec3 laid = color.a * glm::vec3(color) + (1.0f - color.a);
      // Bytes of three pictures' values: colour, alpha, and what they are laid on.
      EXPECT_LT(glm::length(laid - glm::vec3(colorOf(white, {x, y}))), 1.5f * std::sqrt(3.0f) / 255.0f)
          << x << ", " << y;
      outside += sampleOf(plain, {x, y}, "A") == 0.0f && color.a > 0.4f;
    }
  EXPECT_GT(outside, 300) << "half of the line lies beside the ball";
}

TEST_F(ContoursGL, NoiseMakesNoSpeckle) {
  scene::Scene scene = ball(60.0);
  scene.finish.contours = 1.0;
  Image left = intensity(scene, {160, 160});
  EXPECT_LT(meanInk(left, {55, 55}, {105, 105}), 0.03);
}

}  // namespace
}  // namespace velum
