#include "io/stores/BdvVoxels.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/stores/Hdf5Array.h"
#include "io/stores/N5Array.h"
#include "io/stores/StoreSource.h"

namespace velum::io {

namespace {

/// The number of "s03" after "s"; nothing for other names.
std::optional<int> numberAfter(std::string_view word, std::string_view name) {
  if (!name.starts_with(word) || name.size() == word.size()) return std::nullopt;
  int number = 0;
  auto [end, error] = std::from_chars(name.data() + word.size(), name.data() + name.size(), number);
  return error == std::errc() && end == name.data() + name.size() ? std::optional(number) : std::nullopt;
}

void addSetup(SpimData& data, int id) {
  SpimData::Setup setup;
  setup.id = id;
  data.setups.push_back(setup);
}

/// Factors that strangers wrote. @throw InputError
glm::dvec3 checkedFactor(glm::dvec3 factor, const Path& path) {
  bool isFit = factor.x >= 1 && factor.y >= 1 && factor.z >= 1 && std::isfinite(factor.x + factor.y + factor.z);
  if (!isFit)
    refuse(path, fmt::format("the factors {}, {}, {} of a level make no sense", factor.x, factor.y, factor.z));
  return factor;
}

class Hdf5Voxels : public BdvVoxels {
 public:
  explicit Hdf5Voxels(std::shared_ptr<const Hdf5File> file) : mFile(std::move(file)) {}

  std::vector<glm::dvec3> factors(int setup) const override {
    auto rows = mFile->numbers(fmt::format("s{:02}/resolutions", setup));
    if (rows.empty() || rows.size() % 3 != 0 || rows.size() / 3 > kMostLevels)
      refuse(mFile->path(), fmt::format("the resolutions of setup {} are missing, or are no rows of three", setup));
    std::vector<glm::dvec3> factors;
    for (std::size_t i = 0; i < rows.size(); i += 3)
      factors.push_back(checkedFactor({rows[i], rows[i + 1], rows[i + 2]}, mFile->path()));
    return factors;
  }
  std::string key(int timePoint, int setup, int level) const override {
    return fmt::format("t{:05}/s{:02}/{}/cells", timePoint, setup, level);
  }
  std::shared_ptr<const ChunkArray> open(int timePoint, int setup, int level) const override {
    auto array = openArray(*mFile, key(timePoint, setup, level));
    // Java has no unsigned numbers: they were stored as signed ones, and in old files nothing else was.
    std::string said = mFile->text(fmt::format("s{:02}", setup), "dataType").value_or("uint16");
    if (array && array->type.kind == ChunkType::Kind::Signed && said == fmt::format("uint{}", 8 * array->type.bytes))
      array->type.kind = ChunkType::Kind::Unsigned;
    return array;
  }
  SpimData describe() const override {
    SpimData data;
    for (const std::string& name : mFile->names("")) {
      if (auto id = numberAfter("s", name)) addSetup(data, *id);
      if (auto id = numberAfter("t", name)) data.timePoints.push_back(*id);
    }
    data.voxels = mFile->path();
    return data;
  }

 private:
  std::shared_ptr<const Hdf5File> mFile;
};

class N5Voxels : public BdvVoxels {
 public:
  explicit N5Voxels(std::shared_ptr<const Store> store) : mStore(std::move(store)) {}

  std::vector<glm::dvec3> factors(int setup) const override {
    std::string group = fmt::format("setup{}", setup);
    Json attributes = n5Attributes(*mStore, group);
    const Json& rows = memberOf(attributes, "downsamplingFactors");
    if (!rows.is_array() || rows.empty()) return {glm::dvec3(1.0)};
    Path path = mStore->pathOf(group + "/attributes.json");
    if (rows.size() > kMostLevels) refuse(path, fmt::format("{} levels make no sense", rows.size()));
    std::vector<glm::dvec3> factors;
    for (const Json& row : rows) factors.push_back(checkedFactor(vectorOf(row, path, "a downsampling factor"), path));
    return factors;
  }
  std::string key(int timePoint, int setup, int level) const override {
    return fmt::format("setup{}/timepoint{}/s{}", setup, timePoint, level);
  }
  std::shared_ptr<const ChunkArray> open(int timePoint, int setup, int level) const override {
    return openN5(mStore, key(timePoint, setup, level));
  }
  SpimData describe() const override {
    SpimData data;
    for (const std::string& name : mStore->folders(""))
      if (auto id = numberAfter("setup", name)) addSetup(data, *id);
    if (!data.setups.empty())
      for (const std::string& name : mStore->folders(fmt::format("setup{}", data.setups.front().id)))
        if (auto id = numberAfter("timepoint", name)) data.timePoints.push_back(*id);
    data.voxels = mStore->pathOf("");
    return data;
  }

 private:
  std::shared_ptr<const Store> mStore;
};

}  // namespace

std::shared_ptr<const BdvVoxels> bdvInHdf5(std::shared_ptr<const Hdf5File> file) {
  return std::make_shared<Hdf5Voxels>(std::move(file));
}

std::shared_ptr<const BdvVoxels> bdvInN5(std::shared_ptr<const Store> store) {
  return std::make_shared<N5Voxels>(std::move(store));
}

bool isBdv(const Hdf5File& file) {
  for (const std::string& name : file.names(""))
    if (numberAfter("s", name) && file.has(name + "/resolutions")) return true;
  return false;
}

bool isBdv(const Store& store) {
  for (const std::string& name : store.folders(""))
    if (numberAfter("setup", name)) return true;
  return false;
}

}  // namespace velum::io
