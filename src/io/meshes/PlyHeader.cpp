#include "io/meshes/PlyHeader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "core/Text.h"

namespace velum::io {

namespace {

constexpr std::size_t kMostLines = 10'000, kLongestOfHeader = 1 << 16;

std::optional<PlyType> typeNamed(std::string_view name) {
  constexpr std::pair<std::string_view, PlyType> kTypes[] = {
      {"char", PlyType::Int8},      {"int8", PlyType::Int8},       {"uchar", PlyType::UInt8},
      {"uint8", PlyType::UInt8},    {"short", PlyType::Int16},     {"int16", PlyType::Int16},
      {"ushort", PlyType::UInt16},  {"uint16", PlyType::UInt16},   {"int", PlyType::Int32},
      {"int32", PlyType::Int32},    {"uint", PlyType::UInt32},     {"uint32", PlyType::UInt32},
      {"float", PlyType::Float32},  {"float32", PlyType::Float32}, {"double", PlyType::Float64},
      {"float64", PlyType::Float64}};
  auto at = std::find_if(std::begin(kTypes), std::end(kTypes), [&](auto& t) { return t.first == name; });
  return at == std::end(kTypes) ? std::nullopt : std::optional(at->second);
}

/// Takes the lines of the header. Which bytes end a line the first one says: behind "\r" alone a binary body may begin
/// with "\n".
class Lines {
 public:
  Lines(std::string_view text, const Path& path) : mText(text), mPath(path) {
    std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    mEnd = end + 1 < text.size() && text[end] == '\r' && text[end + 1] != '\n' ? '\r' : '\n';
  }
  std::string_view next() {
    if (mAt >= mText.size()) refuse(mPath, "has no end of its header: it is cut short");
    std::size_t end = std::min(mText.find(mEnd, mAt), mText.size());
    if (++mCount > kMostLines || end - mAt > kLongestOfHeader) refuse(mPath, "has no end of its header");
    auto line = mText.substr(mAt, end - mAt);
    mAt = std::min(end + 1, mText.size());
    return trimmed(line);
  }
  std::size_t at() const { return mAt; }

 private:
  std::string_view mText;
  const Path& mPath;
  char mEnd;
  std::size_t mAt = 0, mCount = 0;
};

std::optional<PlyElement> elementOf(const std::vector<std::string>& words) {
  if (words.size() != 3) return std::nullopt;
  PlyElement element{words[1], 0, {}};
  const char* end = words[2].data() + words[2].size();
  auto [stop, error] = std::from_chars(words[2].data(), end, element.count);
  return error == std::errc() && stop == end ? std::optional(std::move(element)) : std::nullopt;
}

std::optional<PlyProperty> propertyOf(const std::vector<std::string>& words) {
  bool isList = words.size() == 5 && words[1] == "list";
  if (!isList && words.size() != 3) return std::nullopt;
  auto type = typeNamed(words[isList ? 3 : 1]), countType = isList ? typeNamed(words[2]) : std::nullopt;
  bool isCount = countType && *countType != PlyType::Float32 && *countType != PlyType::Float64;
  if (!type || (isList && !isCount)) return std::nullopt;
  return PlyProperty{words.back(), *type, countType};
}

/// @return false for a line that makes no sense where it stands
bool takeLine(PlyHeader& header, const std::vector<std::string>& words, bool& hasFormat) {
  const std::string& key = words[0];
  if (key == "comment" || key == "obj_info") return true;
  if (key == "format") {
    hasFormat = words.size() >= 2;
    header.isText = hasFormat && words[1] == "ascii";
    header.isBigEndian = hasFormat && words[1] == "binary_big_endian";
    return header.isText || header.isBigEndian || (hasFormat && words[1] == "binary_little_endian");
  }
  if (key == "element") {
    auto element = elementOf(words);
    auto isSame = [&](const PlyElement& e) { return element && e.name == element->name; };
    if (std::any_of(header.elements.begin(), header.elements.end(), isSame)) return false;
    if (element) header.elements.push_back(std::move(*element));
    return element.has_value();
  }
  if (key != "property" || header.elements.empty()) return false;
  auto property = propertyOf(words);
  if (property) header.elements.back().properties.push_back(std::move(*property));
  return property.has_value();
}

}  // namespace

std::size_t sizeOf(PlyType type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<int>(type)];
}

PlyHeader parsePlyHeader(std::string_view file, const Path& path) {
  Lines lines(file, path);
  if (lines.next() != "ply") refuse(path, "is not a PLY file");
  PlyHeader header;
  bool hasFormat = false;
  for (;;) {
    std::string_view line = lines.next();
    if (line.empty()) continue;
    if (line == "end_header") break;
    if (!takeLine(header, wordsOf(line), hasFormat))
      refuse(path, fmt::format("its header is damaged: the line {} is not understood", inQuotes(line)));
  }
  if (!hasFormat) refuse(path, "its header is damaged: it has no line 'format'");
  header.bodyAt = lines.at();
  return header;
}

}  // namespace velum::io
