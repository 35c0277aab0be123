#include "io/stores/OmeDescription.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/read/JsonParts.h"
#include "io/stores/OwnAttributes.h"

namespace velum::io {

namespace {

using Role = OmeAxis::Role;

constexpr const char* kVersion2Types[] = {"|u1", "|i1", "<u2", "<i2", "<u4", "<i4", "<f4", "<f8"};

std::string jsonText(const Json& json) { return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"; }

/// The unit in which lengths are written, and how many of it are one of the volume's.
struct WrittenUnit {
  std::string name;
  double perOne = 1.0;
};
WrittenUnit unitFor(const Volume& head) {
  if (!head.isSpacingKnown) return {};
  if (head.lengthUnit == LengthUnit::Angstrom) return {"angstrom", 1.0};
  glm::dvec3 spacing = spacingOf(head);
  constexpr double kSmall = 0.1;  // mm: below it people speak of micrometres
  if (std::max({spacing.x, spacing.y, spacing.z}) < kSmall) return {"micrometer", 1e3};
  return {"millimeter", 1.0};
}

std::string colorText(glm::vec3 color) {
  glm::ivec3 c = glm::ivec3(glm::round(glm::clamp(color, 0.0f, 1.0f) * 255.0f));
  return fmt::format("{:02X}{:02X}{:02X}", c.r, c.g, c.b);
}

Json describeLevel(const OmeLayout& layout, const Volume& head, int number) {
  const PlannedLevel& level = layout.levels[std::size_t(number)];
  auto axes = axesOf(head);
  glm::dvec3 spacing = spacingOf(head) * unitFor(head).perOne;
  glm::dvec3 origin = isStraight(head) ? glm::dvec3(head.worldFromVoxel[3]) * unitFor(head).perOne : glm::dvec3(0.0);
  double timeStep = head.timeStepSeconds > 0 ? head.timeStepSeconds : 1.0;
  auto scale = alongAxes(axes, timeStep, 1.0, spacing * level.scale);
  auto translation = alongAxes(axes, 0.0, 0.0, origin + spacing * level.firstCentre);
  return {{"path", std::to_string(number)},
          {"coordinateTransformations",
           {{{"type", "scale"}, {"scale", scale}}, {{"type", "translation"}, {"translation", translation}}}}};
}

Json describeMultiscale(const OmeLayout& layout, const Volume& head) {
  Json axes = Json::array(), datasets = Json::array();
  for (const OmeAxis& axis : axesOf(head)) {
    const char* type = axis.role == Role::Time ? "time" : axis.role == Role::Channel ? "channel" : "space";
    axes.push_back({{"name", axis.name}, {"type", type}});
    if (!axis.unit.empty()) axes.back()["unit"] = axis.unit;
  }
  for (int level = 0; level < int(layout.levels.size()); ++level)
    datasets.push_back(describeLevel(layout, head, level));
  return {{"name", head.name},
          {"axes", axes},
          {"datasets", datasets},
          {"type", layout.isLabels ? "most frequent id" : "mean"}};
}

/// Colours are asked for: those of light, in turn, where the volume gives none.
glm::vec3 colorOf(const Volume& head, std::size_t channel) {
  if (channel < head.channelColors.size()) return head.channelColors[channel];
  constexpr glm::vec3 kColors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}};
  return head.channels == 1 ? glm::vec3(1.0f) : kColors[channel % std::size(kColors)];
}

std::string labelOf(const Volume& head, std::size_t channel) {
  constexpr const char* kColorNames[] = {"Red", "Green", "Blue", "Alpha"};
  if (channel < head.channelNames.size()) return head.channelNames[channel];
  return head.isColor && channel < std::size(kColorNames) ? kColorNames[channel] : fmt::format("Channel {}", channel);
}

/// A window that nobody chose is all that there is: its ends are those of the values.
Json describeChannels(const Volume& head, const std::vector<glm::dvec2>& windows, bool areChosen) {
  Json channels = Json::array();
  for (std::size_t c = 0; c < std::size_t(head.channels); ++c) {
    Json channel = {{"label", labelOf(head, c)}, {"color", colorText(colorOf(head, c))}, {"active", true}};
    if (c < windows.size() && windows[c].x < windows[c].y) {
      double beyond = areChosen ? windows[c].y - windows[c].x : 0.0;
      channel["window"] = {{"min", windows[c].x - beyond},
                           {"max", windows[c].y + beyond},
                           {"start", windows[c].x},
                           {"end", windows[c].y}};
    }
    channels.push_back(channel);
  }
  return {{"channels", channels}, {"rdefs", {{"model", head.channels > 1 ? "color" : "greyscale"}}}};
}

Json describeStructures(const std::vector<LabelInfo>& structures, const char* version) {
  Json colors = Json::array(), properties = Json::array();
  for (const LabelInfo& info : structures) {
    auto c = glm::ivec4(glm::round(glm::clamp(glm::vec4(info.color, info.opacity), 0.0f, 1.0f) * 255.0f));
    std::uint64_t number = info.fileId != 0 ? info.fileId : info.id;
    colors.push_back({{"label-value", number}, {"rgba", {c.r, c.g, c.b, c.a}}});
    properties.push_back({{"label-value", number}, {"name", info.name}});
  }
  Json json = {{"version", version}};
  if (!colors.empty()) json["colors"] = colors, json["properties"] = properties;
  return json;
}

Json codecsOf(const OmeLayout& layout, const std::vector<int>& brick) {
  Json bytes = {{"name", "bytes"}, {"configuration", {{"endian", "little"}}}};
  Json zstd = {{"name", "zstd"}, {"configuration", {{"level", layout.zstdLevel}, {"checksum", true}}}};
  return {{{"name", "sharding_indexed"},
           {"configuration",
            {{"chunk_shape", brick},
             {"codecs", {bytes, zstd}},
             {"index_codecs", {bytes, {{"name", "crc32c"}}}},
             {"index_location", "end"}}}}};
}

}  // namespace

std::vector<OmeAxis> axesOf(const Volume& head) {
  std::vector<OmeAxis> axes;
  if (head.timeSteps > 1) axes.push_back({"t", head.timeStepSeconds > 0 ? "second" : "", Role::Time});
  if (head.channels > 1) axes.push_back({"c", "", Role::Channel});
  std::string unit = unitFor(head).name;
  axes.push_back({"z", unit, Role::Z});
  axes.push_back({"y", unit, Role::Y});
  axes.push_back({"x", unit, Role::X});
  return axes;
}

bool isStraight(const Volume& head) {
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) {
      double value = head.worldFromVoxel[column][row];
      if (column == row ? value <= 0.0 : value != 0.0) return false;
    }
  return true;
}

MetadataFile describeArray(const OmeLayout& layout, const Volume& head, int number) {
  const PlannedLevel& level = layout.levels[std::size_t(number)];
  auto axes = axesOf(head);
  auto shape = alongAxes(axes, head.timeSteps, head.channels, level.dims);
  auto brick = alongAxes(axes, 1, 1, level.brick), shard = alongAxes(axes, 1, 1, level.shard);
  if (layout.version == OmeVersion::V04)
    return {".zarray", jsonText({{"zarr_format", 2},
                                 {"shape", shape},
                                 {"chunks", brick},
                                 {"dtype", layout.carriesIds ? "<u8" : kVersion2Types[std::size_t(head.type)]},
                                 {"compressor", {{"id", "zstd"}, {"level", layout.zstdLevel}}},
                                 {"fill_value", 0},
                                 {"order", "C"},
                                 {"filters", nullptr},
                                 {"dimension_separator", "/"}})};
  Json names = Json::array();
  for (const OmeAxis& axis : axes) names.push_back(axis.name);
  return {"zarr.json", jsonText({{"zarr_format", 3},
                                 {"node_type", "array"},
                                 {"shape", shape},
                                 {"data_type", layout.carriesIds ? "uint64" : std::string(enumName(head.type))},
                                 {"chunk_grid", {{"name", "regular"}, {"configuration", {{"chunk_shape", shard}}}}},
                                 {"chunk_key_encoding", {{"name", "default"}, {"configuration", {{"separator", "/"}}}}},
                                 {"fill_value", 0},
                                 {"codecs", codecsOf(layout, brick)},
                                 {"dimension_names", names},
                                 {"attributes", Json::object()}})};
}

std::vector<MetadataFile> describeImage(const OmeLayout& layout, const Volume& head,
                                        const std::vector<glm::dvec2>& windows,
                                        const std::vector<LabelInfo>& structures) {
  bool isOld = layout.version == OmeVersion::V04;
  const char* version = isOld ? "0.4" : "0.5";
  Json multiscale = describeMultiscale(layout, head), ome = Json::object();
  if (isOld)
    multiscale["version"] = version;
  else
    ome["version"] = version;
  ome["multiscales"] = Json::array({multiscale});
  if (layout.isLabels)
    ome["image-label"] = describeStructures(structures, version);
  else if (head.channels > 1 || !head.channelNames.empty() || !head.channelColors.empty())
    ome["omero"] = describeChannels(head, windows, layout.hasChosenWindows);
  Json own = describeOwn(head);
  if (isOld) {
    ome["velum"] = own;
    return {{".zattrs", jsonText(ome)}, {".zgroup", jsonText({{"zarr_format", 2}})}};
  }
  return {{"zarr.json",
           jsonText({{"zarr_format", 3}, {"node_type", "group"}, {"attributes", {{"ome", ome}, {"velum", own}}}})}};
}

}  // namespace velum::io
