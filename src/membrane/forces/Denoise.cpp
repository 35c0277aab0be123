#include "membrane/forces/Denoise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/Parallel.h"

namespace velum::membrane {

namespace {

// Tried on the phantom of nerve fibres, one to three voxels thick: the widths at which a threshold finds them best.
constexpr int kTaps = 2;              ///< to either side
constexpr double kSmooth = 0.8;       ///< standard deviation of what likeness is seen in, voxels
constexpr double kNoiseLeft = 0.21;   ///< standard deviation of white noise that such smoothing leaves
constexpr double kLike = 2.0 * 1.27;  ///< voxels that differ more, by what noise is left, are not alike
constexpr int kSlab = 12;             ///< layers that a thread works on at once
constexpr int kRim = 1;               ///< voxels around that are looked at

/// Layers of floats, with a rim of clamped voxels along x and y.
class Layers {
 public:
  Layers(glm::ivec3 dims, int first, int count)
      : mSize(dims.x + 2 * kRim, dims.y + 2 * kRim),
        mFirst(first),
        mValues(std::size_t(mSize.x) * std::size_t(mSize.y) * std::size_t(count)) {}
  /// The voxel (0, y, z), y from -1 to the height.
  float* row(int y, int z) {
    return mValues.data() +
           (std::size_t(z - mFirst) * std::size_t(mSize.y) + std::size_t(y + kRim)) * std::size_t(mSize.x) + kRim;
  }

 private:
  glm::ivec2 mSize;
  int mFirst;
  std::vector<float> mValues;
};

/// A slab in the making: the data, and the same smoothed.
class Slab {
 public:
  Slab(const Volume& volume, int channel, int timeStep, int first, int end)
      : mVolume(volume),
        mDims(volume.dims),
        mFirst(first),
        mEnd(end),
        mRaw(mDims, first - kRim - kTaps, end - first + 2 * (kRim + kTaps)),
        mSmooth(mDims, first - kRim, end - first + 2 * kRim) {
    for (int z = first - kRim - kTaps; z < end + kRim + kTaps; ++z) {
      int from = std::clamp(z, 0, mDims.z - 1);
      for (int y = 0; y < mDims.y; ++y) readRow(y, from, channel, timeStep, mRaw.row(y, z));
      closeRim(mRaw, z);
    }
    smooth();
  }

  /// @param perSquare  weights fall to 0 where it is the inverse of the squared difference
  void meanOfAlike(int y, int z, float perSquare, float* out) {
    auto count = std::size_t(mDims.x);
    const float* here = mSmooth.row(y, z);
    mWeights.assign(count, 0.0f);
    mSums.assign(count, 0.0f);
    float *weights = mWeights.data(), *sums = mSums.data();
    for (int place = 0; place < 27; ++place) {
      int dx = place % 3 - 1, dy = place / 3 % 3 - 1, dz = place / 9 - 1;
      const float *like = mSmooth.row(y + dy, z + dz) + dx, *value = mRaw.row(y + dy, z + dz) + dx;
      for (std::size_t x = 0; x < count; ++x) {
        float difference = like[x] - here[x];
        float weight = 1.0f - difference * difference * perSquare;
        bool isLike = weight > 0.0f;  // not beside what is not a number
        weight = isLike ? weight * weight : 0.0f;
        weights[x] += weight;
        sums[x] += isLike ? weight * value[x] : 0.0f;
      }
    }
    const float* raw = mRaw.row(y, z);
    for (std::size_t x = 0; x < count; ++x) out[x] = weights[x] > 0.0f ? sums[x] / weights[x] : raw[x];
  }

 private:
  void readRow(int y, int z, int channel, int timeStep, float* out) const {
    std::size_t first = (std::size_t(z) * std::size_t(mDims.y) + std::size_t(y)) * std::size_t(mDims.x);
    visitSamples(mVolume, [&](auto* p) {
      p += (std::size_t(timeStep) * voxelCount(mVolume) + first) * std::size_t(mVolume.channels) + std::size_t(channel);
      for (int x = 0; x < mDims.x; ++x)
        out[x] = float(double(p[x * mVolume.channels]) * mVolume.scale + mVolume.offset);
    });
  }
  void closeRim(Layers& layers, int z) const {
    for (int y = 0; y < mDims.y; ++y) {
      float* row = layers.row(y, z);
      row[-1] = row[0];
      row[mDims.x] = row[mDims.x - 1];
    }
    std::copy_n(layers.row(0, z) - kRim, mDims.x + 2 * kRim, layers.row(-1, z) - kRim);
    std::copy_n(layers.row(mDims.y - 1, z) - kRim, mDims.x + 2 * kRim, layers.row(mDims.y, z) - kRim);
  }
  void smooth() {
    std::array<float, 2 * kTaps + 1> taps;
    double sum = 0.0;
    for (int i = -kTaps; i <= kTaps; ++i) sum += std::exp(-i * i / (2.0 * kSmooth * kSmooth));
    for (int i = -kTaps; i <= kTaps; ++i)
      taps[std::size_t(i + kTaps)] = float(std::exp(-i * i / (2.0 * kSmooth * kSmooth)) / sum);
    auto wide = std::size_t(mDims.x + 2 * kTaps);
    std::vector<float> layer(wide * std::size_t(mDims.y));
    for (int z = mFirst - kRim; z < mEnd + kRim; ++z) {
      for (int y = 0; y < mDims.y; ++y) {
        float* row = layer.data() + std::size_t(y) * wide + kTaps;
        std::fill_n(row, mDims.x, 0.0f);
        for (int k = -kTaps; k <= kTaps; ++k) addRow(mRaw.row(y, z + k), taps[std::size_t(k + kTaps)], row);
        for (int k = 1; k <= kTaps; ++k) row[-k] = row[0], row[mDims.x - 1 + k] = row[mDims.x - 1];
      }
      std::vector<float> across(std::size_t(mDims.x + 2 * kTaps));
      for (int y = 0; y < mDims.y; ++y) {
        std::fill(across.begin(), across.end(), 0.0f);
        for (int k = -kTaps; k <= kTaps; ++k) {
          const float* row = layer.data() + std::size_t(std::clamp(y + k, 0, mDims.y - 1)) * wide;
          for (std::size_t x = 0; x < wide; ++x) across[x] += taps[std::size_t(k + kTaps)] * row[x];
        }
        float* out = mSmooth.row(y, z);
        std::fill_n(out, mDims.x, 0.0f);
        for (int k = 0; k <= 2 * kTaps; ++k) addRow(across.data() + k, taps[std::size_t(k)], out);
      }
      closeRim(mSmooth, z);
    }
  }
  void addRow(const float* from, float weight, float* to) const {
    for (int x = 0; x < mDims.x; ++x) to[x] += weight * from[x];
  }

  const Volume& mVolume;
  glm::ivec3 mDims;
  int mFirst, mEnd;
  Layers mRaw, mSmooth;
  std::vector<float> mWeights, mSums;
};

bool isShort(SampleType type) { return sampleSize(type) <= 2; }

}  // namespace

double noiseOf(const Volume& volume, int channel, int timeStep) {
  constexpr double kMostSamples = 1e6;
  if (volume.dims.x < 3) return 0.0;
  int step = std::max(1, int(std::sqrt(double(voxelCount(volume)) / kMostSamples)));
  std::vector<float> differences;
  for (int z = 0; z < volume.dims.z; z += step)
    for (int y = z / step % step; y < volume.dims.y; y += step)
      for (int x = 1; x + 1 < volume.dims.x; ++x) {
        double a = valueAt(volume, {x - 1, y, z}, channel, timeStep), b = valueAt(volume, {x, y, z}, channel, timeStep),
               c = valueAt(volume, {x + 1, y, z}, channel, timeStep);
        // What is the same all along is no measurement: air that was cut off, padding.
        if (std::isfinite(a + b + c) && !(a == b && b == c)) differences.push_back(float(std::abs(a - 2.0 * b + c)));
      }
  if (differences.empty()) return 0.0;
  auto middle = differences.begin() + std::ptrdiff_t(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  // Half of a normal distribution lies within 0.6745 standard deviations; the square of the sum's weights is 6.
  return double(*middle) / (0.6745 * std::sqrt(6.0));
}

Volume denoise(const Volume& volume, int channel, int timeStep, double noise, const Progress& progress) {
  Volume out;
  out.dims = volume.dims;
  out.worldFromVoxel = volume.worldFromVoxel;
  out.lengthUnit = volume.lengthUnit;
  out.range = volume.range;
  out.unit = volume.unit;
  out.type = isShort(volume.type) ? SampleType::UInt16 : SampleType::Float32;
  if (isShort(volume.type)) {
    out.scale = volume.range.y > volume.range.x ? (volume.range.y - volume.range.x) / 65535.0 : 1.0;
    out.offset = volume.range.x;
  }
  out.voxels.resize(voxelCount(out) * sampleSize(out.type));
  double like = std::max(kLike * kNoiseLeft * noise, 1e-30);
  auto perSquare = float(std::min(1.0 / (like * like), double(std::numeric_limits<float>::max())));
  parallelFor(0, (out.dims.z + kSlab - 1) / kSlab, [&](int i) {
    if (progress.isCancelled()) return;
    int first = i * kSlab, end = std::min(first + kSlab, out.dims.z);
    Slab slab(volume, channel, timeStep, first, end);
    std::vector<float> row(std::size_t(out.dims.x));
    for (int z = first; z < end && !progress.isCancelled(); ++z)
      for (int y = 0; y < out.dims.y; ++y) {
        slab.meanOfAlike(y, z, perSquare, row.data());
        std::size_t at = (std::size_t(z) * std::size_t(out.dims.y) + std::size_t(y)) * std::size_t(out.dims.x);
        if (out.type == SampleType::Float32) {
          std::memcpy(out.voxels.data() + at * sizeof(float), row.data(), row.size() * sizeof(float));
          continue;
        }
        auto* raw = reinterpret_cast<std::uint16_t*>(out.voxels.data()) + at;
        auto scale = float(1.0 / out.scale), offset = float(out.offset);
        for (std::size_t x = 0; x < row.size(); ++x)
          raw[x] = std::uint16_t(std::clamp((row[x] - offset) * scale + 0.5f, 0.0f, 65535.0f));
      }
  });
  progress.throwIfCancelled();
  return out;
}

}  // namespace velum::membrane
