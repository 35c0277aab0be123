#include <algorithm>
#include <array>

#include "io/phantoms/Phantom.h"

namespace velum::io {

using namespace phantom;

namespace {

constexpr float kExtentUm = 450.0f;
constexpr float kSliceStep = 2.0f;  ///< Slices are so much farther apart than voxels of a slice.
const Vec kStretch(1.0f, 1.0f, kSliceStep);
constexpr float kNoise = 150.0f;     ///< Standard deviation, counts.
constexpr float kHaze = 900.0f;      ///< What is there between the fibres, counts.
constexpr float kGlow = 0.6f;        ///< Light out of focus beside a fibre, as a part of the noise.
constexpr float kGlowVoxels = 2.5f;  ///< And how far it goes.
constexpr int kBundles = 7, kInBundle = 22, kAlone = 130;

/// A class of fibres: how much brighter than the haze, in standard deviations of the noise.
struct Kind {
  const char* name;
  float contrast;
  glm::vec3 color;
};
constexpr std::array<Kind, 3> kKinds{{{"faint fibres", 2.0f, {0.45f, 0.60f, 0.90f}},
                                      {"fibres", 3.0f, {0.45f, 0.80f, 0.50f}},
                                      {"bright fibres", 4.0f, {0.98f, 0.80f, 0.30f}}}};

/// Light that the tissue itself scatters: slowly varying, counts.
float haze(Vec p) { return kHaze + 110.0f * roughNoise(p / 70.0f, 41); }

/// Fibres as tubes, by kind: random walks, in bundles and alone. They grow where voxels are cubes, the light of an
/// objective being stretched along its axis as slices are, and are stretched afterwards.
class Tracts {
 public:
  explicit Tracts(float voxelUm) : mVoxel(voxelUm) {
    for (int bundle = 0; bundle < kBundles; ++bundle) {
      Vec heading = mRandom.direction(), middle = somewhere();
      for (int i = 0; i < kInBundle; ++i) {
        Vec aside = 16.0f * Vec(mRandom.normal(), mRandom.normal(), mRandom.normal());
        grow(middle + aside, glm::normalize(heading + 0.12f * mRandom.direction()), 0.035f);
      }
    }
    for (int i = 0; i < kAlone; ++i) grow(somewhere(), mRandom.direction(), 0.10f);
  }

  std::array<std::vector<Segment>, kKinds.size()> tubes;

 private:
  Vec somewhere() {
    float half = 0.5f * kExtentUm;
    float x = mRandom.uniform(-half, half), y = mRandom.uniform(-half, half);
    return {x, y, mRandom.uniform(-half, half) / kSliceStep};
  }

  /// Both ways from a place to the faces of the box.
  void grow(Vec from, Vec heading, float wander) {
    auto kind = std::size_t(mRandom.uniform(0.0f, float(kKinds.size()) - 1e-3f));
    // A tube thinner than one and a half voxels would fall apart between them: it is one to two voxels thick.
    float radius = 0.5f * mVoxel * mRandom.uniform(1.5f, 3.0f);
    run(from, heading, wander, radius, tubes[kind]);
    run(from, -heading, wander, radius, tubes[kind]);
  }

  void run(Vec at, Vec heading, float wander, float radius, std::vector<Segment>& into) {
    constexpr float kStep = 6.0f, kLongest = 2.0f * kExtentUm;
    Vec half(0.5f * kExtentUm, 0.5f * kExtentUm, 0.5f * kExtentUm / kSliceStep);
    for (float length = 0.0f; length < kLongest; length += kStep) {
      if (glm::any(glm::greaterThan(glm::abs(at), half + kStep))) return;
      heading = glm::normalize(heading + wander * mRandom.direction());
      Vec next = at + kStep * heading;
      into.push_back({at * kStretch, next * kStretch, radius, radius});
      at = next;
    }
  }

  Random mRandom{0xf1b7e5};
  float mVoxel;
};

/// @param contrast  of all kinds; 0: each its own
std::vector<Layer> buildScene(float voxelUm, float contrast) {
  Tracts tracts(voxelUm);
  std::vector<Layer> glow, fibres;
  for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
    Layer around{kKeepLabel, kGlow * kNoise};
    for (Segment s : tracts.tubes[kind]) {
      s.radiusA += kGlowVoxels * voxelUm, s.radiusB += kGlowVoxels * voxelUm;
      around.tubes.push_back(s);
    }
    around.edge = 4.0f;
    around.squash = 1.0f / kStretch;
    around.texture = haze;
    glow.push_back(around);
    Layer fibre{std::uint16_t(kind + 1), (contrast > 0.0f ? contrast : kKinds[kind].contrast) * kNoise};
    fibre.tubes = tracts.tubes[kind];
    fibre.squash = 1.0f / kStretch;
    fibre.texture = haze;
    fibre.edge = 0.9f;
    fibres.push_back(fibre);
  }
  glow.insert(glow.end(), fibres.begin(), fibres.end());
  return glow;
}

}  // namespace

/// Axons one to three voxels thick in bundles and alone, two to four times as bright above the haze as its noise, in
/// voxels twice as deep as wide: a light-sheet volume of nerve fibres. Or all of them as bright as is asked.
Sample makeFibres(int size, double contrast, Progress& progress) {
  float voxel = kExtentUm / float(size);
  Grid grid{{size, size, std::max(int(float(size) / kSliceStep), 1)}, voxel * kStretch, 0.001};
  std::vector<Layer> layers = buildScene(voxel, float(contrast));
  Description description{"fibres", SampleType::UInt16, Modality::Microscopy, "", {}};
  for (std::size_t i = 0; i < kKinds.size(); ++i)
    description.table.push_back({std::uint16_t(i + 1), kKinds[i].name, kKinds[i].color});
  return fill(description, grid, progress, [&](const Slice& slice) {
    std::size_t i = 0;
    for (int y = 0; y < grid.dims.y; ++y)
      for (int x = 0; x < grid.dims.x; ++x, ++i) slice.values[i] = haze(grid.at(x, y, slice.z));
    paint(slice, layers);
    std::uint64_t first = grid.index(0, 0, slice.z);
    for (std::size_t v = 0; v < slice.values.size(); ++v) slice.values[v] += kNoise * gaussian(hash(0xaf1b, first + v));
  });
}

}  // namespace velum::io
