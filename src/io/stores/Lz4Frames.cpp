#include "io/stores/Lz4Frames.h"

#include <fmt/format.h>
#include <lz4.h>

#include <algorithm>
#include <limits>

namespace velum::io {

namespace {

/// Takes numbers and pieces from the front of bytes, and unpacks them to the end of others.
class Lz4Walk {
 public:
  Lz4Walk(std::span<const std::byte> from, std::uint64_t most, const Path& path)
      : mLeft(from), mPath(path), mTo(static_cast<std::size_t>(most)) {}

  std::span<const std::byte> take(std::uint64_t count) {
    if (count > mLeft.size()) refuseIt();
    auto piece = mLeft.first(std::size_t(count));
    mLeft = mLeft.subspan(piece.size());
    return piece;
  }
  std::uint64_t number(std::size_t bytes, bool isBigEndian) {
    auto piece = take(bytes);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) value = value << 8 | std::uint64_t(piece[isBigEndian ? i : bytes - 1 - i]);
    return value;
  }
  /// A block that unpacks to so many bytes.
  void unpack(std::span<const std::byte> block, std::uint64_t size) {
    auto to = room(size);
    constexpr std::size_t kMost = std::size_t(std::numeric_limits<int>::max());
    int done = block.size() > kMost
                   ? -1
                   : ::LZ4_decompress_safe(reinterpret_cast<const char*>(block.data()),
                                           reinterpret_cast<char*>(to.data()), int(block.size()), int(size));
    if (done < 0 || std::size_t(done) != size) refuseIt();
  }
  void copy(std::span<const std::byte> block) { std::copy(block.begin(), block.end(), room(block.size()).begin()); }
  std::size_t left() const { return mLeft.size(); }
  std::uint64_t done() const { return mDone; }
  [[noreturn]] void refuseIt() const { refuseDamaged(mPath, "lz4"); }
  Bytes result() {
    mTo.resize(mDone);
    return std::move(mTo);
  }

 private:
  std::span<std::byte> room(std::uint64_t size) {
    if (size > mTo.size() - mDone) refuseIt();
    auto to = std::span(mTo).subspan(mDone, std::size_t(size));
    mDone += to.size();
    return to;
  }
  std::span<const std::byte> mLeft;
  const Path& mPath;
  Bytes mTo;
  std::size_t mDone = 0;
};

}  // namespace

void refuseDamaged(const Path& path, std::string_view codec) {
  refuse(path, fmt::format("its {} bytes are damaged, or unpack to more than the chunk holds", codec));
}

Bytes unpackLz4(std::span<const std::byte> from, std::uint64_t most, const Path& path) {
  Lz4Walk walk(from, most, path);
  std::uint64_t size = walk.number(4, false);
  walk.unpack(walk.take(walk.left()), size);
  return walk.result();
}

Bytes unpackLz4Java(std::span<const std::byte> from, std::uint64_t most, const Path& path) {
  constexpr std::string_view kWord = "LZ4Block";
  constexpr std::uint64_t kStored = 0x10, kPacked = 0x20;  // in the upper half; the lower one is the level
  Lz4Walk walk(from, most, path);
  while (walk.left() > 0) {
    auto word = walk.take(kWord.size());
    if (!std::equal(word.begin(), word.end(), reinterpret_cast<const std::byte*>(kWord.data()))) walk.refuseIt();
    std::uint64_t method = walk.number(1, false) & 0xf0, packed = walk.number(4, false), size = walk.number(4, false);
    walk.number(4, false);
    if (size == 0) break;
    if (method == kStored && packed == size)
      walk.copy(walk.take(packed));
    else if (method == kPacked)
      walk.unpack(walk.take(packed), size);
    else
      walk.refuseIt();
  }
  return walk.result();
}

Bytes unpackLz4Hdf5(std::span<const std::byte> from, std::uint64_t most, const Path& path) {
  Lz4Walk walk(from, most, path);
  std::uint64_t size = walk.number(8, true), block = walk.number(4, true);
  if (size > most || (block == 0 && size > 0)) walk.refuseIt();
  while (walk.done() < size) {
    std::uint64_t whole = std::min(block, size - walk.done()), packed = walk.number(4, true);
    packed == whole ? walk.copy(walk.take(packed)) : walk.unpack(walk.take(packed), whole);
  }
  return walk.result();
}

}  // namespace velum::io
