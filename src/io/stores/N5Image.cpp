#include "io/stores/N5Image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/read/Placement.h"
#include "io/stores/N5Array.h"
#include "io/stores/PlaceLevels.h"

namespace velum::io {

namespace {

constexpr std::size_t kMostGroups = 20'000;
constexpr int kDeepest = 8;

std::string levelKey(const Store& store, const std::string& key, std::size_t level) {
  return keyBelow(store, key, fmt::format("s{}", level));
}

/// Walks over the groups of a store, but not over the blocks of datasets.
class N5List {
 public:
  explicit N5List(const Store& store) : mStore(store) {}
  std::vector<StoreImage> images;

  void add(const std::string& key, int depth) {
    if (++mGroups > kMostGroups) return;
    Json attributes = n5Attributes(mStore, key);
    if (isN5Dataset(attributes) || isN5Dataset(n5Attributes(mStore, levelKey(mStore, key, 0)))) {
      images.push_back({key, key, false, "", {}});
      return;
    }
    if (depth >= kDeepest) return;
    for (const std::string& name : mStore.folders(key)) add(keyBelow(mStore, key, name), depth + 1);
  }

 private:
  const Store& mStore;
  std::size_t mGroups = 0;
};

/// Three numbers of a list that has as many or more; nothing for anything else.
std::optional<glm::dvec3> threeOf(const Json& list) {
  if (!list.is_array() || list.size() < 2) return std::nullopt;
  glm::dvec3 numbers(1.0);
  for (std::size_t i = 0; i < std::min<std::size_t>(3, list.size()); ++i) {
    if (!list[i].is_number() || !std::isfinite(list[i].get<double>())) return std::nullopt;
    numbers[int(i)] = list[i].get<double>();
  }
  return numbers;
}

/// The size of a voxel, with its unit where that is said, as different programs write it.
std::optional<glm::dvec3> voxelSizeOf(const Json& attributes, std::string& unit) {
  for (const char* word : {"pixelResolution", "resolution"}) {
    const Json& value = memberOf(attributes, word);
    auto size = threeOf(value.is_object() ? memberOf(value, "dimensions") : value);
    if (!size || !(glm::min(glm::min(size->x, size->y), size->z) > 0)) continue;
    unit = wordOf(memberOf(value, "unit"));
    if (unit.empty()) unit = wordOf(memberOf(attributes, "unit"));
    if (const Json& units = memberOf(attributes, "units"); unit.empty() && units.is_array() && !units.empty())
      unit = wordOf(units.front());
    return size;
  }
  return std::nullopt;
}

/// A dataset's own `transform`: scale and translation by the names of axes.
std::optional<glm::dmat4> transformOf(const Json& attributes, std::string& unit) {
  const Json &transform = memberOf(attributes, "transform"), &axes = memberOf(transform, "axes"),
             &scale = memberOf(transform, "scale"), &translate = memberOf(transform, "translate"),
             &units = memberOf(transform, "units");
  if (!axes.is_array() || !scale.is_array() || scale.size() != axes.size()) return std::nullopt;
  glm::dvec3 spacing(1.0), origin(0.0);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    std::string name = wordOf(axes[i]);
    std::size_t axis = std::string_view("xyz").find(name);
    if (name.size() != 1 || axis == std::string_view::npos || !scale[i].is_number()) continue;
    spacing[int(axis)] = scale[i].get<double>();
    if (translate.is_array() && i < translate.size() && translate[i].is_number())
      origin[int(axis)] = translate[i].get<double>();
    if (units.is_array() && i < units.size()) unit = wordOf(units[i]);
  }
  return gridMatrix(spacing, origin);
}

/// Where the levels of an image lie.
class N5Places {
 public:
  N5Places(Json group, const std::vector<Json>& levels, const std::vector<VoxelLevel>& sizes)
      : mGroup(std::move(group)), mLevels(levels), mSizes(sizes) {}

  std::vector<glm::dmat4> places(std::string& unit) const {
    auto size = voxelSizeOf(mGroup, unit);
    if (!size) size = voxelSizeOf(mLevels.front(), unit);
    std::vector<glm::dmat4> places;
    for (std::size_t i = 0; i < mLevels.size(); ++i) {
      auto own = transformOf(mLevels[i], unit);
      places.push_back(own ? *own : gridMatrix(size.value_or(glm::dvec3(1.0))) * finestFromLevel(factor(i)));
    }
    return places;
  }

 private:
  glm::dvec3 factor(std::size_t level) const {
    auto usable = [](const Json& list) {
      auto three = threeOf(list);
      return three && three->x >= 1 && three->y >= 1 && three->z >= 1 ? three : std::nullopt;
    };
    if (auto own = usable(memberOf(mLevels[level], "downsamplingFactors"))) return *own;
    for (const char* word : {"downsamplingFactors", "scales"})
      if (const Json& all = memberOf(mGroup, word); all.is_array() && all.size() == mLevels.size())
        if (auto own = usable(all[level])) return *own;
    return factorFromDims(mSizes.front().dims, mSizes[level].dims);
  }

  Json mGroup;
  const std::vector<Json>& mLevels;
  const std::vector<VoxelLevel>& mSizes;
};

}  // namespace

std::vector<StoreImage> listN5Images(const Store& store) {
  N5List list(store);
  list.add("", 0);
  return std::move(list.images);
}

ArrayPyramid readN5Image(const std::shared_ptr<const Store>& store, const std::string& key) {
  Json group = n5Attributes(*store, key);
  bool isAlone = isN5Dataset(group);
  ArrayPyramid pyramid;
  pyramid.isWhole = true;
  std::vector<Json> attributes;
  std::vector<std::shared_ptr<const ChunkArray>> arrays;
  for (std::size_t i = 0; i < kMostLevels; ++i) {
    std::string name = isAlone ? key : levelKey(*store, key, i);
    Json of = isAlone ? group : n5Attributes(*store, name);
    if (!isN5Dataset(of)) break;
    auto array = std::make_shared<N5Array>(store, name, of);
    pyramid.levels.push_back(levelOf(*array));
    pyramid.facts.levels.push_back(storedAs(*array, name));
    if (i > 0 && (array->size[3] != arrays[0]->size[3] || array->size[4] != arrays[0]->size[4] ||
                  sampleTypeOf(array->type) != sampleTypeOf(arrays[0]->type)))
      refuse(array->path, "it has another type, or other channels or time steps, than the finest level");
    arrays.push_back(std::move(array));
    attributes.push_back(std::move(of));
    if (isAlone) break;
  }
  if (arrays.empty()) refuse(store->pathOf(key), "is no dataset of N5, and holds no levels s0, s1, ...");
  pyramid.head.type = sampleTypeOf(arrays[0]->type);
  pyramid.head.channels = int(arrays[0]->size[3]);
  pyramid.head.timeSteps = int(arrays[0]->size[4]);
  pyramid.head.name = key.substr(key.rfind('/') + 1);  // all of it where there is no '/'
  pyramid.facts.axes = arrays[0]->size[4] > 1 ? "t c z y x" : arrays[0]->size[3] > 1 ? "c z y x" : "z y x";
  std::string unit;
  auto places = N5Places(std::move(group), attributes, pyramid.levels).places(unit);
  placeLevels(pyramid, places, unit);
  pyramid.open = [arrays](int level, int, int) { return arrays[std::size_t(level)]; };
  return pyramid;
}

}  // namespace velum::io
