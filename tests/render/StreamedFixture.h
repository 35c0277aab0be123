#pragma once
#include <cmath>

#include "PyramidSource.h"
#include "RenderFixture.h"

namespace velum {

inline constexpr glm::ivec3 kStreamedDims{101, 90, 77};

/// Balls, tubes and a noise that is the same everywhere.
inline double fieldAt(glm::ivec3 p) {
  double value = 20.0 + (p.x * 31 + p.y * 17 + p.z * 57 + p.x * p.y) % 9;
  for (glm::dvec3 centre : {glm::dvec3(30, 40, 30), glm::dvec3(70, 50, 45), glm::dvec3(50, 20, 60)})
    value += 90.0 * 0.5 * std::erfc((glm::length(glm::dvec3(p) - centre) - 17.0) / 1.5);
  double tube = std::hypot(p.y - 45.0 - 20.0 * std::sin(p.x / 14.0), p.z - 38.0 - 15.0 * std::cos(p.x / 11.0));
  return value + 100.0 * 0.5 * std::erfc((tube - 3.0) / 1.0);
}

class StreamedGL : public RenderTest {
 protected:
  static std::shared_ptr<PyramidSource> makeSource(SampleType type,
                                                   const glm::dmat4& worldFromVoxel = glm::dmat4(1.0)) {
    return std::make_shared<PyramidSource>(
        makeVolume(
            kStreamedDims, type, [](glm::ivec3 p) { return fieldAt(p); }, worldFromVoxel),
        3, glm::ivec3(24, 40, 16));
  }
  /// @param data  in memory or streamed
  static scene::Scene lookOf(Volume data, scene::RenderMode mode) {
    data.range = {15.0, 260.0};
    scene::Scene scene = sceneOf(std::move(data));
    scene.rayCast.mode = mode;
    scene.rayCast.isoValue = 90.0;
    scene.rayCast.jitter = true;
    scene.volume.transfer.colors = {{40, {0.2f, 0.3f, 0.9f}}, {120, {0.9f, 0.6f, 0.3f}}, {220, {1.0f, 1.0f, 0.9f}}};
    scene.volume.transfer.opacities = {{60, 0}, {80, 0.4}, {130, 0.95}};
    scene.lighting.shaded = true;
    scene.lighting.shadow = scene.lighting.occlusion = 0;
    scene.camera.projection = scene::Projection::Orthographic;
    scene.camera.height = 120.0;
    lookAlong(scene, {0.5, -1.0, 0.4}, 300);
    return scene;
  }
  /// Compares a streamed scene with the same that has a level in memory, seen by the same camera.
  /// @param sparePixels  so many may differ by more than 1: where shares are interpolated rounding decides now and then
  ///                     on which side of a border a sample lies
  void expectSameAs(const Volume& inMemory, const scene::Scene& streamed, glm::ivec2 size, const std::string& what,
                    double least = 0.05, int sparePixels = 0) {
    scene::Scene whole = streamed;
    Volume volume = inMemory;
    volume.range = streamed.volume.data->range;
    whole.volume.data = Shared<Volume>(std::move(volume));
    Image a = draw(streamed, size, kAllLayers), b = draw(whole, size, kAllLayers);
    EXPECT_GT(coverageOf(b), least) << what;
    int apart = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        glm::vec4 p = colorOf(a, {x, y}), q = colorOf(b, {x, y});
        glm::vec4 d = glm::abs(p * glm::vec4(glm::vec3(p.a), 1.0f) - q * glm::vec4(glm::vec3(q.a), 1.0f)) * 255.0f;
        apart += std::max(std::max(d.x, d.y), std::max(d.z, d.w)) > 1.005f;
      }
    Difference found = differenceOf(a, b);
    EXPECT_LE(apart, sparePixels) << what << ", pixel " << found.where.x << ' ' << found.where.y;
    EXPECT_LE(found.largest, sparePixels > 0 ? 12.0 : 1.005) << what;
  }
};

}  // namespace velum
