#include "membrane/forces/Attraction.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/Assert.h"
#include "core/Parallel.h"
#include "membrane/forces/BuildLattice.h"
#include "membrane/forces/FrameBox.h"

namespace velum::membrane {

namespace {

/// What a wall of the area of a column's top costs: the gain of a column whose strength is this. A patch is followed to
/// a height of (strength / kWall / 4) times its edge, so that specks of noise of the usual strength (100) are not.
constexpr double kWall = 25.0;
/// What a column's edge of distance from the rest plane costs, and at most.
constexpr double kAway = 1.0, kMostAway = 10.0;
/// Strengths beyond the largest of one curve may add up.
constexpr float kStrongest = 4000.0f;
/// Within a stretch of what attracts alike its middle draws more than its ends, by this share.
constexpr double kMiddle = 0.25;
/// So many layers to either side say where between two of them the sheet lies.
constexpr int kAround = 2;
/// How far the sheet may be from there, in layers: room to be smooth.
constexpr double kSlack = 0.5;

}  // namespace

Attraction::Attraction(const CutLattice& lattice, std::span<const float> strengths, const ProtectedVoxels& grid,
                       const scene::Cut& cut)
    : mDims(lattice.dims), mStep(lattice.step), mRestLayer(lattice.restLayer) {
  glm::ivec3 size = grid.box.end - grid.box.min;
  VELUM_ASSERT(strengths.size() == std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z),
               "each voxel of the box has its strength");
  glm::dmat4 voxelFromLocal = glm::inverse(FrameBox(cut, grid.worldFromVoxel).localFromVoxel);
  mDraw.resize(std::size_t(mDims.x) * std::size_t(mDims.y) * std::size_t(mDims.z));
  std::atomic<int> most = 0;
  parallelFor(0, mDims.y, [&](int y) {
    int own = 0;
    for (int x = 0; x < mDims.x; ++x) {
      std::size_t column = std::size_t(y) * std::size_t(mDims.x) + std::size_t(x);
      for (int z = 1; z + 1 < mDims.z; ++z) {
        glm::dvec3 local = lattice.origin + glm::dvec3(x, y, z) * lattice.step;
        glm::ivec3 v = glm::ivec3(glm::round(glm::dvec3(voxelFromLocal * glm::dvec4(local, 1.0)))) - grid.box.min;
        if (!isWithin(size, v)) continue;
        float strength = strengths[(std::size_t(v.z) * std::size_t(size.y) + std::size_t(v.y)) * std::size_t(size.x) +
                                   std::size_t(v.x)];
        if (strength >= 0.0f) continue;
        mDraw[column * std::size_t(mDims.z) + std::size_t(z)] =
            std::uint16_t(std::ceil(std::min(-strength, kStrongest)));
      }
      favourMiddles(column);
      for (int z = 0; z < mDims.z; ++z) own = std::max(own, at(column, z));
    }
    int now = most.load();
    while (now < own && !most.compare_exchange_weak(now, own)) {
    }
  });
  mMost = most;
}

/// A sheet is to lie in the middle of a stretch that attracts alike, not at the face that it comes upon first.
void Attraction::favourMiddles(std::size_t column) {
  std::uint16_t* draw = mDraw.data() + column * std::size_t(mDims.z);
  for (int z = 0; z < mDims.z; ++z) {
    if (draw[z] == 0) continue;
    int end = z;
    double sum = 0.0, moment = 0.0;
    for (; end < mDims.z && draw[end] > 0; ++end) {
      sum += draw[end];
      moment += double(draw[end]) * end;
    }
    double middle = moment / sum, half = 0.5 * (end - z);
    for (int k = z; k < end; ++k)
      draw[k] = std::uint16_t(std::ceil(draw[k] * (1.0 - kMiddle * std::min(std::abs(k - middle) / half, 1.0))));
    z = end;
  }
}

CutLattice Attraction::costs() const {
  double across = std::sqrt(mStep.x * mStep.y);
  int wall[2] = {std::max(int(std::lround(kWall * mStep.z / mStep.x)), 1),
                 std::max(int(std::lround(kWall * mStep.z / mStep.y)), 1)};
  return buildLattice(mDims, mRestLayer, 1, [&](const auto& add) {
    parallelFor(0, mDims.y, [&](int y) {
      for (int x = 0; x < mDims.x; ++x) {
        std::size_t column = std::size_t(y) * std::size_t(mDims.x) + std::size_t(x);
        for (int z = 0; z < mDims.z; ++z) {
          double away = std::abs(z + 0.5 - mRestLayer) * mStep.z / across;
          // It lies on what it touches; between two that attract it is surer.
          int on = std::max(at(column, z), at(column, z + 1)), unsure = std::min(at(column, z), at(column, z + 1)) == 0;
          add(glm::ivec3(x, y, z), 2, mMost - on + unsure + int(std::min(kAway * away, kMostAway)));
          add(glm::ivec3(x, y, z), 0, wall[0]);
          add(glm::ivec3(x, y, z), 1, wall[1]);
        }
      }
    });
  });
}

std::optional<double> Attraction::layerAt(std::size_t column, int below) const {
  if (at(column, below - 1) == 0 && at(column, below) == 0) return std::nullopt;
  double sum = 0.0, moment = 0.0;
  auto take = [&](int z) {
    sum += at(column, z);
    moment += double(at(column, z)) * z;
    return at(column, z) > 0;
  };
  for (int z = below - 1; z >= below - kAround && take(z); --z) {
  }
  for (int z = below; z < below + kAround && take(z); ++z) {
  }
  return std::clamp(moment / sum, below - 1.0, double(below));
}

LeastCut drawnCut(const CutLattice& lattice, const LeastCut& least, const Attraction& attraction, Progress& progress) {
  std::vector<SheetRange> ranges;
  for (glm::ivec2 gap : least.gap) ranges.push_back({gap.x + 1, gap.y});
  return sheetAt(lattice, computeCutWithin(attraction.costs(), ranges, progress).below);
}

void leadTo(Corridor& corridor, const CutLattice& lattice, const LeastCut& drawn, const Attraction& attraction) {
  corridor.isDrawn = true;
  auto slack = float(kSlack * lattice.step.z);
  parallelFor(std::size_t(0), corridor.room.size(), [&](std::size_t column) {
    auto layer = attraction.layerAt(column, drawn.below[column]);
    if (!layer) return;
    // What is protected has the first say.
    glm::vec2& room = corridor.room[column];
    if (room.x > room.y) return;
    float height = std::clamp(float(lattice.origin.z + *layer * lattice.step.z), room.x, room.y);
    room = {std::max(room.x, height - slack), std::min(room.y, height + slack)};
    corridor.height[column] = height;
  });
}

}  // namespace velum::membrane
