#include "io/phantoms/Brain.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/Error.h"
#include "core/Parallel.h"
#include "io/phantoms/Phantom.h"

namespace velum::io {

using namespace phantom;

namespace {

constexpr Vec kExtent{10.0f, 13.0f, 7.5f};  ///< mm: across, from back to front, upwards
constexpr int kCells = 2400;
constexpr int kBrickSize = 64;
constexpr int kCoarsest = 160;  ///< voxels along the longest axis of the coarsest level, at most
constexpr float kTissue = 420.0f, kCell = 4200.0f, kGround = 90.0f;
constexpr int kIndexCells = 96;  ///< of the index, along the longest axis
constexpr int kLattice = 8;      ///< tissue is computed at one of so many voxels along each axis, else between them

/// Distance to the brain's surface, mm, less than 0 inside: two hemispheres, what joins them, the cerebellum, bulbs.
float outline(Vec p) {
  Vec side(std::abs(p.x), p.y, p.z);
  float d = ellipsoid(side, Vec(2.05f, 0.7f, 0.25f), Vec(2.35f, 4.3f, 2.9f));
  d = smoothMin(d, ellipsoid(p, Vec(0.0f, 0.0f, -0.9f), Vec(2.6f, 4.6f, 1.9f)), 0.5f);
  d = smoothMin(d, ellipsoid(p, Vec(0.0f, -4.4f, 0.2f), Vec(3.1f, 1.6f, 2.1f)), 0.25f);
  return smoothMin(d, ellipsoid(side, Vec(0.75f, 5.3f, 0.2f), Vec(0.7f, 1.0f, 0.75f)), 0.3f);
}

/// One nerve cell: a body, dendrites around it, and an axon that leads far away and forks.
class NerveCell {
 public:
  explicit NerveCell(std::uint64_t seed) : mRandom(seed) {}

  std::vector<Segment> grow() {
    Vec body;
    do body = Vec(mRandom.uniform(-0.5f, 0.5f), mRandom.uniform(-0.5f, 0.5f), mRandom.uniform(-0.5f, 0.5f)) * kExtent;
    while (outline(body) > -0.25f || (outline(body) < -1.3f && mRandom.uniform() < 0.85f));
    float radius = mRandom.uniform(0.011f, 0.016f);
    mSegments.push_back({body, body + 0.6f * radius * mRandom.direction(), radius, 0.8f * radius});
    int dendrites = 5 + int(mRandom.uniform(0.0f, 3.0f));
    for (int i = 0; i < dendrites; ++i)
      extend(body, mRandom.direction(), 0.0048f, mRandom.uniform(0.2f, 0.4f), Vec(0.0f), 3);
    // To the other side, or to the middle.
    bool crosses = mRandom.uniform() < 0.4f;
    Vec goal = crosses ? Vec(-body.x, body.y + mRandom.uniform(-1.5f, 1.5f), body.z)
                       : Vec(0.4f * body.x, mRandom.uniform(-4.0f, 2.0f), -1.0f);
    extend(body, mRandom.direction(), 0.0042f, mRandom.uniform(2.5f, 7.0f), goal, 4);
    return std::move(mSegments);
  }

 private:
  /// @param length  mm  @param goal  0: nowhere  @param forks  at most so many more
  void extend(Vec at, Vec heading, float radius, float length, Vec goal, int forks) {
    constexpr float kStep = 0.02f;
    bool isAxon = goal != Vec(0.0f);
    for (float gone = 0.0f; gone < length; gone += kStep) {
      heading += (isAxon ? 0.16f : 0.25f) * mRandom.direction();
      if (isAxon) heading += 0.05f * glm::normalize(goal - at);
      if (float depth = outline(at); depth > -0.15f) heading += 0.5f * glm::normalize(-at) * (depth + 0.15f) / 0.15f;
      heading = glm::normalize(heading);
      Vec next = at + kStep * heading;
      float thin = radius * (1.0f - 0.35f * gone / length);
      mSegments.push_back({at, next, thin, thin});
      at = next;
      if (forks > 0 && mRandom.uniform() < (isAxon ? 1.6f : 3.0f) * kStep / length) {
        --forks;
        Vec aside = glm::normalize(heading + 0.9f * mRandom.direction());
        extend(at, aside, 0.9f * thin, 0.6f * (length - gone), isAxon ? at + 2.0f * aside : goal, forks - 1);
      }
    }
  }
  Random mRandom;
  std::vector<Segment> mSegments;
};

class BrainSource : public VoxelSource {
 public:
  BrainSource(int size, Progress& progress) {
    auto longest = std::max(kExtent.x, std::max(kExtent.y, kExtent.z));
    double spacing = double(longest) / size;
    for (int axis = 0; axis < 3; ++axis)
      mHead.dims[axis] = std::max(1, int(std::lround(double(kExtent[axis]) / spacing)));
    mHead.type = SampleType::UInt16;
    mHead.modality = Modality::Microscopy;
    mHead.name = "brain";
    mHead.isOrientationKnown = false;
    glm::ivec3 dims = mHead.dims;
    for (double factor = 1.0;; factor *= 2.0) {
      VoxelLevel level;
      level.dims = dims;
      level.brickSize = glm::min(dims, glm::ivec3(kBrickSize));
      for (int axis = 0; axis < 3; ++axis) {
        level.worldFromVoxel[axis][axis] = spacing * factor;
        level.worldFromVoxel[3][axis] = spacing * (0.5 * factor - 0.5 * mHead.dims[axis]);
      }
      mLevels.push_back(level);
      if (std::max(dims.x, std::max(dims.y, dims.z)) <= kCoarsest) break;
      dims = (dims + 1) / 2;
    }
    mHead.worldFromVoxel = mLevels.front().worldFromVoxel;
    growCells(progress);
  }

  const Volume& head() const override { return mHead; }
  void read(const BrickAddress& address, const SampleTarget& target) const override;

 private:
  void growCells(Progress& progress);
  glm::ivec3 indexCell(Vec p) const {
    return glm::clamp(glm::ivec3(glm::floor((p / kExtent + 0.5f) * Vec(mIndexSize))), glm::ivec3(0), mIndexSize - 1);
  }
  std::size_t indexAt(glm::ivec3 cell) const {
    return (std::size_t(cell.z) * std::size_t(mIndexSize.y) + std::size_t(cell.y)) * std::size_t(mIndexSize.x) +
           std::size_t(cell.x);
  }

  Volume mHead;
  std::vector<Segment> mTubes;
  glm::ivec3 mIndexSize{0};
  std::vector<std::uint32_t> mStarts, mListed;  ///< tubes by cells of the index
};

void BrainSource::growCells(Progress& progress) {
  std::vector<std::vector<Segment>> cells(kCells);
  parallelFor(0, kCells, [&](int i) {
    progress.throwIfCancelled();
    cells[std::size_t(i)] = NerveCell(hash(0xb7a1u, std::uint64_t(i))).grow();
  });
  for (const auto& cell : cells) append(mTubes, cell);
  float longest = std::max(kExtent.x, std::max(kExtent.y, kExtent.z));
  mIndexSize = glm::max(glm::ivec3(1), glm::ivec3(kExtent / longest * float(kIndexCells)));
  std::size_t count = std::size_t(mIndexSize.x) * std::size_t(mIndexSize.y) * std::size_t(mIndexSize.z);
  // A tube is listed where its middle is: tubes are shorter than a cell, and who asks looks a little around.
  std::vector<std::uint32_t> counts(count + 1, 0);
  for (const auto& tube : mTubes) ++counts[indexAt(indexCell(0.5f * (tube.a + tube.b))) + 1];
  for (std::size_t i = 0; i < count; ++i) counts[i + 1] += counts[i];
  mStarts = counts;
  mListed.resize(mTubes.size());
  for (std::size_t i = 0; i < mTubes.size(); ++i)
    mListed[counts[indexAt(indexCell(0.5f * (mTubes[i].a + mTubes[i].b)))]++] = std::uint32_t(i);
}

/// Values of tissue at corners of a coarse lattice over a brick, and between them.
class TissueLattice {
 public:
  TissueLattice(Vec origin, float spacing, glm::ivec3 size) : mSize(size / kLattice + 2) {
    mValues.resize(std::size_t(mSize.x) * std::size_t(mSize.y) * std::size_t(mSize.z));
    std::size_t i = 0;
    for (int z = 0; z < mSize.z; ++z)
      for (int y = 0; y < mSize.y; ++y)
        for (int x = 0; x < mSize.x; ++x, ++i) {
          Vec p = origin + spacing * float(kLattice) * Vec(x, y, z);
          float depth = -outline(p);
          float inside = glm::clamp(0.5f + depth / (2.0f * spacing * float(kLattice)), 0.0f, 1.0f);
          // The bark is brighter than what is below it, and fibres run through the middle.
          float bark = 1.0f + 0.35f * smoothStep(1.2f, 0.9f, depth) - 0.15f * smoothStep(0.25f, 0.05f, depth);
          float texture = 1.0f + 0.16f * noise(p * 3.0f, 11) + 0.08f * noise(p * 9.0f, 12);
          mValues[i] = inside * kTissue * bark * texture;
        }
  }
  float at(int x, int y, int z) const {
    glm::ivec3 base(x / kLattice, y / kLattice, z / kLattice);
    Vec f = Vec(x % kLattice, y % kLattice, z % kLattice) / float(kLattice);
    auto v = [&](int a, int b, int c) {
      return mValues[(std::size_t(base.z + c) * std::size_t(mSize.y) + std::size_t(base.y + b)) * std::size_t(mSize.x) +
                     std::size_t(base.x + a)];
    };
    auto mixX = [&](int b, int c) { return glm::mix(v(0, b, c), v(1, b, c), f.x); };
    return glm::mix(glm::mix(mixX(0, 0), mixX(1, 0), f.y), glm::mix(mixX(0, 1), mixX(1, 1), f.y), f.z);
  }

 private:
  glm::ivec3 mSize;
  std::vector<float> mValues;
};

void BrainSource::read(const BrickAddress& address, const SampleTarget& target) const {
  BrickBox box = boxOf(*this, address);
  const VoxelLevel& level = mLevels[std::size_t(address.level)];
  auto spacing = float(level.worldFromVoxel[0][0]);
  Vec origin(glm::dvec3(level.worldFromVoxel * glm::dvec4(glm::dvec3(box.origin), 1.0)));
  TissueLattice tissue(origin, spacing, box.size);
  std::size_t count = std::size_t(box.size.x) * std::size_t(box.size.y) * std::size_t(box.size.z);
  std::vector<float> shares(count, 0.0f);
  // Tubes thinner than a voxel fill a part of it.
  Vec low = origin - spacing, high = origin + spacing * Vec(box.size), reach(0.04f + spacing);
  glm::ivec3 first = indexCell(low - reach), last = indexCell(high + reach);
  for (int k = first.z; k <= last.z; ++k)
    for (int j = first.y; j <= last.y; ++j)
      for (int i = first.x; i <= last.x; ++i) {
        std::size_t cell = indexAt({i, j, k});
        for (std::uint32_t n = mStarts[cell]; n < mStarts[cell + 1]; ++n) {
          const Segment& tube = mTubes[mListed[n]];
          float radius = std::max(tube.radiusA, tube.radiusB), seen = std::max(radius, 0.6f * spacing);
          float share = (radius / seen) * (radius / seen), wide = seen + 0.5f * spacing;
          glm::ivec3 from =
              glm::max(glm::ivec3(glm::floor((glm::min(tube.a, tube.b) - wide - origin) / spacing)), glm::ivec3(0));
          glm::ivec3 to =
              glm::min(glm::ivec3(glm::ceil((glm::max(tube.a, tube.b) + wide - origin) / spacing)), box.size - 1);
          for (int z = from.z; z <= to.z; ++z)
            for (int y = from.y; y <= to.y; ++y)
              for (int x = from.x; x <= to.x; ++x) {
                float d = distance(tube, origin + spacing * Vec(x, y, z)) + radius - seen;
                float part = share * glm::clamp(0.5f - d / spacing, 0.0f, 1.0f);
                float& old =
                    shares[(std::size_t(z) * std::size_t(box.size.y) + std::size_t(y)) * std::size_t(box.size.x) +
                           std::size_t(x)];
                old = std::max(old, part);
              }
        }
      }
  std::size_t i = 0;
  for (int z = 0; z < box.size.z; ++z)
    for (int y = 0; y < box.size.y; ++y)
      for (int x = 0; x < box.size.x; ++x, ++i) {
        std::uint64_t index = (std::uint64_t(box.origin.z + z) << 40) ^ (std::uint64_t(box.origin.y + y) << 20) ^
                              std::uint64_t(box.origin.x + x);
        float value = kGround + tissue.at(x, y, z);
        value += shares[i] * (kCell - value) + float(hash(index) >> 61);
        auto sample = std::uint16_t(glm::clamp(value + 0.5f, 0.0f, 65535.0f));
        std::memcpy(target.first + x * target.x + y * target.y + z * target.z, &sample, sizeof(sample));
      }
}

}  // namespace

std::unique_ptr<VoxelSource> makeBrain(int size, Progress& progress) {
  constexpr int kLeast = 64, kMost = 65536;
  if (size < kLeast || size > kMost)
    throw ArgumentError(
        fmt::format("a brain of {} voxels along its longest axis: from {} to {} are made", size, kLeast, kMost));
  return std::make_unique<BrainSource>(size, progress);
}

}  // namespace velum::io
