#include "VtiHeader.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <vector>

#include "velum/core/Error.h"
#include "velum/core/Text.h"

namespace velum::io {

namespace {

constexpr std::size_t kHead = 1u << 18;

bool isSpace(char c) { return std::isspace(static_cast<unsigned char>(c)); }

/// The inside of `<name ...>` from `at` on; npos in `at` when there is none.
std::string_view tag(std::string_view xml, std::string_view name, std::size_t& at) {
  std::string open = fmt::format("<{}", name);
  for (std::size_t from = at; (from = xml.find(open, from)) != xml.npos; ++from) {
    std::size_t inside = from + open.size();
    if (inside >= xml.size() || !(isSpace(xml[inside]) || xml[inside] == '>' || xml[inside] == '/')) continue;
    std::size_t end = xml.find('>', inside);
    if (end == xml.npos) break;
    at = end + 1;
    return xml.substr(inside, end - inside);
  }
  at = xml.npos;
  return {};
}

std::string_view attribute(std::string_view inside, std::string_view name) {
  for (std::size_t from = 0; (from = inside.find(name, from)) != inside.npos; from += name.size()) {
    if (from == 0 || !isSpace(inside[from - 1])) continue;
    std::size_t at = from + name.size();
    while (at < inside.size() && isSpace(inside[at])) ++at;
    if (at >= inside.size() || inside[at] != '=') continue;
    at = inside.find_first_of("\"'", at);
    if (at == inside.npos) return {};
    std::size_t end = inside.find(inside[at], at + 1);
    if (end != inside.npos) return inside.substr(at + 1, end - at - 1);
  }
  return {};
}

template <std::size_t N>
std::array<double, N> numbersOf(std::string_view text, double otherwise) {
  std::array<double, N> out;
  out.fill(otherwise);
  for (double& value : out) {
    auto number = takeNumber(text);
    if (!number) break;
    value = *number;
  }
  return out;
}

SampleType typeNamed(std::string_view name, const std::string& file) {
  constexpr std::pair<std::string_view, SampleType> kTypes[] = {
      {"UInt8", SampleType::UInt8},     {"Int8", SampleType::Int8},       {"UInt16", SampleType::UInt16},
      {"Int16", SampleType::Int16},     {"UInt32", SampleType::UInt32},   {"Int32", SampleType::Int32},
      {"Float32", SampleType::Float32}, {"Float64", SampleType::Float64}, {"UInt64", SampleType::Float64},
      {"Int64", SampleType::Float64}};
  for (auto [known, type] : kTypes)
    if (known == name) return type;
  throw InputError(fmt::format("{}: samples of type '{}' are not read", file, name));
}

std::string decodeBase64(std::string_view text, std::size_t most) {
  std::string out;
  unsigned bits = 0, held = 0;
  for (char c : text) {
    int v = c >= 'A' && c <= 'Z'   ? c - 'A'
            : c >= 'a' && c <= 'z' ? c - 'a' + 26
            : c >= '0' && c <= '9' ? c - '0' + 52
            : c == '+'             ? 62
            : c == '/'             ? 63
                                   : -1;
    if (v < 0) break;
    bits = (bits << 6) | unsigned(v);
    if ((held += 6) < 8) continue;
    held -= 8;
    out.push_back(char((bits >> held) & 0xff));
    if (out.size() == most) break;
  }
  return out;
}

struct BlockTable {
  double blocks = 0, blockBytes = 0, lastBytes = 0;
};

BlockTable blockTable(std::string_view raw, bool isWide, bool isBigEndian) {
  auto word = [&](std::size_t i) {
    std::size_t size = isWide ? 8 : 4;
    std::uint64_t value = 0;
    for (std::size_t b = 0; b < size && (i + 1) * size <= raw.size(); ++b)
      value |= std::uint64_t(std::uint8_t(raw[i * size + b])) << (8 * (isBigEndian ? size - 1 - b : b));
    return double(value);
  };
  return {word(0), word(1), word(2)};
}

/// The first three words of a compressed array. VTK allocates by them.
void checkBlocks(const FileBytes& file, std::string_view head, std::string_view root, std::string_view array,
                 std::size_t arrayEnd, double expectedBytes, const std::string& name) {
  bool isWide = attribute(root, "header_type") == "UInt64", isBigEndian = attribute(root, "byte_order") == "BigEndian";
  std::string raw;
  if (attribute(array, "format") == "appended") {
    std::size_t at = 0;
    std::string_view appended = tag(head, "AppendedData", at);
    if (at == head.npos)
      return;  // further off than we look; then the header was not a usual one, and VTK's checks must do
    std::size_t mark = head.find('_', at);
    double offset = numbersOf<1>(attribute(array, "offset"), 0)[0];
    if (mark == head.npos || !(offset >= 0) || double(mark) + 1 + offset + 4 > double(file.size()))
      throw InputError(fmt::format("{}: is cut short: its voxels lie behind the end of the file", name));
    std::uint64_t start = mark + 1 + std::uint64_t(offset);
    std::string bytes(std::size_t(std::min<std::uint64_t>(64, file.size() - start)), '\0');
    file.read(start, std::as_writable_bytes(std::span(bytes)));
    raw = attribute(appended, "encoding") == "base64" ? decodeBase64(bytes, 24) : bytes;
  } else {
    std::size_t at = arrayEnd;
    while (at < head.size() && isSpace(head[at])) ++at;
    raw = decodeBase64(head.substr(at, 64), 24);
  }
  BlockTable t = blockTable(raw, isWide, isBigEndian);
  double total = t.lastBytes > 0 ? (t.blocks - 1) * t.blockBytes + t.lastBytes : t.blocks * t.blockBytes;
  // With several pieces a table covers one of them, so it may be less but never more.
  if (t.blocks > double(file.size()) || t.blockBytes > expectedBytes * 2 + (1 << 20) || total > expectedBytes)
    throw InputError(fmt::format("{}: is damaged: its block table promises {:.0f} bytes where the voxels need {:.0f}",
                                 name, total, expectedBytes));
}

}  // namespace

VtiHeader parseVtiHeader(const FileBytes& file, const std::string& name) {
  std::string text = file.head(kHead);
  std::string_view head = text;
  std::size_t at = 0;
  std::string_view root = tag(head, "VTKFile", at);
  if (at == head.npos || attribute(root, "type") != "ImageData")
    throw InputError(fmt::format("{}: is not a VTK image (.vti)", name));
  std::string_view image = tag(head, "ImageData", at);
  if (at == head.npos) throw InputError(fmt::format("{}: is cut short: no ImageData element", name));

  // How it is packed.
  VtiHeader out;
  out.hasDirection = !attribute(image, "Direction").empty();
  std::string_view compressor = attribute(root, "compressor");
  out.isCompressed = !compressor.empty();
  out.isLzma = compressor.find("LZMA") != compressor.npos;

  // Field data too is allocated on the header's word.
  for (std::size_t place = at; place != head.npos;) {
    double tuples = numbersOf<1>(attribute(tag(head, "DataArray", place), "NumberOfTuples"), 0)[0];
    if (tuples < 0 || tuples > double(file.size()))
      throw InputError(fmt::format("{}: {} tuples make no sense", name, tuples));
  }

  // Point data before cell data; in it the array that is named as scalars, else the first.
  std::size_t points = at, array = head.npos;
  std::string_view attributes = tag(head, "PointData", points), inside;
  auto firstArray = [&](std::size_t from, std::string_view end) {
    std::size_t limit = head.find(end, from);
    std::string_view wanted = attribute(attributes, "Scalars"), found;
    for (std::size_t place = from;;) {
      std::string_view candidate = tag(head, "DataArray", place);
      if (place == head.npos || place > limit) return found;
      bool isWanted = !wanted.empty() && attribute(candidate, "Name") == wanted;
      if (found.empty() || isWanted) found = candidate, array = place;
      if (isWanted || wanted.empty()) return found;
    }
  };
  if (points != head.npos && !attributes.ends_with('/')) inside = firstArray(points, "</PointData>");
  if (inside.empty()) {
    std::size_t cells = at;
    attributes = tag(head, "CellData", cells);
    if (cells != head.npos) inside = firstArray(cells, "</CellData>");
    out.isCellData = !inside.empty();
  }
  if (inside.empty()) throw InputError(fmt::format("{}: has no array of values", name));
  // Sizes, and what an array of them needs; nothing of it is allocated before it has been compared with the file.
  auto extent = numbersOf<6>(attribute(image, "WholeExtent"), std::nan(""));
  for (int i = 0; i < 3; ++i) {
    double count = extent[std::size_t(i) * 2 + 1] - extent[std::size_t(i) * 2] + (out.isCellData ? 0.0 : 1.0);
    if (out.isCellData && count == 0) count = 1;  // a flat image has one layer of cells
    if (!(count >= 1 && count <= 1e6))
      throw InputError(fmt::format("{}: an extent of '{}' makes no sense", name, attribute(image, "WholeExtent")));
    out.dims[i] = count;
  }
  out.arrayName = std::string(attribute(inside, "Name"));
  out.type = typeNamed(attribute(inside, "type"), name);
  out.components = numbersOf<1>(attribute(inside, "NumberOfComponents"), 1)[0];
  if (!(out.components >= 1 && out.components <= 1024))
    throw InputError(fmt::format("{}: {} components make no sense", name, out.components));
  out.isAscii = attribute(inside, "format") == "ascii";
  double expected = out.dims.x * out.dims.y * out.dims.z * out.components * double(sampleSize(out.type));
  if (out.isCompressed && !out.isAscii) checkBlocks(file, head, root, inside, array, expected, name);
  return out;
}

}  // namespace velum::io
