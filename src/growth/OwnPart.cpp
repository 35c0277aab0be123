#include "growth/OwnPart.h"

#include <algorithm>
#include <vector>

#include "growth/DivideRegion.h"
#include "growth/GrowRule.h"
#include "growth/PassageCosts.h"
#include "growth/WriteRegion.h"

namespace velum::growth {

namespace {

/// Between two time steps a border moves by fewer voxels than this, or seeds hold.
constexpr int kMovingBorder = 3;
constexpr std::uint16_t kOthersId = 1;

using Places = std::vector<std::size_t>;

/// Calls body(voxel, place) for each voxel of the region.
template <class Body>
void forRegion(const PassageCosts& costs, const Body& body) {
  const RoomyBox& box = costs.box();
  for (int z = box.first().z; z < box.end().z; ++z)
    for (int y = box.first().y; y < box.end().y; ++y) {
      std::size_t place = box.at({box.first().x, y, z});
      for (int x = box.first().x; x < box.end().x; ++x, ++place)
        if (costs.holds(place)) body(glm::ivec3(x, y, z), place);
    }
}

Places placesWith(const PassageCosts& costs, const LabelVolume& labels, int id) {
  Places places;
  forRegion(costs, [&](glm::ivec3 voxel, std::size_t place) {
    if (int(labels.at(voxel)) == id) places.push_back(place);
  });
  return places;
}

/// Those of the box; of a seed that could not join itself its neighbours.
void addSeed(const PassageCosts& costs, glm::ivec3 voxel, Places& places) {
  const RoomyBox& box = costs.box();
  auto add = [&](glm::ivec3 v) {
    if (!box.holds(v) || !costs.holds(box.at(v))) return false;
    places.push_back(box.at(v));
    return true;
  };
  if (add(voxel)) return;
  for (int axis = 0; axis < 3; ++axis)
    for (int side : {-1, 1}) {
      glm::ivec3 beside = voxel;
      beside[axis] += side;
      add(beside);
    }
}

/// Without what lies near to some others; all of it where nothing would be left.
Places awayFrom(const Places& places, const Places& others, const RoomyBox& box, const glm::dmat3& worldFromVoxel) {
  Lengths lengths(box.count(), kFarAway);
  for (std::size_t place : others) lengths[place] = 0;
  spreadLengths(box, worldFromVoxel, lengths);
  Places away;
  std::copy_if(places.begin(), places.end(), std::back_inserter(away),
               [&](std::size_t place) { return lengths[place] >= kMovingBorder * kLengthUnit; });
  return away.empty() ? places : away;
}

RegionGrow::Changed rowsOf(const RoomyBox& box) {
  RegionGrow::Changed changed{{box.first(), box.end()}, {}};
  for (int z = box.first().z; z < box.end().z; ++z)
    for (int y = box.first().y; y < box.end().y; ++y) changed.rows.push_back({y, z});
  return changed;
}

}  // namespace

std::optional<OwnPart> ownPartOf(const RegionGrow& region, const Volume& volume, const LabelVolume& before,
                                 const scene::Growth& step, const GrowDomain& domain, const GrowOptions& options,
                                 Progress& progress) {
  FinestVoxels voxels(volume);
  const Volume& grid = voxels.grid();
  bool mayBeThere = options.othersBegun || std::any_of(step.others.begin(), step.others.end(), [&](glm::dvec3 place) {
                      return region.has(voxelAt(grid, place));
                    });
  if (!mayBeThere) return std::nullopt;
  PassageCosts costs(region, voxels, domain, progress);
  const RoomyBox& box = costs.box();
  // Both kinds of seeds.
  Places own = placesWith(costs, before, step.structure), others;
  for (glm::dvec3 seed : step.seeds) addSeed(costs, voxelAt(grid, seed), own);
  for (glm::dvec3 other : step.others)
    if (glm::ivec3 voxel = voxelAt(grid, other); box.holds(voxel)) others.push_back(box.at(voxel));
  if (options.begun && options.othersBegun) {
    Places begun = placesWith(costs, *options.begun, step.structure);
    Places begunOthers = placesWith(costs, *options.othersBegun, kOthersId);
    glm::dmat3 worldFromVoxel(grid.worldFromVoxel);
    Places inner = awayFrom(begun, begunOthers, box, worldFromVoxel);
    Places innerOthers = awayFrom(begunOthers, begun, box, worldFromVoxel);
    own.insert(own.end(), inner.begin(), inner.end());
    others.insert(others.end(), innerOthers.begin(), innerOthers.end());
  } else if (options.begun) {
    Places begun = placesWith(costs, *options.begun, step.structure);
    own.insert(own.end(), begun.begin(), begun.end());
  }
  std::erase_if(others, [&](std::size_t place) { return !costs.holds(place); });
  if (others.empty()) return std::nullopt;
  progress.report(0.5, "Growing");
  std::vector<Owner> owners = divideRegion(costs, own, others, progress);
  // What belongs to whom.
  OwnPart part{BoxBits({box.first(), box.end()}), {}};
  BoxBits theirs({box.first(), box.end()});
  forRegion(costs, [&](glm::ivec3 v, std::size_t place) { (owners[place] == Owner::Own ? part.own : theirs).set(v); });
  LabelVolume labels(grid.dims, grid.worldFromVoxel, grid.lengthUnit);
  writeRegion([&](int y, int z, int w) { return theirs.word(y, z, w); }, rowsOf(box), kOthersId, labels);
  part.others = Shared<LabelVolume>(std::move(labels));
  return part;
}

}  // namespace velum::growth
