#include "io/volumes/TiffDescription.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "core/Text.h"

namespace velum::io {

namespace {

constexpr std::uint64_t kMaxCount = 10'000'000;

double numberOf(std::string_view text) {
  double value = takeNumber(text).value_or(0.0);
  return std::isfinite(value) ? value : 0.0;
}

std::uint64_t countOf(std::string_view text, std::uint64_t otherwise) {
  double value = numberOf(text);
  return value >= 1 && value <= double(kMaxCount) ? std::uint64_t(value) : otherwise;
}

std::uint64_t indexOf(std::string_view text) { return countOf(text, 0); }

/// Millimetres of a unit as OME and ImageJ spell it; 0 for pixels and words unknown.
double unitInMm(std::string_view unit) {
  struct Row {
    std::string_view name;
    double mm;
  };
  static constexpr Row kUnits[] = {{"\xc2\xb5m", 1e-3}, {"\xce\xbcm", 1e-3}, {"\\u00B5m", 1e-3},   {"um", 1e-3},
                                   {"micron", 1e-3},    {"microns", 1e-3},   {"micrometer", 1e-3}, {"\xb5m", 1e-3},
                                   {"&#181;m", 1e-3},   {"&#xB5;m", 1e-3},   {"nm", 1e-6},         {"mm", 1.0},
                                   {"millimeter", 1.0}, {"cm", 10.0},        {"m", 1000.0},        {"\xc3\x85", 1e-7},
                                   {"inch", 25.4},      {"in", 25.4},        {"pm", 1e-9}};
  for (const Row& row : kUnits)
    if (row.name == unit) return row.mm;
  return 0.0;
}

bool isSpacing(double mm) { return mm >= 1e-9 && mm <= 1e5; }

/// The inside of the first `<name ...>` at or after `at`; moves `at` behind it.
std::optional<std::string_view> tag(std::string_view xml, std::string_view name, std::size_t& at) {
  for (std::size_t from = at; (from = xml.find('<', from)) != xml.npos; ++from) {
    std::string_view rest = xml.substr(from + 1);
    // A prefix such as "ome:" is allowed.
    std::size_t nameEnd = rest.substr(0, 64).find_first_of(" \t\r\n/>");
    if (nameEnd == rest.npos) continue;
    std::string_view word = rest.substr(0, nameEnd);
    if (std::size_t colon = word.find(':'); colon != word.npos) word.remove_prefix(colon + 1);
    if (word != name) continue;
    std::size_t end = rest.find('>', nameEnd);
    if (end == rest.npos) return {};
    at = from + 1 + end;
    return rest.substr(nameEnd, end - nameEnd);
  }
  return {};
}

/// The value of an attribute inside a tag; empty when it is not there.
std::string_view attribute(std::string_view inside, std::string_view name) {
  for (std::size_t from = 0; (from = inside.find(name, from)) != inside.npos; from += name.size()) {
    bool isWord = from > 0 && std::isspace(static_cast<unsigned char>(inside[from - 1]));
    std::size_t at = from + name.size();
    if (!isWord || at + 1 >= inside.size() || inside[at] != '=' || (inside[at + 1] != '"' && inside[at + 1] != '\''))
      continue;
    std::size_t end = inside.find(inside[at + 1], at + 2);
    if (end == inside.npos) return {};
    return inside.substr(at + 2, end - at - 2);
  }
  return {};
}

bool isOrder(std::string_view order) {
  std::string sorted(order);
  std::sort(sorted.begin(), sorted.end());
  return sorted == "CTZ";
}

void readOmeSpacing(std::string_view pixels, TiffLayout& out) {
  constexpr std::string_view kNames[] = {"PhysicalSizeX", "PhysicalSizeY", "PhysicalSizeZ"};
  for (int axis = 0; axis < 3; ++axis) {
    std::string_view unit = attribute(pixels, std::string(kNames[axis]) + "Unit");
    double mm = numberOf(attribute(pixels, kNames[axis])) * (unit.empty() ? 1e-3 : unitInMm(unit));
    if (isSpacing(mm)) out.spacing[axis] = mm;
  }
  double seconds = numberOf(attribute(pixels, "TimeIncrement"));
  std::string_view unit = attribute(pixels, "TimeIncrementUnit");
  if (seconds > 0 && (unit.empty() || unit == "s")) out.timeStepSeconds = seconds;
  if (seconds > 0 && unit == "ms") out.timeStepSeconds = seconds * 1e-3;
}

/// OME's colour: red, green, blue, alpha from the highest byte to the lowest of a signed number.
std::optional<glm::vec3> colorOf(std::string_view text) {
  auto number = takeNumber(text);
  if (!number || std::abs(*number) > 4294967295.0) return std::nullopt;
  auto rgba = std::uint32_t(std::int64_t(*number));
  return glm::vec3(float(rgba >> 24), float(rgba >> 16 & 255), float(rgba >> 8 & 255)) / 255.0f;
}

TiffLayout parseOme(std::string_view xml, std::string_view fileName) {
  TiffLayout out;
  std::size_t at = 0;
  auto pixels = tag(xml, "Pixels", at);
  if (!pixels) return out;
  out.kind = TiffLayout::Kind::Ome;
  // Sizes and the order of planes.
  out.sizeX = indexOf(attribute(*pixels, "SizeX"));
  out.sizeY = indexOf(attribute(*pixels, "SizeY"));
  out.sizeZ = countOf(attribute(*pixels, "SizeZ"), 1);
  out.sizeC = countOf(attribute(*pixels, "SizeC"), 1);
  out.sizeT = countOf(attribute(*pixels, "SizeT"), 1);
  std::string_view order = attribute(*pixels, "DimensionOrder");
  if (order.size() == 5 && isOrder(order.substr(2))) out.order = std::string(order.substr(2));
  readOmeSpacing(*pixels, out);

  // The first image only: a file may hold more (thumbnails, other positions).
  std::size_t end = xml.find("Pixels>", at);
  xml = xml.substr(0, end);
  std::size_t place = at;
  while (auto channel = tag(xml, "Channel", place)) {
    if (out.channelNames.size() >= out.sizeC) break;
    out.channelNames.emplace_back(attribute(*channel, "Name").substr(0, 256));
    if (auto color = colorOf(attribute(*channel, "Color"))) out.channelColors.push_back(*color);
  }
  if (out.channelNames.size() != out.sizeC) out.channelNames.clear();
  const auto& colors = out.channelColors;
  bool tellsApart = std::any_of(colors.begin(), colors.end(), [&](glm::vec3 color) { return color != colors[0]; });
  if (colors.size() != out.sizeC || !tellsApart) out.channelColors.clear();
  place = at;
  // Which page is which plane, where the file says it.
  while (auto data = tag(xml, "TiffData", place)) {
    if (attribute(*data, "IFD").empty() && attribute(*data, "FirstZ").empty()) continue;  // all pages, in order
    TiffLayout::Plane plane{indexOf(attribute(*data, "IFD")), indexOf(attribute(*data, "FirstZ")),
                            indexOf(attribute(*data, "FirstC")), indexOf(attribute(*data, "FirstT")),
                            countOf(attribute(*data, "PlaneCount"), 1)};
    std::size_t inside = place;
    auto uuid = tag(xml.substr(0, xml.find("TiffData", place)), "UUID", inside);
    std::string_view other = uuid ? attribute(*uuid, "FileName") : std::string_view{};
    if (!other.empty() && other != fileName && uuid)
      out.hasOtherFiles = true;
    else if (out.planes.size() < kMaxCount)
      out.planes.push_back(plane);
  }
  // A file that was renamed calls itself by its old name; then its planes are all "elsewhere".
  if (out.planes.empty()) out.hasOtherFiles = false;
  return out;
}

TiffLayout parseImageJ(std::string_view text) {
  TiffLayout out;
  out.kind = TiffLayout::Kind::ImageJ;
  std::uint64_t images = 1;
  double spacing = 0;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    std::size_t equals = line.find('=');
    if (equals == line.npos) continue;
    std::string_view key = line.substr(0, equals), value = line.substr(equals + 1);
    if (!value.empty() && value.back() == '\r') value.remove_suffix(1);
    if (key == "images") images = countOf(value, 1);
    if (key == "channels") out.sizeC = countOf(value, 1);
    if (key == "slices") out.sizeZ = countOf(value, 1);
    if (key == "frames") out.sizeT = countOf(value, 1);
    if (key == "unit") out.unitMm = unitInMm(value);
    if (key == "spacing") spacing = std::abs(numberOf(value));
    if (key == "finterval") out.timeStepSeconds = std::max(0.0, numberOf(value));
  }
  // "images" alone is a plain stack; with others it must be their product, else they are not to be trusted.
  double product = double(std::max<std::uint64_t>(1, out.sizeZ)) * double(out.sizeC) * double(out.sizeT);
  if (product != double(images)) out.sizeZ = images, out.sizeC = out.sizeT = 1;
  if (isSpacing(spacing * out.unitMm)) out.spacing.z = spacing * out.unitMm;
  return out;
}

}  // namespace

TiffLayout parseTiffDescription(std::string_view text, std::string_view fileName) {
  if (text.starts_with("ImageJ=")) return parseImageJ(text);
  std::string_view head = text.substr(0, 4096);
  if (head.find("<OME") != head.npos || head.find(":OME") != head.npos) return parseOme(text, fileName);
  return {};
}

std::vector<PlaneTarget> placePlanes(const TiffLayout& layout, std::uint64_t channelPlanes, std::uint64_t pageCount) {
  const std::uint64_t sizes[] = {layout.sizeZ, channelPlanes, layout.sizeT};
  double total = double(sizes[0]) * double(sizes[1]) * double(sizes[2]);
  if (total < 1 || total > double(pageCount)) return {};
  // Plane number k in the file's order -> z, c, t.
  auto split = [&](std::uint64_t k) {
    PlaneTarget p;
    for (char axis : layout.order) {
      std::uint64_t n = axis == 'Z' ? sizes[0] : axis == 'C' ? sizes[1] : sizes[2];
      (axis == 'Z' ? p.z : axis == 'C' ? p.c : p.t) = k % n;
      k /= n;
    }
    return p;
  };
  auto join = [&](const TiffLayout::Plane& plane) {
    std::uint64_t k = 0, weight = 1;
    for (char axis : layout.order) {
      k += weight * (axis == 'Z' ? plane.z : axis == 'C' ? plane.c : plane.t);
      weight *= axis == 'Z' ? sizes[0] : axis == 'C' ? sizes[1] : sizes[2];
    }
    return k;
  };
  // The page of every plane: in order, or as the file says. Twice or never named: its word is worth nothing.
  auto count = std::uint64_t(total);
  std::vector<std::uint64_t> pageOf(std::size_t(count), pageCount);
  if (layout.planes.empty())
    for (std::uint64_t k = 0; k < count; ++k) pageOf[std::size_t(k)] = k;
  for (const auto& plane : layout.planes) {
    if (plane.z >= sizes[0] || plane.c >= sizes[1] || plane.t >= sizes[2] || plane.page >= pageCount) return {};
    std::uint64_t first = join(plane);
    for (std::uint64_t i = 0; i < plane.count; ++i) {
      if (first + i >= count || plane.page + i >= pageCount || pageOf[std::size_t(first + i)] != pageCount) return {};
      pageOf[std::size_t(first + i)] = plane.page + i;
    }
  }
  // By page, so that the file is read from front to back.
  std::vector<PlaneTarget> out;
  for (std::uint64_t k = 0; k < count; ++k) {
    if (pageOf[std::size_t(k)] == pageCount) return {};
    out.push_back(split(k));
    out.back().page = pageOf[std::size_t(k)];
  }
  std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.page < b.page; });
  return out;
}

}  // namespace velum::io
