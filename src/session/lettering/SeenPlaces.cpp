#include "session/lettering/SeenPlaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <unordered_map>
#include <utility>

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

bool hasLeader(const scene::Mark& mark) {
  bool isNaming = mark.kind == scene::MarkKind::Label || mark.kind == scene::MarkKind::Name;
  return isNaming && mark.points.size() == 1;
}

/// The pixels that show what a mark points at, and what is found of them.
struct PlaceSearch {
  enum class By { Place, Instance, Types, Structure };  ///< Place: it points at its place alone
  By by = By::Place;
  std::int32_t key = -1;  ///< of the instance or structure
  std::vector<std::int32_t> types;
  std::vector<bool> isType;  ///< by the numbers of types
  std::size_t place = 0;     ///< in the list of what is found
  glm::dvec2 own{0.0};       ///< pixels of the picture: next to which it is looked for
  // What has been found so far.
  std::uint64_t count = 0;
  double inner = std::numeric_limits<double>::infinity(),
         outer = inner;  ///< squares of how far away, pixels of the map
  glm::ivec2 innerAt{0}, outerAt{0};

  bool shows(const SeenMap& map, std::size_t i) const {
    if (by == By::Instance) return map.instances[i] == key;
    std::int32_t type = map.types.empty() ? -1 : map.types[i];
    if (by == By::Types) return type >= 0 && std::size_t(type) < isType.size() && isType[std::size_t(type)];
    return type < 0 && map.structures[i] == key;
  }
};

PlaceSearch searchOf(const scene::Scene& scene, const scene::Mark& mark, const SeenMap& map) {
  PlaceSearch search;
  bool followsOne = !mark.pointInstances.empty() && mark.pointInstances[0] >= 0;
  if (followsOne && mark.kind == scene::MarkKind::Label && !map.instances.empty()) {
    search.by = PlaceSearch::By::Instance;
    search.key = mark.pointInstances[0];
    return search;
  }
  if (!mark.type.empty() && !map.types.empty())
    for (const NameGroup& group : listedGroups(scene, {mark.type}, {}))
      for (std::uint32_t type : group.types) {
        if (search.isType.size() <= type) search.isType.resize(std::size_t(type) + 1);
        if (!search.isType[type]) search.types.push_back(std::int32_t(type));
        search.isType[type] = true;
      }
  if (!search.types.empty()) {
    search.by = PlaceSearch::By::Types;
    return search;
  }
  int structure = mark.structure;
  if (structure == 0 && !mark.pointStructures.empty()) structure = mark.pointStructures[0];
  if (structure <= 0 || !scene.labels.data || !scene.labels.visible || map.structures.empty()) return search;
  search.by = PlaceSearch::By::Structure;
  search.key = structure;
  return search;
}

/// Which searches want the pixels of a key. Pixels beside each other mostly show the same.
class SearchTable {
 public:
  void add(std::int32_t key, PlaceSearch& search) { mSearches[key].push_back(&search); }
  bool isEmpty() const { return mSearches.empty(); }
  const std::vector<PlaceSearch*>& at(std::int32_t key) {
    if (mLast && key == mLastKey) return *mLast;
    auto found = mSearches.find(key);
    mLastKey = key;
    mLast = found == mSearches.end() ? &mNone : &found->second;
    return *mLast;
  }

 private:
  std::unordered_map<std::int32_t, std::vector<PlaceSearch*>> mSearches;
  std::vector<PlaceSearch*> mNone;
  std::int32_t mLastKey = 0;
  const std::vector<PlaceSearch*>* mLast = nullptr;
};

class PlacesIn {
 public:
  PlacesIn(const scene::Scene& scene, const SeenMap& map, const render::SheetIndices& sheets)
      : mScene(scene), mMap(map), mSheets(sheets), mView(scene.camera, glm::dvec2(map.size * map.step)) {}

  void add(const scene::Mark& mark) {
    auto own = mView.pixelFromWorld(mark.points[0]);
    PlaceSearch search = searchOf(mScene, mark, mMap);
    bool isSearched = search.by != PlaceSearch::By::Place;
    search.place = mPlaces.size();
    search.own = own ? *own : 0.5 * mView.size();
    mPlaces.push_back({mark.id, {}, own && !isSearched ? shareAt(mark, *own) : 0.0});
    if (isSearched) mSearches.push_back(std::move(search));
  }

  /// In the order in which the marks were added.
  std::vector<SeenPlace> find() {
    if (!mSearches.empty()) lookAtAll();
    for (const PlaceSearch& search : mSearches) mPlaces[search.place] = placeOf(search);
    return std::move(mPlaces);
  }

 private:
  bool isIn(glm::ivec2 pixel) const {
    return glm::all(glm::greaterThanEqual(pixel, glm::ivec2(0))) && glm::all(glm::lessThan(pixel, mMap.size));
  }
  std::size_t at(glm::ivec2 pixel) const {
    return std::size_t(pixel.y) * std::size_t(mMap.size.x) + std::size_t(pixel.x);
  }
  glm::ivec2 mapPixel(glm::dvec2 pixel) const { return glm::ivec2(glm::floor(pixel / double(mMap.step))); }

  /// Hands each pixel to the searches that want it.
  void lookAtAll() {
    SearchTable byInstance, byType, byStructure;
    for (PlaceSearch& search : mSearches) {
      if (search.by == PlaceSearch::By::Instance) byInstance.add(search.key, search);
      if (search.by == PlaceSearch::By::Structure) byStructure.add(search.key, search);
      for (std::int32_t type : search.types) byType.add(type, search);
    }
    bool hasInstances = !byInstance.isEmpty(), hasTypes = !byType.isEmpty(), hasStructures = !byStructure.isEmpty();
    std::size_t i = 0;
    for (int y = 0; y < mMap.size.y; ++y)
      for (int x = 0; x < mMap.size.x; ++x, ++i) {
        auto give = [&](const std::vector<PlaceSearch*>& searches) {
          for (PlaceSearch* search : searches) take(*search, {x, y});
        };
        if (hasInstances) give(byInstance.at(mMap.instances[i]));
        if (hasTypes) give(byType.at(mMap.types[i]));
        if (hasStructures && (mMap.types.empty() || mMap.types[i] < 0)) give(byStructure.at(mMap.structures[i]));
      }
  }

  /// A pixel shows what is looked for.
  void take(PlaceSearch& search, glm::ivec2 pixel) const {
    ++search.count;
    glm::dvec2 away = glm::dvec2(pixel) - (search.own / double(mMap.step) - 0.5);
    double square = glm::dot(away, away);
    if (square < search.outer) search.outer = square, search.outerAt = pixel;
    if (square >= search.inner) return;
    bool isWithin = glm::all(glm::greaterThan(pixel, glm::ivec2(0))) && glm::all(glm::lessThan(pixel + 1, mMap.size));
    if (!isWithin) return;
    std::size_t i = at(pixel), row = std::size_t(mMap.size.x);
    if (search.shows(mMap, i - 1) && search.shows(mMap, i + 1) && search.shows(mMap, i - row) &&
        search.shows(mMap, i + row))
      search.inner = square, search.innerAt = pixel;
  }

  /// The pixel that shows it next to the mark's own place.
  SeenPlace placeOf(const PlaceSearch& search) const {
    double whole = kWholePart * mMap.size.y;
    SeenPlace place{
        mPlaces[search.place].mark, {}, glm::smoothstep(0.0, 1.0, double(search.count) / std::max(1.0, whole * whole))};
    glm::ivec2 there = mapPixel(search.own);
    if (search.count == 0 || (isIn(there) && search.shows(mMap, at(there)))) return place;
    glm::ivec2 nearest = std::isfinite(search.inner) ? search.innerAt : search.outerAt;
    place.at = (glm::dvec2(nearest) + 0.5) * double(mMap.step);
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
    if (std::ranges::none_of(mScene.cuts, &scene::Cut::enabled)) return true;
    if (!mKept) mKept.emplace(mScene, world, mSheets);
    if (!mField && mScene.labels.data) mField = scene::structureFieldOf(mScene);
    return mKept->keeps(world, std::uint16_t(scene::structureAt(mScene, world).id));
  }

  const scene::Scene& mScene;
  const SeenMap& mMap;
  const render::SheetIndices& mSheets;
  ViewSpace mView;
  std::vector<SeenPlace> mPlaces;
  std::vector<PlaceSearch> mSearches;
  std::optional<render::KeptPlaces> mKept;
  std::shared_ptr<const StructureField> mField;  ///< held, so that each place asks the same one
};

}  // namespace

bool needsSeenPlaces(const scene::Lettering& lettering) {
  return std::ranges::any_of(lettering.marks, [](const scene::Mark& mark) { return mark.visible && hasLeader(mark); });
}

std::vector<SeenPlace> seenPlaces(const scene::Scene& scene, const SeenMap& map, const render::SheetIndices& sheets) {
  PlacesIn in(scene, map, sheets);
  for (const scene::Mark& mark : scene.lettering.marks)
    if (isShown(scene, mark) && hasLeader(mark)) in.add(followed(scene, mark));
  return in.find();
}

}  // namespace velum::session
