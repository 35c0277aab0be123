#include "growth/PassageCosts.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/Error.h"
#include "core/Memory.h"
#include "core/Parallel.h"
#include "growth/RowBits.h"

namespace velum::growth {

namespace {

/// Differences that are looked at to know the noise.
constexpr std::size_t kMostSamples = 1000000;
/// Bytes for each voxel of a box, at most while costs are made; and what share of the memory they may take.
constexpr double kBytesPerVoxel = 16.0, kMemoryShare = 0.5;
/// Of what is no more than noise around other things, voxels.
constexpr double kLeastDepth = 0.5;

/// Around a region, with a voxel of what is not of it, where the volume goes on.
RoomyBox boxAround(const RegionGrow& region, glm::ivec3 dims) {
  glm::ivec3 low = dims, high(-1);
  VoxelBox reach = region.reach();
  std::vector<Word> row(static_cast<std::size_t>(wordsOf(dims.x)));
  for (int z = reach.first.z; z < reach.end.z; ++z)
    for (int y = reach.first.y; y < reach.end.y; ++y) {
      if (!region.read(y, z, row.data())) continue;
      for (int w = 0; w < int(row.size()); ++w) {
        Word bits = row[std::size_t(w)];
        if (bits == 0) continue;
        low = glm::min(low, glm::ivec3(w * kWordBits + std::countr_zero(bits), y, z));
        high = glm::max(high, glm::ivec3((w + 1) * kWordBits - 1 - std::countl_zero(bits), y, z));
      }
    }
  if (high.x < 0) return RoomyBox(glm::ivec3(0), glm::ivec3(0));
  low = glm::max(low - 1, glm::ivec3(0));
  high = glm::min(high + 1, dims - 1);
  RoomyBox box(low, high - low + 1);
  double bytes = kBytesPerVoxel * double(box.count());
  if (bytes > kMemoryShare * machineBytes())
    throw InputError(
        fmt::format("what grows reaches over a box of {} x {} x {} voxels, and to tell it from what is not of it takes "
                    "{:.1f} GB of memory; grow it less far, or give it a narrower range",
                    box.dims().x, box.dims().y, box.dims().z, bytes / 1e9));
  return box;
}

/// Calls body(voxel of the volume, place) for each of the box. All cores.
template <class Body>
void forVoxels(const RoomyBox& box, const Body& body) {
  parallelFor(box.first().z, box.end().z, [&](int z) {
    for (int y = box.first().y; y < box.end().y; ++y) {
      std::size_t place = box.at({box.first().x, y, z});
      for (int x = box.first().x; x < box.end().x; ++x) body(glm::ivec3(x, y, z), place++);
    }
  });
}

}  // namespace

PassageCosts::PassageCosts(const RegionGrow& region, const FinestVoxels& voxels, const GrowDomain& domain,
                           Progress& progress)
    : mBox(boxAround(region, voxels.grid().dims)), mIsIn(mBox.count()) {
  const Volume& volume = voxels.grid();
  takeRegion(region);
  glm::dmat3 worldFromVoxel(volume.worldFromVoxel);
  {
    Lengths depth = depths(volume, domain);
    takeDepths(depth);
    mLevels = thicknessLevels(mBox, worldFromVoxel, depth, progress);
  }
  progress.report(0.4, "Growing");
  smoothValues(voxels, region.rule().channel, region.rule().timeStep);
  mPerNoise = float(1.0 / noise());
  double shortest =
      std::min({glm::length(worldFromVoxel[0]), glm::length(worldFromVoxel[1]), glm::length(worldFromVoxel[2])});
  for (std::size_t i = 0; i < mThinness.size(); ++i) {
    double depth = std::max(double(i) / kDepthUnit, kLeastDepth);
    mThinness[i] = int(std::lround(kPerThinStep / (depth * depth)));
  }
  for (int axis = 0; axis < 3; ++axis)
    mLength[std::size_t(axis)] =
        int(std::lround(kPerStep * std::min(glm::length(worldFromVoxel[axis]) / shortest, 1000.0)));
}

int PassageCosts::mostCost() const {
  int mostLevel = mLevels.empty() ? 0 : int(*std::max_element(mLevels.begin(), mLevels.end()));
  return *std::max_element(mLength.begin(), mLength.end()) + int(kPerEdge * kMostEdge * kMostEdge) +
         kPerLevel * mostLevel + mThinness[0];
}

void PassageCosts::takeRegion(const RegionGrow& region) {
  parallelFor(mBox.first().z, mBox.end().z, [&](int z) {
    for (int y = mBox.first().y; y < mBox.end().y; ++y) {
      std::size_t place = mBox.at({mBox.first().x, y, z});
      Word bits = 0;
      for (int x = mBox.first().x; x < mBox.end().x; ++x) {
        if (x == mBox.first().x || x % kWordBits == 0) bits = region.word(y, z, x / kWordBits);
        mIsIn[place++] = bits >> (x % kWordBits) & 1;
      }
    }
  });
}

/// From each voxel of the region to what is not of it, as far as that is known. Noise makes no holes: what most of the
/// neighbours are a voxel counts as, too.
Lengths PassageCosts::depths(const Volume& volume, const GrowDomain& domain) const {
  auto [sx, sy, sz] = mBox.steps();
  std::vector<std::uint8_t> isKnown(mBox.count()), isSolid(mBox.count());
  forVoxels(mBox, [&](glm::ivec3 v, std::size_t place) { isKnown[place] = mIsIn[place] || domain.contains(v); });
  forVoxels(mBox, [&, sx = sx, sy = sy, sz = sz](glm::ivec3, std::size_t place) {
    int known = 0, in = 0;
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
          auto other = std::size_t(std::ptrdiff_t(place) + x * sx + y * sy + z * sz);
          known += isKnown[other], in += mIsIn[other];
        }
    isSolid[place] = 2 * in >= known && in > 0;
  });
  Lengths lengths(mBox.count(), kFarAway);
  forVoxels(mBox, [&](glm::ivec3, std::size_t place) {
    if (isKnown[place] && !isSolid[place]) lengths[place] = 0;
  });
  spreadLengths(mBox, glm::dmat3(volume.worldFromVoxel), lengths);
  for (std::size_t i = 0; i < lengths.size(); ++i)
    if (!isSolid[i]) lengths[i] = 0;
  return lengths;
}

void PassageCosts::takeDepths(const Lengths& depths) {
  mDepths.resize(depths.size());
  for (std::size_t i = 0; i < depths.size(); ++i)
    mDepths[i] = std::uint8_t(std::min(int(depths[i]) * kDepthUnit / kLengthUnit, 255));
}

/// Of the voxels of the region; where bricks are read, of a run of them at a time.
void PassageCosts::readValues(const FinestVoxels& voxels, int channel, int timeStep, std::vector<float>& raw) const {
  const Volume& grid = voxels.grid();
  if (!voxels.isStreamed()) {
    forVoxels(mBox, [&](glm::ivec3 v, std::size_t place) {
      if (mIsIn[place]) raw[place] = float(valueAt(grid, v, channel, timeStep));
    });
    return;
  }
  parallelFor(mBox.first().z, mBox.end().z, [&](int z) {
    for (int y = mBox.first().y; y < mBox.end().y; ++y) {
      std::size_t row = mBox.at({mBox.first().x, y, z});
      int width = mBox.end().x - mBox.first().x;
      for (int from = 0, end; from < width; from = end) {
        end = from + 1;
        if (!mIsIn[row + std::size_t(from)]) continue;
        while (end < width && mIsIn[row + std::size_t(end)]) ++end;
        Volume run = voxels.read({mBox.first().x + from, y, z}, {end - from, 1, 1}, channel, timeStep);
        for (int x = from; x < end; ++x) raw[row + std::size_t(x)] = float(valueAt(run, {x - from, 0, 0}));
      }
    }
  });
}

/// Each with its neighbours in the region.
void PassageCosts::smoothValues(const FinestVoxels& voxels, int channel, int timeStep) {
  std::vector<float> raw(mBox.count());
  readValues(voxels, channel, timeStep, raw);
  mValues.resize(mBox.count());
  auto steps = mBox.steps();
  forVoxels(mBox, [&](glm::ivec3, std::size_t place) {
    if (!mIsIn[place]) return;
    float sum = 2.0f * raw[place], count = 2.0f;
    for (std::ptrdiff_t step : steps)
      for (std::size_t other : {place - std::size_t(step), place + std::size_t(step)})
        if (mIsIn[other]) sum += raw[other], count += 1.0f;
    mValues[place] = sum / count;
  });
}

/// The median of the differences between neighbours; where half of them are none, their mean.
double PassageCosts::noise() const {
  std::size_t every = 3 * mBox.count() / kMostSamples + 1, turn = 0;
  std::vector<float> differences;
  double sum = 0.0;
  auto steps = mBox.steps();
  for (std::size_t place = 0; place < mBox.count(); ++place) {
    if (!mIsIn[place]) continue;
    for (std::ptrdiff_t step : steps) {
      std::size_t other = place + std::size_t(step);
      if (!mIsIn[other] || turn++ % every != 0) continue;
      float difference = std::abs(mValues[place] - mValues[other]);
      if (!std::isfinite(difference)) continue;
      differences.push_back(difference);
      sum += double(difference);
    }
  }
  if (differences.empty()) return 1.0;
  auto middle = differences.begin() + std::ptrdiff_t(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  double median = double(*middle), mean = sum / double(differences.size());
  return median > 0.0 ? median : mean > 0.0 ? mean : 1.0;
}

}  // namespace velum::growth
