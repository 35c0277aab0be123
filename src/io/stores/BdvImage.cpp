#include "io/stores/BdvImage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/Error.h"
#include "io/read/Placement.h"
#include "io/stores/PlaceLevels.h"

namespace velum::io {

namespace {

bool isNear(const glm::dmat4& a, const glm::dmat4& b) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (std::abs(a[column][row] - b[column][row]) > 1e-9 * (1 + std::abs(a[column][row]))) return false;
  return true;
}

std::string keyOf(const SpimData::Setup& setup) { return fmt::format("setup{}", setup.id); }

std::string attributeOf(const SpimData::Setup& setup, const std::string& name) {
  auto found = setup.attributes.find(name);
  return found == setup.attributes.end() ? std::string() : found->second;
}

}  // namespace

BdvImages::BdvImages(SpimData data, std::shared_ptr<const BdvVoxels> voxels, bool hasPlaces)
    : mData(std::move(data)), mVoxels(std::move(voxels)), mHasPlaces(hasPlaces) {
  if (mData.setups.empty() || mData.timePoints.empty()) refuse(mData.voxels, "holds no view setups or no time points");
  for (const SpimData::Setup& setup : mData.setups) {
    auto group =
        std::find_if(mGroups.begin(), mGroups.end(), [&](const Group& other) { return belongs(setup, other); });
    if (group == mGroups.end()) group = mGroups.insert(mGroups.end(), Group());
    group->push_back(setup);
  }
}

bool BdvImages::belongs(const SpimData::Setup& setup, const Group& group) const {
  const SpimData::Setup& first = group.front();
  auto others = [](const SpimData::Setup& of) {
    auto attributes = of.attributes;
    attributes.erase("channel");
    return attributes;
  };
  std::string channel = attributeOf(setup, "channel");
  bool isNew = !channel.empty() && std::none_of(group.begin(), group.end(), [&](const SpimData::Setup& one) {
    return attributeOf(one, "channel") == channel;
  });
  if (!isNew || attributeOf(first, "channel").empty() || others(setup) != others(first)) return false;
  if (setup.size != first.size || setup.voxelSize != first.voxelSize || setup.unit != first.unit) return false;
  int timePoint = mData.timePoints.front();
  if (!isNear(registration(timePoint, setup), registration(timePoint, first))) return false;
  return mVoxels->factors(setup.id) == mVoxels->factors(first.id);
}

std::string BdvImages::nameOf(const Group& group) const {
  const SpimData::Setup& first = group.front();
  if (group.size() == 1 && !first.name.empty()) return first.name;
  std::string name;
  for (const auto& [kind, id] : first.attributes) {
    if (kind == "channel") continue;
    auto known = mData.names.find({kind, id});
    name += fmt::format("{}{} {}", name.empty() ? "" : ", ", kind, known == mData.names.end() ? id : known->second);
  }
  return name.empty() ? keyOf(first) : name;
}

std::vector<StoreImage> BdvImages::list() const {
  std::vector<StoreImage> images;
  for (const Group& group : mGroups)
    images.push_back({keyOf(group.front()), nameOf(group), false, "", group.front().size.value_or(glm::ivec3(0))});
  return images;
}

glm::dmat4 BdvImages::registration(int timePoint, const SpimData::Setup& setup) const {
  auto found = mData.worldFrom.find({timePoint, setup.id});
  if (found != mData.worldFrom.end()) return found->second;
  return gridMatrix(setup.voxelSize.value_or(glm::dvec3(1.0)));
}

/// Registrations may be in the file's unit or, as tiles are registered, in edges of the voxel: then a voxel is not as
/// long as the file says, but all its edges are in proportion.
glm::dmat4 BdvImages::place(const SpimData::Setup& setup, std::vector<std::string>& warnings) const {
  int first = mData.timePoints.front();
  glm::dmat4 world = registration(first, setup);
  bool isMoving = std::any_of(mData.timePoints.begin(), mData.timePoints.end(), [&](int timePoint) {
    return mData.worldFrom.contains({timePoint, setup.id}) && !isNear(registration(timePoint, setup), world);
  });
  if (isMoving)
    warnings.push_back("each time point has a place of its own in the file; all were put where the first one lies");
  if (!setup.voxelSize) return world;
  glm::dvec3 ratio;
  for (int axis = 0; axis < 3; ++axis) ratio[axis] = (*setup.voxelSize)[axis] / glm::length(glm::dvec3(world[axis]));
  double mean = (ratio.x + ratio.y + ratio.z) / 3;
  bool isUniform = glm::all(glm::lessThan(glm::abs(ratio - mean), glm::dvec3(0.01 * mean)));
  if (!isUniform || !(std::abs(mean - 1) > 0.01) || !std::isfinite(mean)) return world;
  warnings.push_back(fmt::format(
      "the file places voxels in a unit of {:.6g} of those of its voxel size; they were made as large as that", mean));
  return glm::dmat4(glm::dmat3(mean)) * world;
}

std::shared_ptr<const ChunkArray> BdvImages::firstArray(const Group& group, int level, std::string& key) const {
  for (int timePoint : mData.timePoints)
    for (const SpimData::Setup& setup : group)
      if (auto array = mVoxels->open(timePoint, setup.id, level)) {
        key = mVoxels->key(timePoint, setup.id, level);
        return array;
      }
  refuse(mData.voxels, fmt::format("level {} of {} is missing at all time points", level, keyOf(group.front())));
}

void BdvImages::describeChannels(const Group& group, ArrayPyramid& pyramid) const {
  if (group.size() < 2) return;
  for (const SpimData::Setup& setup : group) {
    auto known = mData.names.find({"channel", attributeOf(setup, "channel")});
    pyramid.head.channelNames.push_back(known != mData.names.end() ? known->second
                                        : setup.name.empty()       ? keyOf(setup)
                                                                   : setup.name);
  }
}

ArrayPyramid BdvImages::read(const std::string& key) const {
  auto chosen = std::find_if(mGroups.begin(), mGroups.end(),
                             [&](const Group& group) { return key.empty() || keyOf(group.front()) == key; });
  if (chosen == mGroups.end()) refuse(mData.voxels, fmt::format("the store holds no image {}", inQuotes(key)));
  const Group& group = *chosen;
  ArrayPyramid pyramid;
  Volume& head = pyramid.head;
  if (!mHasPlaces)
    head.warnings.push_back("there is no XML beside it that says how large voxels are and where they lie");
  auto factors = mVoxels->factors(group.front().id);
  glm::dmat4 world = place(group.front(), head.warnings);
  std::vector<glm::dmat4> places;
  for (int level = 0; level < int(factors.size()); ++level) {
    std::string name;
    auto array = firstArray(group, level, name);
    pyramid.levels.push_back(levelOf(*array));
    pyramid.facts.levels.push_back(storedAs(*array, name));
    places.push_back(world * finestFromLevel(factors[std::size_t(level)]));
    if (level == 0) head.type = sampleTypeOf(array->type);
  }
  if (mGroups.size() > 1 || !group.front().name.empty()) head.name = nameOf(group);
  head.channels = int(group.size());
  head.timeSteps = int(mData.timePoints.size());
  describeChannels(group, pyramid);
  pyramid.facts.axes = "t c z y x";
  placeLevels(pyramid, places, group.front().unit);
  std::vector<int> setups;
  for (const SpimData::Setup& setup : group) setups.push_back(setup.id);
  pyramid.open = [voxels = mVoxels, setups, timePoints = mData.timePoints](int level, int channel, int timeStep) {
    return voxels->open(timePoints[std::size_t(timeStep)], setups[std::size_t(channel)], level);
  };
  return pyramid;
}

}  // namespace velum::io
