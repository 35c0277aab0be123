#include "session/measure/Follow.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "core/LabelVolume.h"
#include "core/Parallel.h"
#include "scene/Crowd.h"
#include "scene/Scene.h"
#include "scene/StructureAt.h"
#include "session/model/ModelEdit.h"

namespace velum::session {

namespace {

constexpr std::size_t kMiddlesKept = 256;     // structures whose sums are remembered
constexpr std::uint64_t kMostSearched = 2e7;  // instances that are looked at to find one

int itemAt(const std::vector<int>& items, std::size_t point, int none) {
  return point < items.size() ? items[point] : none;
}

/// The voxels of a structure in a brick: how many, and the sum of their places.
struct BrickSum {
  std::uint64_t brick = 0;  ///< see LabelVolume::brickId(); 0: not looked at
  std::uint64_t voxels = 0;
  glm::dvec3 places{0.0};
};

BrickSum sumOfBrick(const LabelVolume& labels, glm::ivec3 index, int structure) {
  constexpr int kEdge = LabelVolume::kBrickSize;
  BrickSum sum{labels.brickId(index), 0, {}};
  const LabelVolume::Brick& brick = labels.brick(index);
  glm::ivec3 corner = index * kEdge, inside = glm::min(labels.dims() - corner, glm::ivec3(kEdge));
  if (brick.size() == 1) {
    if (brick[0] != structure) return sum;
    sum.voxels = std::uint64_t(inside.x) * std::uint64_t(inside.y) * std::uint64_t(inside.z);
    sum.places = double(sum.voxels) * (glm::dvec3(corner) + 0.5 * glm::dvec3(inside - 1));
    return sum;
  }
  for (int z = 0; z < inside.z; ++z)
    for (int y = 0; y < inside.y; ++y) {
      const std::uint16_t* row = &brick[(std::size_t(z) * kEdge + std::size_t(y)) * kEdge];
      for (int x = 0; x < inside.x; ++x)
        if (row[x] == structure) ++sum.voxels, sum.places += glm::dvec3(corner + glm::ivec3(x, y, z));
    }
  return sum;
}

/// What is remembered of a structure.
struct Middle {
  std::uint64_t labels = 0;  ///< Shared<LabelVolume>::id()
  std::vector<BrickSum> bricks;
  std::optional<glm::dvec3> world;
};

void look(Middle& middle, const Shared<LabelVolume>& labels, int structure) {
  glm::ivec3 grid = labels->brickGrid();
  middle.labels = labels.id();
  middle.bricks.resize(std::size_t(grid.x) * std::size_t(grid.y) * std::size_t(grid.z));
  parallelFor(0, grid.z, [&](int z) {
    for (int y = 0; y < grid.y; ++y)
      for (int x = 0; x < grid.x; ++x) {
        BrickSum& sum =
            middle
                .bricks[(std::size_t(z) * std::size_t(grid.y) + std::size_t(y)) * std::size_t(grid.x) + std::size_t(x)];
        if (sum.brick != labels->brickId({x, y, z})) sum = sumOfBrick(*labels, {x, y, z}, structure);
      }
  });
  std::uint64_t voxels = 0;
  glm::dvec3 places(0.0);
  for (const BrickSum& sum : middle.bricks) voxels += sum.voxels, places += sum.places;
  middle.world.reset();
  if (voxels > 0) middle.world = glm::dvec3(labels->worldFromVoxel() * glm::dvec4(places / double(voxels), 1.0));
}

/// The instance of the model whose ball holds a place; of several that whose middle is next. -1: none
int instanceAt(const scene::Scene& scene, glm::dvec3 world) {
  if (!scene.model.data) return -1;
  std::uint64_t each = scene::isCrowd(scene.model) ? 1 : scene.model.data->instances.size();
  std::uint64_t count = each * std::uint64_t(scene::copyCount(scene.model));
  if (count > kMostSearched) return -1;
  int found = -1;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::uint64_t i = 0; i < count; ++i) {
    auto place = instancePlace(scene, std::uint32_t(i));
    if (!place) continue;
    double away = glm::distance(place->middle, world);
    if (away <= place->radius && away < nearest) nearest = away, found = int(i);
  }
  return found;
}

}  // namespace

std::optional<glm::dvec3> middleOfVoxels(const scene::Scene& scene, int structure) {
  static std::mutex mutex;
  static std::map<int, Middle> known;
  const Shared<LabelVolume>& labels = scene.labels.data;
  if (!labels || structure <= 0) return std::nullopt;
  std::lock_guard lock(mutex);
  if (known.size() >= kMiddlesKept && !known.contains(structure)) known.clear();
  Middle& middle = known[structure];
  if (middle.labels != labels.id()) look(middle, labels, structure);
  return middle.world;
}

bool isFollowing(const scene::Mark& mark, std::size_t point) {
  return itemAt(mark.pointInstances, point, -1) >= 0 || itemAt(mark.pointStructures, point, 0) > 0;
}

scene::Mark followed(const scene::Scene& scene, const scene::Mark& mark) {
  scene::Mark now = mark;
  if (mark.pointInstances.empty() && mark.pointStructures.empty()) return now;
  for (std::size_t i = 0; i < now.points.size(); ++i) {
    if (int instance = itemAt(mark.pointInstances, i, -1); instance >= 0) {
      if (auto place = instancePlace(scene, std::uint32_t(instance))) now.points[i] = place->middle;
    } else if (int structure = itemAt(mark.pointStructures, i, 0); structure > 0) {
      if (auto place = middleOfVoxels(scene, structure)) now.points[i] = *place;
    }
  }
  bool isRound = mark.kind == scene::MarkKind::Circle && mark.points.size() == 2;
  if (isRound && !isFollowing(mark, 1)) now.points[1] += now.points[0] - mark.points[0];
  return now;
}

scene::Mark following(const scene::Scene& scene, scene::Mark mark) {
  mark = fixed(scene, mark);
  auto field = scene.labels.data ? scene::structureFieldOf(scene) : nullptr;  // held while points ask it
  for (std::size_t i = 0; i < mark.points.size(); ++i) {
    int instance = instanceAt(scene, mark.points[i]);
    int structure = instance < 0 ? scene::structureAt(scene, mark.points[i]).id : 0;
    if (instance >= 0) mark.pointInstances.resize(i + 1, -1), mark.pointInstances[i] = instance;
    if (structure > 0) mark.pointStructures.resize(i + 1, 0), mark.pointStructures[i] = structure;
  }
  return followed(scene, mark);
}

scene::Mark fixed(const scene::Scene& scene, const scene::Mark& mark) {
  scene::Mark now = followed(scene, mark);
  now.pointInstances.clear();
  now.pointStructures.clear();
  return now;
}

}  // namespace velum::session
