#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "io/read/Refuse.h"

namespace velum::io {

/// The largest ratio of inflated to deflated bytes: deflate makes at most 258 bytes of two bits, which is 1032; 8 more
/// allow for the stream's own frame.
constexpr std::uint64_t kDeflateRatio = 1040;

/// True when the file starts with the two bytes of gzip.
bool isGzip(const Path& file);
/// The first bytes of a file, inflated when it is gzip; fewer when it is shorter or damaged.
/// @throw InputError when there is no such file
std::string readHead(const Path& file, std::size_t count);

/// Reads a file from front to back, inflating it when it is deflated.
class ByteSource {
 public:
  /// Reads from the file's first byte; inflates when the file is gzip. @throw InputError
  explicit ByteSource(const Path& file);
  /// @param offset    where to start, in bytes of the file
  /// @param deflated  a gzip or zlib stream starts there
  /// @throw InputError
  ByteSource(const Path& file, std::uint64_t offset, bool deflated);
  ~ByteSource();
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  /// @return how many bytes were read: fewer than asked for only at the end. @throw InputError for a damaged stream
  std::size_t readSome(std::span<std::byte> to);
  /// Fills all of `to`. @throw InputError when the end came first
  void read(std::span<std::byte> to);
  /// Drops bytes. @return how many were dropped: fewer than asked for only at the end
  std::uint64_t skip(std::uint64_t count);
  /// Reads on to the end of a deflated stream, where its checksum stands. @throw InputError when the stream is cut off
  /// or the checksum is wrong
  void verifyEnd();
  /// An upper bound of the bytes that the source can give.
  std::uint64_t mostBytes() const;

 private:
  struct State;
  std::unique_ptr<State> mState;
};

}  // namespace velum::io
