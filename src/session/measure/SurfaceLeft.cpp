#include "session/measure/SurfaceLeft.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "core/Parallel.h"
#include "io/meshes/ExtractSurface.h"
#include "render/kept/KeptPlaces.h"
#include "scene/Scene.h"
#include "scene/StructureAt.h"
#include "session/measure/MeshNeighbours.h"

namespace velum::session {

namespace {

/// Triangles that a face passes are looked at in so many parts along each edge.
constexpr int kPartsAlongEdge = 8;
/// How often the directions of neighbouring triangles are averaged, where voxels are cubes. Tuned on balls and
/// ellipsoids of 6 to 16 voxels, oblique, sheared and up to four times as long as wide, which come out within 1.3 %.
constexpr double kAveragings = 20.0;

struct Corners {
  glm::dvec3 a, b, c;
};

/// Share of the middles of a triangle's parts that is kept.
double shareOfParts(const render::KeptPlaces& kept, const Corners& t, std::uint16_t structure) {
  constexpr int n = kPartsAlongEdge;
  int left = 0;
  auto look = [&](double u, double v) {
    left += kept.keeps(t.a + u * (t.b - t.a) + v * (t.c - t.a), structure) ? 1 : 0;
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      look((i + 1.0 / 3.0) / n, (j + 1.0 / 3.0) / n);
      if (i + j + 1 < n) look((i + 2.0 / 3.0) / n, (j + 2.0 / 3.0) / n);
    }
  return double(left) / (n * n);
}

double keptShare(const render::KeptPlaces& kept, const Corners& t, std::uint16_t structure) {
  if (kept.isEmpty()) return 1.0;
  glm::dvec3 middle = (t.a + t.b + t.c) / 3.0;
  double reach = std::max({glm::distance(middle, t.a), glm::distance(middle, t.b), glm::distance(middle, t.c)});
  double distance = kept.distance(middle, structure).distance;
  if (std::abs(distance) > (kept.hasSheets() ? 3.0 : 1.0) * reach) return distance > 0.0 ? 1.0 : 0.0;
  return shareOfParts(kept, t, structure);
}

Corners cornersOf(const Mesh& mesh, std::size_t triangle) {
  const std::uint32_t* corner = &mesh.indices[3 * triangle];
  return {mesh.positions[corner[0]], mesh.positions[corner[1]], mesh.positions[corner[2]]};
}

/// The area of each triangle as it is seen along the mean direction of those about it: what is left of steps between
/// voxels adds nothing then.
std::vector<double> areasWithoutRipples(const Mesh& mesh, int rounds, Progress& progress) {
  std::size_t count = mesh.indices.size() / 3;
  std::vector<glm::dvec3> own(count), means(count), next(count);
  for (std::size_t i = 0; i < count; ++i) {
    Corners t = cornersOf(mesh, i);
    own[i] = 0.5 * glm::cross(t.b - t.a, t.c - t.a);
    double area = glm::length(own[i]);
    means[i] = area > 0.0 ? own[i] / area : glm::dvec3(0.0);
  }
  auto neighbours = neighboursOf(mesh.indices);
  for (int round = 0; round < rounds; ++round) {
    progress.throwIfCancelled();
    parallelFor(std::size_t(0), count, [&](std::size_t i) {
      glm::dvec3 sum = glm::length(own[i]) * means[i];
      for (std::uint32_t n : neighbours[i]) sum += glm::length(own[n]) * means[n];
      double length = glm::length(sum);
      next[i] = length > 0.0 ? sum / length : means[i];
    });
    means.swap(next);
  }
  std::vector<double> areas(count);
  for (std::size_t i = 0; i < count; ++i) areas[i] = std::max(0.0, glm::dot(own[i], means[i]));
  return areas;
}

/// Where voxels are long, steps between them are long, too.
int roundsFor(const glm::dmat4& worldFromVoxel) {
  glm::dmat3 axes(worldFromVoxel);
  auto [least, most] = std::minmax({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
  return int(std::lround(kAveragings * std::min(most / least, 10.0)));
}

}  // namespace

double surfaceLeft(const scene::Scene& scene, int structure, glm::ivec3 low, glm::ivec3 high, Progress& progress) {
  const LabelVolume& labels = *scene.labels.data;
  auto field = scene::structureFieldOf(scene);
  auto id = std::uint16_t(structure);
  Mesh mesh = io::extractSurface(*field, id, low, high, 0.0, progress);
  std::vector<double> areas = areasWithoutRipples(mesh, roundsFor(labels.worldFromVoxel()), progress);
  glm::dvec3 middle(labels.worldFromVoxel() * glm::dvec4(0.5 * glm::dvec3(labels.dims() - 1), 1.0));
  render::KeptPlaces kept(scene, middle);
  auto body = [&](std::size_t first, std::size_t end) {
    progress.throwIfCancelled();
    double area = 0.0;
    for (std::size_t i = first; i < end; ++i) area += areas[i] * keptShare(kept, cornersOf(mesh, i), id);
    return area;
  };
  return parallelReduce(std::size_t(0), areas.size(), std::size_t(4096), 0.0, body, std::plus<>());
}

}  // namespace velum::session
