#include "DicomLengths.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace velum::io {

namespace {

constexpr std::uint32_t kUndefined = 0xffffffff;
constexpr std::uint32_t kItem = 0xfffee000, kItemEnd = 0xfffee00d, kSequenceEnd = 0xfffee0dd, kPixels = 0x7fe00010;
constexpr int kDeepest = 64;

/// A file as bytes, without a copy.
class MappedFile {
 public:
  explicit MappedFile(const std::filesystem::path& path) {
    int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    struct stat status {};
    if (descriptor < 0) return;
    if (::fstat(descriptor, &status) == 0 && status.st_size > 0) {
      void* data = ::mmap(nullptr, std::size_t(status.st_size), PROT_READ, MAP_PRIVATE, descriptor, 0);
      if (data != MAP_FAILED) mBytes = {static_cast<const char*>(data), std::size_t(status.st_size)};
    }
    ::close(descriptor);
  }
  ~MappedFile() {
    if (!mBytes.empty()) ::munmap(const_cast<char*>(mBytes.data()), mBytes.size());
  }
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;
  std::string_view bytes() const { return mBytes; }

 private:
  std::string_view mBytes;
};

struct Coding {
  bool isExplicit = true;
  bool isBig = false;
};

class Walker {
 public:
  explicit Walker(std::string_view bytes) : mBytes(bytes) {}

  /// Walks the elements from @p at to @p end. @return false once a length leaves its surroundings
  bool walk(std::size_t& at, std::size_t end, Coding coding, int depth, bool inFragments = false);
  /// Elements of group 2, always explicit and little-endian. @return the transfer syntax
  std::string takeMeta(std::size_t& at);
  std::uint16_t number16(std::size_t at, bool big) const;
  std::uint32_t number32(std::size_t at, bool big) const;

 private:
  struct Element {
    std::uint32_t tag = 0, length = 0;
    std::size_t value = 0;
    std::string_view vr;
    bool isClear = true;  ///< False: not an element as the standard has it.
  };
  Element elementAt(std::size_t at, Coding coding) const;

  std::string_view mBytes;
};

std::uint16_t Walker::number16(std::size_t at, bool big) const {
  auto b = [&](std::size_t i) { return std::uint16_t(static_cast<unsigned char>(mBytes[at + i])); };
  return std::uint16_t(big ? b(0) << 8 | b(1) : b(1) << 8 | b(0));
}

std::uint32_t Walker::number32(std::size_t at, bool big) const {
  std::uint32_t first = number16(at, big), second = number16(at + 2, big);
  return big ? first << 16 | second : second << 16 | first;
}

Walker::Element Walker::elementAt(std::size_t at, Coding coding) const {
  Element e;
  e.tag = std::uint32_t(number16(at, coding.isBig)) << 16 | number16(at + 2, coding.isBig);
  bool isDelimiter = e.tag >> 16 == 0xfffe;
  e.value = at + 8;
  if (isDelimiter || !coding.isExplicit) {
    e.length = number32(at + 4, coding.isBig);
    return e;
  }
  e.vr = mBytes.substr(at + 4, 2);
  auto isCapital = [](char c) { return c >= 'A' && c <= 'Z'; };
  e.isClear = isCapital(e.vr[0]) && isCapital(e.vr[1]);
  constexpr std::string_view kLong = "OB OW OF OD OL OV SQ UC UR UT UN SV UV";
  if (kLong.find(e.vr) == std::string_view::npos) {
    e.length = number16(at + 6, coding.isBig);
  } else if (at + 12 <= mBytes.size()) {
    e.length = number32(at + 8, coding.isBig);
    e.value = at + 12;
  } else {
    e.isClear = false;
  }
  return e;
}

bool Walker::walk(std::size_t& at, std::size_t end, Coding coding, int depth, bool inFragments) {
  if (depth > kDeepest) return false;
  while (at + 8 <= end) {
    Element e = elementAt(at, coding);
    if (!e.isClear) {  // GDCM guesses on from here; nothing more can be promised
      at = end;
      return true;
    }
    at = e.value;
    if (e.tag == kItemEnd || e.tag == kSequenceEnd) return true;
    bool isItem = e.tag == kItem, isPixels = e.tag == kPixels;
    // An unknown sequence is coded implicitly, whatever the file is.
    Coding inside = e.vr == "UN" ? Coding{false, false} : coding;
    if (e.length == kUndefined) {
      if (!walk(at, end, inside, depth + 1, isPixels)) return false;
      continue;
    }
    if (e.length > end - at) return false;
    if (isPixels && depth == 0) return true;
    std::size_t next = at + e.length;
    bool holdsItems = e.length >= 8 && e.vr != "OB" && e.vr != "OW" && number16(at, inside.isBig) == 0xfffe &&
                      number16(at + 2, inside.isBig) == 0xe000;
    bool descend = (isItem && !inFragments) || (!isItem && (e.vr == "SQ" || holdsItems));
    if (descend && !walk(at, next, inside, depth + 1)) return false;
    at = next;
  }
  return true;
}

std::string Walker::takeMeta(std::size_t& at) {
  std::string syntax;
  while (at + 8 <= mBytes.size() && number16(at, false) == 2) {
    Element e = elementAt(at, {});
    if (!e.isClear || e.length > mBytes.size() - e.value) break;
    if (e.tag == 0x00020010) syntax = mBytes.substr(e.value, e.length);
    at = e.value + e.length;
  }
  while (!syntax.empty() && (syntax.back() == '\0' || syntax.back() == ' ')) syntax.pop_back();
  return syntax;
}

}  // namespace

bool dicomLengthsFit(const std::filesystem::path& path) {
  MappedFile file(path);
  std::string_view bytes = file.bytes();
  std::size_t at = bytes.size() > 132 && bytes.substr(128, 4) == "DICM" ? 132 : 0;
  Walker walker(bytes);
  std::string syntax = walker.takeMeta(at);
  if (at + 8 > bytes.size()) return true;  // nothing behind the meta group
  if (syntax == "1.2.840.10008.1.2.1.99") return true;
  Coding coding{syntax != "1.2.840.10008.1.2", syntax == "1.2.840.10008.1.2.2"};
  if (syntax.empty()) {
    auto isCapital = [](char c) { return c >= 'A' && c <= 'Z'; };
    coding.isExplicit = isCapital(bytes[at + 4]) && isCapital(bytes[at + 5]);
    coding.isBig = bytes[at] == 0;
  }
  return walker.walk(at, bytes.size(), coding, 0);
}

}  // namespace velum::io
