// Sketch to PFTF: what lies under strokes, and the curve that is fitted to it.
#include "session/membrane/Sketch.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>

#include "makeVolume.h"
#include "membrane/forces/Kernels.h"
#include "scene/Scene.h"
#include "session/membrane/MembraneEdit.h"
#include "session/membrane/StrokeSamples.h"

namespace velum::session {
namespace {

constexpr glm::ivec3 kSketchDims(60, 48, 40);
constexpr double kAir = 0, kVessel = 300, kOrgan = 200, kTissue = 100;
const glm::dvec3 kVesselMm(-14, 0, 0), kOrganMm(14, 0, 0);

double noiseAt(glm::ivec3 p) {
  return 20.0 * (hashNoise(p, 1) + hashNoise(p, 2) + hashNoise(p, 3) + hashNoise(p, 4) - 2.0);  // deviation 11.5
}

double cleanAt(glm::ivec3 p) {
  glm::dvec3 mm = glm::dvec3(p) - 0.5 * (glm::dvec3(kSketchDims) - 1.0);
  if (glm::length(glm::dvec2(mm.x, mm.y) - glm::dvec2(kVesselMm)) < 4) return kVessel;
  if (glm::length(mm - kOrganMm) < 10) return kOrgan;
  return mm.y > 16 ? kAir : kTissue;
}

scene::VolumeLayer body() {
  scene::VolumeLayer layer;
  layer.data = Shared<Volume>(makeVolume(
      kSketchDims, SampleType::Int16, [](glm::ivec3 p) { return cleanAt(p) + noiseAt(p); }, centredFrame(kSketchDims)));
  return layer;
}

scene::Stroke strokeAt(glm::dvec3 middle, double radius = 2.6, bool avoid = false) {
  return {{middle - glm::dvec3(0, 0, 8), middle + glm::dvec3(0.5, 0, 0), middle + glm::dvec3(0, 0, 8)}, radius, avoid};
}

scene::ForceField sketched(const scene::VolumeLayer& layer, std::vector<scene::Stroke> strokes) {
  scene::ForceField field;
  setStrokes(field, std::move(strokes), layer, wholeHistogram(layer));
  return field;
}

double strengthOf(const scene::ForceField& field, double value) { return membrane::strengthAt(field.byValue, value); }

/// Share of a material's voxels that a field protects.
double shareProtected(const scene::ForceField& field, const scene::VolumeLayer& layer, double material) {
  double all = 0, kept = 0;
  glm::ivec3 p;
  for (p.z = 0; p.z < kSketchDims.z; ++p.z)
    for (p.y = 0; p.y < kSketchDims.y; ++p.y)
      for (p.x = 0; p.x < kSketchDims.x; ++p.x) {
        if (cleanAt(p) != material) continue;
        ++all;
        if (strengthOf(field, valueAt(*layer.data, p)) > 0) ++kept;
      }
  return kept / all;
}

double toSegment(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b) {
  glm::dvec3 along = b - a;
  double length = glm::length(along);
  if (length == 0) return glm::distance(p, a);
  glm::dvec3 unit = along / length;
  double t = glm::dot(p - a, unit);
  if (t <= 0) return glm::distance(p, a);
  if (t >= length) return glm::distance(p, b);
  return glm::length(glm::cross(p - a, unit));
}

/// A plain loop over all voxels.
Histogram loopHistogram(const scene::VolumeLayer& layer, const std::vector<scene::Stroke>& strokes, bool avoid,
                        const Histogram& like) {
  Histogram out{std::vector<std::uint64_t>(like.counts.size()), like.range};
  const Volume& v = *layer.data;
  glm::ivec3 p;
  for (p.z = 0; p.z < v.dims.z; ++p.z)
    for (p.y = 0; p.y < v.dims.y; ++p.y)
      for (p.x = 0; p.x < v.dims.x; ++p.x) {
        glm::dvec3 world(v.worldFromVoxel * glm::dvec4(p, 1.0));
        bool isUnder = false;
        for (const auto& stroke : strokes)
          for (std::size_t i = 0; stroke.avoid == avoid && i < stroke.path.size(); ++i)
            isUnder = isUnder || toSegment(world, stroke.path[i ? i - 1 : 0], stroke.path[i]) <= stroke.radius;
        double value = valueAt(v, p, layer.channel, layer.timeStep);
        if (!isUnder || !std::isfinite(value)) continue;
        double share = (value - like.range.x) / (like.range.y - like.range.x);
        int bin = std::min(int(share * double(out.counts.size())), int(out.counts.size()) - 1);
        ++out.counts[std::size_t(bin)];
      }
  return out;
}

TEST(Sketch, StrokesHoldTheVoxelsOfAPlainLoop) {
  // An oblique grid with unequal spacing, one axis backwards; strokes that cross each other and leave the volume.
  Volume v = makeVolume(
      {40, 30, 25}, SampleType::UInt8, [](glm::ivec3 p) { return 255.0 * hashNoise(p, 7); },
      centredFrame({40, 30, 25}, {1.1, -0.7, 2.3}, 0.8, {5, -3, 11}));
  scene::VolumeLayer layer;
  layer.data = Shared<Volume>(std::move(v));
  std::vector<scene::Stroke> strokes{{{{-9, -3, 3}, {14, 2, 22}, {13, 2, 21}}, 3.71, false},
                                     {{{5, -3, -20}, {5.5, -2, 90}}, 2.93, false},
                                     {{{4, -2, 12}}, 5.17, true},
                                     {{{1e7, 0, 0}, {1e8, 0, 0}}, 4.0, false}};
  Histogram whole = wholeHistogram(layer);
  for (bool avoid : {false, true}) {
    Histogram found = strokeHistogram(layer, strokes, avoid, whole),
              plain = loopHistogram(layer, strokes, avoid, whole);
    EXPECT_EQ(found.counts, plain.counts);
    double count = 0;
    for (auto n : found.counts) count += double(n);
    EXPECT_GT(count, 200);
  }
}

TEST(Sketch, StrokesAreOfTheChannelAndTheMomentThatShow) {
  constexpr glm::ivec3 dims(16, 14, 12);
  constexpr int kChannels = 2, kMoments = 3;
  auto valueOf = [](glm::ivec3 p, int channel, int moment) {
    return std::floor(255.0 * hashNoise(p, std::uint32_t(1 + channel + kChannels * moment)));
  };
  Volume all = makeVolume(dims, SampleType::UInt8, [](glm::ivec3) { return 0.0; });
  all.channels = kChannels, all.timeSteps = kMoments;
  all.voxels.resize(voxelCount(all) * kChannels * kMoments);
  auto* bytes = reinterpret_cast<std::uint8_t*>(all.voxels.data());
  for (int moment = 0; moment < kMoments; ++moment)
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x)
          for (int channel = 0; channel < kChannels; ++channel)
            *bytes++ = std::uint8_t(valueOf({x, y, z}, channel, moment));
  ASSERT_EQ(valueAt(all, {3, 4, 5}, 1, 2), valueOf({3, 4, 5}, 1, 2));
  scene::VolumeLayer layer;
  layer.data = Shared<Volume>(std::move(all));
  std::vector<scene::Stroke> strokes{{{{2, 7, 6}, {13, 8, 6}}, 3.3, false}};
  for (int moment = 0; moment < kMoments; ++moment)
    for (int channel = 0; channel < kChannels; ++channel) {
      scene::VolumeLayer one;
      one.data = Shared<Volume>(
          makeVolume(dims, SampleType::UInt8, [&](glm::ivec3 p) { return valueOf(p, channel, moment); }));
      layer.channel = channel, layer.timeStep = moment;
      Histogram whole = wholeHistogram(one);
      EXPECT_EQ(strokeHistogram(layer, strokes, false, whole).counts,
                strokeHistogram(one, strokes, false, whole).counts)
          << "channel " << channel << ", moment " << moment;
    }
}

TEST(Sketch, FloatsThatAreNoNumbersDoNotCount) {
  Volume v = makeVolume({20, 20, 20}, SampleType::Float32, [](glm::ivec3 p) {
    return p.x % 3 == 0 ? std::numeric_limits<double>::quiet_NaN() : 0.25 + p.y;
  });
  scene::VolumeLayer layer;
  layer.data = Shared<Volume>(std::move(v));
  std::vector<scene::Stroke> strokes{{{{2, 10, 10}, {17, 10, 10}}, 3.3, false}};
  Histogram whole = wholeHistogram(layer);
  EXPECT_EQ(strokeHistogram(layer, strokes, false, whole).counts, loopHistogram(layer, strokes, false, whole).counts);
}

TEST(Sketch, TheThinnestStrokeTakesTheVoxelsItGoesThrough) {
  scene::VolumeLayer layer = body();
  std::vector<scene::Stroke> strokes{{{kVesselMm}, 0.0, false}};
  Histogram found = strokeHistogram(layer, strokes, false, wholeHistogram(layer));
  double count = 0;
  for (auto n : found.counts) count += double(n);
  EXPECT_GE(count, 1);
  EXPECT_LE(count, 8);
}

TEST(Sketch, AStrokeProtectsItsMaterialAndNoOther) {
  scene::VolumeLayer layer = body();
  scene::ForceField vessel = sketched(layer, {strokeAt(kVesselMm)}), organ = sketched(layer, {strokeAt(kOrganMm)});
  EXPECT_GT(shareProtected(vessel, layer, kVessel), 0.98);
  for (double other : {kAir, kTissue, kOrgan}) EXPECT_LT(shareProtected(vessel, layer, other), 0.01) << other;
  EXPECT_GT(shareProtected(organ, layer, kOrgan), 0.98);
  for (double other : {kAir, kTissue, kVessel}) EXPECT_LT(shareProtected(organ, layer, other), 0.01) << other;
  EXPECT_LE(organ.byValue.size(), 4u) << "one material, one trapezoid";
  EXPECT_EQ(strengthOf(organ, kOrgan), kProtectStrength);
}

TEST(Sketch, ABrushThatSpillsIntoWhatLiesEverywhereKeepsTheRareMaterial) {
  scene::VolumeLayer layer = body();
  // As wide as twice the vessel: three quarters of what is under it are tissue.
  scene::ForceField field = sketched(layer, {strokeAt(kVesselMm, 8.0)});
  EXPECT_GT(shareProtected(field, layer, kVessel), 0.98);
  EXPECT_LT(shareProtected(field, layer, kTissue), 0.02);
}

TEST(Sketch, AnAvoidingStrokeTakesItsMaterialBack) {
  scene::VolumeLayer layer = body();
  std::vector<scene::Stroke> both{strokeAt(kVesselMm), strokeAt(kOrganMm)};
  scene::ForceField field = sketched(layer, both);
  EXPECT_GT(shareProtected(field, layer, kVessel), 0.97);
  EXPECT_GT(shareProtected(field, layer, kOrgan), 0.97);
  both.push_back(strokeAt(kOrganMm + glm::dvec3(2, 1, 0), 3.1, true));
  field = sketched(layer, both);
  EXPECT_GT(shareProtected(field, layer, kVessel), 0.97);
  EXPECT_LT(shareProtected(field, layer, kOrgan), 0.02);
  // Right over the only stroke that keeps it.
  field = sketched(layer, {strokeAt(kOrganMm), strokeAt(kOrganMm, 2.6, true)});
  EXPECT_LT(shareProtected(field, layer, kOrgan), 0.02);
}

TEST(Sketch, AvoidingAloneTakesFromTheCurveBefore) {
  scene::VolumeLayer layer = body();
  Histogram whole = wholeHistogram(layer);
  scene::Membrane before;
  protectValues(before, 150, 400);
  scene::ForceField field = before.field;
  setStrokes(field, {strokeAt(kOrganMm, 2.6, true)}, layer, whole);
  EXPECT_EQ(field.byValueBefore, before.field.byValue);
  EXPECT_LT(shareProtected(field, layer, kOrgan), 0.02);
  EXPECT_GT(shareProtected(field, layer, kVessel), 0.98);
  setStrokes(field, {}, layer, whole);
  EXPECT_EQ(field, before.field) << "with the last stroke the curve comes back";
}

TEST(Sketch, ACurveEditedByHandStaysUntilAStrokeChanges) {
  scene::VolumeLayer layer = body();
  Histogram whole = wholeHistogram(layer);
  scene::ForceField field = sketched(layer, {strokeAt(kOrganMm)});
  auto fitted = field.byValue;
  field.byValue[0].value -= 20;
  scene::ForceField edited = field;
  setStrokes(field, field.strokes, layer, whole);
  EXPECT_EQ(field, edited);
  auto strokes = field.strokes;
  strokes[0].radius = 2.7;
  setStrokes(field, strokes, layer, whole);
  EXPECT_NE(field.byValue, edited.byValue);
  strokes[0].radius = 2.6;
  setStrokes(field, strokes, layer, whole);
  EXPECT_EQ(field.byValue, fitted) << "the fit depends on the strokes alone";
}

TEST(Sketch, CurvesAscendAndEndAtNoForce) {
  scene::VolumeLayer layer = body();
  for (glm::dvec3 place : {kVesselMm, kOrganMm, glm::dvec3(0, 0, 0), glm::dvec3(0, 20, 0)}) {
    scene::ForceField field = sketched(layer, {strokeAt(place)});
    ASSERT_FALSE(field.byValue.empty());
    EXPECT_LE(field.byValue.size(), 8u);
    for (std::size_t i = 1; i < field.byValue.size(); ++i)
      EXPECT_LE(field.byValue[i - 1].value, field.byValue[i].value);
    auto first = field.byValue.front(), last = field.byValue.back();
    EXPECT_TRUE(first.strength == 0 || first.value == layer.data->range.x);
    EXPECT_TRUE(last.strength == 0 || last.value == layer.data->range.y);
  }
}

TEST(Sketch, NothingUnderTheStrokesProtectsNothing) {
  scene::VolumeLayer layer = body();
  EXPECT_TRUE(sketched(layer, {strokeAt({500, 0, 0})}).byValue.empty());
  EXPECT_TRUE(sketched(layer, {{{}, 3.0, false}}).byValue.empty());
  EXPECT_TRUE(sketched({}, {strokeAt(kOrganMm)}).byValue.empty());
}

TEST(Sketch, ASimplerPathStaysWithinItsTolerance) {
  std::vector<glm::dvec3> path;
  for (int i = 0; i <= 200; ++i) path.emplace_back(0.1 * i, std::sin(0.1 * i), 0.02 * hashNoise({i, 0, 0}));
  std::vector<glm::dvec3> simple = simplifiedPath(path, 0.1);
  EXPECT_EQ(simple.front(), path.front());
  EXPECT_EQ(simple.back(), path.back());
  EXPECT_LT(simple.size(), 40u);
  for (glm::dvec3 p : path) {
    double nearest = 1e9;
    for (std::size_t i = 1; i < simple.size(); ++i) nearest = std::min(nearest, toSegment(p, simple[i - 1], simple[i]));
    EXPECT_LE(nearest, 0.1 + 1e-12);
  }
  EXPECT_EQ(simplifiedPath(std::vector<glm::dvec3>{{1, 2, 3}}, 0.1).size(), 1u);
}

TEST(Sketch, CostGoesWithTheStrokeAndNotWithTheVolume) {
  // The same stroke in a volume 27 times as large; ten times leaves room for a busy machine.
  auto seconds = [](int size) {
    scene::VolumeLayer layer;
    layer.data =
        Shared<Volume>(makeVolume(glm::ivec3(size), SampleType::UInt8, [](glm::ivec3 p) { return p.x % 200; }));
    Histogram whole = wholeHistogram(layer);
    std::vector<scene::Stroke> strokes{{{{20, 20, 20}, {40, 30, 40}, {20, 40, 40}}, 4.1, false}};
    double best = 1e9;
    for (int i = 0; i < 5; ++i) {
      auto start = std::chrono::steady_clock::now();
      for (int k = 0; k < 10; ++k) strokeHistogram(layer, strokes, false, whole);
      best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return best;
  };
  EXPECT_LT(seconds(192), 10 * seconds(64));
}

}  // namespace
}  // namespace velum::session
