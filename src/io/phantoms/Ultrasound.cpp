
#include <algorithm>

#include "core/Parallel.h"
#include "io/phantoms/Phantom.h"

namespace velum::io {

using namespace phantom;

namespace {

enum Part : std::uint16_t { kOutside, kMother, kWomb, kPlacenta, kFluid, kCord, kFetus, kBone };

// --- The scene: x along the fetus, y the depth under the probe, z across; mm. ----------------------------------------

const Segment kLimbs[] = {
    // thighs, shins, feet
    {{-30, 12, 9}, {-42, -14, 13}, 9.0f, 7.0f},
    {{-42, -14, 13}, {-18, -19, 11}, 6.2f, 4.6f},
    {{-18, -19, 11}, {-14, -28, 14}, 4.2f, 3.0f},
    {{-30, 12, -9}, {-45, -10, -12}, 9.0f, 7.0f},
    {{-45, -10, -12}, {-24, -22, -8}, 6.2f, 4.6f},
    {{-24, -22, -8}, {-20, -31, -10}, 4.2f, 3.0f},
    // upper arms, forearms, hands
    {{9, 6, 16}, {-6, -10, 22}, 6.5f, 5.2f},
    {{-6, -10, 22}, {13, -20, 17}, 5.0f, 3.8f},
    {{13, -20, 17}, {20, -24, 14}, 3.8f, 4.0f},
    {{9, 6, -16}, {-8, -4, -23}, 6.5f, 5.2f},
    {{-8, -4, -23}, {8, -20, -20}, 5.0f, 3.8f},
    {{8, -20, -20}, {14, -26, -16}, 3.8f, 4.0f}};
const Segment kFace[] = {{{38, -13, 0}, {35.5f, -23, 0}, 4.5f, 2.8f},  // nose
                         {{26, -10, 0}, {24, -18, 0}, 7.5f, 4.6f},     // chin
                         {{30, -14, 0}, {30, -18.5f, 0}, 5.5f, 3.4f},  // lips
                         {{44, -12, 0}, {53, -7, 0}, 7.0f, 8.0f}};     // brow
const Vec kHead(40, 4, 0), kHeadRadii(25, 21, 19);

float flesh(Vec p) {
  float head = ellipsoid(p, kHead, kHeadRadii);
  for (const auto& s : kFace) head = smoothMin(head, distance(s, p), 5.0f);
  for (float side : {-1.0f, 1.0f}) {
    head = smoothMax(head, 4.0f - glm::length(p - Vec(40.5f, -19.5f, side * 8.0f)), 5.0f);  // eyes lie in hollows
    head = smoothMin(head, ellipsoid(p, Vec(39, 5, side * 19), Vec(4, 5, 2.5f)), 2.0f);     // ears
  }
  float body = ellipsoid(p, Vec(2, 13, 0), Vec(22, 18, 18));
  body = smoothMin(body, ellipsoid(p, Vec(-18, 13, 0), Vec(22, 18, 17)), 10.0f);
  body = smoothMin(body, distance({Vec(10, 12, 0), Vec(26, 8, 0), 11, 10}, p), 9.0f);
  body = smoothMin(body, head, 5.0f);
  for (const auto& s : kLimbs) body = smoothMin(body, distance(s, p), 3.5f);
  return body;
}

float bones(Vec p) {
  // The skull is open towards the face.
  float skull = std::abs(ellipsoid(p, kHead, kHeadRadii) + 3.0f) - 1.0f;
  float d = smoothMax(skull, -glm::dot(p - Vec(36, -8, 0), glm::normalize(Vec(0.5f, 0.85f, 0))), 3.0f);
  for (const auto& s : kLimbs)
    d = std::min(d, distance({glm::mix(s.a, s.b, 0.12f), glm::mix(s.a, s.b, 0.88f), 1.6f, 1.6f}, p));
  // Vertebrae as beads along the back, ribs as hoops.
  float along = p.x + 34.0f,
        bead =
            glm::length(Vec(std::fmod(along + 60.0f, 4.6f) - 2.3f, p.y - 26.0f + 0.006f * (p.x + 6) * (p.x + 6), p.z)) -
            1.9f;
  if (p.x > -34.0f && p.x < 24.0f) d = std::min(d, bead);
  float hoop = std::abs(ellipse({p.y, p.z}, {13, 0}, {15.0f, 14.5f})) - 0.7f;
  if (p.x > -12.0f && p.x < 16.0f)
    d = std::min(d, std::max(hoop, std::abs(std::fmod(p.x + 0.25f * p.y + 100.0f, 5.0f) - 2.5f) - 1.0f));
  return d;
}

float cord(Vec p) {
  static const std::vector<Segment> path = [] {
    glm::vec4 points[] = {{-16, -2, 0, 3.4f},   {-10, -22, -2, 3.4f}, {-2, -34, 8, 3.4f}, {-22, -38, 16, 3.4f},
                          {-40, -30, 22, 3.4f}, {-52, -16, 12, 3.4f}, {-62, -4, 2, 3.4f}};
    return tube(points, 5);
  }();
  float d = 1e3f;
  for (const auto& s : path) d = std::min(d, distance(s, p));
  return d + 0.5f * std::sin(0.9f * (p.x + p.y + p.z));  // the twist of its vessels
}

float womb(Vec p) { return ellipsoid(p, Vec(0, 8, 0), Vec(76, 58, 52)) + 3.0f * noise(p / 28.0f, 7); }

struct Tissue {
  Part part;
  float echo;         ///< Mean backscatter, 1 is bright.
  float attenuation;  ///< Per mm, beyond what the gain corrects.
};

Tissue inFetus(Vec p, float depthMm) {
  if (bones(p) < 0.0f) return {kBone, 2.4f, 0.28f};
  float brain = ellipsoid(p, kHead, kHeadRadii) + 4.0f;
  float midline = std::exp(-p.z * p.z * 1.2f);
  if (brain < 0.0f && p.y > -10.0f) return {kFetus, 0.10f + 0.25f * midline, 0.0f};
  float lungs = 0.12f * smoothStep(14.0f, 6.0f, glm::length(p - Vec(3, 12, 0)));
  return {kFetus, 0.42f + lungs + 0.35f * smoothStep(-2.0f, 0.0f, -depthMm), 0.006f};
}

Tissue tissueAt(Vec p) {
  float wall = womb(p);
  if (wall > 0.0f) {
    // Skin, fat and muscle above the womb, in bands that follow it.
    float bands = std::sin(wall * 0.55f + 3.5f * noise(p / 18.0f, 11));
    return {kMother, 0.14f + 0.05f * bands, 0.002f};
  }
  if (wall > -5.0f) return {kWomb, 0.36f, 0.002f};
  float body = glm::length(p - Vec(2, 2, 0)) < 75.0f ? flesh(p) : 1e3f;
  if (body < 0.0f) return inFetus(p, -body);
  if (cord(p) < 0.0f) return {kCord, 0.5f, 0.002f};
  float placenta = smoothMax(wall + 4.0f, glm::length((p - Vec(-84, 4, 0)) * Vec(1, 0.8f, 0.8f)) - 30.0f, 8.0f) +
                   2.0f * noise(p / 9.0f, 13);
  if (placenta < 0.0f) return {kPlacenta, 0.50f + 0.08f * noise(p / 4.0f, 19), 0.0f};
  return {kFluid, 0.012f, -0.004f};  // Clear fluid weakens less than the gain expects: what lies behind is brighter.
}

// --- The probe ------------------------------------------------------------------------------------------------------

/// A convex probe that swings: a beam is (angle across, angle along), a sample is a depth on it.
struct Fan {
  Vec apex{0.0f, -112.0f, 0.0f};
  float near = 32.0f, far = 186.0f;             ///< mm from the apex.
  float halfAcross = 0.60f, halfSwing = 0.44f;  ///< rad
  glm::ivec3 count;                             ///< Beams across, beams along, samples.

  Vec pointOf(float across, float swing, float r) const {
    return apex + r * Vec(std::sin(across), std::cos(across) * std::cos(swing), std::cos(across) * std::sin(swing));
  }
  /// Grid coordinates of a point; outside the fan beyond 0 .. count - 1.
  Vec coordinatesOf(Vec p) const {
    Vec q = p - apex;
    float r = glm::length(q), across = std::asin(q.x / r), swing = std::atan2(q.z, q.y);
    Vec unitCube(0.5f + 0.5f * across / halfAcross, 0.5f + 0.5f * swing / halfSwing, (r - near) / (far - near));
    return unitCube * Vec(count - 1);
  }
  std::size_t index(int a, int s, int k) const {
    return (std::size_t(s) * std::size_t(count.x) + std::size_t(a)) * std::size_t(count.z) + std::size_t(k);
  }
};

/// Fully developed speckle: the length of a sum of random phasors, hence Rayleigh-distributed, mean 1. Its grains are
/// longer in depth than the samples and wider than the beams.
float speckle(Vec grain, std::uint64_t seed) {
  float re = noise(grain, seed), im = noise(grain + 0.5f, seed + 1);
  return 2.9f * std::sqrt(re * re + im * im);
}

/// One beam: walks down, dims what lies behind bone, and compresses the echo to grey.
void scanBeam(const Fan& fan, int a, int s, float* samples) {
  float across = (2.0f * float(a) / float(fan.count.x - 1) - 1.0f) * fan.halfAcross;
  float swing = (2.0f * float(s) / float(fan.count.y - 1) - 1.0f) * fan.halfSwing;
  float step = (fan.far - fan.near) / float(fan.count.z - 1), gain = 1.0f, before = 0.3f;
  // Grains keep their size in millimetres of depth and in radians, whatever the size of the phantom.
  Vec grains(fan.halfAcross * 2.0f * 95.0f, fan.halfSwing * 2.0f * 95.0f, (fan.far - fan.near) / 1.3f);
  for (int k = 0; k < fan.count.z; ++k) {
    float r = fan.near + step * float(k);
    Tissue tissue = tissueAt(fan.pointOf(across, swing, r));
    float edge = 0.9f * std::max(tissue.echo - before, 0.0f);  // mirror-like echo where a beam meets harder tissue
    before = glm::mix(before, tissue.echo, std::min(1.0f, step));
    gain = std::clamp(gain * std::exp(-tissue.attenuation * step), 0.015f, 1.5f);
    Vec grain =
        Vec(float(a) / float(fan.count.x), float(s) / float(fan.count.y), float(k) / float(fan.count.z)) * grains;
    float echo = gain * ((tissue.echo + edge) * speckle(grain, 23)) + 0.006f * speckle(grain * 1.7f, 29);
    constexpr float kRangeDb = 44.0f;
    samples[k] =
        255.0f * std::clamp(1.0f + (8.685890f * std::log(std::max(echo, 1e-6f)) - 9.0f) / kRangeDb, 0.0f, 1.0f);
  }
}

std::vector<float> scan(const Fan& fan, Progress& progress) {
  std::vector<float> samples(std::size_t(fan.count.x) * std::size_t(fan.count.y) * std::size_t(fan.count.z));
  for (int s = 0; s < fan.count.y; ++s) {
    progress.report(0.6 * double(s) / double(fan.count.y), "scanning ultrasound");
    parallelFor(0, fan.count.x, [&](int a) { scanBeam(fan, a, s, samples.data() + fan.index(a, s, 0)); });
  }
  return samples;
}

float sampleFan(const Fan& fan, const std::vector<float>& samples, Vec c) {
  glm::ivec3 i = glm::min(glm::ivec3(c), fan.count - 2);
  Vec t = c - Vec(i);
  auto along = [&](int a, int s) {
    const float* p = samples.data() + fan.index(i.x + a, i.y + s, i.z);
    return glm::mix(p[0], p[1], t.z);
  };
  return glm::mix(glm::mix(along(0, 0), along(1, 0), t.x), glm::mix(along(0, 1), along(1, 1), t.x), t.y);
}

std::vector<LabelInfo> table() {
  return {{kMother, "maternal tissue", {0.65f, 0.45f, 0.40f}, 0.1f},
          {kWomb, "uterine wall", {0.75f, 0.40f, 0.42f}, 0.3f},
          {kPlacenta, "placenta", {0.65f, 0.22f, 0.30f}},
          {kFluid, "amniotic fluid", {0.55f, 0.75f, 0.90f}, 0.05f},
          {kCord, "umbilical cord", {0.55f, 0.50f, 0.80f}},
          {kFetus, "fetus", {0.93f, 0.70f, 0.56f}},
          {kBone, "fetal bones", {0.95f, 0.92f, 0.82f}}};
}

}  // namespace

/// A fetus under a swinging convex probe. The echoes are made along the beams and then brought onto the grid, so that
/// speckle widens with depth and shadows run along the beams, as they do in a scanner.
Sample makeUltrasound(int size, Progress& progress) {
  constexpr float kWidthMm = 172.0f;
  Grid grid{{size, std::max(1, size * 9 / 10), std::max(1, size * 3 / 4)}, Vec(kWidthMm / float(size))};
  Fan fan;
  fan.count = glm::max(glm::ivec3(size * 7 / 8, size * 5 / 8, size), 4);
  std::vector<float> samples = scan(fan, progress);
  Description description{"ultrasound", SampleType::UInt8, Modality::Ultrasound, "", table()};
  return fill(description, grid, progress, [&](const Slice& slice) {
    std::size_t i = 0;
    for (int y = 0; y < grid.dims.y; ++y)
      for (int x = 0; x < grid.dims.x; ++x, ++i) {
        Vec p = grid.at(x, y, slice.z), c = fan.coordinatesOf(p);
        if (glm::any(glm::lessThan(c, Vec(0.0f))) || glm::any(glm::greaterThan(c, Vec(fan.count - 1)))) continue;
        slice.values[i] = sampleFan(fan, samples, c);
        slice.labels[i] = tissueAt(p).part;
      }
  });
}

}  // namespace velum::io
