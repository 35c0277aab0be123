#include "session/document/LabelPlace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/Scene.h"

namespace velum::session {

namespace {

constexpr int kBrick = LabelVolume::kBrickSize;
constexpr double kMostSamples = 3e5;   ///< voxels that are looked at: some milliseconds
constexpr double kLeastInside = 0.05;  ///< labels of a whole body may well be laid over a part of its scan
constexpr double kFewVoxels = 3.0;     ///< of the scan, along each axis

/// Voxels that are labelled, and those of them that lie in the scan.
struct Labelled {
  std::size_t count = 0, inside = 0;
  /// @param at  in voxels of the scan
  void add(glm::dvec3 at, glm::ivec3 dims) {
    ++count;
    inside += glm::all(glm::greaterThanEqual(at, glm::dvec3(-0.5))) &&
              glm::all(glm::lessThanEqual(at, glm::dvec3(dims) - 0.5));
  }
};

std::vector<glm::ivec3> bricksWithLabels(const LabelVolume& labels) {
  std::vector<glm::ivec3> bricks;
  glm::ivec3 grid = labels.brickGrid();
  for (int z = 0; z < grid.z; ++z)
    for (int y = 0; y < grid.y; ++y)
      for (int x = 0; x < grid.x; ++x) {
        const LabelVolume::Brick& brick = labels.brick({x, y, z});
        if (brick.size() > 1 || brick[0] != 0) bricks.emplace_back(x, y, z);
      }
  return bricks;
}

Labelled findLabelled(const LabelVolume& labels, const Volume& scan) {
  Labelled found;
  auto bricks = bricksWithLabels(labels);
  double voxels = double(bricks.size()) * kBrick * kBrick * kBrick;
  int step = std::clamp(int(std::cbrt(voxels / kMostSamples)), 1, kBrick / 2);
  glm::dmat4 scanFromLabels = glm::inverse(scan.worldFromVoxel) * labels.worldFromVoxel();
  for (glm::ivec3 brick : bricks)
    for (int z = 0; z < kBrick; z += step)
      for (int y = 0; y < kBrick; y += step)
        for (int x = 0; x < kBrick; x += step) {
          glm::ivec3 voxel = brick * kBrick + glm::ivec3(x, y, z);
          if (labels.at(voxel) != 0) found.add(glm::dvec3(scanFromLabels * glm::dvec4(voxel, 1.0)), scan.dims);
        }
  return found;
}

std::string sizeOf(glm::ivec3 dims, const glm::dmat4& worldFromVoxel, LengthUnit unit) {
  glm::dvec3 edges;
  for (int i = 0; i < 3; ++i) edges[i] = glm::length(glm::dvec3(worldFromVoxel[i])) * dims[i];
  return fmt::format("{:.4g} x {:.4g} x {:.4g} {}", edges.x, edges.y, edges.z, symbolOf(unit));
}

}  // namespace

std::string misplacedLabels(const scene::Scene& scene) {
  if (!scene.volume.data || !scene.labels.data) return {};
  const Volume& scan = *scene.volume.data;
  const LabelVolume& labels = *scene.labels.data;
  Labelled found = findLabelled(labels, scan);
  if (found.count == 0) return {};
  std::string sizes =
      fmt::format("the scan measures {}, the labels {}", sizeOf(scan.dims, scan.worldFromVoxel, scene.unit),
                  sizeOf(labels.dims(), labels.worldFromVoxel(), scene.unit));
  constexpr const char* kWhatToDo = "check that they are of this scan, and the voxel size of both";
  double share = double(found.inside) / double(found.count);
  if (found.inside == 0) return fmt::format("the labels do not overlap the scan at all: {}; {}", sizes, kWhatToDo);
  if (share < kLeastInside)
    return fmt::format("only {:.2g} % of what is labelled lies in the scan: {}; {}", 100.0 * share, sizes, kWhatToDo);
  glm::dmat3 scanFromLabels = glm::inverse(glm::dmat3(scan.worldFromVoxel)) * glm::dmat3(labels.worldFromVoxel());
  double longest = 0.0;  // edge of the labels' whole grid, in voxels of the scan
  for (int i = 0; i < 3; ++i) longest = std::max(longest, glm::length(scanFromLabels[i]) * labels.dims()[i]);
  if (longest < kFewVoxels && glm::all(glm::greaterThan(labels.dims(), glm::ivec3(1))))
    return fmt::format("all of the labels lie in a few voxels of the scan: {}; {}", sizes, kWhatToDo);
  return {};
}

std::optional<io::LabelGrid> gridOfScan(const scene::Scene& scene) {
  if (!scene.volume.data) return std::nullopt;
  return io::gridOf(*scene.volume.data);
}

LabelVolume readLabelsOf(const scene::Scene& scene, Progress& progress) {
  io::KnownIds known;
  for (const scene::Structure& structure : scene.labels.structures)
    if (std::uint64_t fileId = scene::fileIdOf(structure); fileId != 0) known[fileId] = std::uint16_t(structure.id);
  return io::readLabels(scene.labels.source, progress, gridOfScan(scene), known);
}

}  // namespace velum::session
