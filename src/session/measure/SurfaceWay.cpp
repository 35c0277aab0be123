#include "session/measure/SurfaceWay.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "render/kept/KeptPlaces.h"
#include "scene/Scene.h"
#include "session/measure/Solid.h"

namespace velum::session {

namespace {

constexpr double kMostNodes = 2.5e6;  // of a grid: half a second
/// Rounds of smoothing, where voxels are cubes, and the step in voxels: steps between labels make ways longer. Tuned on
/// balls and cylinders of 15 voxels.
constexpr double kSmoothRounds = 5.0, kLabelRounds = 25.0, kLabelStep = 1.4;

std::string noSurfaceAt(glm::dvec3 place) {
  return fmt::format("there is no surface at {:.6g}, {:.6g}, {:.6g}", place.x, place.y, place.z);
}

/// The triangles of a surface from a file that the cuts leave, points at one place joined.
WayMesh leftOf(const scene::Scene& scene, const Mesh& mesh) {
  WayMesh left;
  std::map<std::array<float, 3>, std::uint32_t> known;
  render::KeptPlaces kept(scene, glm::dvec3(mesh.positions.front()));
  auto pointOf = [&](std::uint32_t index) {
    glm::vec3 p = mesh.positions[index];
    auto [at, isNew] = known.try_emplace({p.x, p.y, p.z}, std::uint32_t(left.points.size()));
    if (isNew) left.points.emplace_back(p);
    return at->second;
  };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = pointOf(mesh.indices[i + k]);
    glm::dvec3 middle = (left.points[corners[0]] + left.points[corners[1]] + left.points[corners[2]]) / 3.0;
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    if (kept.isEmpty() || kept.keeps(middle, 0))
      left.indices.insert(left.indices.end(), corners.begin(), corners.end());
  }
  return left;
}

/// Over a surface from a file, where both places lie on it.
std::optional<SurfaceWay> wayOverFile(const scene::Scene& scene, glm::dvec3 a, glm::dvec3 b, Progress& progress) {
  for (const scene::Surface& surface : scene.surfaces) {
    if (!surface.visible || !surface.data || surface.data->indices.empty()) continue;
    WayMesh mesh = leftOf(scene, *surface.data);
    if (mesh.indices.empty()) continue;
    glm::dvec3 low(1e300), high(-1e300);
    for (const glm::dvec3& point : mesh.points) low = glm::min(low, point), high = glm::max(high, point);
    double near = 2e-3 * glm::distance(low, high);
    MeshPlace from = nearestPlace(mesh, a), to = nearestPlace(mesh, b);
    if (from.distance > near || to.distance > near) continue;
    auto way = wayOverMesh(mesh, from, to, progress);
    if (!way) return SurfaceWay{{}, "the surface does not lead from one point to the other"};
    return SurfaceWay{*way, {}};
  }
  return std::nullopt;
}

/// No way from a to b that leaves a box through a side within `whole` is shorter: it is as long as one to the mirror
/// image of b, or longer.
double shortestOutside(const WorldBox& box, const WorldBox& whole, glm::dvec3 a, glm::dvec3 b) {
  double shortest = 1e300;
  for (int axis = 0; axis < 3; ++axis)
    for (bool isLow : {true, false}) {
      double side = isLow ? box.low[axis] : box.high[axis];
      bool isOutermost = isLow ? side <= whole.low[axis] : side >= whole.high[axis];
      if (isOutermost) continue;
      glm::dvec3 mirrored = b;
      mirrored[axis] = 2.0 * side - b[axis];
      shortest = std::min(shortest, glm::distance(a, mirrored));
    }
  return shortest;
}

}  // namespace

SurfaceWay wayOverSurface(const scene::Scene& scene, glm::dvec3 a, glm::dvec3 b, Progress& progress) {
  if (auto way = wayOverFile(scene, a, b, progress)) return *way;
  SolidPlace place = solidPlaceAt(scene, a, b);
  if (!place.problem.empty()) return {{}, place.problem};
  const SolidGrid& grid = place.grid;
  double finest = grid.fineness * std::min(std::sqrt(grid.roughness), 2.0) * (place.isStructure ? kLabelStep : 1.0);
  WorldBox whole{grid.box.low - 2.0 * finest, grid.box.high + 2.0 * finest};
  for (double margin = 0.3 * glm::distance(a, b) + 8.0 * finest;; margin *= 1.8) {
    WorldBox box{glm::max(glm::min(a, b) - margin, whole.low), glm::min(glm::max(a, b) + margin, whole.high)};
    glm::dvec3 size = box.high - box.low;
    if (size.x <= 0.0 || size.y <= 0.0 || size.z <= 0.0) return {{}, noSurfaceAt(a)};
    double step = std::max(finest, std::cbrt(size.x * size.y * size.z / kMostNodes));
    progress.report(0.0, "Measuring along the surface");
    Solid solid = solidUnder(scene, place, a, b, box, step, progress);
    if (!solid.holds) return {{}, solid.problem};
    double roundsOfCubes = place.isStructure ? kLabelRounds : kSmoothRounds;
    int rounds = int(std::lround(roundsOfCubes * std::min(grid.roughness, 4.0)));
    WayMesh mesh = surfaceOf(solid, box, step, rounds, progress);
    if (mesh.indices.empty()) return {{}, noSurfaceAt(a)};
    MeshPlace from = nearestPlace(mesh, a), to = nearestPlace(mesh, b);
    double near = 3.0 * step + 2.0 * grid.fineness * grid.roughness;
    if (from.distance > near || to.distance > near) return {{}, noSurfaceAt(from.distance > near ? a : b)};
    double outside = shortestOutside(box, whole, a, b);
    auto way = wayOverMesh(mesh, from, to, progress);
    if (way && way->length <= outside) return {*way, {}};
    if (outside >= 1e300) return {{}, "the surface does not lead from one point to the other"};
  }
}

}  // namespace velum::session
