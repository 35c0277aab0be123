#pragma once
#include "RenderFixture.h"

namespace velum {

/// Small scenes to finish, and measures of the lines on them.
class FinishFixture : public RenderTest {
 protected:
  static constexpr glm::ivec3 kDims{48, 48, 48};
  static constexpr double kRadius = 15.0;
  static constexpr double kHeight = 48.0;  ///< of the picture, world

  /// A white ball before white, orthographic from the front.
  static scene::Scene ball(double noise = 0.0) {
    scene::Scene scene = sceneOf(makeVolume(
        kDims, SampleType::Float32,
        [&](glm::ivec3 p) {
          double r = glm::length(glm::dvec3(p) - 0.5 * (glm::dvec3(kDims) - 1.0));
          return 500.0 + 100.0 * (kRadius - r) + noise * (hashNoise(p) - 0.5);
        },
        centredFrame(kDims)));
    scene.volume.transfer.colors = {{0, {1, 1, 1}}};
    scene.volume.transfer.opacities = {{490, 0}, {510, 0.999}};
    scene.volume.transfer.unitDistance = 0.1;
    scene.background.transparent = false;
    scene.background.top = scene.background.bottom = glm::vec3(1.0f);
    seenFromFront(scene);
    return scene;
  }
  /// A block that fills the picture; labels 1 and 2 on its halves.
  static scene::Scene halves() {
    scene::Scene scene = sceneOf(makeVolume(
        kDims, SampleType::UInt8, [](glm::ivec3) { return 100.0; }, centredFrame(kDims)));
    makeSolid(scene, {1, 1, 1});
    scene.labels.data = Shared<LabelVolume>(makeLabels(
        kDims, [](glm::ivec3 p) { return p.x < kDims.x / 2 ? 1 : 2; }, centredFrame(kDims)));
    scene::completeStructures(scene.labels);
    scene.labels.tint = 0.0;
    scene.background.transparent = false;
    seenFromFront(scene);
    scene.camera.height = 40;
    return scene;
  }
  static void seenFromFront(scene::Scene& scene) {
    scene.camera.projection = scene::Projection::Orthographic;
    scene.camera.height = kHeight;
    scene.rayCast.samplesPerPixel = 8;
  }
  /// Everything at once.
  static void finishAll(scene::Scene& scene) {
    scene.finish.contours = 0.8;
    scene.finish.contourWidth = 6.0;
    scene.finish.litSphere = 0.5;
    scene.finish.hatching = 0.7;
    scene.finish.hatchWidth = 60.0;  // of such small pictures
    scene.finish.sphere = "gold";
    scene.finish.paper = scene::Paper::Rough;
  }
  /// What lines leave of the light, by pixel.
  Image intensity(scene::Scene scene, glm::ivec2 size) {
    scene.finish.contourColor = glm::vec3(0.0f);
    Image with = draw(scene, size);
    scene.finish.contours = scene.finish.hatching = 0.0;
    Image without = draw(scene, size);
    for (std::size_t i = 0; i < with.pixels.size(); ++i) with.pixels[i] /= std::max(without.pixels[i], 1e-3f);
    return with;
  }
  /// The ink along a row or column from the middle of a picture outwards, pixels.
  struct Line {
    double ink = 0, at = 0;
    int runs = 0;
  };
  static Line lineAlong(const Image& image, glm::ivec2 from, glm::ivec2 way) {
    Line line;
    bool wasInk = false;
    int step = 0;
    for (glm::ivec2 p = from; p.x >= 0 && p.y >= 0 && p.x < image.width && p.y < image.height; p += way, ++step) {
      double ink = 1.0 - double(sampleOf(image, p, "G"));
      line.ink += ink;
      line.at += ink * step;
      bool isInk = ink > 0.1;
      line.runs += isInk && !wasInk;
      wasInk = isInk;
    }
    line.at /= std::max(line.ink, 1e-9);
    return line;
  }
  static double meanInk(const Image& image, glm::ivec2 from, glm::ivec2 to) {
    double sum = 0;
    for (int y = from.y; y < to.y; ++y)
      for (int x = from.x; x < to.x; ++x) sum += 1.0 - double(sampleOf(image, {x, y}, "G"));
    return sum / ((to.x - from.x) * (to.y - from.y));
  }
};

}  // namespace velum
