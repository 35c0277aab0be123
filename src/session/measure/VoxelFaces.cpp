#include "session/measure/VoxelFaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "core/LabelCover.h"
#include "core/Parallel.h"

namespace velum::session {

namespace {

constexpr int kBrickEdge = LabelVolume::kBrickSize;
/// The six ways out of a voxel; the opposite one of i is i ^ 1.
constexpr std::array<glm::ivec3, 6> kWays = {{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};

/// A patch is all faces of one way in a cell. Where voxels are long, cells hold several of them side by side, so that
/// they are about as wide as long: steps between layers are wide, too.
using PatchKey = std::uint64_t;

class Cells {
 public:
  explicit Cells(const LabelVolume& labels) {
    constexpr double kMost = 16.0;
    glm::dmat3 axes(labels.worldFromVoxel());
    glm::dvec3 edges(glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]));
    mWidth = std::max({edges.x, edges.y, edges.z});
    mVoxels = glm::ivec3(glm::round(glm::clamp(mWidth / edges, 1.0, kMost)));
    mCount = labels.dims() / mVoxels + 1;
  }
  PatchKey patchOf(glm::ivec3 voxel, std::size_t way) const {
    glm::ivec3 cell = voxel / mVoxels;
    auto row = PatchKey(cell.z) * PatchKey(mCount.y) + PatchKey(cell.y);
    return (row * PatchKey(mCount.x) + PatchKey(cell.x)) * 6 + way;
  }
  double width() const { return mWidth; }

 private:
  glm::ivec3 mVoxels{1}, mCount{1};
  double mWidth = 0.0;
};

/// A face, and the patches of the four faces that it shares its edges with.
struct LinkedFace {
  glm::ivec3 voxel{0};
  std::uint32_t way = 0;
  PatchKey own = 0;
  std::array<PatchKey, 4> beside{};
};

/// The faces of a brick and its surroundings.
class BrickFaces {
 public:
  BrickFaces(const LabelVolume& labels, const Cells& cells, std::uint16_t structure, glm::ivec3 first, glm::ivec3 size)
      : mDims(labels.dims()),
        mCells(cells),
        mStructure(structure),
        mFrom(first - 1),
        mSize(size + 2),
        mIds(readAround(labels, mFrom, mSize)) {}

  std::vector<LinkedFace> all() const {
    std::vector<LinkedFace> faces;
    glm::ivec3 v;
    for (v.z = 1; v.z + 1 < mSize.z; ++v.z)
      for (v.y = 1; v.y + 1 < mSize.y; ++v.y)
        for (v.x = 1; v.x + 1 < mSize.x; ++v.x) {
          if (!holds(mFrom + v)) continue;
          for (std::size_t way = 0; way < 6; ++way)
            if (!holds(mFrom + v + kWays[way])) faces.push_back(linked(mFrom + v, way));
        }
    return faces;
  }

 private:
  bool holds(glm::ivec3 voxel) const {
    if (glm::any(glm::lessThan(voxel, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(voxel, mDims))) return false;
    glm::ivec3 at = voxel - mFrom;
    return mIds[(std::size_t(at.z) * std::size_t(mSize.y) + std::size_t(at.y)) * std::size_t(mSize.x) +
                std::size_t(at.x)] == mStructure;
  }
  LinkedFace linked(glm::ivec3 voxel, std::size_t way) const {
    LinkedFace face{voxel, std::uint32_t(way), mCells.patchOf(voxel, way), {}};
    std::size_t count = 0;
    for (std::size_t to = 0; to < 6; ++to) {
      if (to / 2 == way / 2) continue;
      glm::ivec3 flat = voxel + kWays[to], up = flat + kWays[way];
      // Into a corner, straight on, or round an edge.
      face.beside[count++] = holds(up)     ? mCells.patchOf(up, to ^ 1)
                             : holds(flat) ? mCells.patchOf(flat, way)
                                           : mCells.patchOf(voxel, to);
    }
    return face;
  }

  glm::ivec3 mDims;
  const Cells& mCells;
  std::uint16_t mStructure;
  glm::ivec3 mFrom, mSize;
  std::vector<std::uint16_t> mIds;
};

std::vector<LinkedFace> linkedFaces(const LabelVolume& labels, const Cells& cells, std::uint16_t structure,
                                    glm::ivec3 low, glm::ivec3 high, Progress& progress) {
  glm::ivec3 firstBrick = low / kBrickEdge, bricks = high / kBrickEdge - firstBrick + 1;
  std::vector<std::vector<LinkedFace>> parts(std::size_t(bricks.x) * std::size_t(bricks.y) * std::size_t(bricks.z));
  parallelFor(std::size_t(0), parts.size(), [&](std::size_t i) {
    progress.throwIfCancelled();
    auto at = int(i);
    glm::ivec3 index = firstBrick + glm::ivec3(at % bricks.x, at / bricks.x % bricks.y, at / bricks.x / bricks.y);
    glm::ivec3 from = glm::max(index * kBrickEdge, low), to = glm::min((index + 1) * kBrickEdge, high + 1);
    bool isOutermost =
        glm::any(glm::equal(index, glm::ivec3(0))) || glm::any(glm::equal(index, labels.brickGrid() - 1));
    if (isUniformAround(labels, index) && (!isOutermost || labels.brick(index)[0] != structure)) return;
    parts[i] = BrickFaces(labels, cells, structure, from, to - from).all();
  });
  std::vector<LinkedFace> faces;
  for (const auto& part : parts) faces.insert(faces.end(), part.begin(), part.end());
  return faces;
}

using Means = std::vector<glm::dvec3>;

/// The mean vector area of a face of each patch, and how these are passed on to the patches around.
class Patches {
 public:
  /// @param wayAreas  vector area of a face of each way
  Patches(const std::vector<LinkedFace>& faces, const std::array<glm::dvec3, 6>& wayAreas) {
    std::vector<PatchKey> keys(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) keys[i] = faces[i].own;
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    auto numberOf = [&](PatchKey key) {
      return std::uint32_t(std::lower_bound(keys.begin(), keys.end(), key) - keys.begin());
    };
    mOwn.resize(faces.size());
    std::vector<std::array<std::uint32_t, 4>> beside(faces.size());
    parallelFor(std::size_t(0), faces.size(), [&](std::size_t i) {
      mOwn[i] = numberOf(faces[i].own);
      for (std::size_t k = 0; k < 4; ++k) beside[i][k] = numberOf(faces[i].beside[k]);
    });
    mCounts.resize(keys.size(), 0.0);
    mMeans.resize(keys.size());
    mFirstLinks.resize(keys.size() + 1, 0);
    for (std::size_t i = 0; i < faces.size(); ++i) {
      mCounts[mOwn[i]] += 1.0;
      mMeans[mOwn[i]] = wayAreas[faces[i].way];
      for (std::uint32_t other : beside[i]) mFirstLinks[mOwn[i] + 1] += other != mOwn[i];
    }
    for (std::size_t p = 0; p < keys.size(); ++p) mFirstLinks[p + 1] += mFirstLinks[p];
    mLinks.resize(mFirstLinks.back());
    std::vector<std::size_t> next(mFirstLinks.begin(), mFirstLinks.end() - 1);
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (std::uint32_t other : beside[i])
        if (other != mOwn[i]) mLinks[next[mOwn[i]]++] = other;
  }

  /// Means over faces further around; what all faces have together stays.
  void spread(int rounds, Progress& progress) {
    constexpr double kShare = 0.2;  // through each edge: a face and its four neighbours count alike
    Means next(mMeans.size());
    for (; rounds > 0; --rounds) {
      progress.throwIfCancelled();
      parallelFor(std::size_t(0), next.size(), [&](std::size_t p) {
        glm::dvec3 gain(0.0);
        for (std::size_t i = mFirstLinks[p]; i < mFirstLinks[p + 1]; ++i) gain += mMeans[mLinks[i]] - mMeans[p];
        next[p] = mMeans[p] + kShare / mCounts[p] * gain;
      });
      mMeans.swap(next);
    }
  }
  const Means& means() const { return mMeans; }
  std::uint32_t patchOf(std::size_t face) const { return mOwn[face]; }

 private:
  std::vector<std::uint32_t> mOwn, mLinks;  ///< patch of each face; patches beside each patch, once a shared edge
  std::vector<std::size_t> mFirstLinks;
  std::vector<double> mCounts;
  Means mMeans;
};

/// A vector area as it is seen along a direction.
double seenAlong(const glm::dvec3& direction, const glm::dvec3& area) {
  double length = glm::length(direction);
  return length > 0.0 ? glm::dot(area, direction) / length : 0.0;
}

/// Means at two widths, one twice the other.
struct MeanPair {
  const Means &narrow, &wide;
  double steps;  ///< factor that makes up for steps that the narrow one has not quite levelled

  /// Where what is round is no wider than the mean, the mean vanishes.
  bool isTooWide(std::uint32_t patch) const {
    constexpr double kVanishing = 0.5;
    return glm::length(wide[patch]) < kVanishing * glm::length(narrow[patch]);
  }
  /// What is rounded off grows with the width: as much as from narrow to wide is missing at narrow.
  double areaOf(std::uint32_t patch, const glm::dvec3& area) const {
    double near = seenAlong(narrow[patch], area);
    return steps * (isTooWide(patch) ? near : 2.0 * near - seenAlong(wide[patch], area));
  }
};

std::array<glm::dvec3, 6> wayAreasOf(const glm::dmat4& worldFromVoxel) {
  glm::dmat3 axes(worldFromVoxel);
  glm::dmat3 areas = std::abs(glm::determinant(axes)) * glm::transpose(glm::inverse(axes));
  std::array<glm::dvec3, 6> ways;
  for (std::size_t i = 0; i < ways.size(); ++i) ways[i] = areas * glm::dvec3(kWays[i]);
  return ways;
}

/// Three volumes by the surface, as of a ball its radius, in lengths.
double thicknessOf(const std::vector<LinkedFace>& faces, const Patches& patches, const glm::dmat4& worldFromVoxel,
                   const std::array<glm::dvec3, 6>& areas) {
  double surface = 0.0, volumes = 0.0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    glm::dvec3 middle = glm::dvec3(faces[i].voxel - faces[0].voxel) + 0.5 * glm::dvec3(kWays[faces[i].way]);
    const glm::dvec3& area = areas[faces[i].way];
    surface += seenAlong(patches.means()[patches.patchOf(i)], area);
    volumes += glm::dot(glm::dmat3(worldFromVoxel) * middle, area);  // by Gauss, about the first voxel
  }
  return surface > 0.0 ? volumes / surface : 0.0;
}

/// Rounds of spreading, an even number, for what is so many cells thick.
int roundsFor(double thickness) {
  constexpr double kLeast = 7.0, kBySquare = 1.0 / 6.0, kFewest = 8.0, kMost = 24.0;
  return 4 * int(std::lround(std::clamp(kLeast + kBySquare * thickness * thickness, kFewest, kMost) / 4.0));
}

/// Makes up for steps that are left: balls and ellipsoids of all sizes come out too large by so much.
double stepsAfter(int rounds) { return 1.0 / (1.0 + 0.65 / (double(rounds) * rounds)); }

}  // namespace

std::vector<VoxelFace> voxelFaces(const LabelVolume& labels, std::uint16_t structure, glm::ivec3 low, glm::ivec3 high,
                                  Progress& progress) {
  Cells cells(labels);
  std::vector<LinkedFace> linked = linkedFaces(labels, cells, structure, low, high, progress);
  std::array<glm::dvec3, 6> areas = wayAreasOf(labels.worldFromVoxel());
  Patches patches(linked, areas);
  constexpr int kFirst = 4;  // half of the fewest
  patches.spread(kFirst, progress);
  int rounds = roundsFor(thicknessOf(linked, patches, labels.worldFromVoxel(), areas) / cells.width());
  std::array<Means, 4> means;
  for (int i = 0, spread = kFirst; i < 4; ++i) {
    int wanted = rounds / 2 << i;
    patches.spread(wanted - spread, progress);
    spread = wanted;
    means[std::size_t(i)] = patches.means();
  }
  MeanPair wanted{means[1], means[3], stepsAfter(rounds)}, halved{means[0], means[2], stepsAfter(rounds / 2)};
  std::vector<VoxelFace> faces(linked.size());
  parallelFor(std::size_t(0), faces.size(), [&](std::size_t i) {
    const glm::ivec3& way = kWays[linked[i].way];
    std::uint32_t patch = patches.patchOf(i);
    const MeanPair& pair = wanted.isTooWide(patch) ? halved : wanted;
    faces[i] = {linked[i].voxel, way, pair.areaOf(patch, areas[linked[i].way])};
  });
  return faces;
}

}  // namespace velum::session
