#include "membrane/forces/Pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/Parallel.h"

namespace velum::membrane {

namespace {

/// Fewer pieces of one voxel than this are no noise, but ends of structures. Clean phantoms have up to some dozens.
constexpr std::size_t kFewSpecks = 100;
/// And where they are a smaller share of what is protected, noise does no harm, and small pieces are ends as well.
constexpr double kFewOfAll = 0.005;
/// Of white noise there is at most a quarter as many pieces of two voxels as of one, of smoothed noise a third; of
/// thin structures that fall apart between voxels about as many.
constexpr double kSpeckFall = 0.4;
constexpr std::size_t kSizesLookedAt = 3;
/// A ratio of fewer pieces says little.
constexpr std::size_t kEnoughPieces = 30;

/// Runs of protected voxels, and which piece each belongs to: the one of its smallest run.
struct Runs {
  std::vector<std::uint32_t> first;  ///< of each row, and an end
  std::vector<VoxelRun> runs;
  std::vector<std::uint32_t> parent;

  std::uint32_t find(std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    if (a != b) parent[std::max(a, b)] = std::min(a, b);
  }
  /// Joins what lies side by side in two rows.
  void uniteRows(std::size_t row, std::size_t other) {
    std::uint32_t a = first[row], b = first[other];
    while (a < first[row + 1] && b < first[other + 1]) {
      if (runs[a].x < runs[b].end && runs[b].x < runs[a].end) unite(a, b);
      runs[a].end < runs[b].end ? ++a : ++b;
    }
  }
};

/// Layers are shared out in slabs of so many.
constexpr int kSlab = 16;

void appendRuns(const std::vector<float>& strengths, std::vector<VoxelRun>& runs) {
  auto count = std::uint32_t(strengths.size());
  for (std::uint32_t x = 0; x < count; ++x) {
    if (!(strengths[x] > 0.0f)) continue;
    VoxelRun run{x, x + 1};
    while (run.end < count && strengths[run.end] > 0.0f) ++run.end;
    runs.push_back(run);
    x = run.end;
  }
}

Runs gatherRuns(glm::ivec3 dims, const std::function<void(int, int, float*)>& row, const Progress& progress) {
  Runs all;
  all.first.assign(std::size_t(dims.y) * std::size_t(dims.z) + 1, 0);
  std::vector<std::vector<VoxelRun>> slabs(std::size_t((dims.z + kSlab - 1) / kSlab));
  parallelFor(0, int(slabs.size()), [&](int slab) {
    std::vector<float> strengths(std::size_t(dims.x));
    auto& runs = slabs[std::size_t(slab)];
    for (int z = slab * kSlab; z < std::min((slab + 1) * kSlab, dims.z) && !progress.isCancelled(); ++z)
      for (int y = 0; y < dims.y; ++y) {
        std::size_t before = runs.size();
        row(y, z, strengths.data());
        appendRuns(strengths, runs);
        all.first[std::size_t(z) * std::size_t(dims.y) + std::size_t(y) + 1] = std::uint32_t(runs.size() - before);
      }
  });
  progress.throwIfCancelled();
  for (std::size_t i = 1; i < all.first.size(); ++i) all.first[i] += all.first[i - 1];
  all.runs.reserve(all.first.back());
  for (auto& slab : slabs) {
    all.runs.insert(all.runs.end(), slab.begin(), slab.end());
    slab = {};
  }
  return all;
}

/// Gives each run its piece: slabs by themselves, on all cores, then across their borders.
void joinRuns(Runs& all, glm::ivec3 dims, const Progress& progress) {
  all.parent.resize(all.runs.size());
  for (std::size_t i = 0; i < all.parent.size(); ++i) all.parent[i] = std::uint32_t(i);
  auto joinLayer = [&](int z, bool across) {
    auto inLayer = std::size_t(dims.y), from = std::size_t(z) * inLayer;
    for (std::size_t y = from; y < from + inLayer; ++y) {
      if (!across && y > from) all.uniteRows(y, y - 1);
      if (across) all.uniteRows(y, y - inLayer);
    }
  };
  parallelFor(0, (dims.z + kSlab - 1) / kSlab, [&](int slab) {
    int low = slab * kSlab;
    for (int z = low; z < std::min(low + kSlab, dims.z) && !progress.isCancelled(); ++z) {
      joinLayer(z, false);
      if (z > low) joinLayer(z, true);
    }
  });
  progress.throwIfCancelled();
  for (int z = kSlab; z < dims.z; z += kSlab) joinLayer(z, true);
  // A run's piece has a smaller number, and is known by then.
  for (auto& parent : all.parent) parent = all.parent[parent];
}

/// Voxels of each piece, at the place of its smallest run.
std::vector<std::uint32_t> sizesOf(const Runs& all) {
  std::vector<std::uint32_t> sizes(all.runs.size(), 0);
  for (std::size_t i = 0; i < all.runs.size(); ++i) sizes[all.parent[i]] += all.runs[i].end - all.runs[i].x;
  return sizes;
}

int leastOf(const std::vector<std::uint32_t>& sizes) {
  std::array<std::size_t, kSizesLookedAt> counts{};
  std::size_t largest = 0, all = 0;
  for (std::uint32_t size : sizes) {
    largest = std::max(largest, std::size_t(size));
    all += size;
    if (size >= 1 && size <= counts.size()) ++counts[size - 1];
  }
  return leastPieceByNoise(counts, largest, all);
}

}  // namespace

int leastPieceByNoise(std::span<const std::size_t> counts, std::size_t largest, std::size_t all) {
  if (counts.size() < 2 || counts[0] < kFewSpecks || double(counts[0]) < kFewOfAll * double(all) ||
      double(counts[1]) > kSpeckFall * double(counts[0]))
    return 1;
  // Larger pieces fall more slowly, as there are more shapes of them.
  double fall = double(std::max<std::size_t>(counts[1], 1)) / double(counts[0]);
  for (std::size_t i = 1; i + 1 < std::min(counts.size(), kSizesLookedAt) && counts[i + 1] >= kEnoughPieces; ++i)
    fall = std::max(fall, std::min(double(counts[i + 1]) / double(counts[i]), kSpeckFall));
  double least = 1.0 + std::ceil(std::log(double(counts[0])) / -std::log(fall));
  return int(std::clamp(least, 1.0, std::max(double(largest) / 10.0, 1.0)));
}

SmallPieces findSmallPieces(glm::ivec3 dims, int least, const std::function<void(int y, int z, float* strengths)>& row,
                            const Progress& progress) {
  SmallPieces small;
  small.least = std::max(least, 1);
  if (least == 0 || least == 1) return small;
  Runs all = gatherRuns(dims, row, progress);
  joinRuns(all, dims, progress);
  std::vector<std::uint32_t> sizes = sizesOf(all);
  if (least < 0) small.least = leastOf(sizes);
  for (std::uint32_t size : sizes) {
    small.protectedVoxels += size;
    if (size > 0 && size < std::uint32_t(small.least)) ++small.pieces, small.voxels += size;
  }
  if (small.pieces == 0) return small;
  small.first.reserve(all.first.size());
  small.first.push_back(0);
  for (std::size_t r = 0; r + 1 < all.first.size(); ++r) {
    for (std::uint32_t i = all.first[r]; i < all.first[r + 1]; ++i)
      if (sizes[all.parent[i]] < std::uint32_t(small.least)) small.runs.push_back(all.runs[i]);
    small.first.push_back(std::uint32_t(small.runs.size()));
  }
  return small;
}

}  // namespace velum::membrane
