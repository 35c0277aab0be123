#include "io/volumes/DicomSoundness.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>

namespace velum::io {

namespace {

constexpr std::uint32_t kUndefined = 0xffffffff;
constexpr std::uint32_t kItem = 0xfffee000, kItemEnd = 0xfffee00d, kSequenceEnd = 0xfffee0dd, kPixels = 0x7fe00010;
constexpr int kDeepestSequence = 32;
constexpr std::size_t kLargestDeflated = 1 << 30;

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

/// Bytes of a value, or of what is left of the file.
struct Stretch {
  std::size_t end = 0;
  bool isOpen = false;  ///< Of undefined length: a delimiter ends it.
};

class Walker {
 public:
  explicit Walker(std::string_view bytes, bool isRle = false) : mBytes(bytes), mIsRle(isRle) {}

  /// Walks over elements from @p at. @return false at the first thing that the standard does not allow
  bool walkElements(std::size_t& at, Stretch stretch, Coding coding, int depth);
  /// Elements of group 2, always explicit and little-endian. @return false as walkElements
  bool takeMeta(std::size_t& at, std::string& syntax);

 private:
  struct Element {
    std::uint32_t tag = 0, length = 0;
    std::size_t value = 0;
    std::string_view vr;
    bool isClear = true;  ///< False: not an element as the standard has it.
  };
  Element elementAt(std::size_t at, Coding coding) const;
  bool walkItems(std::size_t& at, Stretch stretch, Coding coding, int depth, bool areFragments);
  bool walkValue(std::size_t& at, const Element& e, std::size_t end, Coding coding, int depth);
  std::uint16_t number16(std::size_t at, bool big) const;
  std::uint32_t number32(std::size_t at, bool big) const;

  /// The numbers that describe pixels must be numbers, and flags 0 or 1.
  bool isSoundPixelModule(const Element& e, Coding coding) const;
  /// What GDCM asks for by its representation must have it, and ACR-NEMA be of a version that was.
  bool isAsAskedFor(const Element& e, Coding coding) const;
  /// GDCM trusts the header of a run-length fragment: how many segments, and where.
  bool isSoundRle(std::size_t at, std::uint32_t length) const;

  std::string_view mBytes;
  bool mIsRle;
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
  constexpr std::string_view kKnown =
      "AE AS AT CS DA DS DT FD FL IS LO LT OB OD OF OL OV OW PN SH SL SQ SS ST SV TM UC UI UL UN UR US UT UV";
  auto found = kKnown.find(e.vr);
  e.isClear = found != std::string_view::npos && found % 3 == 0;
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

bool Walker::walkElements(std::size_t& at, Stretch stretch, Coding coding, int depth) {
  if (depth > kDeepestSequence) return false;
  while (at < stretch.end) {
    if (stretch.end - at < 8) return false;
    Element e = elementAt(at, coding);
    at = e.value;
    if (e.tag == kItemEnd) return stretch.isOpen && e.length == 0;
    if (!e.isClear || e.tag >> 16 == 0xfffe || at > stretch.end) return false;
    if ((depth == 0 && !isSoundPixelModule(e, coding)) || !isAsAskedFor(e, coding)) return false;
    if (!walkValue(at, e, stretch.end, coding, depth)) return false;
    // Zeros behind the pixels are common, and GDCM stops at them unless they are half an element.
    bool isZero = mBytes.find_first_not_of('\0', at) == std::string_view::npos;
    std::size_t left = stretch.end - at;
    if (e.tag == kPixels && depth == 0 && isZero && (left < 3 || left >= 8)) return true;
  }
  return !stretch.isOpen;
}

bool Walker::walkValue(std::size_t& at, const Element& e, std::size_t end, Coding coding, int depth) {
  // An unknown sequence is coded implicitly, whatever the file is.
  Coding inside = e.vr == "UN" ? Coding{false, false} : coding;
  if (e.length == kUndefined) {
    bool isPlain = e.vr != "SQ" && e.vr != "UN" && coding.isExplicit;
    if (isPlain && e.tag != kPixels) return false;
    return walkItems(at, {end, true}, inside, depth + 1, e.tag == kPixels);
  }
  if (e.length > end - at) return false;
  std::size_t next = at + e.length;
  bool mayHoldItems = e.vr == "SQ" || e.vr == "UN" || !coding.isExplicit;
  if (mayHoldItems && e.length >= 8) {
    std::uint32_t first = std::uint32_t(number16(at, inside.isBig)) << 16 | number16(at + 2, inside.isBig);
    // Items in the other byte order, as an old scanner wrote them, are more than GDCM can be trusted with.
    if (first == 0xfeff00e0) return false;
    if ((first == kItem || e.vr == "SQ") && !walkItems(at, {next, false}, inside, depth + 1, false)) return false;
  }
  at = next;
  return true;
}

bool Walker::walkItems(std::size_t& at, Stretch stretch, Coding coding, int depth, bool areFragments) {
  if (depth > kDeepestSequence) return false;
  bool isTable = true;
  while (at < stretch.end) {
    if (stretch.end - at < 8) return false;
    Element e = elementAt(at, coding);
    at += 8;
    if (e.tag == kSequenceEnd) return stretch.isOpen && e.length == 0;
    if (e.tag != kItem) return false;
    bool isOpen = e.length == kUndefined;
    if (!isOpen && e.length > stretch.end - at) return false;
    if (areFragments && isOpen) return false;
    if (areFragments) {
      // The first item is the table of offsets.
      if (mIsRle && !isTable && !isSoundRle(at, e.length)) return false;
      isTable = false;
      at += e.length;
    } else if (isOpen || e.length > 0) {
      if (!walkElements(at, {isOpen ? stretch.end : at + e.length, isOpen}, coding, depth + 1)) return false;
    }
  }
  return !stretch.isOpen;
}

bool Walker::isSoundPixelModule(const Element& e, Coding coding) const {
  constexpr std::uint32_t kNumbers[] = {0x00280002, 0x00280006, 0x00280010, 0x00280011,
                                        0x00280100, 0x00280101, 0x00280102, 0x00280103};
  constexpr std::uint32_t kPlanar = 0x00280006, kSign = 0x00280103;
  if (std::find(std::begin(kNumbers), std::end(kNumbers), e.tag) == std::end(kNumbers)) return true;
  if (coding.isExplicit && e.vr != "US") return false;
  if (e.length == 0) return true;  // some writers leave them empty where there is no image
  if (e.length != 2 || e.value + 2 > mBytes.size()) return false;
  return (e.tag != kPlanar && e.tag != kSign) || number16(e.value, coding.isBig) <= 1;
}

bool Walker::isAsAskedFor(const Element& e, Coding coding) const {
  constexpr std::uint32_t kRecognition = 0x00080010;
  if (e.tag == kRecognition) {
    std::string_view code = mBytes.substr(std::min(e.value, mBytes.size()), e.length);
    return code == "ACR-NEMA 1.0" || code == "ACR-NEMA 2.0";
  }
  constexpr std::pair<std::uint32_t, std::string_view> kAsked[] = {
      {0x00180088, "DS"}, {0x00181164, "DS"}, {0x00200032, "DS"}, {0x00200037, "DS"},
      {0x00280008, "IS"}, {0x00280030, "DS"}, {0x00280034, "IS"}, {0x00281052, "DS"},
      {0x00281053, "DS"}, {0x3004000c, "DS"}, {0x3004000e, "DS"}};
  auto asked = std::find_if(std::begin(kAsked), std::end(kAsked), [&](const auto& a) { return a.first == e.tag; });
  return !coding.isExplicit || asked == std::end(kAsked) || e.vr == asked->second || e.vr == "UN";
}

bool Walker::isSoundRle(std::size_t at, std::uint32_t length) const {
  if (length < 64) return false;
  std::uint32_t count = number32(at, false), last = 63;
  if (count < 1 || count > 15) return false;
  for (std::uint32_t i = 1; i <= count; ++i) {
    std::uint32_t offset = number32(at + 4 * i, false);
    if (offset <= last || offset >= length) return false;
    last = offset;
  }
  return true;
}

bool Walker::takeMeta(std::size_t& at, std::string& syntax) {
  while (at + 8 <= mBytes.size() && number16(at, false) == 2) {
    Element e = elementAt(at, {});
    if (!e.isClear || e.vr == "SQ" || e.value > mBytes.size() || e.length > mBytes.size() - e.value) return false;
    if (e.tag == 0x00020010) syntax = mBytes.substr(e.value, e.length);
    at = e.value + e.length;
  }
  while (!syntax.empty() && (syntax.back() == '\0' || syntax.back() == ' ')) syntax.pop_back();
  return true;
}

/// A raw deflate stream; empty when it is damaged or unfolds to more than we walk over.
std::string inflated(std::string_view packed) {
  std::string result;
  z_stream stream{};
  if (inflateInit2(&stream, -15) != Z_OK) return result;
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = uInt(packed.size());
  int code = Z_OK;
  while (code == Z_OK && result.size() < kLargestDeflated) {
    std::size_t have = result.size();
    result.resize(have + (1 << 20));
    stream.next_out = reinterpret_cast<Bytef*>(result.data() + have);
    stream.avail_out = 1 << 20;
    code = inflate(&stream, Z_NO_FLUSH);
    result.resize(result.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (code != Z_STREAM_END) result.clear();
  return result;
}

}  // namespace

bool mayBeDicom(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  char head[132] = {};
  stream.read(head, sizeof head);
  if (stream.gcount() == 132 && std::memcmp(head + 128, "DICM", 4) == 0) return true;
  return stream.gcount() >= 16 && (head[0] == 2 || head[0] == 8) && head[1] == 0 && head[3] == 0;
}

bool isSoundDicom(const std::filesystem::path& path) {
  MappedFile file(path);
  std::string_view bytes = file.bytes();
  std::size_t at = bytes.size() > 132 && bytes.substr(128, 4) == "DICM" ? 132 : 0;
  std::string syntax, unpacked;
  if (!Walker(bytes).takeMeta(at, syntax)) return false;
  if (syntax == "1.2.840.10008.1.2.1.99") {
    if (bytes.size() > 0x7fffffff) return false;
    unpacked = inflated(bytes.substr(at));
    bytes = unpacked;
    at = 0;
  }
  if (at + 8 > bytes.size()) return false;
  Coding coding{syntax != "1.2.840.10008.1.2", syntax == "1.2.840.10008.1.2.2"};
  if (syntax.empty()) {
    auto isCapital = [](char c) { return c >= 'A' && c <= 'Z'; };
    coding.isExplicit = isCapital(bytes[at + 4]) && isCapital(bytes[at + 5]);
    // GDCM guesses otherwise where the first element is none that files begin with.
    constexpr std::string_view kIdentifying("\x08\0", 2), kTurned("\0\x08", 2);
    coding.isBig = bytes.substr(at, 2) == kTurned;
    if (!coding.isBig && bytes.substr(at, 2) != kIdentifying) return false;
  }
  return Walker(bytes, syntax == "1.2.840.10008.1.2.5").walkElements(at, {bytes.size(), false}, coding, 0);
}

}  // namespace velum::io
