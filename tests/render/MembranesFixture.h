#pragma once
#include "FrameSetup.h"
#include "RenderFixture.h"
#include "sheetShapes.h"
#include "upload/CutSheets.h"

/// Scenes with a membrane, and the same asked on the processor, by shaders/shared/sheet.h.
namespace velum {

inline constexpr glm::ivec3 kDims(40, 36, 44);
inline constexpr glm::ivec2 kSize(64, 64);
inline constexpr glm::ivec2 kParticles(18, 21);
inline const glm::dvec3 kFrame(34, 38, 22);

inline scene::Cut membraneOf(const scene::SheetShape& shape, glm::dvec3 axis = {0.2, -1, 0.1},
                             glm::dvec3 size = kFrame) {
  scene::Cut cut;
  cut.id = 1;
  cut.shape = scene::CutShape::Membrane;
  cut.membrane.emplace();
  cut.centre = {1, 2, -1};
  cut.axis = axis;
  cut.spinDeg = 12;
  cut.size = size;
  cut.membrane->cloth.particles = kParticles;
  cut.membrane->shape = shape;
  return cut;
}

inline scene::Cut planeOf(const scene::Cut& membrane) {
  scene::Cut plane = membrane;
  plane.shape = scene::CutShape::Plane;
  return plane;
}

class MembranesGL : public RenderTest {
 protected:
  static scene::Scene solidScene(double turnRad = 0.3) {
    scene::Scene scene = sceneOf(makeVolume(
        kDims, SampleType::UInt8, [](glm::ivec3) { return 100.0; }, centredFrame(kDims, {1, 1.1, 0.9}, turnRad)));
    makeSolid(scene);
    lookAlong(scene, {0.35, -1, 0.3}, 100);
    return scene;
  }
  /// Soft material with structure, lit.
  static scene::Scene softScene() {
    scene::Scene scene = sceneOf(makeVolume(
        kDims, SampleType::Int16,
        [](glm::ivec3 p) { return 300 + 250 * std::sin(0.5 * p.x) * std::cos(0.4 * p.y) * std::sin(0.45 * p.z + 1); },
        centredFrame(kDims)));
    scene.volume.transfer.colors = {{0, {0.5f, 0.2f, 0.1f}}, {600, {1, 0.9f, 0.8f}}};
    scene.volume.transfer.opacities = {{200, 0}, {400, 0.3}, {550, 0.9}};
    scene.lighting.shaded = true;
    lookAlong(scene, {0.35, -1, 0.3}, 100);
    return scene;
  }

  /// The cuts of a scene as the processor asks them.
  struct Cuts {
    explicit Cuts(const scene::Scene& scene)
        : sheets(render::makeCpuSheets(scene, {})), data(render::makeCutData(scene, {0, 0, 0}, sheets.plans)) {}
    bool keep(glm::vec3 p) const {
      return std::none_of(data.begin(), data.end(),
                          [&](const auto& cut) { return shared::cutRemoves(cut, p, sheets.view()); });
    }
    /// Millimetres of a stretch of a ray that no cut removes: stretch by stretch between all crossings.
    double keptLength(const TestRay& ray, glm::dvec2 stretch) const {
      glm::vec3 o(ray.origin), d(ray.direction);
      std::vector<double> ends{stretch.x, stretch.y};
      for (const auto& cut : data) {
        if (cut.kind.x == shared::kCutMembrane) {
          float t = float(stretch.x);
          while ((t = shared::membraneCrossing(cut, o, d, t, float(stretch.y), sheets.view()).t) < stretch.y) {
            ends.push_back(t);
            t += 1e-3f;
          }
        } else {
          glm::vec2 inside = shared::cutInterval(cut, o, d);
          ends.push_back(std::clamp(double(inside.x), stretch.x, stretch.y));
          ends.push_back(std::clamp(double(inside.y), stretch.x, stretch.y));
        }
      }
      std::sort(ends.begin(), ends.end());
      double length = 0;
      for (std::size_t i = 1; i < ends.size(); ++i)
        if (keep(glm::vec3(ray.at(0.5 * (ends[i - 1] + ends[i]))))) length += ends[i] - ends[i - 1];
      return length;
    }
    render::CpuSheets sheets;
    std::vector<shared::CutData> data;
  };

  /// A pixel shows something exactly where something is kept, and never at a removed position.
  void expectAgrees(const scene::Scene& scene, const std::string& what) {
    Image image = draw(scene, kSize, kAllLayers);
    Cuts cuts(scene);
    int doubtful = 0, wrong = 0, shown = 0, empty = 0;
    for (int y = 0; y < kSize.y && wrong < 3; ++y)
      for (int x = 0; x < kSize.x && wrong < 3; ++x) {
        // Rays a hundredth of a pixel beside tell where rounding may decide.
        double least = 1e9, most = 0;
        for (int k = 0; k < 5; ++k) {
          glm::dvec2 shift(k == 1 ? 0.01 : k == 2 ? -0.01 : 0.0, k == 3 ? 0.01 : k == 4 ? -0.01 : 0.0);
          TestRay ray = rayThrough(scene.camera, kSize, glm::dvec2(x + 0.5, y + 0.5) + shift);
          glm::dvec2 box = boxInterval(*scene.volume.data, ray);
          double length = box.x < box.y ? cuts.keptLength(ray, box) : 0.0;
          least = std::min(least, length), most = std::max(most, length);
        }
        float alpha = sampleOf(image, {x, y}, "A");
        std::string where = what + ", pixel " + std::to_string(x) + ", " + std::to_string(y) + ", kept " +
                            std::to_string(most) + " mm, alpha " + std::to_string(alpha);
        if (most == 0.0) {
          EXPECT_EQ(alpha, 0.0f) << where << ": shown, but everything is cut away";
          wrong += alpha != 0.0f;
          ++empty;
        } else if (least > 0.05) {
          EXPECT_GT(alpha, 0.9f) << where << ": empty, but something is kept";
          wrong += alpha <= 0.9f;
          ++shown;
        } else {
          ++doubtful;
        }
        if (alpha == 0.0f) continue;
        glm::vec3 p = vectorOf(image, {x, y}, "position");
        for (const auto& cut : cuts.data) {
          float distance = shared::cutDistance(cut, p, cuts.sheets.view());
          EXPECT_GE(distance, -0.02f) << where << ": the position lies in what is removed";
          wrong += distance < -0.02f;
        }
      }
    EXPECT_LT(doubtful, kSize.x * kSize.y / 12) << what << ": the test has decided too little";
    EXPECT_GT(shown, 100) << what;
  }
};

}  // namespace velum
