#include "membrane/forces/Corridor.h"

#include <algorithm>
#include <cmath>

#include "core/Assert.h"
#include "core/Parallel.h"
#include "scene/Scene.h"

namespace velum::membrane {

namespace {

/// How far the sheet keeps from the middles of nodes that it must not pass, in layers, where there is room: the surface
/// of what is protected lies about half a voxel beyond its outermost voxels, and its soft edge a voxel further. To all
/// sides, as if the nodes were balls: a distance up and down alone would leave walls of the lattice. The balls are so
/// large that they are round on it, and sunk, so that up and down the sheet keeps 1.48 layers only (with 1.5 rounding
/// would decide whether there is room in a gap of three).
constexpr double kBall = 2.1, kSunk = 0.62;
/// And where there is none: this share of the gap to either side.
constexpr double kShareOfGap = 0.4;

/// Where the sheet must pass through what is protected it may leave the least cut by so many layers, so that it is
/// smooth there, rather than made of steps.
constexpr int kSmoothing = 1;
/// So far from nodes it is clear on which side of them the sheet is, in layers.
constexpr double kBesideNode = 0.25;

/// What a column's sheet separates, its neighbours' sheets being where they are. Neighbours that themselves cut through
/// what is protected at about the same height do not count.
class ColumnCost {
 public:
  ColumnCost(const CutLattice& lattice, std::span<const int> below, glm::ivec2 at)
      : mLattice(lattice), mBelow(below), mAt(at), mHeight(below[std::size_t(at.y * lattice.dims.x + at.x)]) {
    mIsCutting = pair(2, at, mHeight - 1) > 0.0;
  }

  double separated(int b) const {
    double sum = pair(2, mAt, b - 1);
    for (int side = 0; side < 4; ++side) {
      int axis = side / 2;
      glm::ivec2 other = mAt, low = mAt;
      other[axis] += side % 2 ? 1 : -1;
      if (other[axis] < 0 || other[axis] >= mLattice.dims[axis]) continue;
      low[axis] = std::min(mAt[axis], other[axis]);
      int there = mBelow[std::size_t(other.y * mLattice.dims.x + other.x)];
      if (mIsCutting && std::abs(there - mHeight) <= 2 * kSmoothing && pair(2, other, there - 1) > 0.0) continue;
      for (int z = std::min(b, there); z < std::max(b, there); ++z) sum += pair(axis, low, z);
    }
    return sum;
  }

  bool isCutting() const { return mIsCutting; }

  /// The last height in a direction that separates no more than its own. @param gap  to where that is known
  int freeTo(int gap, int step) const {
    double now = separated(mHeight);
    int b = mIsCutting ? mHeight : std::clamp(gap, 1, mLattice.dims.z - 1);
    int last = mIsCutting ? mHeight + kSmoothing * step : b + mLattice.dims.z * step;
    while (b != last && b + step >= 1 && b + step < mLattice.dims.z && separated(b + step) <= now) b += step;
    return b;
  }

 private:
  double pair(int axis, glm::ivec2 at, int z) const { return pairsAt(mLattice, {at.x, at.y, z}, axis); }
  const CutLattice& mLattice;
  std::span<const int> mBelow;
  glm::ivec2 mAt;
  int mHeight = 0;
  bool mIsCutting = false;  ///< its sheet passes through what is protected
};

struct ColumnRoom {
  double low = 0.0, high = 0.0;
  bool isCutting = false;  ///< these are bounds to what is cut, not obstacles
};

/// Takes from the room of each column what is too near to what it or its neighbours must not pass. Where nothing would
/// be left the sheet keeps to the middle of its own room. @param step  of a layer
void keepClear(Corridor& corridor, const std::vector<ColumnRoom>& room, double step) {
  struct Neighbour {
    glm::ivec2 step;
    double rise;
  };
  std::vector<Neighbour> ball;
  double radius = kBall * step, sunk = kSunk * step, clear = radius - sunk;
  glm::ivec2 most(glm::floor(radius / corridor.step));
  for (int y = -most.y; y <= most.y; ++y)
    for (int x = -most.x; x <= most.x; ++x) {
      glm::dvec2 away = glm::dvec2(x, y) * corridor.step;
      double rest = radius * radius - glm::dot(away, away);
      if (rest > 0.0) ball.push_back({{x, y}, std::sqrt(rest) - sunk});
    }
  glm::ivec2 n = corridor.dims;
  parallelFor(0, n.y, [&](int y) {
    for (int x = 0; x < n.x; ++x) {
      std::size_t i = std::size_t(y * n.x + x);
      const ColumnRoom& own = room[i];
      if (own.isCutting) {
        corridor.room[i] = {float(own.low + kBesideNode * step), float(own.high - kBesideNode * step)};
        continue;
      }
      glm::dvec2 free(own.low, own.high);
      for (const Neighbour& neighbour : ball) {
        glm::ivec2 at = glm::clamp(glm::ivec2(x, y) + neighbour.step, glm::ivec2(0), n - 1);
        const ColumnRoom& other = room[std::size_t(at.y * n.x + at.x)];
        // To what is cut the sheet comes down, but not in a wall of columns.
        double rise = other.isCutting ? neighbour.rise - clear : neighbour.rise;
        free.x = std::max(free.x, other.low + rise);
        free.y = std::min(free.y, other.high - rise);
      }
      if (free.x > free.y) {
        double margin = std::min(clear, kShareOfGap * (own.high - own.low));
        free = {own.low + margin, own.high - margin};
      }
      corridor.room[i] = glm::vec2(free);
    }
  });
}

}  // namespace

Corridor corridorAround(const CutLattice& lattice, const LeastCut& cut) {
  VELUM_ASSERT(cut.dims == glm::ivec2(lattice.dims), "the sheet is one of this lattice");
  Corridor corridor;
  corridor.dims = glm::ivec2(lattice.dims);
  corridor.origin = glm::dvec2(lattice.origin);
  corridor.step = glm::dvec2(lattice.step);
  corridor.room.resize(cut.below.size());
  corridor.height.resize(cut.below.size());
  double step = lattice.step.z;
  std::vector<ColumnRoom> room(cut.below.size());
  parallelFor(0, lattice.dims.y, [&](int y) {
    for (int x = 0; x < lattice.dims.x; ++x) {
      std::size_t i = std::size_t(y * lattice.dims.x + x);
      ColumnCost cost(lattice, cut.below, {x, y});
      glm::ivec2 gap = cut.gap[i];
      double low = lattice.origin.z + (cost.freeTo(gap.x + 1, -1) - 1) * step;
      double high = lattice.origin.z + cost.freeTo(gap.y, 1) * step;
      room[i] = {low, high, cost.isCutting()};
      corridor.height[i] = float(lattice.origin.z + (cut.below[i] - 0.5) * step);
    }
  });
  keepClear(corridor, room, step);
  return corridor;
}

HeightOver heightOf(const Corridor& corridor) {
  return [dims = corridor.dims, origin = corridor.origin, step = corridor.step,
          height = corridor.height](glm::dvec2 local) {
    glm::dvec2 at = glm::clamp((local - origin) / step, glm::dvec2(0.0), glm::dvec2(dims - 1));
    glm::ivec2 low = glm::min(glm::ivec2(at), glm::max(dims - 2, 0)), high = glm::min(low + 1, dims - 1);
    glm::dvec2 part = at - glm::dvec2(low);
    auto of = [&](int x, int y) { return double(height[std::size_t(y) * std::size_t(dims.x) + std::size_t(x)]); };
    return std::lerp(std::lerp(of(low.x, low.y), of(high.x, low.y), part.x),
                     std::lerp(of(low.x, high.y), of(high.x, high.y), part.x), part.y);
  };
}

std::vector<glm::vec2> roomOf(const Corridor& corridor, std::span<const glm::vec3> places, glm::dvec2 pitch) {
  VELUM_ASSERT(corridor.room.size() == std::size_t(corridor.dims.x) * std::size_t(corridor.dims.y),
               "each column has its room");
  std::vector<glm::vec2> room;
  if (corridor.dims.x == 0) return room;
  glm::dvec2 own = glm::max(0.5 * (pitch / corridor.step - 1.0), 0.0);
  for (glm::vec3 place : places) {
    glm::dvec2 at = (glm::dvec2(place) - corridor.origin) / corridor.step;
    auto column = [&](glm::dvec2 p) {
      return glm::clamp(glm::ivec2(glm::floor(p + 0.5)), glm::ivec2(0), corridor.dims - 1);
    };
    glm::ivec2 low = column(at - own), high = column(at + own), nearest = column(at);
    glm::vec2 all(-1e30f, 1e30f);
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        glm::vec2 one = corridor.room[std::size_t(y * corridor.dims.x + x)];
        all = {std::max(all.x, one.x), std::min(all.y, one.y)};
      }
    bool suitsAll = all.x <= all.y;
    room.push_back(suitsAll ? all : corridor.room[std::size_t(nearest.y * corridor.dims.x + nearest.x)]);
  }
  return room;
}

}  // namespace velum::membrane
