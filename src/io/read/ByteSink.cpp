#include "io/read/ByteSink.h"

#include <zlib.h>

#include <algorithm>
#include <vector>

#include "io/read/Refuse.h"

namespace velum::io {

namespace {
/// Level 4 deflates a CT three times as fast as the default 6 and is 2 % larger.
constexpr int kLevel = 4;
constexpr std::size_t kPiece = 1 << 18;
}  // namespace

struct ByteSink::State {
  ReplaceFile& file;
  bool deflated = false;
  z_stream stream{};
  std::vector<std::byte> output;

  void deflateAll(std::span<const std::byte> bytes, int flush) {
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(bytes.data()));
    stream.avail_in = uInt(bytes.size());
    do {
      stream.next_out = reinterpret_cast<Bytef*>(output.data());
      stream.avail_out = uInt(output.size());
      deflate(&stream, flush);
      file.write(std::span<const std::byte>(output).first(output.size() - stream.avail_out));
    } while (stream.avail_out == 0);
  }
};

ByteSink::ByteSink(ReplaceFile& file) : mState(new State{.file = file}) {}

ByteSink::~ByteSink() {
  if (mState->deflated) deflateEnd(&mState->stream);
}

void ByteSink::startGzip() {
  mState->output.resize(kPiece);
  if (deflateInit2(&mState->stream, kLevel, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    refuse(mState->file.target(), "cannot be deflated");
  mState->deflated = true;
}

void ByteSink::write(std::span<const std::byte> bytes) {
  if (!mState->deflated) return mState->file.write(bytes);
  for (std::size_t at = 0; at < bytes.size(); at += kPiece)
    mState->deflateAll(bytes.subspan(at, std::min(kPiece, bytes.size() - at)), Z_NO_FLUSH);
}

void ByteSink::write(std::string_view text) { write(std::as_bytes(std::span(text))); }

void ByteSink::finish() {
  if (mState->deflated) mState->deflateAll({}, Z_FINISH);
}

}  // namespace velum::io
