#include "session/structure/StructureSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/Parallel.h"

namespace velum::session {

namespace {

constexpr int kDirections = 13;
constexpr int kSlab = LabelVolume::kBrickSize;
/// The steps to one neighbour of each pair of opposite neighbours.
constexpr std::array<glm::ivec3, kDirections> kSteps = {{{1, 0, 0},
                                                         {-1, 1, 0},
                                                         {0, 1, 0},
                                                         {1, 1, 0},
                                                         {-1, -1, 1},
                                                         {0, -1, 1},
                                                         {1, -1, 1},
                                                         {-1, 0, 1},
                                                         {0, 0, 1},
                                                         {1, 0, 1},
                                                         {-1, 1, 1},
                                                         {0, 1, 1},
                                                         {1, 1, 1}}};

using Counts = std::array<std::uint64_t, kDirections>;

/// How much each direction counts so that a plane of any direction has its area, as nearly as may be.
/// Differs: [CROFTON] takes the parts of the sphere that lie next to a direction; here weights are fitted to 600 planes
/// by multiplicative steps, which is nearer where voxels are long, for their directions crowd.
std::array<double, kDirections> weightsOf(const std::array<glm::dvec3, kDirections>& units) {
  constexpr int kPlanes = 600, kRounds = 300;
  std::vector<std::array<double, kDirections>> seen(kPlanes);
  for (int i = 0; i < kPlanes; ++i) {
    double z = (i + 0.5) / kPlanes, angle = i * 2.399963229728653, r = std::sqrt(1.0 - z * z);
    glm::dvec3 normal(r * std::cos(angle), r * std::sin(angle), z);
    for (std::size_t k = 0; k < kDirections; ++k) seen[std::size_t(i)][k] = 2.0 * std::abs(glm::dot(normal, units[k]));
  }
  std::array<double, kDirections> weights, gain, total{};
  weights.fill(1.0 / kDirections);
  for (const auto& row : seen)
    for (std::size_t k = 0; k < kDirections; ++k) total[k] += row[k];
  for (int round = 0; round < kRounds; ++round) {
    gain.fill(0.0);
    for (const auto& row : seen) {
      double area = 0.0;
      for (std::size_t k = 0; k < kDirections; ++k) area += row[k] * weights[k];
      for (std::size_t k = 0; k < kDirections; ++k) gain[k] += row[k] / area;
    }
    for (std::size_t k = 0; k < kDirections; ++k) weights[k] *= gain[k] / total[k];
  }
  // Together 1: then a ball's area is exact.
  double sum = 0.0;
  for (double weight : weights) sum += weight;
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// Two planes of ids, as numbers of their places in a table, with a border of 0.
class Planes {
 public:
  explicit Planes(glm::ivec3 dims)
      : mWidth(std::size_t(dims.x) + 2), mRows(std::size_t(dims.y) + 2), mLower(cells(), 0), mUpper(cells(), 0) {}

  std::size_t width() const { return mWidth; }
  /// The upper plane becomes the lower one; `z` is read above it.
  void step(const LabelVolume& labels, int z, const std::vector<std::uint16_t>& places) {
    std::swap(mLower, mUpper);
    glm::ivec3 dims = labels.dims();
    if (z < 0 || z >= dims.z) {
      std::fill(mUpper.begin(), mUpper.end(), std::uint16_t(0));
      return;
    }
    mRead.resize(std::size_t(dims.x) * std::size_t(dims.y));
    labels.read({0, 0, z}, {dims.x, dims.y, 1}, mRead);
    for (std::size_t y = 0; y < std::size_t(dims.y); ++y)
      for (std::size_t x = 0; x < std::size_t(dims.x); ++x)
        mUpper[first() + (y + 1) * mWidth + x + 1] = places[mRead[y * std::size_t(dims.x) + x]];
  }
  /// Adds what changes from each cell of the lower plane to its neighbours.
  void count(std::vector<Counts>& counts) const {
    std::array<std::ptrdiff_t, kDirections> offsets;
    for (std::size_t k = 0; k < kDirections; ++k) offsets[k] = kSteps[k].y * std::ptrdiff_t(mWidth) + kSteps[k].x;
    const std::uint16_t* lower = mLower.data() + first();
    const std::uint16_t* upper = mUpper.data() + first();
    for (std::size_t i = 0; i < mWidth * mRows; ++i) {
      std::uint16_t here = lower[i];
      for (std::size_t k = 0; k < kDirections; ++k) {
        std::uint16_t there = (kSteps[k].z ? upper : lower)[std::ptrdiff_t(i) + offsets[k]];
        if (here == there) continue;
        ++counts[here][k];
        ++counts[there][k];
      }
    }
  }

 private:
  /// A row and a cell more on either side, for neighbours of the border.
  std::size_t first() const { return mWidth + 1; }
  std::size_t cells() const { return mWidth * mRows + 2 * first(); }

  std::size_t mWidth, mRows;
  std::vector<std::uint16_t> mLower, mUpper, mRead;
};

std::vector<Counts> countChanges(const LabelVolume& labels, const std::vector<std::uint16_t>& used,
                                 Progress& progress) {
  std::vector<std::uint16_t> places(65536, 0);
  for (std::size_t i = 0; i < used.size(); ++i) places[used[i]] = std::uint16_t(i + 1);
  std::vector<Counts> none(used.size() + 1, Counts{});
  auto body = [&](int from, int end) {
    progress.throwIfCancelled();
    std::vector<Counts> counts = none;
    Planes planes(labels.dims());
    planes.step(labels, from, places);
    for (int z = from; z < end; ++z) {
      planes.step(labels, z + 1, places);
      planes.count(counts);
    }
    return counts;
  };
  auto join = [](std::vector<Counts> a, const std::vector<Counts>& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t k = 0; k < kDirections; ++k) a[i][k] += b[i][k];
    return a;
  };
  // From the plane below the first one on.
  return parallelReduce(-1, labels.dims().z, kSlab, none, body, join);
}

}  // namespace

std::map<int, double> measureSurfaces(const LabelVolume& labels, Progress& progress) {
  glm::dmat3 axes(labels.worldFromVoxel());
  std::array<glm::dvec3, kDirections> units;
  std::array<double, kDirections> lengths;
  for (std::size_t k = 0; k < kDirections; ++k) {
    glm::dvec3 step = axes * glm::dvec3(kSteps[k]);
    lengths[k] = glm::length(step);
    units[k] = step / lengths[k];
  }
  auto weights = weightsOf(units);
  auto used = labels.idsInUse();
  auto counts = countChanges(labels, used, progress);
  double voxel = std::abs(glm::determinant(axes));
  std::map<int, double> areas;
  for (std::size_t i = 0; i < used.size(); ++i) {
    // A line of a direction has the voxel's volume over the step's length to itself.
    double area = 0.0;
    for (std::size_t k = 0; k < kDirections; ++k)
      area += 2.0 * weights[k] * double(counts[i + 1][k]) * voxel / lengths[k];
    areas[used[i]] = area;
  }
  return areas;
}

}  // namespace velum::session
