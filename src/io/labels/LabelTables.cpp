#include "io/labels/LabelTables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>

#include "core/Text.h"
#include "io/labels/ReadLabels.h"
#include "io/read/FileBytes.h"

namespace velum::io {

namespace {

constexpr std::uint64_t kLongestTable = 16 << 20;

std::optional<double> numberOf(std::string_view word) {
  auto value = numberIn(word);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<std::uint16_t> idOf(const std::string& word) {
  auto value = numberOf(word);
  if (!value || *value < 0 || *value > 65535 || *value != std::floor(*value)) return std::nullopt;
  return std::uint16_t(*value);
}

glm::vec3 clampedColor(double r, double g, double b) { return glm::clamp(glm::vec3(glm::dvec3(r, g, b)), 0.0f, 1.0f); }

/// `id R G B alpha visible mesh "name"`, as ITK-SNAP writes it.
std::optional<LabelInfo> parseSnapLine(const std::string& line) {
  auto open = line.find('"'), close = line.rfind('"');
  if (open == std::string::npos || close == open) return std::nullopt;
  std::istringstream stream(line.substr(0, open));
  double id, r, g, b, alpha;
  if (!(stream >> id >> r >> g >> b >> alpha) || id < 0 || id > 65535) return std::nullopt;
  return LabelInfo{std::uint16_t(id), line.substr(open + 1, close - open - 1), clampedColor(r / 255, g / 255, b / 255),
                   float(std::clamp(alpha, 0.0, 1.0))};
}

/// `id name R G B A` (3D Slicer, FreeSurfer), or `id name [number]` (MRIcron).
std::optional<LabelInfo> parseColumns(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  if (words.size() < 2 || !idOf(words[0])) return std::nullopt;
  LabelInfo label{*idOf(words[0]), "", defaultLabelColor(*idOf(words[0])), 1.0f};
  std::size_t end = words.size();
  if (words.size() >= 6) {
    double color[4];
    bool isColor = true;
    for (std::size_t i = 0; i < 4; ++i) {
      auto value = numberOf(words[words.size() - 4 + i]);
      isColor = isColor && value && *value >= 0 && *value <= 255;
      color[i] = value.value_or(0);
    }
    if (isColor) {
      end -= 4;
      label.color = clampedColor(color[0] / 255, color[1] / 255, color[2] / 255);
      label.opacity = float(color[3] / 255);
    }
  }
  if (end == words.size() && end > 2 && numberOf(words.back())) --end;
  for (std::size_t i = 1; i < end; ++i) label.name += (i > 1 ? " " : "") + words[i];
  return label;
}

/// Segments of other layers whose value is an id already get ids of their own.
void numberApart(std::vector<SlicerSegment>& segments) {
  std::vector<int> values;
  for (const SlicerSegment& segment : segments) values.push_back(segment.value);
  std::vector<std::uint16_t> ids = idsApart(values);
  for (std::size_t i = 0; i < segments.size(); ++i)
    if (segments[i].value != 0) segments[i].label.id = ids[i];
}

/// Value of an XML attribute inside a tag; empty when there is none.
std::string attribute(std::string_view tag, std::string_view name) {
  std::string key = " " + std::string(name) + "=\"";
  auto at = tag.find(key);
  if (at == std::string_view::npos) return {};
  auto end = tag.find('"', at + key.size());
  return end == std::string_view::npos ? std::string()
                                       : std::string(tag.substr(at + key.size(), end - at - key.size()));
}

std::string plainText(std::string_view content) {
  if (auto open = content.find("<![CDATA["); open != std::string_view::npos) {
    auto close = content.find("]]>", open);
    return std::string(content.substr(open + 9, close == std::string_view::npos ? close : close - open - 9));
  }
  std::string text(content);
  constexpr std::pair<const char*, char> kEntities[] = {
      {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}};
  for (auto [entity, plain] : kEntities)
    for (auto at = text.find(entity); at != std::string::npos; at = text.find(entity, at + 1))
      text.replace(at, std::string_view(entity).size(), 1, plain);
  return text;
}

}  // namespace

std::vector<LabelInfo> readLabelTable(const std::filesystem::path& path) {
  if (sizeOfFile(path) > kLongestTable) refuse(path, "is too large for a label table");
  std::ifstream stream(path);
  std::vector<LabelInfo> table;
  for (std::string line; std::getline(stream, line);) {
    auto first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    auto label = parseSnapLine(line);
    if (!label) label = parseColumns(line);
    if (label) table.push_back(*label);
  }
  if (table.empty()) refuse(path, "no line is a label: expected a number and a name");
  // FreeSurfer writes 0 for opaque.
  if (std::all_of(table.begin(), table.end(), [](const LabelInfo& l) { return l.opacity == 0.0f; }))
    for (LabelInfo& label : table) label.opacity = 1.0f;
  return completeTable(std::move(table), {});
}

std::vector<std::uint16_t> idsApart(const std::vector<int>& numbers) {
  auto isId = [](int number) { return number >= 1 && number <= 65535; };
  std::set<int> wanted, taken;
  std::copy_if(numbers.begin(), numbers.end(), std::inserter(wanted, wanted.end()), isId);
  std::vector<std::uint16_t> ids;
  int next = 1;
  for (int number : numbers) {
    if (!isId(number) || taken.contains(number)) {
      while (next < 65535 && (wanted.contains(next) || taken.contains(next))) ++next;
      number = next;
    }
    taken.insert(number);
    ids.push_back(std::uint16_t(number));
  }
  return ids;
}

std::vector<LabelInfo> parseCaretLabels(std::string_view xml) {
  std::vector<LabelInfo> table;
  if (xml.find("<LabelTable") == std::string_view::npos) return table;
  for (auto at = xml.find("<Label "); at != std::string_view::npos; at = xml.find("<Label ", at + 1)) {
    auto tagEnd = xml.find('>', at), close = xml.find("</Label>", at);
    if (tagEnd == std::string_view::npos || close == std::string_view::npos || close < tagEnd) break;
    std::string_view tag = xml.substr(at, tagEnd - at);
    auto id = idOf(attribute(tag, "Key"));
    if (!id) continue;
    auto part = [&](const char* name) { return numberOf(attribute(tag, name)).value_or(1.0); };
    table.push_back({*id, plainText(xml.substr(tagEnd + 1, close - tagEnd - 1)),
                     clampedColor(part("Red"), part("Green"), part("Blue")),
                     float(std::clamp(part("Alpha"), 0.0, 1.0))});
  }
  return completeTable(std::move(table), {});
}

std::vector<SlicerSegment> parseSlicerSegments(const std::map<std::string, std::string>& keyValues) {
  std::vector<SlicerSegment> segments;
  std::set<std::size_t> isUncolored;
  auto value = [&](std::size_t i, const char* what) {
    auto found = keyValues.find(fmt::format("Segment{}_{}", i, what));
    return found == keyValues.end() ? std::string() : found->second;
  };
  for (std::size_t i = 0; i < 65535 && !value(i, "ID").empty(); ++i) {
    SlicerSegment segment;
    // Files before Slicer 4.11 have one layer per segment and no value in the header.
    segment.layer = int(idOf(value(i, "Layer")).value_or(value(i, "LabelValue").empty() ? std::uint16_t(i) : 0));
    segment.value = idOf(value(i, "LabelValue")).value_or(1);
    segment.label.name = value(i, "Name").empty() ? value(i, "ID") : value(i, "Name");
    if (auto opacity = numberOf(value(i, "VelumOpacity")))
      segment.label.opacity = float(std::clamp(*opacity, 0.0, 1.0));
    std::istringstream stream(value(i, "Color"));
    double r, g, b;
    bool hasColor = bool(stream >> r >> g >> b);
    segment.label.id = segment.value;
    if (hasColor)
      segment.label.color = clampedColor(r, g, b);
    else
      isUncolored.insert(i);
    segments.push_back(segment);
  }
  numberApart(segments);
  for (std::size_t i : isUncolored) segments[i].label.color = defaultLabelColor(segments[i].label.id);
  return segments;
}

std::string trackingIdOf(std::uint16_t id) { return fmt::format("velum {}", id); }

std::optional<std::uint16_t> idOfTrackingId(std::string_view text) {
  constexpr std::string_view kStart = "velum ";
  if (!text.starts_with(kStart)) return std::nullopt;
  auto id = idOf(std::string(text.substr(kStart.size())));
  return id && *id != 0 ? id : std::nullopt;
}

std::vector<LabelInfo> completeTable(std::vector<LabelInfo> table, const std::vector<std::uint16_t>& inUse) {
  std::erase_if(table, [](const LabelInfo& l) { return l.id == 0; });
  std::stable_sort(table.begin(), table.end(), [](const LabelInfo& a, const LabelInfo& b) { return a.id < b.id; });
  table.erase(std::unique(table.begin(), table.end(), [](auto& a, auto& b) { return a.id == b.id; }), table.end());
  std::set<std::uint16_t> known;
  for (LabelInfo& label : table) {
    known.insert(label.id);
    if (label.name.empty()) label.name = fmt::format("label {}", label.id);
  }
  for (std::uint16_t id : inUse)
    if (!known.contains(id)) table.push_back({id, fmt::format("label {}", id), defaultLabelColor(id), 1.0f});
  std::stable_sort(table.begin(), table.end(), [](const LabelInfo& a, const LabelInfo& b) { return a.id < b.id; });
  return table;
}

}  // namespace velum::io
