// The lattice of a frame, and the least cut of it as a figure.
#include "membrane/forces/Limit.h"
#include "core/Assert.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <memory>

#include "membrane/forces/BuildLattice.h"
#include "membrane/forces/FrameBox.h"

namespace velum::membrane {

namespace {

/// Nodes along one axis of a frame, at first + i * step.
struct Nodes {
  double first = 0.0, step = 1.0;
  int count = 0;
};

/// The nodes that lie within `reach` of 0 and within the data's extent, and one more at both ends; those around 0 in
/// any case.
Nodes nodesWithin(double anchor, double step, double reach, glm::dvec2 extent) {
  constexpr double kSlack = 1e-6;
  double low = std::min(std::max(-reach, extent.x - 0.5 * step), 0.0);
  double high = std::max(std::min(reach, extent.y + 0.5 * step), 0.0);
  double first = std::ceil((low - anchor) / step - kSlack), last = std::floor((high - anchor) / step + kSlack);
  return {anchor + (first - 1.0) * step, step, int(std::max(last - first, -1.0)) + 3};
}

/// Frame-local extent of a box of voxels' centres.
void extentOf(const VoxelBox& box, const glm::dmat4& localFromVoxel, glm::dvec3& low, glm::dvec3& high) {
  low = glm::dvec3(1e300);
  high = glm::dvec3(-1e300);
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 voxel;
    for (int axis = 0; axis < 3; ++axis) voxel[axis] = corner >> axis & 1 ? box.end[axis] - 1 : box.min[axis];
    glm::dvec3 p(localFromVoxel * glm::dvec4(voxel, 1.0));
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
}

/// The voxel axis that an axis of the rest plane runs along, or -1: no voxel of the box may stray by a twentieth.
int alignedAxis(const glm::dmat4& voxelFromLocal, int axis, double length) {
  glm::dvec3 v = glm::abs(glm::dvec3(voxelFromLocal[axis]));
  int along = v.x >= v.y && v.x >= v.z ? 0 : v.y >= v.z ? 1 : 2;
  double astray = (v.x + v.y + v.z - v[along]) * length;
  return astray < 0.05 ? along : -1;
}

int floorOf(double value) {
  int whole = int(value);
  return whole - (value < whole);
}

/// Hands one protected pair of voxels out to the edges between the nodes that they are nearest to.
template <class Add>
void spreadPair(glm::ivec3 a, glm::ivec3 b, const Add& add) {
  glm::ivec3 d = b - a;
  int axes = (d.x != 0) + (d.y != 0) + (d.z != 0);
  auto addPath = [&](std::initializer_list<int> order, int halves) {
    glm::ivec3 at = a;
    for (int axis : order)
      while (at[axis] != b[axis]) {
        int step = at[axis] < b[axis] ? 1 : -1;
        glm::ivec3 low = at;
        low[axis] = std::min(at[axis], at[axis] + step);
        at[axis] += step;
        add(low, axis, halves);
      }
  };
  if (axes == 1) addPath({0, 1, 2}, 2);
  // Half to the path that goes along x first and half to the one that ends with it.
  if (axes > 1) addPath({0, 1, 2}, 1), addPath({2, 1, 0}, 1);
}

/// Calls add(node, axis, units of pairs) for each protected pair with a voxel in the frame, from many threads.
template <class Add>
void forEachPair(const ProtectedVoxels& voxels, const FrameBox& frame, const CutLattice& lattice, const Add& add) {
  glm::ivec3 size = voxels.box.end - voxels.box.min;
  std::ptrdiff_t step[3] = {1, size.x, std::ptrdiff_t(size.x) * size.y};
  // Places in steps of the lattice, where node n is at n + 0.5, and what of them is in the frame.
  auto inSteps = [&](glm::dvec3 local) { return (local - lattice.origin) / lattice.step + 0.5; };
  glm::dvec3 low = inSteps(-frame.half), high = inSteps(frame.half), next[3];
  for (int axis = 0; axis < 3; ++axis) next[axis] = glm::dvec3(frame.localFromVoxel[axis]) / lattice.step;
  auto holds = [&](glm::dvec3 p) {
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y && p.z >= low.z && p.z <= high.z;
  };
  auto nodeOf = [](glm::dvec3 p) { return glm::ivec3(floorOf(p.x), floorOf(p.y), floorOf(p.z)); };
  const std::uint8_t *first = voxels.mask.data(), *weights = voxels.weight.empty() ? nullptr : voxels.weight.data();
  parallelFor(0, size.z, [&](int z) {
    const std::uint8_t* mask = first + step[2] * z;
    for (int y = 0; y < size.y; ++y) {
      glm::dvec3 row = inSteps(frame.local(glm::dvec3(voxels.box.min + glm::ivec3(0, y, z))));
      for (int x = 0; x < size.x; ++x, ++mask) {
        if (!*mask) continue;
        glm::ivec3 at(x, y, z);
        glm::dvec3 p = row + next[0] * double(x);
        bool isInside = holds(p);
        for (int axis = 0; axis < 3; ++axis) {
          if (at[axis] + 1 >= size[axis] || !mask[step[axis]]) continue;
          if (!isInside && !holds(p + next[axis])) continue;
          int weight = weights ? std::min(weights[mask - first], weights[mask - first + step[axis]]) : 1;
          spreadPair(nodeOf(p), nodeOf(p + next[axis]),
                     [&](glm::ivec3 node, int along, int halves) { add(node, along, weight * halves); });
        }
      }
    }
  });
}

/// Notes which nodes hold what was put in by hand.
void markPlaced(const ProtectedVoxels& voxels, const FrameBox& frame, CutLattice& lattice) {
  glm::ivec3 size = voxels.box.end - voxels.box.min;
  auto found = std::find(voxels.mask.begin(), voxels.mask.end(), ProtectedVoxels::kPlaced);
  if (found == voxels.mask.end()) return;
  lattice.isPlaced.assign(lattice.layer.size(), 0);
  for (; found != voxels.mask.end(); ++found) {
    if (*found != ProtectedVoxels::kPlaced) continue;
    auto at = int(found - voxels.mask.begin());
    glm::ivec3 voxel = voxels.box.min + glm::ivec3(at % size.x, at / size.x % size.y, at / (size.x * size.y));
    glm::dvec3 local = frame.local(glm::dvec3(voxel));
    if (auto node = nodeAt(lattice, glm::ivec3(glm::floor((local - lattice.origin) / lattice.step + 0.5))))
      lattice.isPlaced[*node] = 1;
  }
}

}  // namespace

CutLattice gatherLattice(const ProtectedVoxels& voxels, const scene::Cut& cut, double coarsening) {
  VELUM_ASSERT(holdsItsBox(voxels), "each voxel of the box is decided");
  VELUM_ASSERT(coarsening >= 1.0, "nodes are a voxel apart at least");
  FrameBox frame(cut, voxels.worldFromVoxel);
  glm::dmat4 voxelFromLocal = glm::inverse(frame.localFromVoxel);
  glm::dvec3 low, high, half = cut.size * 0.5;
  extentOf(voxels.box, frame.localFromVoxel, low, high);
  Nodes nodes[3];
  for (int axis = 0; axis < 3; ++axis) {
    // Voxels along a direction are as far apart as the ellipsoid of their spacing says: right along the axes.
    double step = coarsening / glm::length(glm::dvec3(voxelFromLocal[axis]));
    double anchor = axis == 2 ? 0.5 * step : 0.0;
    // A node on every voxel where the axes agree, so that pairs between nodes are pairs of voxels. Elsewhere a node
    // stands for what is around it: all of that is to lie where the sheet can pass it.
    bool isAligned = coarsening == 1.0 && alignedAxis(voxelFromLocal, axis, high[axis] - low[axis]) >= 0;
    if (isAligned) anchor = low[axis];
    double reach = isAligned ? half[axis] : std::max(half[axis] - 0.5 * step, 0.0);
    nodes[axis] = nodesWithin(anchor, step, reach, {low[axis], high[axis]});
  }
  glm::ivec3 dims(nodes[0].count, nodes[1].count, nodes[2].count);
  // A rest plane through the middles of voxels is to lie on their layer, whatever the last digits say.
  double restLayer = -nodes[2].first / nodes[2].step, layer = std::round(restLayer);
  CutLattice place;
  place.dims = dims;
  for (int axis = 0; axis < 3; ++axis) {
    place.origin[axis] = nodes[axis].first;
    place.step[axis] = nodes[axis].step;
  }
  int unit = CutLattice::kHalves * (voxels.weight.empty() ? 1 : ProtectedVoxels::kStrongest);
  CutLattice lattice = buildLattice(dims, std::abs(restLayer - layer) < kHair ? layer : restLayer, unit,
                                    [&](const auto& add) { forEachPair(voxels, frame, place, add); });
  lattice.origin = place.origin;
  lattice.step = place.step;
  markPlaced(voxels, frame, lattice);
  return lattice;
}

SideOfPoints sideOfLeastCut(const CutLattice& lattice, const LeastCut& cut) {
  VELUM_ASSERT(glm::ivec2(lattice.dims) == cut.dims, "the sheet is one of this lattice");
  struct Stairs {
    glm::dvec3 origin, step;
    glm::ivec2 dims;
    std::vector<int> below;
  };
  auto stairs = std::make_shared<Stairs>(Stairs{lattice.origin, lattice.step, cut.dims, cut.below});
  return [stairs](std::span<const glm::vec3> local, std::span<std::uint8_t> above) {
    VELUM_ASSERT(above.size() == local.size(), "each point gets its side");
    for (std::size_t i = 0; i < local.size(); ++i) {
      glm::ivec3 node(glm::floor((glm::dvec3(local[i]) - stairs->origin) / stairs->step + 0.5));
      glm::ivec2 n = stairs->dims;
      bool inside = node.x >= 0 && node.y >= 0 && node.x < n.x && node.y < n.y;
      above[i] = inside ? node.z >= stairs->below[std::size_t(node.y) * std::size_t(n.x) + std::size_t(node.x)]
                        : local[i].z > 0.0f;
    }
  };
}

double meanDistance(const CutLattice& lattice, const LeastCut& least, const scene::Cut& cut) {
  VELUM_ASSERT(glm::ivec2(lattice.dims) == least.dims, "the sheet is one of this lattice");
  double sum = 0.0;
  for (int below : least.below) {
    // A flat column lies on the rest plane itself, wherever between the two layers that is.
    double z = below == flatCount(lattice) ? 0.0 : lattice.origin.z + (below - 0.5) * lattice.step.z;
    sum += std::abs(z);
  }
  // The frame may be larger than the data; there the sheet is flat.
  double columnMm2 = lattice.step.x * lattice.step.y, frameMm2 = cut.size.x * cut.size.y;
  return sum * columnMm2 / std::max(frameMm2, columnMm2);
}

KeptWholeLimit computeLimit(const ProtectedVoxels& voxels, const scene::Cut& cut, Progress& progress) {
  KeptWholeLimit limit;
  limit.lattice = gatherLattice(voxels, cut);
  limit.least = computeLeastCut(limit.lattice, cut.membrane->field.side, CutMetric::Pairs, progress);
  limit.figure = measureKeptWhole(voxels, cut, sideOfLeastCut(limit.lattice, limit.least),
                                  meanDistance(limit.lattice, limit.least, cut), progress);
  return limit;
}

}  // namespace velum::membrane
