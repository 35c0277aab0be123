// Texels finer than voxels: the spline through them.
#include <gtest/gtest.h>

#include "makeVolume.h"
#include "render/upload/GradientPlanes.h"
#include "render/upload/SmoothTexels.h"

namespace velum::render {
namespace {

template <class ValueOf>
VolumeTexels texelsOf(glm::ivec3 dims, ValueOf valueOf) {
  VolumeTexels texels;
  texels.volume = Shared<Volume>(makeVolume(dims, SampleType::Float32, valueOf));
  texels.dims = dims;
  return texels;
}

TEST(SmoothTexels, MakeACoarseAxisAsFineAsTheFinestOne) {
  auto factors = [](glm::dvec3 spacing) {
    glm::dmat4 m(1.0);
    for (int axis = 0; axis < 3; ++axis) m[axis][axis] = spacing[axis];
    return smoothFactors(makeVolume(
        {8, 8, 8}, SampleType::UInt8, [](glm::ivec3) { return 0.0; }, m));
  };
  EXPECT_EQ(factors({0.8, 0.8, 5.0}), glm::ivec3(1, 1, 6));
  EXPECT_EQ(factors({3.0, 1.0, 1.0}), glm::ivec3(3, 1, 1));
  EXPECT_EQ(factors({1.0, 1.0, 100.0}), glm::ivec3(1, 1, 8));
  EXPECT_EQ(factors({1.0, 1.0, 1.2}), glm::ivec3(2, 2, 2));
}

TEST(SmoothTexels, GoThroughTheVoxels) {
  glm::ivec3 dims(9, 8, 11), finer(3, 1, 5), fine = dims * finer;
  VolumeTexels source = texelsOf(dims, [](glm::ivec3 p) { return 10.0 + hashNoise(p); });
  auto texels = smoothPlanes(source, finer, 0, fine.z);
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) {
        auto at = (std::size_t(z * 5 + 2) * std::size_t(fine.y) + std::size_t(y)) * std::size_t(fine.x) +
                  std::size_t(x * 3 + 1);
        // What lies farther than five voxels away is not asked.
        EXPECT_NEAR(texels[at], valueAt(*source.volume, {x, y, z}), 0.01);
      }
}

TEST(SmoothTexels, FollowAWaveOfSixVoxelsCloserThanLinesDo) {
  glm::ivec3 dims(4, 4, 60), finer(1, 1, 6);
  auto wave = [](double z) { return std::sin(2.0 * 3.14159265 * z / 6.0); };
  VolumeTexels source = texelsOf(dims, [&](glm::ivec3 p) { return wave(p.z); });
  auto texels = smoothPlanes(source, finer, 0, dims.z * finer.z);
  double worst = 0.0, worstOfLines = 0.0;
  for (int z = 60; z < 300; ++z) {
    double place = (z + 0.5) / 6.0 - 0.5, low = std::floor(place), share = place - low;
    worst = std::max(worst, std::abs(texels[std::size_t(z) * 16] - wave(place)));
    double line = wave(low) * (1.0 - share) + wave(low + 1.0) * share;
    worstOfLines = std::max(worstOfLines, std::abs(line - wave(place)));
  }
  EXPECT_LT(worst, 0.02);  // lines: 0.13
  EXPECT_GT(worstOfLines, 0.1);
}

/// Halves of a plane come out as a whole one does; nothing swings over beside an edge.
TEST(SmoothTexels, SlabsAreSeamlessAndEdgesDoNotRing) {
  glm::ivec3 dims(5, 6, 20), finer(2, 2, 2), fine = dims * finer;
  VolumeTexels source = texelsOf(dims, [](glm::ivec3 p) { return p.z < 10 ? -1000.0 : 40.0; });
  auto whole = smoothPlanes(source, finer, 0, fine.z);
  std::vector<float> parts;
  for (int z = 0; z < fine.z; z += 7) {
    auto slab = smoothPlanes(source, finer, z, std::min(fine.z, z + 7));
    parts.insert(parts.end(), slab.begin(), slab.end());
  }
  EXPECT_EQ(whole, parts);
  for (float value : whole) {
    EXPECT_GE(value, -1000.0f);
    EXPECT_LE(value, 40.0f);
  }
}

/// Waves and a little noise on a grid, and their gradients, a vector a voxel.
class Gradients {
 public:
  /// @param voxelOf  from a voxel of this grid to one of the waves
  template <class VoxelOf>
  Gradients(glm::ivec3 dims, glm::dvec3 spacing, const VoxelOf& voxelOf) : mDims(dims) {
    VolumeTexels source;
    auto valueOf = [](glm::ivec3 p) {
      glm::dvec3 q(p);
      return 100.0 * std::sin(0.35 * q.x) * std::cos(0.27 * q.y + 0.4) + 60.0 * std::sin(0.31 * q.z + 0.2 * q.x) +
             3.0 * hashNoise(p);
    };
    source.volume = Shared<Volume>(makeVolume(
        dims, SampleType::Float32, [&](glm::ivec3 p) { return valueOf(voxelOf(p)); }, centredFrame(dims, spacing)));
    source.dims = dims;
    mNumbers = GradientPlanes(source, glm::ivec3(1)).planes(0, dims.z);
  }
  glm::vec3 at(glm::ivec3 v) const {
    auto i =
        3 * ((std::size_t(v.z) * std::size_t(mDims.y) + std::size_t(v.y)) * std::size_t(mDims.x) + std::size_t(v.x));
    return {mNumbers[i], mNumbers[i + 1], mNumbers[i + 2]};
  }
  template <class Visit>
  void each(const Visit& visit) const {
    for (int z = 0; z < mDims.z; ++z)
      for (int y = 0; y < mDims.y; ++y)
        for (int x = 0; x < mDims.x; ++x) visit(glm::ivec3(x, y, z));
  }

 private:
  glm::ivec3 mDims;
  std::vector<float> mNumbers;
};

constexpr float kRounding = 2e-3f;  // sums in another order, of gradients of some tens

TEST(GradientPlanes, OfTurnedAxesAreTheTurnedGradients) {
  // Thick slices along each axis in turn.
  glm::ivec3 dims(13, 17, 9);
  glm::dvec3 spacing(0.8, 1.1, 4.0);
  Gradients plain(dims, spacing, [](glm::ivec3 p) { return p; });
  for (int turn : {1, 2}) {
    auto turned = [&](auto v) { return decltype(v)(v[turn % 3], v[(turn + 1) % 3], v[(turn + 2) % 3]); };
    auto back = [&](glm::ivec3 v) { return glm::ivec3(v[(3 - turn) % 3], v[(4 - turn) % 3], v[(5 - turn) % 3]); };
    Gradients other(turned(dims), turned(spacing), back);
    plain.each([&](glm::ivec3 v) {
      EXPECT_LT(glm::length(other.at(turned(v)) - turned(plain.at(v))), kRounding)
          << turn << ": " << v.x << ", " << v.y << ", " << v.z;
    });
  }
}

TEST(GradientPlanes, OfAMirroredVolumeAreMirroredToItsEdges) {
  glm::ivec3 dims(13, 17, 9);
  glm::dvec3 spacing(0.8, 1.1, 4.0);
  Gradients plain(dims, spacing, [](glm::ivec3 p) { return p; });
  for (int axis = 0; axis < 3; ++axis) {
    auto mirrored = [&](glm::ivec3 v) {
      v[axis] = dims[axis] - 1 - v[axis];
      return v;
    };
    Gradients other(dims, spacing, mirrored);
    plain.each([&](glm::ivec3 v) {
      glm::vec3 wanted = plain.at(v);
      wanted[axis] = -wanted[axis];
      EXPECT_LT(glm::length(other.at(mirrored(v)) - wanted), kRounding)
          << "axis " << axis << ": " << v.x << ", " << v.y << ", " << v.z;
    });
  }
}

}  // namespace
}  // namespace velum::render
