#include "session/structure/StructureSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <vector>

#include "core/LabelCover.h"
#include "core/Parallel.h"

namespace velum::session {

namespace {

constexpr int kDirections = 13;
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

using CountsById = std::unordered_map<std::uint16_t, Counts>;

/// The ids of a brick, with those of the voxels around it, which are 0 beyond the grid.
class BrickCells {
 public:
  BrickCells() {
    for (std::size_t k = 0; k < kDirections; ++k)
      mOffsets[k] = (kSteps[k].z * kWidth + kSteps[k].y) * kWidth + kSteps[k].x;
  }

  void read(const LabelVolume& labels, glm::ivec3 brick) {
    mDims = labels.dims();
    mFirst = brick * kBrick;
    mSize = glm::min(mDims - mFirst, glm::ivec3(kBrick));
    glm::ivec3 low = glm::max(mFirst - 1, glm::ivec3(0)), high = glm::min(mFirst + mSize + 1, mDims), size = high - low;
    mRead.resize(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    labels.read(low, size, mRead);
    std::fill(mCells.begin(), mCells.end(), std::uint16_t(0));
    const std::uint16_t* from = mRead.data();
    for (int z = low.z; z < high.z; ++z)
      for (int y = low.y; y < high.y; ++y, from += size.x) std::copy_n(from, size.x, cellAt({low.x, y, z}));
  }

  /// Adds what changes from each voxel of the brick to its neighbours: to those ahead of it, and to those before it
  /// that lie beyond the grid, so that each pair counts once.
  void count(CountsById& counts) {
    std::uint16_t known = 0;
    Counts* ofKnown = nullptr;
    auto add = [&](std::uint16_t id, std::size_t k) {
      if (!ofKnown || id != known) ofKnown = &counts[known = id];
      ++(*ofKnown)[k];
    };
    for (int z = 0; z < mSize.z; ++z)
      for (int y = 0; y < mSize.y; ++y) {
        const std::uint16_t* row = cellAt(mFirst + glm::ivec3(0, y, z));
        for (std::size_t k = 0; k < kDirections; ++k)
          for (int x = 0; x < mSize.x; ++x) {
            std::uint16_t here = row[x], there = row[x + mOffsets[k]];
            if (here != there) add(here, k), add(there, k);
            if (here != 0 && isBeyond(mFirst + glm::ivec3(x, y, z) - kSteps[k])) add(here, k);
          }
      }
  }

 private:
  static constexpr int kBrick = LabelVolume::kBrickSize, kWidth = kBrick + 2;
  std::uint16_t* cellAt(glm::ivec3 voxel) {
    glm::ivec3 at = voxel - mFirst + 1;
    return mCells.data() + (at.z * kWidth + at.y) * kWidth + at.x;
  }
  bool isBeyond(glm::ivec3 voxel) const {
    return glm::any(glm::greaterThanEqual(glm::uvec3(voxel), glm::uvec3(mDims)));
  }
  glm::ivec3 mDims{0}, mFirst{0}, mSize{0};
  std::array<int, kDirections> mOffsets{};
  std::vector<std::uint16_t> mCells = std::vector<std::uint16_t>(std::size_t(kWidth) * kWidth * kWidth), mRead;
};

/// No surface passes through or along a brick.
bool isPlain(const LabelVolume& labels, glm::ivec3 brick) {
  glm::ivec3 last = labels.brickGrid() - 1;
  bool isInside = glm::all(glm::greaterThan(brick, glm::ivec3(0))) && glm::all(glm::lessThan(brick, last));
  return isUniformAround(labels, brick) && (isInside || labels.brick(brick)[0] == 0);
}

CountsById countChanges(const LabelVolume& labels, Progress& progress) {
  auto body = [&](int first, int end) {
    CountsById counts;
    BrickCells cells;
    glm::ivec3 grid = labels.brickGrid(), at;
    for (at.z = first; at.z < end; ++at.z)
      for (at.y = 0; at.y < grid.y; ++at.y) {
        progress.throwIfCancelled();
        for (at.x = 0; at.x < grid.x; ++at.x) {
          if (isPlain(labels, at)) continue;
          cells.read(labels, at);
          cells.count(counts);
        }
      }
    return counts;
  };
  auto join = [](CountsById a, const CountsById& b) {
    for (const auto& [id, counts] : b)
      for (std::size_t k = 0; k < kDirections; ++k) a[id][k] += counts[k];
    return a;
  };
  return parallelReduce(0, labels.brickGrid().z, 1, CountsById(), body, join);
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
  auto counts = countChanges(labels, progress);
  double voxel = std::abs(glm::determinant(axes));
  std::map<int, double> areas;
  for (std::uint16_t id : labels.idsInUse()) {
    // A line of a direction has the voxel's volume over the step's length to itself.
    double area = 0.0;
    for (std::size_t k = 0; k < kDirections; ++k) area += 2.0 * weights[k] * double(counts[id][k]) * voxel / lengths[k];
    areas[id] = area;
  }
  return areas;
}

}  // namespace velum::session
