#include "velum/session/membrane/FirstPlace.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "velum/core/Vectors.h"
#include "velum/membrane/forces/Kernels.h"
#include "velum/membrane/forces/Limit.h"

namespace velum::session {

namespace {

/// A grid so coarse that a place is tried in a few milliseconds.
constexpr int kLooksAlongEdge = 48;
constexpr int kPlaces = 14;
/// The places that are tried lie between the front and where so much of what is protected is in front. What lies before
/// the front is too little to count: noise, a cable.
constexpr double kBeforeFront = 0.02, kMostInFront = 0.6;
/// What must be cut counts more than what is spared.
constexpr double kWorthOfCut = 2.0;
/// A place further in front is taken where it is nearly as good.
constexpr double kNearlyAsGood = 0.8;

/// What is protected, on every so manyth voxel.
membrane::ProtectedVoxels lookCoarsely(const membrane::Potential& potential, const scene::ForceField& field,
                                       Progress& progress) {
  glm::ivec3 dims = potential.dims(), step = glm::max(dims / kLooksAlongEdge, glm::ivec3(1)), count = dims / step;
  membrane::ProtectedVoxels voxels{{glm::ivec3(0), count}, {}, potential.worldFromVoxel()};
  voxels.worldFromVoxel[3] = potential.worldFromVoxel() * glm::dvec4(glm::dvec3(step / 2), 1.0);
  for (int axis = 0; axis < 3; ++axis) voxels.worldFromVoxel[axis] *= double(step[axis]);
  for (int k = 0; k < count.z; ++k) {
    int z = k * step.z + step.z / 2;
    auto layer = potential.computeProtected(field, {{0, 0, z}, {dims.x, dims.y, z + 1}}, progress);
    for (int j = 0; j < count.y; ++j)
      for (int i = 0; i < count.x; ++i) {
        glm::ivec2 at = glm::ivec2(i, j) * glm::ivec2(step) + glm::ivec2(step) / 2;
        voxels.mask.push_back(layer.mask[std::size_t(at.y) * std::size_t(dims.x) + std::size_t(at.x)]);
      }
  }
  return voxels;
}

/// How far along a direction what is protected lies, ascending.
std::vector<double> depthsOf(const membrane::ProtectedVoxels& voxels, glm::dvec3 along) {
  std::vector<double> depths;
  glm::ivec3 n = voxels.box.end, at;
  const std::uint8_t* mask = voxels.mask.data();
  for (at.z = 0; at.z < n.z; ++at.z)
    for (at.y = 0; at.y < n.y; ++at.y)
      for (at.x = 0; at.x < n.x; ++at.x)
        if (*mask++) depths.push_back(glm::dot(glm::dvec3(voxels.worldFromVoxel * glm::dvec4(at, 1.0)), along));
  std::sort(depths.begin(), depths.end());
  return depths;
}

/// What the sheet would spare here of what the plane would cut, less what it must cut.
double worthOf(const membrane::ProtectedVoxels& voxels, const scene::Cut& cut, Progress& progress) {
  membrane::CutLattice lattice = membrane::gatherLattice(voxels, cut);
  std::vector<int> flat(std::size_t(lattice.dims.x) * std::size_t(lattice.dims.y), membrane::flatCount(lattice));
  double plane = membrane::countCutPairs(lattice, flat);
  double sheet = membrane::computeLeastCut(lattice, cut.membrane->field.side, progress).cutPairs;
  return plane - sheet - kWorthOfCut * sheet;
}

}  // namespace

std::optional<glm::dvec3> firstPlaceOf(const scene::Scene& scene, const scene::Cut& cut, Progress& progress) {
  scene::ForceField field = cut.membrane->field;
  field.byGradient.clear();  // seconds to compute
  membrane::Potential potential(scene);
  if (potential.dims().x == 0) return std::nullopt;
  membrane::ProtectedVoxels voxels = lookCoarsely(potential, field, progress);
  // What is removed is in front.
  glm::dvec3 axis = unitOr(cut.axis, {0, 0, 1}), front = cut.invert ? -axis : axis;
  std::vector<double> depths = depthsOf(voxels, front);
  if (depths.empty()) return std::nullopt;
  auto behind = [&](double share) { return depths[std::size_t((1.0 - share) * double(depths.size() - 1))]; };
  double from = behind(kBeforeFront), to = behind(kMostInFront);
  std::vector<std::pair<double, glm::dvec3>> tried;
  for (int i = 0; i < kPlaces; ++i) {
    scene::Cut there = cut;
    there.centre += front * (std::lerp(from, to, i / double(kPlaces - 1)) - glm::dot(cut.centre, front));
    tried.emplace_back(worthOf(voxels, there, progress), there.centre);
  }
  double best = std::max_element(tried.begin(), tried.end(), [](auto& a, auto& b) { return a.first < b.first; })->first;
  double enough = best > 0.0 ? kNearlyAsGood * best : best;
  return std::find_if(tried.begin(), tried.end(), [&](const auto& one) { return one.first >= enough; })->second;
}

}  // namespace velum::session
