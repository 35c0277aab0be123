// By the sided rule sheets are drawn to what attracts, by value, gradient and label; and what is stronger counts more.
#include <algorithm>
#include <random>

#include "GlFixture.h"
#include "io/phantoms/Sample.h"
#include "makeVolume.h"
#include "membrane/forces/Kernels.h"
#include "membrane/sheet/Simulation.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/MembraneEdit.h"
#include "session/membrane/Membranes.h"

namespace velum::session {

namespace {

constexpr int kDrawnSheetSize = 72;

/// A folded surface, in voxels.
double foldAt(double x, double y) { return 42.0 + 4.0 * std::sin(0.12 * x) + 3.0 * std::cos(0.1 * y + 0.05 * x); }

class DrawnSheetGL : public GlTest {
 protected:
  static scene::Scene sceneOf(Volume volume) {
    scene::Scene scene;
    scene.volume.data = Shared<Volume>(std::move(volume));
    scene.cuts = {makeCut(scene, scene::CutShape::Membrane)};
    scene.cuts[0].axis = {0, 0, 1};
    scene.cuts[0].spinDeg = 0.0;
    scene.cuts[0].centre = centreOf(*scene.volume.data);
    scene.cuts[0].size.z = 36;
    return scene;
  }
  /// How far the sheet is from a surface, in voxels: of ten places nine are no farther. Away from the rim, on which it
  /// hangs.
  template <class HeightAt>
  static double farthestOf(const scene::Scene& settled, HeightAt heightAt, double rim = 9.0) {
    const scene::Cut& cut = settled.cuts[0];
    const Volume& volume = *settled.volume.data;
    glm::dmat4 localFromVoxel = glm::inverse(scene::worldFromCut(cut)) * volume.worldFromVoxel;
    membrane::HeightOver height = membrane::heightOf(cut.membrane->shape);
    std::vector<double> off;
    for (double y = rim; y < volume.dims.y - rim; y += 1.0)
      for (double x = rim; x < volume.dims.x - rim; x += 1.0) {
        std::optional<double> z = heightAt(x, y);
        if (!z) continue;
        glm::dvec3 p(localFromVoxel * glm::dvec4(x, y, *z, 1.0));
        off.push_back(std::abs(height(glm::dvec2(p)) - p.z) / glm::length(glm::dvec3(volume.worldFromVoxel[2])));
      }
    EXPECT_GT(off.size(), 300u);
    if (off.empty()) return 1e9;
    std::sort(off.begin(), off.end());
    return off[off.size() * 9 / 10];
  }
  static std::optional<double> fold(double x, double y) { return foldAt(x, y); }
  inline static Progress sProgress;
};

/// Amplitudes about a folded horizon, with noise.
Volume amplitudes() {
  std::mt19937 random(5);
  return makeVolume(
      glm::ivec3(kDrawnSheetSize), SampleType::Int16,
      [&](glm::ivec3 p) {
        double t = (p.z - foldAt(p.x, p.y)) / 2.2, noise = 80.0 * (double(random() % 2000) / 1000.0 - 1.0);
        return 1000.0 * (1.0 - t * t) * std::exp(-0.5 * t * t) + noise;
      },
      glm::dmat4(1.0));
}

TEST_F(DrawnSheetGL, ByValueItLiesOnAHorizonWithinAVoxel) {
  scene::Scene scene = sceneOf(amplitudes());
  settleMembranes(scene, {}, sProgress);
  ASSERT_GT(farthestOf(scene, fold), 5.0) << "without a force it is flat";
  scene.cuts[0].membrane->field.byValue = {{400, 0}, {1000, -100}, {1200, -100}};
  auto report = settleMembranes(scene, {}, sProgress).at(0);
  EXPECT_TRUE(report.atRest);
  EXPECT_LT(farthestOf(scene, fold), 1.0);
}

TEST_F(DrawnSheetGL, ByGradientItLiesOnAnInterfaceWithinAVoxel) {
  auto step = [](glm::ivec3 p) { return 1000.0 / (1.0 + std::exp(1.5 * (p.z - foldAt(p.x, p.y)))); };
  scene::Scene scene = sceneOf(makeVolume(glm::ivec3(kDrawnSheetSize), SampleType::Int16, step, glm::dmat4(1.0)));
  scene.cuts[0].membrane->field.byGradient = {{50, 0}, {400, -100}, {2000, -100}};
  settleMembranes(scene, {}, sProgress);
  EXPECT_LT(farthestOf(scene, fold), 1.0);
}

TEST_F(DrawnSheetGL, ByLabelItLiesInTheMiddleOfAStructureWithinAVoxel) {
  auto bed = [](glm::ivec3 p) { return std::uint16_t(std::abs(p.z - foldAt(p.x, p.y)) < 2.5 ? 4 : 1); };
  scene::Scene scene = sceneOf(amplitudes());
  scene.labels.data = Shared<LabelVolume>(makeLabels(glm::ivec3(kDrawnSheetSize), bed));
  protectStructure(*scene.cuts[0].membrane, 4, -100.0);
  settleMembranes(scene, {}, sProgress);
  EXPECT_LT(farthestOf(scene, fold), 1.0);
  // In a frame whose axes are not the data's, too.
  scene.cuts[0].spinDeg = 30;
  settleMembranes(scene, {}, sProgress);
  EXPECT_LT(farthestOf(scene, fold, 18.0), 1.0);
}

TEST_F(DrawnSheetGL, InASeismicPhantomItLiesOnStrongAmplitudesWithinAVoxel) {
  constexpr double kStrong = -0.35;
  scene::Scene scene = sceneOf(io::makeSample("seismic", 96, sProgress).volume);
  const Volume& volume = *scene.volume.data;
  scene::Cut& cut = scene.cuts[0];
  cut.size.z = 24 * glm::length(glm::dvec3(volume.worldFromVoxel[2]));
  // The share of places with a strong amplitude in the voxel of the sheet or in one over or under it.
  auto shareOn = [&] {
    glm::dmat4 voxelFromLocal = glm::inverse(volume.worldFromVoxel) * scene::worldFromCut(cut);
    membrane::HeightOver height = membrane::heightOf(cut.membrane->shape);
    double on = 0, all = 0;
    for (int i = -20; i <= 20; ++i)
      for (int j = -20; j <= 20; ++j) {
        glm::dvec2 at = 0.02 * glm::dvec2(i, j) * glm::dvec2(cut.size);
        glm::ivec3 voxel(glm::round(glm::dvec3(voxelFromLocal * glm::dvec4(at, height(at), 1.0))));
        double least = 0;
        for (int k = -1; k <= 1; ++k) least = std::min(least, valueAt(volume, voxel + glm::ivec3(0, 0, k)));
        on += least < kStrong;
        all += 1;
      }
    return on / all;
  };
  settleMembranes(scene, {}, sProgress);
  double flat = shareOn();
  cut.membrane->field.byValue = {{-2.0, -100}, {-0.8, -100}, {kStrong, 0}};
  settleMembranes(scene, {}, sProgress);
  double drawn = shareOn();
  std::printf("on strong amplitudes: %.0f %% flat, %.0f %% drawn\n", 100 * flat, 100 * drawn);
  EXPECT_LT(flat, 0.4);
  EXPECT_GT(drawn, 0.8);
}

TEST_F(DrawnSheetGL, WhatDrawsCutsNothingThatIsProtected) {
  scene::Scene scene = sceneOf(io::makeSample("vessels", 72, sProgress).volume);
  protectValues(*scene.cuts[0].membrane, 700, 4000);
  scene.cuts[0].size.z = 20;
  auto before = settleMembranes(scene, {true, false}, sProgress).at(0);
  auto& curve = scene.cuts[0].membrane->field.byValue;
  curve.insert(curve.begin(), {{-500, 0}, {-500, -100}, {300, -100}, {300, 0}});
  auto after = settleMembranes(scene, {true, true}, sProgress).at(0);
  EXPECT_GT(before.kept->cutAreaPlane, 200);
  EXPECT_LE(after.kept->ratio, 1.25 * after.limit->figure.ratio + 0.02);
}

TEST_F(DrawnSheetGL, WhatMustBeCutIsCutWhereItIsWeaker) {
  // Bars through the whole reach, strong before the rest plane and weak behind it, or the other way round.
  for (bool isWeakAbove : {true, false}) {
    auto bars = [&](glm::ivec3 p) {
      bool isBar = p.x % 12 > 3 && p.x % 12 < 8 && p.y % 12 > 3 && p.y % 12 < 8;
      return !isBar ? 0.0 : (isWeakAbove ? p.z > 42 : p.z < 30) ? 500.0 : 1000.0;
    };
    scene::Scene scene = sceneOf(makeVolume(glm::ivec3(kDrawnSheetSize), SampleType::Int16, bars, glm::dmat4(1.0)));
    scene.cuts[0].membrane->field.byValue = {{400, 30}, {700, 30}, {700, 100}, {1200, 100}};
    settleMembranes(scene, {}, sProgress);
    membrane::HeightOver height = membrane::heightOf(scene.cuts[0].membrane->shape);
    // In the middle of a bar near the middle of the data.
    double there = height({41.5 - 35.5, 41.5 - 35.5});
    EXPECT_EQ(there > 0.0, isWeakAbove) << there;
  }
}

}  // namespace
}  // namespace velum::session
