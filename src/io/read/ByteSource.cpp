#include "io/read/ByteSource.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <vector>

#include "core/Error.h"
#include "io/read/FileBytes.h"

namespace velum::io {

namespace {

constexpr std::size_t kReadPiece = 1 << 20;
/// Longest tail behind the samples that is read to reach the checksum.
constexpr std::uint64_t kLongestTail = 64 << 20;

}  // namespace

struct ByteSource::State {
  FileBytes file;
  std::uint64_t offset;  ///< of the file's next byte
  bool deflated;
  bool atStreamEnd = false;
  z_stream stream{};
  std::vector<std::byte> input;

  bool refill() {
    std::size_t got = file.readSome(offset, input);
    offset += got;
    stream.next_in = reinterpret_cast<Bytef*>(input.data());
    stream.avail_in = uInt(got);
    return got > 0;
  }
  std::size_t inflateInto(std::span<std::byte> to);
};

ByteSource::ByteSource(const Path& file) : ByteSource(file, 0, isGzip(file)) {}

ByteSource::ByteSource(const Path& file, std::uint64_t offset, bool deflated)
    : mState(new State{.file = FileBytes(file), .offset = offset, .deflated = deflated}) {
  if (!deflated) return;
  mState->input.resize(kReadPiece / 4);
  // 15 + 32: the largest window, gzip and zlib frames both known by their first bytes.
  if (inflateInit2(&mState->stream, 15 + 32) != Z_OK) refuse(file, "cannot be inflated");
}

ByteSource::~ByteSource() {
  if (mState->deflated) inflateEnd(&mState->stream);
}

std::size_t ByteSource::State::inflateInto(std::span<std::byte> to) {
  std::size_t done = 0;
  while (done < to.size()) {
    if (stream.avail_in == 0 && !refill()) {
      if (atStreamEnd) break;
      refuse(file.path(), "the compressed data is cut off");
    }
    if (atStreamEnd) {
      // More members may follow, as pigz and bgzip write them; anything else behind the stream is padding.
      if (stream.next_in[0] != 0x1f) break;
      inflateReset(&stream);
      atStreamEnd = false;
    }
    uInt room = uInt(std::min<std::size_t>(to.size() - done, 1u << 30));
    stream.next_out = reinterpret_cast<Bytef*>(to.data() + done);
    stream.avail_out = room;
    int result = inflate(&stream, Z_NO_FLUSH);
    done += room - stream.avail_out;
    if (result == Z_STREAM_END) {
      atStreamEnd = true;
    } else if (result != Z_OK && result != Z_BUF_ERROR) {
      refuse(file.path(), fmt::format("the compressed data is damaged ({})", stream.msg ? stream.msg : "zlib"));
    }
  }
  return done;
}

std::size_t ByteSource::readSome(std::span<std::byte> to) {
  if (mState->deflated) return mState->inflateInto(to);
  std::size_t got = mState->file.readSome(mState->offset, to);
  mState->offset += got;
  return got;
}

void ByteSource::read(std::span<std::byte> to) {
  if (readSome(to) != to.size()) refuse(mState->file.path(), "the file is cut short");
}

std::uint64_t ByteSource::skip(std::uint64_t count) {
  std::vector<std::byte> scratch(std::min<std::uint64_t>(count, kReadPiece));
  std::uint64_t done = 0;
  while (done < count) {
    std::size_t now = readSome(std::span(scratch).first(std::min<std::uint64_t>(count - done, scratch.size())));
    if (now == 0) break;
    done += now;
  }
  return done;
}

void ByteSource::verifyEnd() {
  if (!mState->deflated) return;
  std::vector<std::byte> scratch(kReadPiece / 4);
  for (std::uint64_t tail = 0; tail < kLongestTail;) {
    std::size_t now = mState->inflateInto(scratch);
    if (now < scratch.size()) return;
    tail += now;
  }
}

std::uint64_t ByteSource::mostBytes() const { return mState->file.size() * (mState->deflated ? kDeflateRatio : 1); }

bool isGzip(const Path& file) { return FileBytes(file).head(2) == "\x1f\x8b"; }

std::string readHead(const Path& file, std::size_t count) {
  ByteSource source(file);
  std::string head;
  try {
    // In small steps, so that what comes before a damaged place is still seen.
    std::array<std::byte, 4096> piece;
    while (head.size() < count) {
      std::size_t now = source.readSome(std::span(piece).first(std::min(piece.size(), count - head.size())));
      head.append(reinterpret_cast<const char*>(piece.data()), now);
      if (now < piece.size()) break;
    }
  } catch (const InputError&) {
  }
  return head;
}

}  // namespace velum::io
