#include "io/volumes/SegyLayout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <string_view>

#include "io/read/Refuse.h"

namespace velum::io {

namespace {

constexpr std::uint64_t kTextHeader = 3200, kBinaryHeader = 400;
constexpr int kMostTextHeaders = 10'000;

enum class Code {
  Ibm = 1,
  Int32 = 2,
  Int16 = 3,
  Ieee32 = 5,
  Ieee64 = 6,
  Int8 = 8,
  UInt32 = 10,
  UInt16 = 11,
  UInt8 = 16
};

std::optional<SampleType> typeOf(int code) {
  switch (static_cast<Code>(code)) {
    case Code::Ibm:
    case Code::Ieee32:
      return SampleType::Float32;
    case Code::Int32:
      return SampleType::Int32;
    case Code::Int16:
      return SampleType::Int16;
    case Code::Ieee64:
      return SampleType::Float64;
    case Code::Int8:
      return SampleType::Int8;
    case Code::UInt32:
      return SampleType::UInt32;
    case Code::UInt16:
      return SampleType::UInt16;
    case Code::UInt8:
      return SampleType::UInt8;
  }
  return {};
}

/// EBCDIC's letters, digits and marks, and its space.
bool isEbcdic(unsigned char c) {
  constexpr std::pair<int, int> kPrinted[] = {{0x40, 0x40}, {0x4a, 0x50}, {0x5a, 0x61}, {0x6a, 0x6f},
                                              {0x79, 0x7f}, {0x81, 0x89}, {0x91, 0x99}, {0xa1, 0xa9},
                                              {0xc1, 0xc9}, {0xd1, 0xd9}, {0xe2, 0xe9}, {0xf0, 0xf9}};
  return std::any_of(std::begin(kPrinted), std::end(kPrinted), [&](auto r) { return c >= r.first && c <= r.second; });
}

/// True for the 3200 bytes of a text header in either code; traces hold zeros and much that is no character.
bool isText(std::string_view block) {
  std::size_t ascii = 0, ebcdic = 0, used = 0;
  for (char c : block) {
    auto byte = static_cast<unsigned char>(c);
    used += byte != 0;
    ascii += (byte >= 0x20 && byte < 0x7f) || byte == '\n' || byte == '\r' || byte == '\t';
    ebcdic += isEbcdic(byte);
  }
  return used >= block.size() / 8 && double(std::max(ascii, ebcdic)) > 0.95 * double(used);
}

/// True for the header that ends a variable number of them: it has the stanza ((SEG: EndText)).
bool isLastText(std::string block) {
  std::string ebcdic = block;
  for (char& c : block)
    if (c >= 'A' && c <= 'Z') c = char(c | 0x20);
  for (char& c : ebcdic)  // small letters are the capitals without 0x40
    if (static_cast<unsigned char>(c) > 0xc0) c = char(c & 0xbf);
  return block.find("endtext") != std::string::npos || ebcdic.find("\x85\x95\x84\xa3\x85\xa7\xa3") != std::string::npos;
}

std::string textBlock(const FileBytes& file, int index) {
  std::string block(kTextHeader, '\0');
  std::uint64_t at = kTextHeader + kBinaryHeader + std::uint64_t(index) * kTextHeader;
  if (at + kTextHeader > file.size()) return {};
  file.read(at, std::as_writable_bytes(std::span(block)));
  return block;
}

/// Extended text headers up to the one that says that it is the last; nothing when none says so.
std::optional<int> countTexts(const FileBytes& file) {
  for (int i = 0; i < kMostTextHeaders; ++i) {
    std::string block = textBlock(file, i);
    if (block.empty()) break;
    if (isLastText(block)) return i + 1;
  }
  return {};
}

/// Extended text headers, of which files of revision 0 know nothing although programs write them: there and wherever
/// else a number may be rubbish, what stands behind the binary header decides.
/// @param fills  whether traces fill the file from a byte on
template <class Fills>
int textHeadersOf(const FileBytes& file, const SegyFields& f, int revision, const Path& path, const Fills& fills,
                  std::vector<std::string>& warnings) {
  int claimed = f.two(3505);
  if (claimed < 0) {
    auto counted = countTexts(file);
    if (!counted && revision > 0)
      refuse(path, "has a variable number of extended text headers, of which none says that it is the last");
    return counted.value_or(0);
  }
  if (claimed == 0 || claimed > kMostTextHeaders) return 0;
  bool isThere = true;
  for (int i = 0; i < claimed && isThere; ++i) {
    std::string block = textBlock(file, i);
    isThere = !block.empty() && isText(block);
  }
  constexpr std::uint64_t kFirst = kTextHeader + kBinaryHeader;
  bool fillsBehind = fills(kFirst + std::uint64_t(claimed) * kTextHeader), fillsAtOnce = fills(kFirst);
  bool isRead = isThere || fillsBehind == fillsAtOnce ? isThere || revision > 0 : fillsBehind;
  if (!isRead && revision > 0)
    warnings.push_back(fmt::format("the {} extended text headers that it claims are not there", claimed));
  return isRead ? claimed : 0;
}

/// What revision 2 says in places of its own. @return where the traces end
std::uint64_t takeRevisionTwo(const SegyFields& f, SegyLayout& out, std::uint64_t end) {
  if (int samples = f.four(3269); samples > 0) out.samples = samples;
  if (auto interval = std::bit_cast<double>(f.eight(3273)); interval > 0 && interval < 1e9) out.interval = interval;
  if (int more = f.four(3507); more > 0 && more < 1000) out.headerBytes += std::uint64_t(more) * kSegyTraceHeader;
  int trailers = f.four(3529);
  if (trailers <= 0 || trailers > kMostTextHeaders) return end;
  return end - std::min(end, std::uint64_t(trailers) * kTextHeader);
}

/// The layout in one byte order, if it makes sense so.
std::optional<SegyLayout> layoutOf(const FileBytes& file, std::span<const std::byte> binary, const Path& path,
                                   bool isLittle) {
  SegyFields f(binary, 3201, isLittle);
  SegyLayout out;
  int code = f.two(3225);
  auto type = typeOf(code);
  if (!type) return {};
  out.isLittle = isLittle;
  out.isIbm = static_cast<Code>(code) == Code::Ibm;
  out.samples = f.unsignedTwo(3221);
  out.interval = f.unsignedTwo(3217);
  out.sorting = f.two(3229);
  out.isFeet = f.two(3255) == 2;
  out.type = *type;
  // A number of two bytes in revision 1, two of one byte in revision 2.
  int revision = std::max<int>(f.unsignedTwo(3501) >> 8, f.one(3501));
  if (revision > 2) revision = 0;
  out.isOneLength = revision > 0 && f.two(3503) == 1;
  std::uint64_t end = file.size();
  if (revision == 2) end = takeRevisionTwo(f, out, end);
  // Where traces begin depends on their size only where the headers are in doubt.
  constexpr std::uint64_t kFirst = kTextHeader + kBinaryHeader;
  auto bytesOf = [&](int samples) { return out.headerBytes + std::uint64_t(samples) * sampleSize(out.type); };
  auto fills = [&](std::uint64_t from) {
    return out.samples > 0 && from < end && (end - from) % bytesOf(out.samples) == 0;
  };
  out.firstTrace = kFirst + std::uint64_t(textHeadersOf(file, f, revision, path, fills, out.warnings)) * kTextHeader;
  if (std::uint64_t from = revision == 2 ? f.eight(3521) : 0; from >= kFirst && from < end) out.firstTrace = from;
  if (out.samples == 0 && out.firstTrace + kSegyTraceHeader <= file.size()) {
    std::array<std::byte, kSegyTraceHeader> header;
    file.read(out.firstTrace, header);
    out.samples = SegyFields(header, 1, isLittle).unsignedTwo(115);
  }
  if (out.samples == 0) return {};
  out.traceBytes = bytesOf(out.samples);
  std::uint64_t body = end > out.firstTrace ? end - out.firstTrace : 0;
  out.traces = body / out.traceBytes;
  out.hasRest = body % out.traceBytes != 0;
  return out;
}

}  // namespace

SegyLayout findSegyLayout(const FileBytes& file, const Path& path) {
  std::string head = file.head(64);
  if (head.starts_with("version https://git-lfs"))
    refuse(path, "is a Git LFS pointer and not the data; fetch it with 'git lfs pull'");
  if (file.size() < kTextHeader + kBinaryHeader)
    refuse(path, fmt::format("is not SEG-Y: {} bytes are fewer than its headers ({})", file.size(),
                             kTextHeader + kBinaryHeader));
  std::array<std::byte, kBinaryHeader> binary;
  file.read(kTextHeader, binary);
  auto big = layoutOf(file, binary, path, false), little = layoutOf(file, binary, path, true);
  if (!big && !little)
    refuse(path,
           fmt::format("is not SEG-Y, or of a kind that is not read (sample format {}, {} samples a trace)",
                       SegyFields(binary, 3201, false).two(3225), SegyFields(binary, 3201, false).unsignedTwo(3221)));
  // Both make sense rarely; then traces that fill the file decide, else the standard's order.
  SegyLayout out = big && little ? (little->traces > 0 && !little->hasRest && big->hasRest ? *little : *big)
                   : big         ? *big
                                 : *little;
  if (out.traces == 0) refuse(path, "has headers but no whole trace");
  if (out.traces > 200'000'000) refuse(path, fmt::format("has {} traces; that many are not read", out.traces));
  return out;
}

}  // namespace velum::io
