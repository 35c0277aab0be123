#include "ExrHeader.h"

#include <cstring>
#include <optional>
#include <string>

namespace velum::io {

namespace {

constexpr std::uint32_t kManyParts = 0x1000;  ///< Of the word behind the magic number.
constexpr std::size_t kLongestName = 255;
constexpr int kMostAttributes = 10000;

class Attributes {
 public:
  explicit Attributes(const FileBytes& file) : mFile(file) {}

  /// The attributes of one part. @return how many; nothing when one of them leaves the file
  std::optional<int> skipPart() {
    for (int count = 0; count < kMostAttributes; ++count) {
      auto name = takeName();
      if (!name) return std::nullopt;
      if (name->empty()) return count;
      auto type = takeName();
      if (!type || mFile.size() - mAt < 4) return std::nullopt;
      auto size = number(mAt);
      mAt += 4;
      if (size > mFile.size() - mAt) return std::nullopt;
      mAt += size;
    }
    return std::nullopt;
  }
  std::uint32_t number(std::uint64_t at) const {
    unsigned char b[4];
    mFile.read(at, std::as_writable_bytes(std::span(b)));
    return std::uint32_t(b[0]) | std::uint32_t(b[1]) << 8 | std::uint32_t(b[2]) << 16 | std::uint32_t(b[3]) << 24;
  }

 private:
  /// Up to the zero behind it.
  std::optional<std::string> takeName() {
    std::string bytes(kLongestName + 1, '\0');
    bytes.resize(mFile.readSome(mAt, std::as_writable_bytes(std::span(bytes))));
    std::size_t end = bytes.find('\0');
    if (end == std::string::npos) return std::nullopt;
    bytes.resize(end);
    mAt += end + 1;
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
