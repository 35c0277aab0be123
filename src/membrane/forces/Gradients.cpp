#include "membrane/forces/Gradients.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/Parallel.h"

namespace velum::membrane {

namespace {

/// Squared gradient magnitudes of rows of voxels.
template <class T>
struct SquaredGradient {
  /// Differences of 32-bit integers and doubles need doubles; of the others floats lose nothing that matters.
  using Real = std::conditional_t<(sizeof(T) <= 2 || std::is_same_v<T, float>), float, double>;
  const T* samples;  ///< of the timeStep and channel
  glm::ivec3 dims;
  std::ptrdiff_t stride;        ///< samples a voxel
  glm::mat<3, 3, Real> metric;  ///< g = d^T metric d for differences d between neighbours

  SquaredGradient(const T* p, const Volume& volume, int channel, int timeStep)
      : samples(p + std::size_t(timeStep) * voxelCount(volume) * std::size_t(volume.channels) + channel),
        dims(volume.dims),
        stride(volume.channels) {
    glm::dmat3 worldFromVoxelGradient = glm::transpose(glm::inverse(glm::dmat3(volume.worldFromVoxel))) * volume.scale;
    metric = glm::mat<3, 3, Real>(glm::transpose(worldFromVoxelGradient) * worldFromVoxelGradient);
  }

  const T* row(int y, int z) const { return samples + (std::ptrdiff_t(z) * dims.y + y) * dims.x * stride; }

  void fill(int y, int z, float* out) const {
    // One channel is the common case, and vectorised only where the compiler knows it.
    if (stride == 1)
      fill(y, z, out, std::integral_constant<std::ptrdiff_t, 1>());
    else
      fill(y, z, out, stride);
  }

 private:
  void fill(int y, int z, float* out, auto step) const {
    int y0 = std::max(y - 1, 0), y1 = std::min(y + 1, dims.y - 1);
    int z0 = std::max(z - 1, 0), z1 = std::min(z + 1, dims.z - 1);
    Real perY = Real(1) / Real(std::max(y1 - y0, 1)), perZ = Real(1) / Real(std::max(z1 - z0, 1));
    const T *middle = row(y, z), *yLow = row(y0, z), *yHigh = row(y1, z), *zLow = row(y, z0), *zHigh = row(y, z1);
    Real xx = metric[0][0], yy = metric[1][1], zz = metric[2][2];
    Real xy = 2 * metric[1][0], xz = 2 * metric[2][0], yz = 2 * metric[2][1];
    auto at = [&](int x, int x0, int x1, Real perX) {
      Real dx = (Real(middle[x1 * step]) - Real(middle[x0 * step])) * perX;
      Real dy = (Real(yHigh[x * step]) - Real(yLow[x * step])) * perY;
      Real dz = (Real(zHigh[x * step]) - Real(zLow[x * step])) * perZ;
      Real g = dx * (dx * xx + dy * xy + dz * xz) + dy * (dy * yy + dz * yz) + dz * dz * zz;
      return g < Real(3e38) ? std::max(float(g), 0.0f) : 0.0f;  // false for what is not a number
    };
    int last = dims.x - 1;
    out[0] = at(0, 0, std::min(1, last), Real(1));
    for (int x = 1; x < last; ++x) out[x] = at(x, x - 1, x + 1, Real(0.5));
    if (last > 0) out[last] = at(last, last - 1, last, Real(1));
  }
};

/// Calls body(row index, squared magnitudes) for all rows of a range.
template <class T, class Body>
void forRows(const SquaredGradient<T>& gradient, int first, int end, Body body) {
  std::vector<float> squared(std::size_t(gradient.dims.x));
  for (int row = first; row < end; ++row) {
    gradient.fill(row % gradient.dims.y, row / gradient.dims.y, squared.data());
    body(row, squared);
  }
}

template <class T>
Gradients compute(const SquaredGradient<T>& gradient, Progress& progress) {
  constexpr int kGrain = 64;
  int rows = gradient.dims.y * gradient.dims.z;
  float largest = parallelReduce(
      0, rows, kGrain, 0.0f,
      [&](int first, int end) {
        float most = 0.0f;
        if (progress.isCancelled()) return most;
        forRows(gradient, first, end, [&](int, const std::vector<float>& squared) {
          for (float g : squared) most = std::max(most, g);
        });
        return most;
      },
      [](float a, float b) { return std::max(a, b); });
  progress.report(0.5, "measuring gradients");
  Gradients result;
  result.largest = std::sqrt(double(largest));
  result.codes.resize(std::size_t(gradient.dims.x) * std::size_t(gradient.dims.y) * std::size_t(gradient.dims.z));
  float perLargest = largest > 0.0f ? 1.0f / largest : 0.0f;
  parallelForRanges(0, rows, kGrain, [&](int first, int end) {
    if (progress.isCancelled()) return;
    forRows(gradient, first, end, [&](int row, const std::vector<float>& squared) {
      std::uint16_t* out = result.codes.data() + std::size_t(row) * squared.size();
      for (float g : squared) *out++ = std::uint16_t(std::sqrt(std::sqrt(g * perLargest)) * 65535.0f + 0.5f);
    });
  });
  progress.throwIfCancelled();
  return result;
}

}  // namespace

Gradients computeGradients(const Volume& volume, int channel, int timeStep, Progress& progress) {
  return visitSamples(volume,
                      [&](auto* p) { return compute(SquaredGradient(p, volume, channel, timeStep), progress); });
}

}  // namespace velum::membrane
