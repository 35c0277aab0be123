#include "session/measure/Solid.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "core/BrickCache.h"
#include "core/FinestVoxels.h"
#include "render/kept/KeptPlaces.h"
#include "scene/Scene.h"
#include "scene/Shown.h"
#include "scene/StructureAt.h"
#include "session/measure/ValueBetween.h"

namespace velum::session {

namespace {

/// So many smallest edges of voxels from a place structures and faces are looked for: a hand that points is no better.
constexpr double kNearEdges = 2.0;

glm::dvec3 placeIn(const glm::dmat4& from, glm::dvec3 world) { return glm::dvec3(from * glm::dvec4(world, 1.0)); }

SolidGrid gridOf(glm::ivec3 dims, const glm::dmat4& worldFromVoxel) {
  SolidGrid grid;
  glm::dmat3 axes(worldFromVoxel);
  auto [least, most] = std::minmax({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
  grid.fineness = least;
  grid.roughness = most / least;
  grid.box = {glm::dvec3(1e300), glm::dvec3(-1e300)};
  glm::dmat4 worldFromUnit = worldFromBox(dims, worldFromVoxel);
  for (int i = 0; i < 8; ++i) {
    glm::dvec3 corner = placeIn(worldFromUnit, glm::dvec3(i & 1, i >> 1 & 1, i >> 2));
    grid.box.low = glm::min(grid.box.low, corner);
    grid.box.high = glm::max(grid.box.high, corner);
  }
  return grid;
}

/// What tells whose a place is among the structures that are shown, and are left by the cuts.
class ShownStructures {
 public:
  explicit ShownStructures(const scene::Scene& scene)
      : mField(scene::structureFieldOf(scene)),
        mLabelFromWorld(glm::inverse(scene.labels.data->worldFromVoxel())),
        mKept(scene, glm::dvec3(glm::inverse(mLabelFromWorld)[3])),
        mIsHidden(65536, false) {
    mIsHidden[0] = true;
    for (const scene::Structure& structure : scene.labels.structures)
      if (structure.id > 0 && structure.id < 65536) mIsHidden[std::size_t(structure.id)] = !structure.visible;
  }
  /// 0: none
  std::uint16_t at(glm::dvec3 world) const {
    std::uint16_t id = mField->at(placeIn(mLabelFromWorld, world)).id;
    return mIsHidden[id] || !mKept.keeps(world, id) ? 0 : id;
  }
  /// The nearest one to a place, of those that are near.
  std::uint16_t near(glm::dvec3 world, double fineness) const {
    for (int ring = 0; ring <= 4; ++ring)
      for (int i = 0; i < 27; ++i) {
        glm::dvec3 way(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if ((ring == 0) != (i == 13)) continue;
        glm::dvec3 step = ring == 0 ? glm::dvec3(0.0) : glm::normalize(way) * (kNearEdges * fineness * ring / 4.0);
        if (std::uint16_t id = at(world + step)) return id;
      }
    return 0;
  }

 private:
  std::shared_ptr<const StructureField> mField;
  glm::dmat4 mLabelFromWorld;
  render::KeptPlaces mKept;
  std::vector<bool> mIsHidden;
};

/// A volume's level as fine as is needed, about a box.
struct Looked {
  std::shared_ptr<const Volume> own;  ///< of what is streamed
  const Volume* volume = nullptr;
  int channel = 0, timeStep = 0;
  glm::dmat4 voxelFromWorld{1.0};

  double at(glm::dvec3 world) const { return valueBetween(*volume, placeIn(voxelFromWorld, world), channel, timeStep); }
  bool isInside(glm::dvec3 world) const {
    glm::dvec3 voxel = placeIn(voxelFromWorld, world);
    return glm::all(glm::greaterThanEqual(voxel, glm::dvec3(-0.5))) &&
           glm::all(glm::lessThanEqual(voxel, glm::dvec3(volume->dims) - 0.5));
  }
};

Looked lookAt(const scene::VolumeLayer& layer, const WorldBox& box, double step, Progress& progress) {
  const Volume& volume = *layer.data;
  Looked looked{nullptr, &volume, scene::shownChannel(layer), scene::shownTimeStep(layer)};
  if (volume.finer) {
    int level = 0, levels = int(volume.finer->bricks->source().levels().size());
    while (level + 1 < levels && smallestSpacing(worldFromLevel(volume, level + 1)) <= step) ++level;
    FinestVoxels voxels(volume, level);
    glm::dmat4 voxelFromWorld = glm::inverse(voxels.grid().worldFromVoxel);
    glm::dvec3 low(1e300), high(-1e300);
    for (int i = 0; i < 8; ++i) {
      glm::dvec3 corner = placeIn(voxelFromWorld, glm::mix(box.low, box.high, glm::dvec3(i & 1, i >> 1 & 1, i >> 2)));
      low = glm::min(low, corner);
      high = glm::max(high, corner);
    }
    glm::dvec3 end(voxels.grid().dims);
    glm::ivec3 first(glm::clamp(glm::floor(low) - 1.0, glm::dvec3(0.0), end - 1.0));
    glm::ivec3 last(glm::clamp(glm::ceil(high) + 2.0, glm::dvec3(first) + 1.0, end));
    looked.own =
        std::make_shared<const Volume>(voxels.readAll(first, last - first, looked.channel, looked.timeStep, progress));
    looked.volume = looked.own.get();
    looked.channel = looked.timeStep = 0;
  }
  looked.voxelFromWorld = glm::inverse(looked.volume->worldFromVoxel);
  return looked;
}

/// The value at which the surface lies; nothing where no value is known at the places.
std::optional<double> valueOfSurface(const scene::Scene& scene, const Looked& looked, const render::KeptPlaces& kept,
                                     double fineness, glm::dvec3 a, glm::dvec3 b) {
  if (scene.rayCast.mode == scene::RenderMode::Iso) return scene.rayCast.isoValue;
  double sum = 0.0, least = 1e300;
  int count = 0;
  for (glm::dvec3 place : {a, b}) {
    double value = looked.at(place);
    if (!std::isfinite(value)) continue;
    least = std::min(least, value);
    // On a face any value may be.
    if (std::abs(kept.distance(place, 0).distance) < kNearEdges * fineness) continue;
    sum += value;
    ++count;
  }
  if (count > 0) return sum / count;
  if (least < 1e300) return least - 1e-6 * std::abs(least);
  return std::nullopt;
}

}  // namespace

SolidPlace solidPlaceAt(const scene::Scene& scene, glm::dvec3 a, glm::dvec3 b) {
  SolidPlace place;
  if (scene.labels.data && scene.labels.visible) {
    const LabelVolume& labels = *scene.labels.data;
    place.grid = gridOf(labels.dims(), labels.worldFromVoxel());
    ShownStructures shown(scene);
    place.isStructure = shown.near(a, place.grid.fineness) != 0 && shown.near(b, place.grid.fineness) != 0;
    if (place.isStructure) return place;
  }
  if (!scene.volume.data) {
    place.problem = "there is no surface under both points";
    return place;
  }
  FinestVoxels voxels(*scene.volume.data);
  place.grid = gridOf(voxels.grid().dims, voxels.grid().worldFromVoxel);
  return place;
}

Solid solidUnder(const scene::Scene& scene, const SolidPlace& place, glm::dvec3 a, glm::dvec3 b, const WorldBox& box,
                 double step, Progress& progress) {
  Solid solid;
  double fineness = place.grid.fineness;
  if (place.isStructure) {
    auto shown = std::make_shared<const ShownStructures>(scene);
    std::uint16_t first = shown->near(a, fineness), second = shown->near(b, fineness);
    solid.holds = [shown, only = first == second ? first : std::uint16_t(0)](glm::dvec3 world) {
      std::uint16_t id = shown->at(world);
      return only != 0 ? id == only : id != 0;
    };
    return solid;
  }
  auto looked = std::make_shared<const Looked>(lookAt(scene.volume, box, step, progress));
  auto kept = std::make_shared<const render::KeptPlaces>(scene, 0.5 * (a + b));
  auto value = valueOfSurface(scene, *looked, *kept, fineness, a, b);
  if (!value) {
    solid.problem = "the points lie outside of the volume";
    return solid;
  }
  solid.holds = [looked, kept, least = *value](glm::dvec3 world) {
    return looked->isInside(world) && looked->at(world) >= least && (kept->isEmpty() || kept->keeps(world, 0));
  };
  return solid;
}

}  // namespace velum::session
