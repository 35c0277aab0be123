#include "app/Text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/Text.h"

namespace velum::app {

namespace {

constexpr std::size_t kMostRows = 40;  ///< Of a table; the rest is counted.

void line(const std::string& name, const std::string& text) {
  if (!text.empty()) fmt::print("  {:<13} {}\n", name, text);
}

/// "12 345".
std::string counted(std::uint64_t count) { return grouped(count, " "); }

std::string textIn(const Json& json, const char* name) {
  return json.contains(name) && json[name].is_string() ? printable(json[name].get<std::string>()) : std::string();
}

/// A length of the report, which is in mm or angstrom, in the unit that suits it.
struct Unit {
  const char* symbol;
  double mm;
};
Unit unitFor(double mm) {
  return mm >= 1e4 ? Unit{"m", 1e3} : mm >= 0.02 ? Unit{"mm", 1.0} : mm >= 2e-5 ? Unit{"um", 1e-3} : Unit{"nm", 1e-6};
}

/// "62.5 x 62.5 x 80 mm".
std::string lengths(const std::vector<double>& mm) {
  Unit unit = unitFor(*std::max_element(mm.begin(), mm.end()));
  std::vector<std::string> numbers;
  for (double length : mm) numbers.push_back(fmt::format("{:.4g}", length / unit.mm));
  return fmt::format("{} {}", fmt::join(numbers, " x "), unit.symbol);
}

void printVoxels(const Json& json) {
  auto dims = json["dims"].get<std::vector<double>>();
  auto spacing = json["spacingMm"].get<std::vector<double>>();
  std::vector<double> size;
  for (std::size_t i = 0; i < 3; ++i) size.push_back(dims[i] * spacing[i]);
  bool isKnown = json.value("spacingKnown", true);
  line("voxels", fmt::format("{} x {} x {}", dims[0], dims[1], dims[2]));
  line("spacing", isKnown ? lengths(spacing) : "not in the file (1 mm is taken; --spacing says another)");
  if (isKnown) line("size", lengths(size));
}

std::string productOf(const Json& sizes) {
  std::vector<double> numbers = sizes.get<std::vector<double>>();
  return fmt::format("{}", fmt::join(numbers, " x "));
}

void printVolume(const Json& json) {
  std::string modality = textIn(json, "modality");
  fmt::print("{}: {}\n", textIn(json, "name"), modality == "unknown" ? "volume" : modality + " volume");
  printVoxels(json);
  std::string unit = textIn(json, "unit");
  if (json["range"].is_null())
    line("values", fmt::format("{}; they were not read, so their range is not known", textIn(json, "type")));
  else
    line("values", fmt::format("{}, {} to {}{}{}", textIn(json, "type"), tidyNumber(json["range"][0].get<double>()),
                               tidyNumber(json["range"][1].get<double>()), unit.empty() ? "" : " ", unit));
  int channels = json["channels"].get<int>(), frames = json["frames"].get<int>();
  if (json["color"].get<bool>()) {
    line("channels", "colour");
  } else if (channels > 1) {
    auto names = json["channelNames"].get<std::vector<std::string>>();
    line("channels", fmt::format("{}{}{}", channels, names.empty() ? "" : ": ",
                                 printable(fmt::format("{}", fmt::join(names, ", ")))));
  }
  double seconds = json["frameSeconds"].get<double>();
  if (frames > 1)
    line("time steps",
         fmt::format("{}{}", frames, seconds > 0 ? fmt::format(", {} s apart", tidyNumber(seconds)) : ""));
  if (!json["orientationKnown"].get<bool>()) line("patient", "how it lay is not in the file");
  line("first look", textIn(json, "preset"));
  if (!json.contains("levels") || json["levels"].size() < 2) return;
  for (std::size_t i = 0; i < json["levels"].size(); ++i)
    line(fmt::format("level {}", i), fmt::format("{}, {}", productOf(json["levels"][i]["dims"]),
                                                 lengths(json["levels"][i]["spacingMm"].get<std::vector<double>>())));
}

/// A store of levels, of which no voxel was read.
void printStore(const Json& json) {
  fmt::print("{}: {} in a store\n", textIn(json, "name"), textIn(json, "kind"));
  printVoxels(json);
  line("values", textIn(json, "type"));
  line("axes", textIn(json, "axes"));
  line("unit", textIn(json, "unitInFile"));
  if (int channels = json["channels"].get<int>(); channels > 1) line("channels", fmt::format("{}", channels));
  for (const Json& channel : json["channelList"])
    line("channel", textIn(channel, "name") + (channel.contains("window")
                                                   ? fmt::format(", {} to {}", channel["window"][0].get<double>(),
                                                                 channel["window"][1].get<double>())
                                                   : ""));
  if (int frames = json["frames"].get<int>(); frames > 1) line("time steps", fmt::format("{}", frames));
  const Json& levels = json["levels"];
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const Json& level = levels[i];
    std::string shard = level.contains("shard") ? " in shards of " + productOf(level["shard"]) : "";
    line(fmt::format("level {}", i), fmt::format("{}, {}, chunks of {}{}, {}", productOf(level["dims"]),
                                                 lengths(level["spacingMm"].get<std::vector<double>>()),
                                                 productOf(level["chunk"]), shard, textIn(level, "codec")));
  }
  if (json["levelsAlignedByBorders"].get<bool>())
    line("levels", "their places are not in the file; they are taken as means of blocks, border on border");
  if (json.contains("levelRead") && levels.size() > 1)
    line("to be read",
         fmt::format(fmt::runtime(json.value("isStreamed", false)
                                      ? "level {}, over which finer ones are streamed; --level says another"
                                      : "level {}; --level says another"),
                     json["levelRead"].get<int>()));
}

void printLabels(const Json& json) {
  fmt::print("{}: labels\n", textIn(json, "name"));
  printVoxels(json);
  const Json& structures = json["structures"];
  line("structures", counted(structures.size()));
  std::size_t width = 4, rows = std::min(structures.size(), kMostRows);
  for (std::size_t i = 0; i < rows; ++i) width = std::max(width, textIn(structures[i], "name").size());
  for (std::size_t i = 0; i < rows; ++i) {
    const Json& s = structures[i];
    auto voxels = s["voxels"].get<std::uint64_t>();
    std::string size = voxels == 0 ? "does not occur"
                                   : fmt::format("{:>9} ml  {:>9} cm2", tidyNumber(s["volumeMl"].get<double>()),
                                                 tidyNumber(s["surfaceCm2"].get<double>()));
    if (s.contains("values"))
      size += fmt::format("  mean {:>8}  max {:>8} {}", tidyNumber(s["values"]["mean"].get<double>()),
                          tidyNumber(s["values"]["max"].get<double>()), textIn(json, "valueUnit"));
    fmt::print("  {:>5}  {:<{}}  {}\n", s["id"].get<int>(), textIn(s, "name"), width, size);
  }
  if (structures.size() > rows) fmt::print("  and {} more\n", structures.size() - rows);
}

void printModel(const Json& json) {
  fmt::print("{}: cell model\n", textIn(json, "name"));
  line("instances",
       fmt::format("{} of {} types", counted(json["instances"].get<std::uint64_t>()), json["types"].get<int>()));
  line("atoms", counted(json["atoms"].get<std::uint64_t>()));
  if (json["beads"].get<std::uint64_t>() > 0) line("beads", counted(json["beads"].get<std::uint64_t>()));
  std::vector<double> size;
  for (std::size_t i = 0; i < 3; ++i)
    size.push_back(1e-7 * (json["bounds"][1][i].get<double>() - json["bounds"][0][i].get<double>()));
  line("size", lengths(size));
  const Json& types = json["perType"];
  std::size_t width = 4, rows = std::min(types.size(), kMostRows);
  for (std::size_t i = 0; i < rows; ++i) width = std::max(width, textIn(types[i], "path").size());
  for (std::size_t i = 0; i < rows; ++i)
    fmt::print("  {:<{}}  {:>9} x {} atoms\n", textIn(types[i], "path"), width,
               counted(types[i]["instances"].get<std::uint64_t>()), counted(types[i]["atoms"].get<std::uint64_t>()));
  if (types.size() > rows) fmt::print("  and {} more\n", types.size() - rows);
  for (const Json& made : json["completed"]) line("added", printable(made.get<std::string>()));
}

void printSurface(const Json& json) {
  fmt::print("{}: surface\n", textIn(json, "name"));
  line("triangles", counted(json["triangles"].get<std::uint64_t>()));
  line("vertices", counted(json["vertices"].get<std::uint64_t>()));
}

/// Formats and presets.
void printTables(const Json& json) {
  for (const auto& [name, rows] : json.items()) {
    fmt::print("{}\n", name);
    for (const Json& row : rows) {
      std::string more = textIn(row, "extensions") + textIn(row, "title");
      bool isRead = row.value("read", false), isWritten = row.value("write", false);
      fmt::print("  {:<22} {}{}\n", textIn(row, "name"), more, isRead && isWritten ? "  (read and written)" : "");
    }
  }
}

}  // namespace

Json valuesJson(const session::StructureValues& values) {
  return {{"voxels", values.voxels},
          {"mean", values.mean},
          {"deviation", values.deviation},
          {"min", values.least},
          {"max", values.most}};
}

void printForPeople(const Json& report) {
  std::string kind = textIn(report, "kind");
  if (kind.empty()) return printTables(report);
  bool isStore = report.contains("axes");
  if (isStore) printStore(report);
  if (kind == "volume" && !isStore) printVolume(report);
  if (kind == "labels" && !isStore) printLabels(report);
  if (kind == "model") printModel(report);
  if (kind == "surface") printSurface(report);
  if (report.contains("labels")) printLabels(report["labels"]);
  for (const Json& warning : report["warnings"]) line("note", printable(warning.get<std::string>()));
  if (!report.contains("series")) return;
  if (isStore && report["series"].size() < 2) return;
  line(isStore ? "images" : "DICOM series", isStore ? "one opens with --series PATH" : "one opens with --series UID");
  if (isStore) {
    for (const Json& series : report["series"])
      fmt::print("    {} \"{}\", {} planes of {} x {}, {}\n", series.value("segmentation", false) ? "labels" : "image",
                 textIn(series, "description"), series["images"].get<int>(), series["size"][0].get<int>(),
                 series["size"][1].get<int>(), textIn(series, "uid"));
    return;
  }
  for (const Json& series : report["series"])
    fmt::print("    {} \"{}\", {} images of {} x {}, {}\n", textIn(series, "modality"), textIn(series, "description"),
               series["images"].get<int>(), series["size"][0].get<int>(), series["size"][1].get<int>(),
               textIn(series, "uid"));
}

}  // namespace velum::app
