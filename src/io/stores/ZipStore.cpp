#include "io/stores/ZipStore.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <unordered_map>

#include "io/read/ByteSource.h"
#include "io/read/FileBytes.h"

namespace velum::io {

namespace {

constexpr std::uint64_t kMostDirectory = std::uint64_t(1) << 30;
constexpr std::uint64_t kMostInflated = std::uint64_t(2) << 30;

/// A number of `Number` bytes, low byte first, inside bytes that were checked to be there.
template <class Number>
Number numberAt(std::string_view bytes, std::size_t at) {
  Number number = 0;
  std::memcpy(&number, bytes.data() + at, sizeof(Number));  // the machine's order, as everywhere here
  return number;
}

struct Member {
  std::uint64_t header = 0;            ///< where its local header begins
  std::uint64_t packed = 0, size = 0;  ///< bytes in the archive, and inflated
  bool isDeflated = false;
};

std::string readText(const FileBytes& file, std::uint64_t at, std::uint64_t count) {
  std::string text(std::size_t(count), '\0');
  file.read(at, std::as_writable_bytes(std::span(text)));
  return text;
}

/// Bytes of a member that is stored as it is.
class StoredBlob : public Blob {
 public:
  StoredBlob(std::shared_ptr<const FileBytes> file, std::uint64_t at, std::uint64_t size)
      : mFile(std::move(file)), mAt(at), mSize(size) {}
  std::uint64_t size() const override { return mSize; }
  void read(std::uint64_t at, std::span<std::byte> to) const override {
    if (at > mSize || to.size() > mSize - at) refuse(mFile->path(), "a member of the archive is cut short");
    mFile->read(mAt + at, to);
  }

 private:
  std::shared_ptr<const FileBytes> mFile;
  std::uint64_t mAt, mSize;
};

/// Bytes of a member that was deflated.
class InflatedBlob : public Blob {
 public:
  InflatedBlob(Path path, Bytes bytes) : mPath(std::move(path)), mBytes(std::move(bytes)) {}
  std::uint64_t size() const override { return mBytes.size(); }
  void read(std::uint64_t at, std::span<std::byte> to) const override {
    if (at > mBytes.size() || to.size() > mBytes.size() - at) refuse(mPath, "a member of the archive is cut short");
    std::copy_n(mBytes.begin() + std::ptrdiff_t(at), to.size(), to.begin());
  }

 private:
  Path mPath;
  Bytes mBytes;
};

Bytes inflateMember(const Path& path, const Bytes& packed, std::uint64_t size) {
  if (size > kMostInflated || size > packed.size() * kDeflateRatio)
    refuse(path, fmt::format("a member of the archive promises {} bytes, which it cannot hold", size));
  Bytes bytes(static_cast<std::size_t>(size));
  z_stream stream{};
  if (::inflateInit2(&stream, -MAX_WBITS) != Z_OK) refuse(path, "there is no memory to inflate a member");
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(packed.data()));
  stream.avail_in = uInt(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = uInt(bytes.size());
  int result = ::inflate(&stream, Z_FINISH);
  bool isWhole = result == Z_STREAM_END && stream.avail_out == 0;
  ::inflateEnd(&stream);
  if (!isWhole) refuse(path, "a deflated member of the archive is damaged");
  return bytes;
}

class ZipStore : public Store {
 public:
  explicit ZipStore(const Path& path) : mFile(std::make_shared<FileBytes>(path)) {
    readDirectory();
    findRoot();
  }
  Path pathOf(const std::string& key) const override { return key.empty() ? mFile->path() : mFile->path() / key; }
  std::unique_ptr<Blob> open(const std::string& key) const override;

 private:
  [[noreturn]] void refuseIt(std::string_view why) const { refuse(mFile->path(), why); }
  void readDirectory();
  void addMember(std::string_view entry, std::string_view name, std::string_view extra);
  void findRoot();

  std::shared_ptr<const FileBytes> mFile;
  std::unordered_map<std::string, Member> mMembers;
  std::string mRoot;  ///< before each key: a folder with its slash, or nothing
};

void ZipStore::readDirectory() {
  constexpr std::uint64_t kEnd = 22, kMostComment = 65535, kEnd64 = 56, kLocator = 20;
  std::uint64_t tailSize = std::min(mFile->size(), kEnd + kMostComment + kLocator);
  std::uint64_t tailAt = mFile->size() - tailSize;
  std::string tail = readText(*mFile, tailAt, tailSize);
  std::size_t end = tail.rfind("PK\x05\x06");
  if (end == tail.npos || end + kEnd > tail.size()) refuseIt("is no ZIP archive, or one that is cut short");
  std::uint64_t count = numberAt<std::uint16_t>(tail, end + 10), size = numberAt<std::uint32_t>(tail, end + 12),
                at = numberAt<std::uint32_t>(tail, end + 16);
  if (end >= kLocator && tail.compare(end - kLocator, 4, "PK\x06\x07") == 0) {
    std::uint64_t end64 = numberAt<std::uint64_t>(tail, end - kLocator + 8);
    if (end64 > mFile->size() || mFile->size() - end64 < kEnd64) refuseIt("the ZIP archive's directory is damaged");
    std::string record = readText(*mFile, end64, kEnd64);
    if (!record.starts_with("PK\x06\x06")) refuseIt("the ZIP archive's directory is damaged");
    count = numberAt<std::uint64_t>(record, 32);
    size = numberAt<std::uint64_t>(record, 40);
    at = numberAt<std::uint64_t>(record, 48);
  }
  if (at > mFile->size() || size > mFile->size() - at || size > kMostDirectory)
    refuseIt("the ZIP archive's directory is damaged");
  std::string directory = readText(*mFile, at, size);
  std::string_view left = directory;
  constexpr std::size_t kEntry = 46;
  for (; count > 0; --count) {
    if (left.size() < kEntry || !left.starts_with("PK\x01\x02")) refuseIt("the ZIP archive's directory is damaged");
    std::size_t name = numberAt<std::uint16_t>(left, 28), extra = numberAt<std::uint16_t>(left, 30),
                comment = numberAt<std::uint16_t>(left, 32);
    if (left.size() < kEntry + name + extra + comment) refuseIt("the ZIP archive's directory is damaged");
    addMember(left.substr(0, kEntry), left.substr(kEntry, name), left.substr(kEntry + name, extra));
    left.remove_prefix(kEntry + name + extra + comment);
  }
}

void ZipStore::addMember(std::string_view entry, std::string_view name, std::string_view extra) {
  if (name.ends_with('/')) return;
  int method = numberAt<std::uint16_t>(entry, 10);
  if (numberAt<std::uint16_t>(entry, 8) & 1) refuseIt("the ZIP archive is encrypted");
  if (method != 0 && method != 8)
    refuseIt(fmt::format("the ZIP archive packs {} by method {}; members may be stored or deflated", inQuotes(name),
                         method));
  Member member{numberAt<std::uint32_t>(entry, 42), numberAt<std::uint32_t>(entry, 20),
                numberAt<std::uint32_t>(entry, 24), method == 8};
  while (extra.size() >= 4) {
    std::size_t id = numberAt<std::uint16_t>(extra, 0), size = numberAt<std::uint16_t>(extra, 2);
    if (extra.size() < 4 + size) break;
    std::string_view wide = extra.substr(4, size);
    extra.remove_prefix(4 + size);
    if (id != 1) continue;
    for (std::uint64_t* number : {&member.size, &member.packed, &member.header}) {
      if (*number != 0xffffffffu || wide.size() < 8) continue;
      *number = numberAt<std::uint64_t>(wide, 0);
      wide.remove_prefix(8);
    }
  }
  if (!member.isDeflated && member.packed != member.size) refuseIt("the ZIP archive's directory is damaged");
  mMembers[std::string(name)] = member;
}

void ZipStore::findRoot() {
  constexpr std::string_view kMetadata[] = {"zarr.json", ".zgroup", ".zattrs", ".zarray"};
  for (std::string_view name : kMetadata)
    if (mMembers.contains(std::string(name))) return;
  std::string root;
  for (const auto& [name, member] : mMembers) {
    std::string folder = name.substr(0, name.find('/') + 1);
    if (folder.empty() || (!root.empty() && folder != root)) return;
    root = folder;
  }
  mRoot = root;
}

std::unique_ptr<Blob> ZipStore::open(const std::string& key) const {
  auto found = mMembers.find(mRoot + key);
  if (found == mMembers.end()) return nullptr;
  const Member& member = found->second;
  constexpr std::uint64_t kLocal = 30;
  if (member.header > mFile->size() || mFile->size() - member.header < kLocal)
    refuse(pathOf(key), "its place in the ZIP archive lies beyond the end");
  std::string local = readText(*mFile, member.header, kLocal);
  std::uint64_t at = member.header + kLocal + numberAt<std::uint16_t>(local, 26) + numberAt<std::uint16_t>(local, 28);
  if (!local.starts_with("PK\x03\x04") || at > mFile->size() || member.packed > mFile->size() - at)
    refuse(pathOf(key), "its place in the ZIP archive is damaged");
  auto stored = std::make_unique<StoredBlob>(mFile, at, member.packed);
  if (!member.isDeflated) return stored;
  Bytes packed = bytesOf(*stored, pathOf(key), kMostInflated);
  return std::make_unique<InflatedBlob>(pathOf(key), inflateMember(pathOf(key), packed, member.size));
}

}  // namespace

std::unique_ptr<Store> openZipStore(const Path& path) { return std::make_unique<ZipStore>(path); }

}  // namespace velum::io
