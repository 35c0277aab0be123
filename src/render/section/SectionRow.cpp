#include "render/section/SectionRow.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace velum::render {

namespace {

constexpr double kOne = 4294967296.0;  // 2^32
constexpr std::int64_t kHalf = std::int64_t(1) << 31;

std::int64_t fixedPoint(double value) { return std::llround(std::clamp(value, -2e9, 2e9) * kOne); }

/// 32-bit integers and doubles keep their digits, all else is quicker in floats.
template <class T>
using Real = std::conditional_t<(sizeof(T) > 2 && !std::is_same_v<T, float>), double, float>;

template <class R>
R fraction(std::int64_t at) {
  return R(std::uint32_t(at)) * R(1.0 / kOne);
}

/// The two voxels about a coordinate and how far it lies from the first to the second.
template <class R>
struct Between {
  std::ptrdiff_t low, high;
  R share;
};
template <class R>
Between<R> between(std::int64_t at, int count, std::ptrdiff_t stride) {
  std::ptrdiff_t i = at >> 32;
  return {std::clamp<std::ptrdiff_t>(i, 0, count - 1) * stride,
          std::clamp<std::ptrdiff_t>(i + 1, 0, count - 1) * stride, fraction<R>(at)};
}

/// One grid's samples of one channel.
template <class T>
struct Samples {
  const T* first;
  glm::ivec3 dims;
  std::array<std::ptrdiff_t, 3> stride;
};

template <class T>
void sampleNearest(const Samples<T>& s, const GridRow& row, Real<T> scale, Real<T> offset, float* out) {
  auto at = row.at;
  for (int x = row.first; x < row.last; ++x) {
    std::ptrdiff_t index = 0;
    for (int i = 0; i < 3; ++i) {
      std::ptrdiff_t voxel = (at[std::size_t(i)] + kHalf) >> 32;
      index += std::clamp<std::ptrdiff_t>(voxel, 0, s.dims[i] - 1) * s.stride[std::size_t(i)];
      at[std::size_t(i)] += row.step[std::size_t(i)];
    }
    out[x] = float(Real<T>(s.first[index]) * scale + offset);
  }
}

/// A row along one axis of the grid: a weighted sum of at most four lines of voxels, interpolated along them.
template <int kLines, class T>
void sampleLines(const std::array<const T*, 4>& line, const std::array<Real<T>, 4>& weight, std::int64_t at,
                 std::int64_t step, int count, std::ptrdiff_t stride, const GridRow& row, float* out, Real<T> offset) {
  for (int x = row.first; x < row.last; ++x, at += step) {
    auto [low, high, share] = between<Real<T>>(at, count, stride);
    Real<T> a = 0, b = 0;
    for (std::size_t i = 0; i < kLines; ++i) {
      a += weight[i] * Real<T>(line[i][low]);
      b += weight[i] * Real<T>(line[i][high]);
    }
    out[x] = float(a + share * (b - a) + offset);
  }
}

template <class T>
void sampleAlong(std::size_t axis, const Samples<T>& s, const GridRow& row, Real<T> scale, Real<T> offset, float* out) {
  std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  // A section that lies on a plane of voxels but for the rounding of the transforms reads that plane alone.
  auto snapped = [](std::int64_t at) { return (at + (1 << 11)) & ~std::int64_t((1 << 12) - 1); };
  auto [u0, u1, fu] = between<Real<T>>(snapped(row.at[u]), s.dims[int(u)], s.stride[u]);
  auto [v0, v1, fv] = between<Real<T>>(snapped(row.at[v]), s.dims[int(v)], s.stride[v]);
  std::array<const T*, 4> line{};
  std::array<Real<T>, 4> weight{};
  std::size_t count = 0;
  auto add = [&](std::ptrdiff_t at, Real<T> w) {
    if (w == 0) return;
    line[count] = s.first + at;
    weight[count++] = w * scale;
  };
  add(u0 + v0, (1 - fu) * (1 - fv));
  add(u1 + v0, fu * (1 - fv));
  add(u0 + v1, (1 - fu) * fv);
  add(u1 + v1, fu * fv);
  auto run = [&](auto lines) {
    sampleLines<decltype(lines)::value>(line, weight, row.at[axis], row.step[axis], s.dims[int(axis)], s.stride[axis],
                                        row, out, offset);
  };
  if (count == 1) return run(std::integral_constant<int, 1>());
  if (count == 2) return run(std::integral_constant<int, 2>());
  run(std::integral_constant<int, 4>());
}

template <class T>
void sampleOblique(const Samples<T>& s, const GridRow& row, Real<T> scale, Real<T> offset, float* out) {
  auto at = row.at;
  for (int n = row.first; n < row.last; ++n) {
    auto x = between<Real<T>>(at[0], s.dims.x, s.stride[0]);
    auto y = between<Real<T>>(at[1], s.dims.y, s.stride[1]);
    auto z = between<Real<T>>(at[2], s.dims.z, s.stride[2]);
    auto along = [&](std::ptrdiff_t line) {
      Real<T> a = Real<T>(s.first[line + x.low]), b = Real<T>(s.first[line + x.high]);
      return a + x.share * (b - a);
    };
    Real<T> a = along(y.low + z.low), b = along(y.high + z.low), c = along(y.low + z.high), d = along(y.high + z.high);
    Real<T> front = a + y.share * (b - a), back = c + y.share * (d - c);
    out[n] = float((front + z.share * (back - front)) * scale + offset);
    for (std::size_t i = 0; i < 3; ++i) at[i] += row.step[i];
  }
}

}  // namespace

GridPath::GridPath(const scene::SectionPlane& plane, glm::ivec3 dims, const glm::dmat4& worldFromVoxel) : mDims(dims) {
  glm::dmat4 voxelFromWorld = glm::inverse(worldFromVoxel);
  glm::dmat3 turn(voxelFromWorld);
  mOrigin = glm::dvec3(voxelFromWorld * glm::dvec4(scene::worldFromSectionPixel(plane, {0, 0}), 1.0));
  mAcross = turn * plane.right * plane.lengthPerPixel;
  mDown = turn * -plane.up * plane.lengthPerPixel;
  // Noise of the transforms would take a row along an axis off it.
  for (int i = 0; i < 3; ++i)
    if (std::abs(mAcross[i]) < 1e-9) mAcross[i] = 0.0;
}

GridRow GridPath::row(int y, int width) const {
  glm::dvec3 start = mOrigin + mDown * (y + 0.5) + mAcross * 0.5;
  double from = 0.0, to = width - 1.0;
  for (int i = 0; i < 3; ++i) {
    double low = -0.5 - start[i], high = mDims[i] - 0.5 - start[i];
    if (mAcross[i] == 0.0) {
      if (low > 0.0 || high < 0.0) return {};
      continue;
    }
    double a = low / mAcross[i], b = high / mAcross[i];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  GridRow row;
  if (!(from <= to)) return row;
  row.first = int(std::ceil(from));
  row.last = std::max(row.first, int(std::floor(to)) + 1);
  for (int i = 0; i < 3; ++i) {
    row.at[std::size_t(i)] = fixedPoint(start[i] + mAcross[i] * row.first);
    row.step[std::size_t(i)] = fixedPoint(mAcross[i]);
  }
  return row;
}

void sampleRow(const Volume& volume, int channel, int timeStep, const GridRow& row, bool interpolate, double scale,
               double offset, float* out) {
  if (row.first >= row.last) return;
  visitSamples(volume, [&](auto* samples) {
    using T = std::remove_cvref_t<decltype(*samples)>;
    std::size_t start =
        std::size_t(timeStep) * voxelCount(volume) * std::size_t(volume.channels) + std::size_t(channel);
    std::ptrdiff_t x = volume.channels, y = x * volume.dims.x, z = y * volume.dims.y;
    Samples<T> s{samples + start, volume.dims, {x, y, z}};
    auto k = Real<T>(scale), c = Real<T>(offset);
    if (!interpolate) return sampleNearest(s, row, k, c, out);
    int moving = 0;
    std::size_t axis = 0;
    for (std::size_t i = 0; i < 3; ++i)
      if (row.step[i] != 0) ++moving, axis = i;
    if (moving == 1) return sampleAlong(axis, s, row, k, c, out);
    sampleOblique(s, row, k, c, out);
  });
}

}  // namespace velum::render
