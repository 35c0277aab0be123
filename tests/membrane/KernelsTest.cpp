#include "membrane/forces/Kernels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "makeVolume.h"
#include "scene/Scene.h"

namespace velum::membrane {
namespace {

using Curve = std::vector<scene::StrengthPoint>;

/// The curve's meaning, read off its definition: the last segment that holds the value.
double lookUp(const Curve& curve, double value) {
  double strength = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    if (value == curve[i].value) strength = curve[i].strength;
    if (i + 1 == curve.size() || value <= curve[i].value || value >= curve[i + 1].value) continue;
    double share = (value - curve[i].value) / (curve[i + 1].value - curve[i].value);
    strength = curve[i].strength * (1.0 - share) + curve[i + 1].strength * share;
  }
  return strength;
}

/// Means over super-voxels of strengths of voxels, the plain way.
template <class StrengthOf>
std::vector<double> meansOf(glm::ivec3 dims, int level, StrengthOf strengthOf) {
  int size = 1 << level;
  glm::ivec3 grid = (dims + size - 1) / size;
  std::vector<double> means;
  for (int kz = 0; kz < grid.z; ++kz)
    for (int ky = 0; ky < grid.y; ++ky)
      for (int kx = 0; kx < grid.x; ++kx) {
        double sum = 0.0;
        int held = 0;
        for (int z = kz * size; z < std::min((kz + 1) * size, dims.z); ++z)
          for (int y = ky * size; y < std::min((ky + 1) * size, dims.y); ++y)
            for (int x = kx * size; x < std::min((kx + 1) * size, dims.x); ++x, ++held)
              sum += strengthOf(glm::ivec3(x, y, z));
        means.push_back(sum / held);
      }
  return means;
}

void expectNear(const KernelGrid& kernels, const std::vector<double>& means, double tolerance) {
  ASSERT_EQ(kernels.strengths.size(), means.size());
  for (std::size_t i = 0; i < means.size(); ++i) ASSERT_NEAR(kernels.strengths[i], means[i], tolerance) << i;
}

scene::Scene sceneOf(Volume volume) {
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(std::move(volume));
  return scene;
}

constexpr glm::ivec3 kOdd(13, 7, 11);
const Curve kCurve{{-40, -300}, {10, 20}, {10, 600}, {55, 1000}, {80, 0}};

TEST(Kernels, EqualAPlainLoopForEveryTypeAndLevel) {
  constexpr SampleType kTypes[] = {SampleType::UInt8,  SampleType::Int8,  SampleType::UInt16,  SampleType::Int16,
                                   SampleType::UInt32, SampleType::Int32, SampleType::Float32, SampleType::Float64};
  for (SampleType type : kTypes) {
    bool isUnsigned = type == SampleType::UInt8 || type == SampleType::UInt16 || type == SampleType::UInt32;
    auto valueOf = [&](glm::ivec3 v) { return std::floor(hashNoise(v) * 120.0) - (isUnsigned ? 0.0 : 50.0); };
    Volume volume = makeVolume(kOdd, type, valueOf, centredFrame(kOdd), 0.5, -3.0);
    Potential potential(sceneOf(volume));
    for (int level : {0, 1, 2, 3, 6}) {
      scene::ForceField field;
      field.byValue = kCurve;
      field.level = level;
      field.threshold = 0.0;
      Progress progress;
      auto strengthOf = [&](glm::ivec3 v) { return lookUp(kCurve, valueAt(volume, v)); };
      // Strengths are floats of up to 1000: 1e-5 of that, and less.
      expectNear(potential.computeKernels(field, progress), meansOf(kOdd, level, strengthOf), 2e-4);
    }
  }
}

TEST(Kernels, AllLevelsFromOnePass) {
  Volume volume = makeVolume({37, 21, 18}, SampleType::Int16, [](glm::ivec3 v) { return hashNoise(v) * 100.0; });
  scene::ForceField field;
  field.byValue = {{0, 0}, {100, 1000}};
  Potential potential(sceneOf(volume));
  Progress progress;
  auto levels = potential.computeLevels(field, 1, 6, progress);
  ASSERT_EQ(levels.size(), 6u);
  for (const KernelGrid& grid : levels)
    expectNear(grid, meansOf(volume.dims, grid.level, [&](glm::ivec3 v) { return 10.0 * valueAt(volume, v); }), 1e-3);
}

TEST(Kernels, TheMeanIsOfStrengthsNotOfValues) {
  // Two values whose mean has a strength that neither has.
  Volume volume = makeVolume({4, 4, 4}, SampleType::UInt8, [](glm::ivec3 v) { return (v.x + v.y + v.z) % 2 * 100; });
  scene::ForceField field;
  field.byValue = {{40, 0}, {50, 1000}, {60, 0}};
  Progress progress;
  KernelGrid kernels = Potential(sceneOf(volume)).computeKernels(field, progress);
  EXPECT_EQ(kernels.count, 0u);
  for (float c : kernels.strengths) EXPECT_EQ(c, 0.0f);
}

TEST(Kernels, StandInTheMiddleOfTheirSuperVoxels) {
  glm::ivec3 dims(8, 8, 8);
  glm::dmat4 frame = centredFrame(dims, {0.5, 2.0, -1.0}, 0.7, {10, -20, 30});
  Volume volume = makeVolume(
      dims, SampleType::UInt8, [](glm::ivec3) { return 1; }, frame);
  scene::ForceField field;
  field.byValue = {{0, 5}, {2, 5}};
  field.level = 2;
  Progress progress;
  KernelGrid kernels = Potential(sceneOf(volume)).computeKernels(field, progress);
  EXPECT_EQ(kernels.count, 8u);
  glm::dvec4 expected = frame * glm::dvec4(1.5, 5.5, 1.5, 1.0);
  EXPECT_LT(glm::length(kernels.worldFromKernel * glm::dvec4(0, 1, 0, 1) - expected), 1e-9);
}

TEST(Kernels, WeakOnesAreLeftOut) {
  Volume volume = makeVolume({4, 2, 2}, SampleType::UInt8, [](glm::ivec3 v) { return v.x < 2 ? 10 : 20; });
  scene::ForceField field;
  field.byValue = {{0, 0}, {100, -100}};
  field.threshold = 15.0;
  Progress progress;
  KernelGrid kernels = Potential(sceneOf(volume)).computeKernels(field, progress);
  EXPECT_EQ(kernels.count, 1u);
  EXPECT_EQ(kernels.strengths[0], 0.0f);
  EXPECT_NEAR(kernels.strengths[1], -20.0f, 1e-4);
}

TEST(Kernels, GradientOfARampHasItsClosedForm) {
  glm::ivec3 dims(9, 8, 7);
  glm::dmat4 frame = centredFrame(dims, {0.5, -1.5, 3.0}, 1.1, {5, 6, 7});
  glm::dvec3 slope(3.0, -4.0, 12.0);  // value per mm in the world: length 13
  auto valueOf = [&](glm::ivec3 v) { return glm::dot(slope, glm::dvec3(frame * glm::dvec4(glm::dvec3(v), 1.0))); };
  Volume volume = makeVolume(dims, SampleType::Float32, valueOf, frame);
  scene::ForceField field;
  field.byGradient = {{0, 0}, {26, 1000}};
  Progress progress;
  auto strengths = Potential(sceneOf(volume)).computeStrengths(field, {{0, 0, 0}, dims}, progress);
  // Voxels are floats of about 100, and their differences as small as 1.5.
  for (float c : strengths) EXPECT_NEAR(c, 500.0, 0.05);
}

TEST(Kernels, GradientsOfOneVoxelAlongAnAxisAreThoseOfTheOthers) {
  Volume volume = makeVolume({6, 1, 5}, SampleType::Int16, [](glm::ivec3 v) { return 3 * v.x + 4 * v.z; });
  scene::ForceField field;
  field.byGradient = {{0, 0}, {10, 10}};
  Progress progress;
  for (float c : Potential(sceneOf(volume)).computeStrengths(field, {{0, 0, 0}, {6, 1, 5}}, progress))
    EXPECT_NEAR(c, 5.0, 1e-4);
}

TEST(Kernels, LabelsOfAnotherGridAreThoseNearestInTheWorld) {
  glm::dmat4 frame = centredFrame(kOdd, {1.0, 1.3, 0.8}, 0.4, {3, 2, 1});
  glm::ivec3 labelDims(7, 9, 6);
  glm::dmat4 labelFrame = centredFrame(labelDims, {2.1, 1.7, 1.4}, -0.3, {3.5, 2, 1});
  auto idOf = [](glm::ivec3 v) { return int(hashNoise(v, 9) * 4.0); };
  scene::Scene scene = sceneOf(makeVolume(
      kOdd, SampleType::UInt8, [](glm::ivec3) { return 0; }, frame));
  scene.labels.data = Shared<LabelVolume>(makeLabels(labelDims, idOf, labelFrame));
  scene::ForceField field;
  field.byLabel = {{1, 700}, {2, -50}, {2, 20}};
  field.level = 1;
  field.threshold = 0.0;
  auto strengthOf = [&](glm::ivec3 v) {
    glm::dvec3 p(glm::inverse(labelFrame) * frame * glm::dvec4(glm::dvec3(v), 1.0));
    glm::ivec3 nearest(glm::floor(p + 0.5));
    bool inside =
        glm::all(glm::greaterThanEqual(nearest, glm::ivec3(0))) && glm::all(glm::lessThan(nearest, labelDims));
    int id = inside ? idOf(nearest) : 0;
    return id == 1 ? 700.0 : id == 2 ? -30.0 : 0.0;
  };
  Progress progress;
  expectNear(Potential(scene).computeKernels(field, progress), meansOf(kOdd, 1, strengthOf), 2e-4);
}

TEST(Kernels, PartsAddUp) {
  scene::Scene scene = sceneOf(makeVolume(kOdd, SampleType::Int16, [](glm::ivec3 v) { return 10 * v.x; }));
  scene.labels.data = Shared<LabelVolume>(makeLabels(kOdd, [](glm::ivec3 v) { return v.z % 3; }));
  scene::ForceField field;
  field.byValue = {{0, 0}, {1000, 1000}};
  field.byGradient = {{0, 0}, {20, 200}};
  field.byLabel = {{0, 3}, {2, -1000}};
  field.level = 0;
  Progress progress;
  auto strengthOf = [](glm::ivec3 v) {
    return 10.0 * v.x + 100.0 + (v.z % 3 == 2 ? -1000.0 : v.z % 3 == 0 ? 3.0 : 0.0);
  };
  expectNear(Potential(scene).computeKernels(field, progress), meansOf(kOdd, 0, strengthOf), 1e-2);
}

TEST(Kernels, LabelsAloneAreEnough) {
  scene::Scene scene;
  scene.labels.data = Shared<LabelVolume>(makeLabels(
      kOdd, [](glm::ivec3 v) { return v.x > 5; }, centredFrame(kOdd)));
  scene::ForceField field;
  field.byValue = {{0, 100}, {1, 100}};
  field.byLabel = {{1, 10}};
  field.level = 0;
  Progress progress;
  KernelGrid kernels = Potential(scene).computeKernels(field, progress);
  EXPECT_EQ(kernels.dims, kOdd);
  EXPECT_EQ(kernels.count, std::size_t(7 * 7 * 11));
  EXPECT_EQ(Potential(scene::Scene()).computeKernels(field, progress).count, 0u);
}

TEST(Kernels, TakeTheCurrentChannelAndTimeStep) {
  Volume volume = makeVolume({4, 4, 4}, SampleType::UInt8, [](glm::ivec3) { return 0; });
  volume.channels = 2;
  volume.timeSteps = 2;
  volume.voxels.resize(timeStepBytes(volume) * 2);
  for (std::size_t i = 0; i < volume.voxels.size(); ++i)
    volume.voxels[i] = std::byte(i % 2 + i / timeStepBytes(volume) * 2);
  scene::Scene scene = sceneOf(volume);
  Potential first(scene);
  scene.volume.timeStep = 1;
  scene.volume.channel = 1;
  EXPECT_FALSE(first.matches(scene));
  scene::ForceField field;
  field.byValue = {{0, 0}, {10, 10}};
  field.level = 2;
  Progress progress;
  EXPECT_NEAR(Potential(scene).computeKernels(field, progress).strengths[0], 3.0, 1e-6);
  EXPECT_TRUE(Potential(scene).matches(scene));
}

TEST(Kernels, WhatIsNotANumberHasNoStrength) {
  Volume volume =
      makeVolume({3, 1, 1}, SampleType::Float32, [](glm::ivec3 v) { return v.x == 1 ? NAN : v.x * INFINITY; });
  scene::ForceField field;
  field.byValue = {{-1, 5}, {1, 5}};
  field.byGradient = {{0, 0}, {1, 100}};
  Progress progress;
  for (float c : Potential(sceneOf(volume)).computeStrengths(field, {{0, 0, 0}, {3, 1, 1}}, progress))
    EXPECT_EQ(c, 0.0f);
}

TEST(Kernels, ProtectedVoxelsOfABoxAreThoseWithAStrength) {
  Volume volume = makeVolume(kOdd, SampleType::Int16, [](glm::ivec3 v) { return hashNoise(v) * 100.0; });
  scene::ForceField field;
  field.byValue = {{0, -1}, {50, -1}, {50, 1}, {100, 1}};
  VoxelBox box{{2, 1, 3}, {9, 6, 10}};
  Progress progress;
  Potential potential(sceneOf(volume));
  ProtectedVoxels voxels = potential.computeProtected(field, box, progress);
  std::size_t at = 0;
  for (int z = 3; z < 10; ++z)
    for (int y = 1; y < 6; ++y)
      for (int x = 2; x < 9; ++x) EXPECT_EQ(voxels.mask[at++] != 0, valueAt(volume, {x, y, z}) >= 50.0);
  EXPECT_THROW(potential.computeProtected(field, {{0, 0, 0}, {14, 1, 1}}, progress), ArgumentError);
}

TEST(Kernels, StopWhenCancelled) {
  Volume volume = makeVolume(kOdd, SampleType::UInt8, [](glm::ivec3) { return 1; });
  Progress progress;
  progress.cancel();
  EXPECT_THROW(Potential(sceneOf(volume)).computeKernels({}, progress), Cancelled);
}

}  // namespace
}  // namespace velum::membrane
