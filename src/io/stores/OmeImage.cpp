#include "io/stores/OmeImage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "io/stores/OmeGroup.h"
#include "io/stores/StoreSource.h"
#include "io/stores/WideIds.h"

namespace velum::io {

namespace {

using Role = OmeAxis::Role;

constexpr std::size_t kMostAxes = 5;

/// Reads one image of a group. Refusals name the file with the group's attributes.
class ImageReader {
 public:
  ImageReader(const Store& store, std::string key, const Json& attributes)
      : mStore(store), mAttributes(attributes), mPath(omePath(store, key)) {
    mImage.key = std::move(key);
  }

  OmeImage read() {
    const Json& all = memberOf(mAttributes, "multiscales");
    if (!all.is_array() || all.empty()) refuseIt("its list of multiscales is empty");
    const Json& multiscale = all.front();
    std::string version = wordOf(memberOf(mAttributes, "version"));
    if (version.empty()) version = wordOf(memberOf(multiscale, "version"));
    mIsOld = version == "0.1" || version == "0.2" || version == "0.3";
    mImage.name = wordOf(memberOf(multiscale, "name"));
    if (mImage.name == "/") mImage.name.clear();
    readAxes(multiscale);
    readLevels(multiscale);
    return std::move(mImage);
  }

 private:
  [[noreturn]] void refuseIt(std::string_view why) const { refuse(mPath, why); }
  void readAxes(const Json& multiscale);
  void addAxis(const Json& axis);
  void nameSpace();
  void readLevels(const Json& multiscale);
  OmeLevel readLevel(const Json& dataset);
  void apply(OmeLevel& level, const Json& transformations, bool isOfLevel);
  void applyOne(OmeLevel& level, const Json& transformation, int& scales);
  std::vector<double> numbers(const Json& transformation, std::string_view name) const;

  const Store& mStore;
  const Json& mAttributes;
  Path mPath;
  bool mIsOld = false;  ///< a version that has no transformations
  OmeImage mImage;
  std::vector<bool> mIsSpace;
};

void ImageReader::readAxes(const Json& multiscale) {
  const Json* axes = &memberOf(multiscale, "axes");
  if (const Json& systems = memberOf(multiscale, "coordinateSystems"); systems.is_array() && !systems.empty())
    axes = &memberOf(systems.front(), "axes");  // 0.6
  static const Json kOldest = {"t", "c", "z", "y", "x"};
  if (axes->is_null() && mIsOld) axes = &kOldest;
  if (!axes->is_array() || axes->empty()) refuseIt("its multiscales have no axes");
  if (axes->size() > kMostAxes) refuseIt(fmt::format("it has {} axes; {} are the most", axes->size(), kMostAxes));
  for (const Json& axis : *axes) addAxis(axis);
  nameSpace();
}

void ImageReader::addAxis(const Json& json) {
  OmeAxis axis;
  axis.name = json.is_string() ? wordOf(json) : wordOf(memberOf(json, "name"));
  axis.unit = wordOf(memberOf(json, "unit"));
  const Json& stated = memberOf(json, "type");
  std::string type = wordOf(stated);
  if (axis.name.empty()) refuseIt("one of its axes has no name");
  if (!stated.is_null() && !stated.is_string()) refuseIt("the type of one of its axes is no word");
  for (const OmeAxis& other : mImage.axes)
    if (other.name == axis.name) refuseIt(fmt::format("two of its axes are called {}", inQuotes(axis.name)));
  if (type.empty()) type = axis.name == "t" ? "time" : axis.name == "c" ? "channel" : "space";
  bool isSpace = type == "space";
  axis.role = type == "time" ? Role::Time : Role::Channel;
  for (std::size_t i = 0; i < mImage.axes.size() && !isSpace; ++i)
    if (!mIsSpace[i] && mImage.axes[i].role == axis.role)
      refuseIt(fmt::format("it has two axes, {} and {}, where there is room for one beside those of space",
                           inQuotes(mImage.axes[i].name), inQuotes(axis.name)));
  mImage.axes.push_back(axis);
  mIsSpace.push_back(isSpace);
}

/// Axes of space are z, y and x, by their names, or else in this order.
void ImageReader::nameSpace() {
  std::vector<std::size_t> spaces;
  for (std::size_t i = 0; i < mIsSpace.size(); ++i)
    if (mIsSpace[i]) spaces.push_back(i);
  if (spaces.size() < 2 || spaces.size() > 3)
    refuseIt(fmt::format("it has {} axes of space, not 2 or 3", spaces.size()));
  constexpr std::string_view kNames = "zyx";
  constexpr Role kRoles[] = {Role::Z, Role::Y, Role::X};
  bool isNamed = std::all_of(spaces.begin(), spaces.end(), [&](std::size_t i) {
    return mImage.axes[i].name.size() == 1 && kNames.find(mImage.axes[i].name) != kNames.npos;
  });
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    OmeAxis& axis = mImage.axes[spaces[i]];
    axis.role = isNamed ? kRoles[kNames.find(axis.name)] : kRoles[i + 3 - spaces.size()];
  }
}

void ImageReader::readLevels(const Json& multiscale) {
  const Json& datasets = memberOf(multiscale, "datasets");
  if (!datasets.is_array() || datasets.empty()) refuseIt("its multiscales have no datasets");
  if (datasets.size() > kMostLevels) refuseIt(fmt::format("it has {} levels, which makes no sense", datasets.size()));
  for (const Json& dataset : datasets) {
    OmeLevel level = readLevel(dataset);
    if (const Json& common = memberOf(multiscale, "coordinateTransformations"); !common.is_null())
      apply(level, common, false);
    mImage.levels.push_back(std::move(level));
  }
}

OmeLevel ImageReader::readLevel(const Json& dataset) {
  std::string name = wordOf(memberOf(dataset, "path"));
  if (name.empty()) refuseIt("one of its datasets has no path");
  OmeLevel level;
  level.key = keyBelow(mStore, mImage.key, name);
  level.scale.assign(mImage.axes.size(), 1.0);
  level.translation.assign(mImage.axes.size(), 0.0);
  if (!mIsOld) apply(level, memberOf(dataset, "coordinateTransformations"), true);
  return level;
}

void ImageReader::apply(OmeLevel& level, const Json& transformations, bool isOfLevel) {
  if (!transformations.is_array() || transformations.empty()) refuseIt("a level has no coordinateTransformations");
  int scales = 0;
  for (const Json& one : transformations) applyOne(level, one, scales);
  if (scales > 1 || (isOfLevel && scales == 0)) refuseIt(fmt::format("a level has {} scales, not one", scales));
}

void ImageReader::applyOne(OmeLevel& level, const Json& transformation, int& scales) {
  std::string type = wordOf(memberOf(transformation, "type"));
  if (type == "identity") return;
  if (type == "sequence") {  // 0.6
    const Json& inner = memberOf(transformation, "transformations");
    if (!inner.is_array()) refuseIt("a sequence of transformations is no list");
    for (const Json& one : inner) {
      if (wordOf(memberOf(one, "type")) == "sequence") refuseIt("it has a sequence in a sequence of transformations");
      applyOne(level, one, scales);
    }
    return;
  }
  if (type == "scale") {
    std::vector<double> scale = numbers(transformation, "scale");
    for (std::size_t i = 0; i < scale.size(); ++i) {
      level.scale[i] *= scale[i];
      level.translation[i] *= scale[i];
    }
    ++scales;
  } else if (type == "translation") {
    std::vector<double> translation = numbers(transformation, "translation");
    for (std::size_t i = 0; i < translation.size(); ++i) level.translation[i] += translation[i];
    level.hasTranslation = true;
  } else {
    refuseIt(fmt::format("the transformation {} is not known here; scale and translation are", inQuotes(type)));
  }
}

std::vector<double> ImageReader::numbers(const Json& transformation, std::string_view name) const {
  const Json& list = memberOf(transformation, name);
  if (list.is_null() && memberOf(transformation, "path").is_string())
    refuseIt(fmt::format("a {} is kept in an array of its own, which is not known here", name));
  if (!list.is_array() || list.size() != mImage.axes.size())
    refuseIt(fmt::format("a {} has not one number for each axis", name));
  std::vector<double> numbers;
  for (const Json& item : list) {
    double number = item.is_number() ? item.get<double>() : NAN;
    if (!std::isfinite(number)) refuseIt(fmt::format("a {} holds something that is no number", name));
    numbers.push_back(number);
  }
  return numbers;
}

/// "00FF00"
std::optional<glm::vec3> colorOf(const Json& value) {
  std::string text = wordOf(value);
  if (text.size() != 6 || text.find_first_not_of("0123456789abcdefABCDEF") != text.npos) return std::nullopt;
  int rgb = int(std::stoul(text, nullptr, 16));
  return glm::vec3((rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255) / 255.0f;
}

std::vector<OmeChannel> channelsOf(const Json& attributes) {
  std::vector<OmeChannel> channels;
  constexpr std::size_t kMostChannels = 4096;
  const Json& list = memberOf(memberOf(attributes, "omero"), "channels");
  if (!list.is_array() || list.size() > kMostChannels) return channels;
  for (const Json& json : list) {
    OmeChannel channel{wordOf(memberOf(json, "label")), colorOf(memberOf(json, "color")), {}};
    const Json &window = memberOf(json, "window"), &start = memberOf(window, "start"), &end = memberOf(window, "end");
    bool isAll = start == memberOf(window, "min") && end == memberOf(window, "max");  // nobody chose it
    if (!isAll && start.is_number() && end.is_number() && start.get<double>() < end.get<double>())
      channel.window = glm::dvec2(start.get<double>(), end.get<double>());
    channels.push_back(channel);
  }
  return channels;
}

/// Names and colours of ids, in their order.
std::vector<LabelInfo> structuresOf(const Json& imageLabel) {
  std::map<std::uint64_t, LabelInfo> structures;
  auto at = [&](const Json& row) -> LabelInfo* {
    const Json& value = memberOf(row, "label-value");
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() < 1) return nullptr;
    auto number = value.get<std::uint64_t>();
    LabelInfo& info = structures[number];
    if (!info.name.empty()) return &info;
    if (number > kLargestLabel) {
      info = {0, segmentName(number), defaultLabelColor(std::uint16_t(number)), 1.0f, number};
    } else {
      auto id = std::uint16_t(number);
      info = {id, fmt::format("Structure {}", id), defaultLabelColor(id), 1.0f};
    }
    return &info;
  };
  if (const Json& colors = memberOf(imageLabel, "colors"); colors.is_array())
    for (const Json& row : colors) {
      const Json& rgba = memberOf(row, "rgba");
      LabelInfo* info = rgba.is_array() && rgba.size() == 4 ? at(row) : nullptr;
      for (std::size_t i = 0; info && i < 3; ++i)
        if (rgba[i].is_number()) info->color[int(i)] = std::clamp(rgba[i].get<float>() / 255.0f, 0.0f, 1.0f);
    }
  if (const Json& properties = memberOf(imageLabel, "properties"); properties.is_array())
    for (const Json& row : properties)
      for (const char* word : {"name", "label", "class", "cell type"})
        if (std::string name = wordOf(memberOf(row, word)); !name.empty()) {
          if (LabelInfo* info = at(row)) info->name = name;
          break;
        }
  std::vector<LabelInfo> list;
  for (auto& [number, info] : structures) list.push_back(std::move(info));
  return list;
}

/// An array without a word of OME's: its last axes are those of space, before them channels, then time.
OmeImage bareImage(const ZarrArray& array, const Path& path) {
  OmeImage image;
  image.key = array.key;
  image.isBare = true;
  std::size_t count = array.shape.size();
  if (count > kMostAxes) refuse(path, fmt::format("it has {} axes; {} are the most", count, kMostAxes));
  constexpr Role kRoles[] = {Role::Time, Role::Channel, Role::Z, Role::Y, Role::X};
  constexpr std::string_view kNames = "tczyx";
  for (std::size_t i = kMostAxes - count; i < kMostAxes; ++i)
    image.axes.push_back({std::string(1, kNames[i]), "", kRoles[i]});
  std::set<std::string> names(array.axes.begin(), array.axes.end());
  bool isNamed = names.size() == count && std::all_of(names.begin(), names.end(), [&](const std::string& name) {
                   return name.size() == 1 && kNames.find(name) != kNames.npos;
                 });
  for (std::size_t i = 0; isNamed && i < count; ++i)
    image.axes[i] = {array.axes[i], "", kRoles[kNames.find(array.axes[i])]};
  image.levels = {{array.key, std::vector<double>(count, 1.0), std::vector<double>(count, 0.0), false}};
  return image;
}

}  // namespace

std::optional<OmeImage> readOmeImage(const Store& store, const std::string& key) {
  Json attributes = omeAttributes(store, key);
  if (!memberOf(attributes, "multiscales").is_null()) {
    OmeImage image = ImageReader(store, key, attributes).read();
    image.channels = channelsOf(attributes);
    const Json& imageLabel = memberOf(attributes, "image-label");
    // Labels need not say that they are: they lie in a group of that name.
    image.isLabels = imageLabel.is_object() || store.pathOf(key).parent_path().filename() == "labels";
    if (image.isLabels) image.structures = structuresOf(imageLabel);
    return image;
  }
  auto array = readZarrArray(store, key);
  if (!array) return std::nullopt;
  return bareImage(*array, store.pathOf(key));
}

}  // namespace velum::io
