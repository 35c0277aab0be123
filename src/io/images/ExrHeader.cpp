#include "io/images/ExrHeader.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace velum::io {

namespace {

constexpr std::uint32_t kManyParts = 0x1000;  ///< Of the word behind the magic number.
constexpr std::size_t kLongestName = 255;
constexpr int kMostAttributes = 10000;

/// Of the types that the library reads by what they are, whatever size the file says.
constexpr std::pair<std::string_view, std::uint32_t> kSizes[] = {{"box2i", 16},
                                                                 {"box2f", 16},
                                                                 {"chromaticities", 32},
                                                                 {"compression", 1},
                                                                 {"deepImageState", 1},
                                                                 {"double", 8},
                                                                 {"envmap", 1},
                                                                 {"float", 4},
                                                                 {"int", 4},
                                                                 {"keycode", 28},
                                                                 {"lineOrder", 1},
                                                                 {"m33d", 72},
                                                                 {"m33f", 36},
                                                                 {"m44d", 128},
                                                                 {"m44f", 64},
                                                                 {"rational", 8},
                                                                 {"tiledesc", 9},
                                                                 {"timecode", 8},
                                                                 {"v2d", 16},
                                                                 {"v2f", 8},
                                                                 {"v2i", 8},
                                                                 {"v3d", 24},
                                                                 {"v3f", 12},
                                                                 {"v3i", 12}};

class Attributes {
 public:
  explicit Attributes(const FileBytes& file) : mFile(file) {}

  /// The attributes of one part. @return how many; nothing when one of them is not what it says
  std::optional<int> skipPart() {
    for (int count = 0; count < kMostAttributes; ++count) {
      auto name = takeName(mFile.size());
      if (!name) return std::nullopt;
      if (name->empty()) return count;
      auto type = takeName(mFile.size());
      auto size = take(mFile.size());
      if (!type || !size || *size > mFile.size() - mAt) return std::nullopt;
      std::uint64_t end = mAt + *size;
      if (!isSound(*type, *size, end)) return std::nullopt;
      mAt = end;
    }
    return std::nullopt;
  }
  std::uint32_t number(std::uint64_t at) const {
    unsigned char b[4];
    mFile.read(at, std::as_writable_bytes(std::span(b)));
    return std::uint32_t(b[0]) | std::uint32_t(b[1]) << 8 | std::uint32_t(b[2]) << 16 | std::uint32_t(b[3]) << 24;
  }

 private:
  /// The value of an attribute, which begins here.
  bool isSound(const std::string& type, std::uint32_t size, std::uint64_t end) {
    auto known = std::find_if(std::begin(kSizes), std::end(kSizes), [&](const auto& s) { return s.first == type; });
    if (known != std::end(kSizes)) return size == known->second;
    if (type == "preview")
      return size >= 8 && size % 4 == 0 && std::uint64_t(number(mAt)) * number(mAt + 4) == size / 4 - 2;
    if (type == "chlist") return areChannels(end);
    if (type == "stringvector") return areStrings(end);
    return true;
  }
  /// A name and 16 bytes each, up to an empty name, which must stand at the end.
  bool areChannels(std::uint64_t end) {
    for (;;) {
      auto name = takeName(end);
      if (!name) return false;
      if (name->empty()) return mAt == end;
      if (end - mAt < 16) return false;
      mAt += 16;
    }
  }
  bool areStrings(std::uint64_t end) {
    while (mAt < end) {
      auto length = take(end);
      if (!length || *length > end - mAt) return false;
      mAt += *length;
    }
    return true;
  }
  std::optional<std::uint32_t> take(std::uint64_t end) {
    if (end - mAt < 4) return std::nullopt;
    mAt += 4;
    return number(mAt - 4);
  }
  /// Up to the zero behind it.
  std::optional<std::string> takeName(std::uint64_t end) {
    std::string bytes(std::size_t(std::min<std::uint64_t>(kLongestName + 1, end - mAt)), '\0');
    mFile.read(mAt, std::as_writable_bytes(std::span(bytes)));
    std::size_t zero = bytes.find('\0');
    if (zero == std::string::npos) return std::nullopt;
    bytes.resize(zero);
    mAt += zero + 1;
    return bytes;
  }

  const FileBytes& mFile;
  std::uint64_t mAt = 8;
};

}  // namespace

bool isSoundExr(const FileBytes& file) {
  if (file.size() < 9) return false;
  Attributes attributes(file);
  if (!(attributes.number(4) & kManyParts)) return attributes.skipPart().value_or(0) > 0;
  // An empty part ends the list.
  for (;;) {
    auto count = attributes.skipPart();
    if (!count) return false;
    if (*count == 0) return true;
  }
}

}  // namespace velum::io
