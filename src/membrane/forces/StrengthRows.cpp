#include "membrane/forces/StrengthRows.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "membrane/forces/Kernels.h"
#include "scene/Scene.h"

namespace velum::membrane {

namespace {

using Curve = std::vector<scene::StrengthPoint>;

constexpr int kNumbers = 65536;  ///< of labels, and of types
constexpr int kMostSamples = 6;  ///< along an edge of a voxel

/// The curve in order, without points that are no numbers: what a file says is not always sound.
Curve soundCurve(Curve curve) {
  std::erase_if(curve, [](const auto& p) { return !std::isfinite(p.value) || !std::isfinite(p.strength); });
  std::stable_sort(curve.begin(), curve.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  return curve;
}

/// True when two voxel grids are the same one, to a thousandth of a voxel.
bool isSameGrid(const glm::dmat4& labelFromVoxel, glm::ivec3 dims, glm::ivec3 labelDims) {
  glm::dvec4 far(glm::dvec3(dims), 1.0);
  glm::dvec4 origin(0.0, 0.0, 0.0, 1.0);
  auto moved = [&](glm::dvec4 p) { return glm::length(labelFromVoxel * p - p); };
  return dims == labelDims && moved(origin) < 1e-3 && moved(far) < 1e-3 && moved(far * glm::dvec4(0, 1, 1, 1)) < 1e-3 &&
         moved(far * glm::dvec4(1, 0, 1, 1)) < 1e-3;
}

}  // namespace

double strengthAt(std::span<const scene::StrengthPoint> curve, double value) {
  auto after = std::upper_bound(curve.begin(), curve.end(), value, [](double v, const auto& p) { return v < p.value; });
  if (after == curve.begin() || !(value == value)) return 0.0;
  const auto& a = *(after - 1);
  if (after == curve.end()) return value == a.value ? a.strength : 0.0;
  return a.strength + (after->strength - a.strength) * (value - a.value) / (after->value - a.value);
}

StrengthRows::StrengthRows(PotentialSource source, const Gradients* gradients, const scene::ForceField& field,
                           std::shared_ptr<const SmallPieces> small)
    : mSource(std::move(source)), mGradients(gradients), mSmall(std::move(small)) {
  if (mSource.volume && !field.byValue.empty()) tabulateValues(soundCurve(field.byValue));
  if (mGradients) {
    Curve curve = soundCurve(field.byGradient);
    mByCode.resize(65536);
    for (int code = 0; code < 65536; ++code)
      mByCode[std::size_t(code)] = float(strengthAt(curve, mGradients->magnitude(code)));
  }
  if (mSource.labels && !field.byLabel.empty()) {
    mLabels = byNumber(mSource.labels);
    for (const auto& label : field.byLabel)
      if (label.id >= 0 && label.id < kNumbers && std::isfinite(label.strength))
        mLabels.strengths[std::size_t(label.id)] += float(label.strength);
  }
  if (mSource.types && !field.byType.empty()) {
    mTypes = byNumber(mSource.types);
    // A shell of molecules may be thinner than a voxel of a volume.
    for (int axis = 0; axis < 3; ++axis)
      mTypes.samples[axis] =
          std::clamp(int(std::ceil(glm::length(mTypes.gridFromVoxel[axis]) - 1e-3)), 1, kMostSamples);
    const auto& types = mSource.model.data->types;
    for (std::size_t t = 0; t < types.size() && t + 1 < std::size_t(kNumbers); ++t) {
      double strength = scene::strengthOf(field, pathOf(*mSource.model.data, types[t]));
      if (std::isfinite(strength)) mTypes.strengths[t + 1] = float(strength);
    }
  }
}

StrengthRows::ByNumber StrengthRows::byNumber(const Shared<LabelVolume>& grid) const {
  ByNumber by;
  by.grid = &*grid;
  by.strengths.resize(std::size_t(kNumbers));
  by.gridFromVoxel = glm::inverse(grid->worldFromVoxel()) * mSource.worldFromVoxel;
  by.isSameGrid = isSameGrid(by.gridFromVoxel, mSource.dims, grid->dims());
  return by;
}

void StrengthRows::tabulateValues(const Curve& curve) {
  mHasValues = true;
  const Volume& volume = *mSource.volume;
  visitSamples(volume, [&](auto* p) {
    using T = std::remove_cv_t<std::remove_pointer_t<decltype(p)>>;
    if constexpr (std::is_integral_v<T> && sizeof(T) <= 2) {
      int low = std::numeric_limits<T>::min(), high = std::numeric_limits<T>::max();
      for (int raw = low; raw <= high; ++raw)
        mByRaw.push_back(float(strengthAt(curve, raw * volume.scale + volume.offset)));
    }
  });
  if (!mByRaw.empty()) return;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < curve.size(); ++i) {
    // The last point holds at its own value only.
    bool isLast = i + 1 == curve.size();
    double end = isLast ? std::nextafter(curve[i].value, kInfinity) : curve[i + 1].value;
    if (end <= curve[i].value) continue;
    double slope = isLast ? 0.0 : (curve[i + 1].strength - curve[i].strength) / (end - curve[i].value);
    mPieces.push_back({curve[i].value, end, curve[i].strength - slope * curve[i].value, slope});
  }
}

void StrengthRows::selectPiece(const Piece& piece, const double* values, int count, double* strengths) {
  for (int i = 0; i < count; ++i) {
    double strength = piece.at + piece.slope * values[i];
    bool holds = (values[i] >= piece.from) & (values[i] < piece.end);
    strengths[i] = holds ? strength : strengths[i];
  }
}

void StrengthRows::fillValues(std::ptrdiff_t first, int count, float* out) const {
  const Volume& volume = *mSource.volume;
  std::ptrdiff_t stride = volume.channels;
  visitSamples(volume, [&](auto* p) {
    using T = std::remove_cv_t<std::remove_pointer_t<decltype(p)>>;
    p += std::ptrdiff_t(mSource.timeStep) * std::ptrdiff_t(voxelCount(volume)) * stride + first * stride +
         mSource.channel;
    if constexpr (std::is_integral_v<T> && sizeof(T) <= 2) {
      const float* byRaw = mByRaw.data() - std::numeric_limits<T>::min();
      for (int i = 0; i < count; ++i) out[i] = byRaw[p[i * stride]];
    } else {
      // Piece by piece over the whole row: selects instead of a search, which the compiler vectorises.
      thread_local std::vector<double> values, strengths;
      values.resize(std::size_t(count));
      strengths.assign(std::size_t(count), 0.0);
      for (int i = 0; i < count; ++i) values[std::size_t(i)] = double(p[i * stride]) * volume.scale + volume.offset;
      for (const Piece& piece : mPieces) selectPiece(piece, values.data(), count, strengths.data());
      for (int i = 0; i < count; ++i) out[i] = float(strengths[std::size_t(i)]);
    }
  });
}

void StrengthRows::addNumbers(const ByNumber& by, int x, int end, int y, int z, float* out) {
  if (by.isSameGrid) {
    thread_local std::vector<std::uint16_t> ids;
    ids.resize(std::size_t(end - x));
    by.grid->read({x, y, z}, {end - x, 1, 1}, ids);
    for (std::size_t i = 0; i < ids.size(); ++i) out[i] += by.strengths[ids[i]];
    return;
  }
  addNearest(by, by.gridFromVoxel, x, end, y, z, out);
}

void StrengthRows::addNearest(const ByNumber& by, const glm::dmat4& gridFromVoxel, int x, int end, int y, int z,
                              float* out) {
  constexpr double kOne = 4294967296.0;  // places are walked in fixed point, 32 bits after the point
  constexpr double kFar = 1e9;
  constexpr int kBrick = LabelVolume::kBrickSize;
  const LabelVolume& labels = *by.grid;
  glm::dvec3 start(gridFromVoxel * glm::dvec4(x, y, z, 1.0)), step(gridFromVoxel[0]);
  if (glm::any(glm::greaterThan(glm::abs(start) + glm::abs(step) * double(end - x), glm::dvec3(kFar)))) return;
  std::int64_t at[3], walk[3];
  for (int axis = 0; axis < 3; ++axis) {
    at[axis] = std::llround((start[axis] + 0.5) * kOne);
    walk[axis] = std::llround(step[axis] * kOne);
  }
  glm::ivec3 current(-1);
  const LabelVolume::Brick* brick = nullptr;
  for (int i = 0; i < end - x; ++i, at[0] += walk[0], at[1] += walk[1], at[2] += walk[2]) {
    glm::ivec3 voxel(int(at[0] >> 32), int(at[1] >> 32), int(at[2] >> 32));
    bool inside = unsigned(voxel.x) < unsigned(labels.dims().x) && unsigned(voxel.y) < unsigned(labels.dims().y) &&
                  unsigned(voxel.z) < unsigned(labels.dims().z);
    if (!inside) {
      out[i] += by.strengths[0];
      continue;
    }
    if (glm::ivec3 index = voxel / kBrick; index != current) {
      current = index;
      brick = &labels.brick(index);
    }
    glm::ivec3 in = voxel - current * kBrick;
    out[i] +=
        by.strengths[brick->size() == 1 ? (*brick)[0] : (*brick)[std::size_t((in.z * kBrick + in.y) * kBrick + in.x)]];
  }
}

void StrengthRows::addMeans(const ByNumber& by, int x, int end, int y, int z, float* out) {
  glm::dvec3 from(by.gridFromVoxel * glm::dvec4(x, y, z, 1.0)), to(by.gridFromVoxel * glm::dvec4(end - 1, y, z, 1.0));
  glm::dvec3 around(0.0);
  for (int axis = 0; axis < 3; ++axis) around += glm::abs(glm::dvec3(by.gridFromVoxel[axis]));
  glm::dvec3 low = glm::min(from, to) - around, high = glm::max(from, to) + around;
  if (glm::any(glm::lessThan(high, glm::dvec3(0.0))) || glm::any(glm::greaterThan(low, glm::dvec3(by.grid->dims()))))
    return;  // most rows of a volume have nothing of a model
  thread_local std::vector<float> sums;
  sums.assign(std::size_t(end - x), 0.0f);
  glm::dmat4 shifted = by.gridFromVoxel;
  for (int i = 0; i < by.samples.x * by.samples.y * by.samples.z; ++i) {
    glm::ivec3 at(i % by.samples.x, i / by.samples.x % by.samples.y, i / (by.samples.x * by.samples.y));
    glm::dvec3 off = (glm::dvec3(at) + 0.5) / glm::dvec3(by.samples) - 0.5;
    shifted[3] = by.gridFromVoxel * glm::dvec4(off, 1.0);
    addNearest(by, shifted, x, end, y, z, sums.data());
  }
  float share = 1.0f / float(by.samples.x * by.samples.y * by.samples.z);
  for (std::size_t i = 0; i < sums.size(); ++i) out[i] += share * sums[i];
}

void StrengthRows::leaveOutSmall(int x, int end, std::size_t row, float* out) const {
  for (VoxelRun run : mSmall->runsOf(row)) {
    int from = std::max(int(run.x), x), to = std::min(int(run.end), end);
    if (from < to) std::fill(out + (from - x), out + (to - x), 0.0f);
  }
}

void StrengthRows::fillOfVolume(int x, int end, int y, int z, float* out) const {
  glm::ivec3 dims = mSource.volume ? mSource.volume->dims : mSource.dims;
  std::ptrdiff_t first = (std::ptrdiff_t(z) * dims.y + y) * dims.x + x;
  if (mHasValues)
    fillValues(first, end - x, out);
  else
    std::fill_n(out, end - x, 0.0f);
  if (mSmall) leaveOutSmall(x, end, std::size_t(z) * std::size_t(dims.y) + std::size_t(y), out);
  if (mGradients) {
    const std::uint16_t* codes = mGradients->codes.data() + first;
    for (int i = 0; i < end - x; ++i) out[i] += mByCode[codes[i]];
  }
}

void StrengthRows::fill(int x, int end, int y, int z, float* out) const {
  std::fill_n(out, end - x, 0.0f);
  if (mHasValues || mGradients) {
    glm::ivec3 from = mSource.volumeFrom, dims = mSource.volume->dims;
    int low = std::max(x, from.x), high = std::min(end, from.x + dims.x), row = y - from.y, layer = z - from.z;
    if (low < high && row >= 0 && row < dims.y && layer >= 0 && layer < dims.z)
      fillOfVolume(low - from.x, high - from.x, row, layer, out + (low - x));
  }
  if (mLabels.grid) addNumbers(mLabels, x, end, y, z, out);
  if (!mTypes.grid) return;
  if (mTypes.samples == glm::ivec3(1))
    addNumbers(mTypes, x, end, y, z, out);
  else
    addMeans(mTypes, x, end, y, z, out);
}

}  // namespace velum::membrane
