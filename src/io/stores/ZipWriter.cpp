#include "io/stores/ZipWriter.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

#include "io/read/FileBytes.h"
#include "io/stores/Codecs.h"

namespace velum::io {

namespace {

constexpr std::uint16_t kVersion = 45;                                   ///< of ZIP, that has sizes of 64 bits
constexpr std::uint16_t kNames = 1 << 11;                                ///< flag: names are UTF-8
constexpr std::uint32_t kDay = (2020 - 1980) << 25 | 1 << 21 | 1 << 16;  ///< the same bytes whenever it is written
constexpr std::uint32_t kIn64 = 0xffffffffu;                             ///< the size is in the extra field

/// Numbers of given sizes, low byte first.
class Record {
 public:
  explicit Record(std::uint32_t signature) { u32(signature); }
  Record& u16(std::uint64_t number) { return put(number, 2); }
  Record& u32(std::uint64_t number) { return put(number, 4); }
  Record& u64(std::uint64_t number) { return put(number, 8); }
  Record& text(const std::string& text) {
    bytes += text;
    return *this;
  }
  std::string bytes;

 private:
  Record& put(std::uint64_t number, int size) {
    for (int i = 0; i < size; ++i) bytes += char(number >> (8 * i) & 255);
    return *this;
  }
};

struct ZipEntry {
  std::string name;
  std::uint64_t at = 0, size = 0;
  std::uint32_t crc = 0;
};

std::vector<ZipEntry> membersOf(const Path& folder, const std::string& without) {
  std::vector<ZipEntry> members;
  std::error_code error;
  for (std::filesystem::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::string name = entry->path().lexically_relative(folder).generic_string();
    if (entry->is_regular_file(error) && name != without) members.push_back({name});
  }
  if (error) refuse(folder, fmt::format("cannot be listed: {}", error.message()));
  auto rank = [](const ZipEntry& member) {
    std::string file = member.name.substr(member.name.rfind('/') + 1);
    bool isMetadata = file == "zarr.json" || file.starts_with(".z");
    return std::tuple(!isMetadata, isMetadata ? std::count(member.name.begin(), member.name.end(), '/') : 0,
                      member.name);
  };
  std::sort(members.begin(), members.end(), [&](const ZipEntry& a, const ZipEntry& b) { return rank(a) < rank(b); });
  return members;
}

std::uint32_t crcOf(const Bytes& bytes) {
  return std::uint32_t(::crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::string localHeader(const ZipEntry& m) {
  return Record(0x04034b50)
      .u16(kVersion)
      .u16(kNames)
      .u16(0)
      .u32(kDay)
      .u32(m.crc)
      .u32(kIn64)
      .u32(kIn64)
      .u16(m.name.size())
      .u16(20)
      .text(m.name)
      .u16(1)
      .u16(16)
      .u64(m.size)
      .u64(m.size)
      .bytes;
}

std::string directoryEntry(const ZipEntry& m) {
  return Record(0x02014b50)
      .u16(kVersion)
      .u16(kVersion)
      .u16(kNames)
      .u16(0)
      .u32(kDay)
      .u32(m.crc)
      .u32(kIn64)
      .u32(kIn64)
      .u16(m.name.size())
      .u16(28)
      .u16(0)
      .u16(0)
      .u16(0)
      .u32(0)
      .u32(kIn64)
      .text(m.name)
      .u16(1)
      .u16(24)
      .u64(m.size)
      .u64(m.size)
      .u64(m.at)
      .bytes;
}

std::string directoryEnd(std::uint64_t count, std::uint64_t at, std::uint64_t size, const std::string& comment) {
  std::string end64 = Record(0x06064b50)
                          .u64(44)
                          .u16(kVersion)
                          .u16(kVersion)
                          .u32(0)
                          .u32(0)
                          .u64(count)
                          .u64(count)
                          .u64(size)
                          .u64(at)
                          .bytes;
  std::string locator = Record(0x07064b50).u32(0).u64(at + size).u32(1).bytes;
  std::uint64_t shortCount = std::min<std::uint64_t>(count, 0xffff);
  std::string end = Record(0x06054b50)
                        .u16(0)
                        .u16(0)
                        .u16(shortCount)
                        .u16(shortCount)
                        .u32(std::min<std::uint64_t>(size, kIn64))
                        .u32(kIn64)
                        .u16(comment.size())
                        .text(comment)
                        .bytes;
  return end64 + locator + end;
}

}  // namespace

void zipFolder(const Path& folder, const std::string& without, const std::string& comment, ReplaceFile& file,
               Progress& progress) {
  std::vector<ZipEntry> members = membersOf(folder, without);
  std::uint64_t at = 0;
  auto put = [&](auto bytes) {
    file.write(bytes);
    at += bytes.size();
  };
  for (std::size_t i = 0; i < members.size(); ++i) {
    progress.report(double(i) / double(members.size()), "Joining the archive");
    ZipEntry& member = members[i];
    FileBytes from(folder / member.name);
    if (from.size() > kMostChunkBytes) refuse(from.path(), "is larger than any file of a store that we write");
    Bytes bytes(static_cast<std::size_t>(from.size()));
    from.read(0, bytes);
    member.at = at;
    member.size = bytes.size();
    member.crc = crcOf(bytes);
    std::string header = localHeader(member);
    put(std::string_view(header));
    put(std::span<const std::byte>(bytes));
  }
  std::string directory;
  for (const ZipEntry& member : members) directory += directoryEntry(member);
  std::uint64_t directoryAt = at;
  put(std::string_view(directory));
  file.write(directoryEnd(members.size(), directoryAt, directory.size(), comment));
}

}  // namespace velum::io
