#include <algorithm>

#include "io/phantoms/Phantom.h"

namespace velum::io {

using namespace phantom;

namespace {

enum Part : std::uint16_t { kCover = 1, kFirstFormation = 2, kFormations = 5, kSalt = 7, kFault = 8 };

constexpr float kDepthM = 1536.0f, kWidthM = 3200.0f;
constexpr float kBoundaries[] = {520.0f, 760.0f, 980.0f, 1240.0f};  ///< Between the formations, stratigraphic metres.

/// Ricker's wavelet; `peakM` is the distance from its middle to where it crosses zero, times sqrt 2.
float ricker(float offsetM, float peakM) {
  float a = offsetM * offsetM / (peakM * peakM);
  return (1.0f - 2.0f * a) * std::exp(-a);
}

/// Amplitude against stratigraphic depth: random layers, each interface a wavelet of its reflectivity.
class Trace {
 public:
  explicit Trace(std::uint64_t seed) : mSamples(kCount, 0.0f) {
    Random random(seed);
    for (float at = kFirstM; at < kFirstM + float(kCount);) {
      addInterface(at, 0.34f * random.normal());
      at += random.uniform(14.0f, 46.0f);
    }
    float sign = 1.0f;
    for (float at : kBoundaries) addInterface(at, sign = -sign);
  }
  float at(float depthM) const {
    float x = std::clamp(depthM - kFirstM, 0.0f, float(kCount - 2));
    auto i = std::size_t(x);
    return glm::mix(mSamples[i], mSamples[i + 1], x - float(i));
  }

 private:
  static constexpr float kFirstM = -900.0f;
  static constexpr int kCount = 3600;  // One sample per metre.
  void addInterface(float at, float reflectivity) {
    int middle = int(at - kFirstM);
    for (int i = std::max(0, middle - 90); i < std::min(kCount, middle + 90); ++i)
      mSamples[std::size_t(i)] += reflectivity * ricker(kFirstM + float(i) - at, 17.0f);
  }
  std::vector<float> mSamples;
};

// Positions: x and y as the world's, z is depth below the surface, all in metres.

/// To the salt: a mushroom with a rough skin.
float saltDistance(Vec p) {
  Vec q = p - Vec(-720.0f, 260.0f, 1000.0f);
  float head = ellipsoid(q, Vec(0.0f), Vec(560.0f, 500.0f, 300.0f));
  float stem = glm::length(glm::vec2(q.x, q.y)) - 330.0f - 0.25f * std::max(q.z - 250.0f, 0.0f);
  stem = std::max(stem, -q.z);
  return smoothMin(head, stem, 180.0f) + 34.0f * roughNoise(p / 240.0f, 17);
}

/// Horizontal distance to the fault; positive in the block that has slipped down. It flattens with depth.
float faultDistance(Vec p) {
  float depth = p.z / kDepthM;
  return p.x - 380.0f + 0.22f * p.y - 520.0f * depth - 260.0f * depth * depth + 35.0f * noise(p / 700.0f, 29);
}

/// The surface on which the young, nearly flat beds lie.
float unconformityDepth(Vec p) { return 330.0f + 26.0f * noise(Vec(p.x, p.y, 0.0f) / 800.0f, 41) + 0.015f * p.x; }

/// Depth at which a point's bed was laid down: undoes slip, folding, and the salt's push.
float stratigraphicDepth(Vec p) {
  float slip = 105.0f * (0.75f + 0.25f * std::cos(p.y / 900.0f));
  if (faultDistance(p) > 0.0f) p.z -= slip;
  float strength = smoothStep(150.0f, 1100.0f, p.z);
  float fold = 95.0f * std::sin((p.x + 0.45f * p.y) / 330.0f + 0.6f) + 60.0f * noise(Vec(p.x, p.y, 0.0f) / 620.0f, 43);
  glm::vec2 fromSalt = (glm::vec2(p) - glm::vec2(-720.0f, 260.0f)) / 760.0f;
  float push = 330.0f * std::exp(-glm::dot(fromSalt, fromSalt)) * smoothStep(100.0f, 1000.0f, p.z);
  return p.z + fold * (0.35f + 0.65f * strength) + push + 0.13f * p.x - 0.06f * p.y;
}

std::uint16_t formationOf(float depthM) {
  int i = 0;
  while (i < kFormations - 1 && depthM > kBoundaries[i]) ++i;
  return std::uint16_t(kFirstFormation + i);
}

struct Earth {
  Trace young{61}, old{67};
  float faultHalfWidthM;

  void at(Vec p, float& amplitude, std::uint16_t& label) const {
    float salt = saltDistance(p), cover = unconformityDepth(p) - p.z;
    if (cover > 0.0f) {
      amplitude = 0.8f * young.at(p.z + 0.25f * (330.0f - unconformityDepth(p)));
      label = kCover;
    } else {
      float depth = stratigraphicDepth(p), fault = faultDistance(p);
      // Broken rock beside the fault scatters the waves.
      amplitude = old.at(depth) * (0.25f + 0.75f * smoothStep(4.0f, 45.0f, std::abs(fault)));
      label = std::abs(fault) < faultHalfWidthM ? std::uint16_t(kFault) : formationOf(depth);
    }
    float inside = smoothStep(14.0f, -14.0f, salt);
    amplitude = glm::mix(amplitude, 0.16f * roughNoise(p / Vec(70.0f, 70.0f, 26.0f), 71), inside);
    amplitude += 1.5f * ricker(salt, 20.0f) * smoothStep(1500.0f, 900.0f, p.z) - 0.9f * ricker(cover, 17.0f);
    if (salt < 0.0f && cover <= 0.0f) label = kSalt;
  }
};

std::vector<LabelInfo> table() {
  return {{kCover, "young cover", {0.93f, 0.87f, 0.55f}}, {2, "formation A", {0.62f, 0.75f, 0.42f}},
          {3, "formation B", {0.85f, 0.62f, 0.35f}},      {4, "formation C", {0.45f, 0.62f, 0.60f}},
          {5, "formation D", {0.72f, 0.45f, 0.38f}},      {6, "formation E", {0.48f, 0.42f, 0.55f}},
          {kSalt, "salt", {0.90f, 0.65f, 0.78f}},         {kFault, "fault", {0.85f, 0.15f, 0.15f}}};
}

}  // namespace

/// A migrated seismic cube: folded beds under an unconformity, a normal fault, a salt dome. z is up, in millimetres of
/// the earth, as everywhere.
Sample makeSeismic(int size, Progress& progress) {
  float across = kWidthM / float(size);
  int layers = std::max(1, size * 3 / 4);
  Grid grid{{size, size, layers}, Vec(across, across, kDepthM / float(layers)), 1000.0};
  Earth earth;
  earth.faultHalfWidthM = 1.3f * across;
  Description description{"seismic", SampleType::Float32, Modality::Seismic, "", table()};
  return fill(description, grid, progress, [&](const Slice& slice) {
    std::size_t i = 0;
    for (int y = 0; y < grid.dims.y; ++y)
      for (int x = 0; x < grid.dims.x; ++x, ++i) {
        Vec p = grid.at(x, y, slice.z);
        p.z = 0.5f * kDepthM - p.z;
        earth.at(p, slice.values[i], slice.labels[i]);
        float loss = 1.0f - 0.45f * p.z / kDepthM;
        float hum = 0.10f * noise(p / Vec(45.0f, 45.0f, 14.0f), 79);
        slice.values[i] = slice.values[i] * loss + hum + 0.05f * gaussian(hash(83, grid.index(x, y, slice.z)));
      }
  });
}

}  // namespace velum::io
