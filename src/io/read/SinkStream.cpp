#include "io/read/SinkStream.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <streambuf>
#include <vector>

namespace velum::io {

/// Keeps what is written in a piece of memory, until it is full or the writer goes elsewhere.
class SinkStream::Buffer : public std::streambuf {
 public:
  explicit Buffer(ReplaceFile& file) : mFile(file), mPiece(kPiece) {
    setp(mPiece.data(), mPiece.data() + mPiece.size());
  }

 protected:
  int_type overflow(int_type c) override {
    if (sync() != 0) return traits_type::eof();
    if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }

  int sync() override {
    auto count = std::size_t(pptr() - pbase());
    bool isWritten = mFile.writeAt(mBegin, std::as_bytes(std::span(pbase(), count)));
    mBegin += count;
    mEnd = std::max(mEnd, mBegin);
    setp(mPiece.data(), mPiece.data() + mPiece.size());
    return isWritten ? 0 : -1;
  }

  pos_type seekoff(off_type by, std::ios_base::seekdir from, std::ios_base::openmode) override {
    auto here = off_type(mBegin) + (pptr() - pbase());
    off_type end = std::max(off_type(mEnd), here);
    off_type to = by + (from == std::ios_base::cur ? here : from == std::ios_base::end ? end : off_type(0));
    if (to == here) return here;
    if (to < 0 || sync() != 0) return pos_type(off_type(-1));
    mBegin = std::uint64_t(to);
    return to;
  }

  pos_type seekpos(pos_type to, std::ios_base::openmode which) override {
    return seekoff(off_type(to), std::ios_base::beg, which);
  }

 private:
  static constexpr std::size_t kPiece = 1 << 18;
  ReplaceFile& mFile;
  std::vector<char> mPiece;
  std::uint64_t mBegin = 0;  ///< Where the piece belongs in the file, in bytes.
  std::uint64_t mEnd = 0;    ///< The largest that was written.
};

SinkStream::SinkStream(ReplaceFile& file) : std::ostream(nullptr), mBuffer(std::make_unique<Buffer>(file)) {
  rdbuf(mBuffer.get());
}

SinkStream::~SinkStream() { mBuffer->pubsync(); }

}  // namespace velum::io
