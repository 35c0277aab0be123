#include "session/measure/Follow.h"

#include <fmt/format.h>

#include <limits>
#include <utility>
#include <vector>

#include "core/Error.h"
#include "core/Model.h"
#include "core/Parallel.h"
#include "scene/Crowd.h"
#include "scene/Scene.h"
#include "scene/StructureAt.h"
#include "session/model/ModelEdit.h"

namespace velum::session {

namespace {

constexpr std::size_t kInstancesAtOnce = 1u << 16;  // pieces of the search

int itemAt(const std::vector<int>& items, std::size_t point, int none) {
  return point < items.size() ? items[point] : none;
}

/// What holds a place: the instance, or of a crowd the copy, whose middle is next to it.
struct PlaceHolder {
  double away = std::numeric_limits<double>::infinity();
  std::int64_t instance = -1;  ///< -1: nothing does
  void take(double otherAway, std::int64_t other) {
    if (other >= 0 && std::pair(otherAway, other) < std::pair(away, instance)) away = otherAway, instance = other;
  }
};
using PlaceHolders = std::vector<PlaceHolder>;

/// A place that a copy of the model may hold.
struct PlaceInCopy {
  std::size_t point = 0;
  glm::dvec3 world{0.0};
  glm::dvec3 shift{0.0};            ///< of the copy, angstrom
  std::uint64_t firstInstance = 0;  ///< of the copy
};

/// Each place with all copies whose boxes hold it.
std::vector<PlaceInCopy> placesInCopies(const scene::Scene& scene, const std::vector<glm::dvec3>& points) {
  const Model& model = *scene.model.data;
  scene::CopyGrid grid = scene::copyGrid(scene.model);
  scene::ModelFrame frame = scene::modelFrame(scene);
  glm::dvec3 low(model.low), high(model.high), rim(1e-3 * glm::length(high - low));
  std::vector<PlaceInCopy> places;
  for (int copy = 0; copy < scene::copyCount(scene.model); ++copy) {
    glm::ivec3 cell(copy % grid.counts.x, copy / grid.counts.x % grid.counts.y, copy / (grid.counts.x * grid.counts.y));
    glm::dvec3 shift = grid.step * glm::dvec3(cell);
    glm::dvec3 from = frame.worldOf(low + shift - rim), to = frame.worldOf(high + shift + rim);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (glm::all(glm::lessThanEqual(from, points[i])) && glm::all(glm::lessThanEqual(points[i], to)))
        places.push_back({i, points[i], shift, std::uint64_t(copy) * model.instances.size()});
  }
  return places;
}

/// @throw ArgumentError where it would take too long
void checkSearch(std::uint64_t instances, std::size_t places) {
  if (places == 0 || instances <= kMostSearched / places) return;
  throw ArgumentError(
      fmt::format("{} instances are too many to find which of them hold {} points: at most {} can be "
                  "looked at for one point; give pointInstances",
                  instances, places, kMostSearched));
}

/// Looks at all from 0 to before count, on all cores. @param look  (PlaceHolders& of all points, number)
template <class LookAt>
PlaceHolders searchAll(std::uint64_t count, std::size_t points, const Progress& progress, const LookAt& look) {
  PlaceHolders held(points);
  auto lookAtPiece = [&](std::uint64_t first, std::uint64_t end) {
    progress.throwIfCancelled();
    PlaceHolders piece(points);
    for (std::uint64_t i = first; i < end; ++i) look(piece, i);
    return piece;
  };
  auto join = [](PlaceHolders a, const PlaceHolders& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i].take(b[i].away, b[i].instance);
    return a;
  };
  isolated([&] {
    held = parallelReduce(std::uint64_t(0), count, std::uint64_t(kInstancesAtOnce), PlaceHolders(points), lookAtPiece,
                          join);
  });
  return held;
}

/// The instances of the model whose balls hold places, see following(). One pass for all of them.
PlaceHolders instancesAt(const scene::Scene& scene, const std::vector<glm::dvec3>& points, const Progress& progress) {
  if (!scene.model.data || scene.model.data->instances.empty()) return PlaceHolders(points.size());
  if (scene::isCrowd(scene.model)) {
    auto count = std::uint64_t(scene::copyCount(scene.model));
    checkSearch(count, points.size());
    return searchAll(count, points.size(), progress, [&](PlaceHolders& held, std::uint64_t copy) {
      auto place = instancePlace(scene, std::uint32_t(copy));
      for (std::size_t i = 0; place && i < points.size(); ++i)
        if (double away = glm::distance(place->middle, points[i]); away <= place->radius)
          held[i].take(away, std::int64_t(copy));
    });
  }
  const Model& model = *scene.model.data;
  scene::ModelFrame frame = scene::modelFrame(scene);
  std::vector<PlaceInCopy> places = placesInCopies(scene, points);
  if (places.empty()) return PlaceHolders(points.size());
  checkSearch(model.instances.size(), places.size());
  return searchAll(model.instances.size(), points.size(), progress, [&](PlaceHolders& held, std::uint64_t i) {
    const Instance& one = model.instances[i];
    const Molecule& molecule = model.molecules[one.molecule];
    glm::dvec3 middle(one.rotation * molecule.centre + one.position);
    double radius = molecule.radius * frame.length;
    for (const PlaceInCopy& place : places) {
      double away = glm::distance(frame.worldOf(middle + place.shift), place.world);
      if (away <= radius) held[place.point].take(away, std::int64_t(place.firstInstance + i));
    }
  });
}

}  // namespace

bool isFollowing(const scene::Mark& mark, std::size_t point) {
  return itemAt(mark.pointInstances, point, -1) >= 0 || itemAt(mark.pointStructures, point, 0) > 0;
}

bool isFollowing(const scene::Mark& mark) {
  for (std::size_t i = 0; i < mark.points.size(); ++i)
    if (isFollowing(mark, i)) return true;
  return false;
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

scene::Mark following(const scene::Scene& scene, scene::Mark mark, const Progress& progress) {
  mark = fixed(scene, mark);
  PlaceHolders held = instancesAt(scene, mark.points, progress);
  auto field = scene.labels.data ? scene::structureFieldOf(scene) : nullptr;  // held while points ask it
  for (std::size_t i = 0; i < mark.points.size(); ++i) {
    int instance = int(held[i].instance);
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
