#pragma once
#include "CutsFixture.h"
#include "render/FrameSetup.h"
#include "render/upload/CutSheets.h"
#include "sheetShapes.h"

/// Scenes with a membrane, and the same asked on the processor, by shaders/shared/sheet.h.
namespace velum {

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

class MembranesGL : public CutPictures {
 protected:
  static scene::Scene solidScene(double turnRad = 0.3) {
    scene::Scene scene = CutPictures::solidScene(turnRad);
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

  /// How far a position is from what a cut removes, that which is nearest.
  static float distanceTo(const Cuts& cuts, glm::vec3 p) {
    float least = 1e9f;
    for (const auto& cut : cuts.data) least = std::min(least, shared::cutDistance(cut, p, cuts.sheets.view()));
    return least;
  }

  void expectAgrees(const scene::Scene& scene, const std::string& what) {
    Cuts cuts(scene);
    int shown = expectShowsWhatIsKept(
        scene, kSize, [&](const TestRay& ray, glm::dvec2 box) { return cuts.keptLength(ray, box); },
        [&](glm::vec3 p) { return distanceTo(cuts, p); }, 0.02f, what);
    EXPECT_GT(shown, 100) << what;
  }
};

}  // namespace velum
