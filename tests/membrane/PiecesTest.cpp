#include "membrane/forces/Pieces.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>

#include "makeVolume.h"
#include "membrane/forces/CoarseVoxels.h"
#include "membrane/forces/Denoise.h"
#include "membrane/forces/Kernels.h"
#include "scene/Scene.h"

namespace velum::membrane {
namespace {

Progress sProgress;

/// Size of the piece that each voxel is in, by filling from voxel to voxel; 0 where nothing is.
std::vector<int> sizesByFilling(glm::ivec3 dims, const std::vector<std::uint8_t>& mask) {
  std::vector<int> piece(mask.size(), -1), sizes;
  auto at = [&](glm::ivec3 p) { return std::size_t((p.z * dims.y + p.y) * dims.x + p.x); };
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) {
        if (!mask[at({x, y, z})] || piece[at({x, y, z})] >= 0) continue;
        std::vector<glm::ivec3> open{{x, y, z}};
        piece[at(open[0])] = int(sizes.size());
        sizes.push_back(0);
        while (!open.empty()) {
          glm::ivec3 p = open.back();
          open.pop_back();
          ++sizes.back();
          for (int way = 0; way < 6; ++way) {
            glm::ivec3 q = p;
            q[way / 2] += way % 2 ? 1 : -1;
            if (q[way / 2] < 0 || q[way / 2] >= dims[way / 2] || !mask[at(q)] || piece[at(q)] >= 0) continue;
            piece[at(q)] = int(sizes.size()) - 1;
            open.push_back(q);
          }
        }
      }
  std::vector<int> out(mask.size(), 0);
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (mask[i]) out[i] = sizes[std::size_t(piece[i])];
  return out;
}

std::vector<std::uint8_t> randomMask(glm::ivec3 dims, double share, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<std::uint8_t> mask(std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z));
  for (auto& one : mask) one = uniform(random) < share;
  return mask;
}

SmallPieces piecesOf(glm::ivec3 dims, const std::vector<std::uint8_t>& mask, int least) {
  return findSmallPieces(
      dims, least,
      [&](int y, int z, float* out) {
        for (int x = 0; x < dims.x; ++x) out[x] = mask[std::size_t((z * dims.y + y) * dims.x + x)] ? 1.0f : -1.0f;
      },
      sProgress);
}

TEST(Pieces, AreThoseFoundByFilling) {
  const glm::ivec3 kDims[] = {{13, 9, 40}, {1, 7, 33}, {30, 1, 1}, {5, 20, 17}};
  unsigned seed = 0;
  for (glm::ivec3 dims : kDims)
    for (double share : {0.0, 0.05, 0.2, 0.32, 0.6, 1.0})
      for (int least : {2, 3, 7, 40}) {
        auto mask = randomMask(dims, share, ++seed);
        std::vector<int> sizes = sizesByFilling(dims, mask);
        SmallPieces small = piecesOf(dims, mask, least);
        std::vector<std::uint8_t> dropped(mask.size(), 0);
        for (std::size_t row = 0; row < std::size_t(dims.y) * std::size_t(dims.z); ++row)
          for (VoxelRun run : small.runsOf(row))
            for (std::uint32_t x = run.x; x < run.end; ++x) dropped[row * std::size_t(dims.x) + x] = 1;
        std::size_t voxels = 0, all = 0;
        for (std::size_t i = 0; i < mask.size(); ++i) {
          ASSERT_EQ(dropped[i] != 0, sizes[i] > 0 && sizes[i] < least) << share << " " << least << " " << i;
          voxels += dropped[i];
          all += mask[i];
        }
        EXPECT_EQ(small.voxels, voxels);
        EXPECT_EQ(small.protectedVoxels, all);
      }
}

TEST(Pieces, OfWhiteNoiseNextToNothingIsLeft) {
  glm::ivec3 dims(100, 90, 80);
  for (double share : {0.01, 0.03, 0.08}) {
    auto mask = randomMask(dims, share, 5);
    // One structure that is no noise.
    for (int i = 0; i < 4000; ++i) mask[std::size_t((40 * dims.y + i / 80) * dims.x + i % 80)] = 1;
    SmallPieces small = piecesOf(dims, mask, -1);
    EXPECT_GT(small.least, 2);
    EXPECT_LT(small.least, 20);
    double noise = double(small.protectedVoxels) - 4000.0;
    EXPECT_GT(double(small.voxels), 0.95 * noise - 4000.0 * 6.0 * share) << "but for what touches the structure";
    EXPECT_LE(double(small.voxels), noise);
  }
}

TEST(Pieces, WithoutNoiseAllCount) {
  using Counts = std::array<std::size_t, 3>;
  EXPECT_EQ(leastPieceByNoise(Counts{0, 0, 0}, 1000, 1000), 1);
  EXPECT_EQ(leastPieceByNoise(Counts{60, 4, 0}, 100000, 100000), 1) << "few specks";
  EXPECT_EQ(leastPieceByNoise(Counts{400, 20, 1}, 100000, 1000000), 1) << "a small share";
  EXPECT_EQ(leastPieceByNoise(Counts{400, 380, 350}, 100000, 20000), 1) << "as many of two voxels: structures";
  EXPECT_EQ(leastPieceByNoise(Counts{1000, 100, 0}, 100000, 10000), 4) << "a tenth from size to size: 1000, 100, 10, 1";
  EXPECT_EQ(leastPieceByNoise(Counts{1000, 0, 0}, 100000, 10000), 2);
  EXPECT_EQ(leastPieceByNoise(Counts{1000, 100, 0}, 25, 10000), 2) << "a tenth of the largest at most";
}

TEST(Pieces, OfNoStrengthByValueButByAllElse) {
  glm::ivec3 dims(24, 20, 16);
  auto mask = randomMask(dims, 0.15, 9);
  auto isIn = [&](glm::ivec3 p) { return mask[std::size_t((p.z * dims.y + p.y) * dims.x + p.x)] != 0; };
  scene::Scene scene;
  scene.volume.data =
      Shared<Volume>(makeVolume(dims, SampleType::UInt8, [&](glm::ivec3 p) { return isIn(p) ? 200.0 : 10.0; }));
  scene.labels.data = Shared<LabelVolume>(makeLabels(dims, [](glm::ivec3 p) { return p.x < 4; }));
  Potential potential(scene);
  scene::ForceField field;
  field.byValue = {{100, 100}, {255, 100}};
  field.byLabel = {{1, 7}};
  field.leastPiece = 5;
  field.level = 0;
  field.threshold = 0.0;
  std::vector<int> sizes = sizesByFilling(dims, mask);
  VoxelBox box{{2, 3, 4}, {20, 18, 13}};
  auto strengths = potential.computeStrengths(field, box, sProgress);
  auto kernels = potential.computeKernels(field, sProgress).strengths;
  auto protectedHere = potential.computeProtected(field, box, sProgress).mask;
  auto coarse = coarseVoxels(potential, field, 64, sProgress).grid.mask;
  std::size_t i = 0;
  for (int z = box.min.z; z < box.end.z; ++z)
    for (int y = box.min.y; y < box.end.y; ++y)
      for (int x = box.min.x; x < box.end.x; ++x, ++i) {
        auto at = std::size_t((z * dims.y + y) * dims.x + x);
        float expected = (sizes[at] >= 5 ? 100.0f : 0.0f) + (x < 4 ? 7.0f : 0.0f);
        ASSERT_EQ(strengths[i], expected);
        ASSERT_EQ(kernels[at], expected);
        ASSERT_EQ(protectedHere[i] != 0, expected > 0.0f);
        ASSERT_EQ(coarse[at] != 0, expected > 0.0f);
      }
  // Another least size, and back, from what is known.
  auto first = potential.computeLeftOut(field, sProgress);
  field.leastPiece = 1;
  EXPECT_EQ(potential.computeLeftOut(field, sProgress), LeftOut());
  field.leastPiece = 5;
  EXPECT_EQ(potential.computeLeftOut(field, sProgress), first);
  EXPECT_GT(first.pieces, 10u);
}

TEST(Pieces, StopWhenCancelled) {
  glm::ivec3 dims(8);
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume(dims, SampleType::UInt8, [](glm::ivec3) { return 1; }));
  scene::ForceField field;
  field.byValue = {{0, 1}, {2, 1}};
  Potential potential(scene);
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW(potential.computeLeftOut(field, cancelled), Cancelled);
  field.denoise = true;
  EXPECT_THROW(potential.computeLeftOut(field, cancelled), Cancelled);
  EXPECT_EQ(potential.computeLeftOut(field, sProgress).protectedVoxels, 512u) << "and is asked again";
}

double noiseAt(glm::ivec3 p) {  // variance 1
  double sum = 0.0;
  for (int i = 0; i < 12; ++i) sum += hashNoise(p, i);
  return sum - 6.0;
}

TEST(Denoise, NoiseIsWhatItIsAndEdgesDoNotCount) {
  glm::ivec3 dims(40, 40, 40);
  auto step = [](glm::ivec3 p) { return p.x / 20 % 2 ? 1000.0 : 0.0; };
  Volume clean = makeVolume(dims, SampleType::Float32, step);
  Volume noisy = makeVolume(dims, SampleType::Float32, [&](glm::ivec3 p) { return step(p) + 20.0 * noiseAt(p); });
  EXPECT_NEAR(noiseOf(noisy, 0, 0), 20.0, 3.5);
  EXPECT_EQ(noiseOf(makeVolume(dims, SampleType::UInt8, [](glm::ivec3) { return 7; }), 0, 0), 0.0);
  EXPECT_LT(noiseOf(noisy, 0, 0), 0.1 * noiseOf(clean, 0, 0)) << "where all but edges is even, they are all there is";
}

TEST(Denoise, TakesNoiseOutAndLeavesEdges) {
  glm::ivec3 dims(30, 29, 31);
  auto step = [](glm::ivec3 p) { return p.y < 14 ? 1000.0 : 400.0; };
  for (SampleType type : {SampleType::UInt16, SampleType::Float32, SampleType::Int32}) {
    Volume noisy = makeVolume(dims, type, [&](glm::ivec3 p) { return std::round(step(p) + 50.0 * noiseAt(p)); });
    Volume calm = denoise(noisy, 0, 0, 50.0, sProgress);
    EXPECT_EQ(calm.dims, dims);
    double before = 0.0, after = 0.0;
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x) {
          glm::ivec3 p(x, y, z);
          before += std::pow(valueAt(noisy, p) - step(p), 2);
          after += std::pow(valueAt(calm, p) - step(p), 2);
        }
    EXPECT_LT(after, 0.15 * before);
  }
}

TEST(Denoise, LeavesAloneWhatIsNotANumberAndWhatHasNoNoise) {
  glm::ivec3 dims(9, 8, 7);
  auto valueOf = [](glm::ivec3 p) { return p == glm::ivec3(4, 4, 4) ? double(NAN) : 10.0 * p.x + p.y; };
  Volume volume = makeVolume(dims, SampleType::Float32, valueOf);
  Volume calm = denoise(volume, 0, 0, 0.0, sProgress);
  Volume smooth = denoise(volume, 0, 0, 30.0, sProgress);
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) {
        glm::ivec3 p(x, y, z);
        bool isNumber = std::isfinite(valueOf(p));
        EXPECT_EQ(std::isfinite(valueAt(calm, p)), isNumber);
        EXPECT_EQ(std::isfinite(valueAt(smooth, p)), isNumber);
        if (!isNumber) continue;
        EXPECT_NEAR(valueAt(calm, p), valueOf(p), 1e-3);
      }
}

}  // namespace
}  // namespace velum::membrane
