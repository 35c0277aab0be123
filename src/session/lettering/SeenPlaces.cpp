#include "session/lettering/SeenPlaces.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <set>

#include "render/kept/KeptPlaces.h"
#include "scene/Project.h"
#include "scene/Scene.h"
#include "scene/SectionPlane.h"
#include "scene/StructureAt.h"
#include "session/ViewSpace.h"
#include "session/lettering/NameGroups.h"
#include "session/mark/MarkHands.h"
#include "session/measure/Follow.h"

namespace velum::session {

namespace {

constexpr double kWholePart = 0.012;            // of the picture's height: edge of a square that is seen as a whole
constexpr double kLookRound = 0.004;            // the same: radius about a place
constexpr double kHidden = 0.25, kSeen = 0.75;  // shares of the pixels about a place
constexpr double kBehindSteps = 2.5, kBehindPixels = 4.0;  // so far behind what is seen a place still lies on it

using IsShown = std::function<bool(std::size_t pixel)>;

bool hasLeader(const scene::Mark& mark) {
  bool isNaming = mark.kind == scene::MarkKind::Label || mark.kind == scene::MarkKind::Name;
  return isNaming && mark.points.size() == 1;
}

/// Tells which pixels show what a mark points at; nothing where it points at its place alone.
IsShown targetOf(const scene::Scene& scene, const scene::Mark& mark, const SeenMap& map) {
  bool followsOne = !mark.pointInstances.empty() && mark.pointInstances[0] >= 0;
  if (followsOne && mark.kind == scene::MarkKind::Label && !map.instances.empty())
    return [&map, wanted = mark.pointInstances[0]](std::size_t i) { return map.instances[i] == wanted; };
  if (!mark.type.empty() && !map.types.empty()) {
    std::set<std::int32_t> types;
    for (const NameGroup& group : listedGroups(scene, {mark.type}, {}))
      types.insert(group.types.begin(), group.types.end());
    if (!types.empty())
      return [&map, types](std::size_t i) { return map.types[i] >= 0 && types.contains(map.types[i]); };
  }
  int structure = mark.structure;
  if (structure == 0 && !mark.pointStructures.empty()) structure = mark.pointStructures[0];
  if (structure <= 0 || !scene.labels.data || !scene.labels.visible) return {};
  return [&map, structure](std::size_t i) {
    return map.structures[i] == structure && (map.types.empty() || map.types[i] < 0);
  };
}

class PlacesIn {
 public:
  PlacesIn(const scene::Scene& scene, const SeenMap& map)
      : mScene(scene), mMap(map), mView(scene.camera, glm::dvec2(map.size * map.step)) {}

  SeenPlace find(const scene::Mark& mark) {
    auto own = mView.pixelFromWorld(mark.points[0]);
    IsShown target = targetOf(mScene, mark, mMap);
    if (target) return nearest(mark.id, own ? *own : 0.5 * mView.size(), target);
    return {mark.id, {}, own ? shareAt(mark, *own) : 0.0};
  }

 private:
  bool isIn(glm::ivec2 pixel) const {
    return glm::all(glm::greaterThanEqual(pixel, glm::ivec2(0))) && glm::all(glm::lessThan(pixel, mMap.size));
  }
  std::size_t at(glm::ivec2 pixel) const {
    return std::size_t(pixel.y) * std::size_t(mMap.size.x) + std::size_t(pixel.x);
  }
  glm::ivec2 mapPixel(glm::dvec2 pixel) const { return glm::ivec2(glm::floor(pixel / double(mMap.step))); }

  /// The pixel that shows the target next to a place.
  SeenPlace nearest(int mark, glm::dvec2 own, const IsShown& target) const {
    glm::dvec2 goal = own / double(mMap.step) - 0.5;
    double inner = std::numeric_limits<double>::infinity(), outer = inner;
    glm::ivec2 innerAt(0), outerAt(0);
    std::uint64_t count = 0;
    for (int y = 0; y < mMap.size.y; ++y)
      for (int x = 0; x < mMap.size.x; ++x) {
        if (!target(at({x, y}))) continue;
        ++count;
        glm::dvec2 away = glm::dvec2(x, y) - goal;
        double square = glm::dot(away, away);
        if (square < outer) outer = square, outerAt = {x, y};
        if (square >= inner) continue;
        bool isInside = x > 0 && y > 0 && x + 1 < mMap.size.x && y + 1 < mMap.size.y && target(at({x - 1, y})) &&
                        target(at({x + 1, y})) && target(at({x, y - 1})) && target(at({x, y + 1}));
        if (isInside) inner = square, innerAt = {x, y};
      }
    double whole = kWholePart * mMap.size.y;
    SeenPlace place{mark, {}, glm::smoothstep(0.0, 1.0, double(count) / std::max(1.0, whole * whole))};
    glm::ivec2 there = mapPixel(own);
    if (count == 0 || (isIn(there) && target(at(there)))) return place;
    place.at = (glm::dvec2(std::isfinite(inner) ? innerAt : outerAt) + 0.5) * double(mMap.step);
    return place;
  }

  /// How much of what is about a place lets it be seen.
  double shareAt(const scene::Mark& mark, glm::dvec2 own) {
    glm::ivec2 middle = mapPixel(own);
    glm::dvec3 world = mark.points[0];
    if (!isIn(middle) || !isKept(world)) return 0.0;
    if (mMap.distances.empty()) return 1.0;
    const scene::Camera& camera = mView.camera();
    glm::dvec3 fromEye = world - camera.eye;
    double away = camera.projection == scene::Projection::Orthographic
                      ? glm::dot(fromEye, scene::cameraBasis(camera).forward)
                      : glm::length(fromEye);
    away -= kBehindSteps * scene::sectionStep(mScene) + kBehindPixels * mView.lengthPerPixel(world);
    int radius = std::max(1, int(std::lround(kLookRound * mMap.size.y))), all = 0, seen = 0;
    for (int y = -radius; y <= radius; ++y)
      for (int x = -radius; x <= radius; ++x) {
        glm::ivec2 pixel = middle + glm::ivec2(x, y);
        if (x * x + y * y > radius * radius || !isIn(pixel)) continue;
        ++all;
        seen += double(mMap.distances[at(pixel)]) >= away;
      }
    return glm::smoothstep(kHidden, kSeen, double(seen) / all);
  }

  /// No cut has removed what is at a place.
  bool isKept(glm::dvec3 world) {
    if (!mKept) mKept.emplace(mScene, world);
    if (mKept->isEmpty()) return true;
    if (!mField && mScene.labels.data) mField = scene::structureFieldOf(mScene);
    return mKept->keeps(world, std::uint16_t(scene::structureAt(mScene, world).id));
  }

  const scene::Scene& mScene;
  const SeenMap& mMap;
  ViewSpace mView;
  std::optional<render::KeptPlaces> mKept;
  std::shared_ptr<const StructureField> mField;  ///< held, so that each place asks the same one
};

}  // namespace

bool needsSeenPlaces(const scene::Lettering& lettering) {
  return std::ranges::any_of(lettering.marks, [](const scene::Mark& mark) { return mark.visible && hasLeader(mark); });
}

std::vector<SeenPlace> seenPlaces(const scene::Scene& scene, const SeenMap& map) {
  std::vector<SeenPlace> places;
  PlacesIn in(scene, map);
  for (const scene::Mark& mark : scene.lettering.marks)
    if (isShown(scene, mark) && hasLeader(mark)) places.push_back(in.find(followed(scene, mark)));
  return places;
}

}  // namespace velum::session
