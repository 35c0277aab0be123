#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include "core/ReplaceFile.h"

namespace velum::io {

/// Writes to a ReplaceFile: plain bytes first, and after startGzip() a gzip stream.
class ByteSink {
 public:
  /// The file is borrowed and must outlive the sink; the caller commits the file.
  explicit ByteSink(ReplaceFile& file);
  ~ByteSink();
  ByteSink(const ByteSink&) = delete;
  ByteSink& operator=(const ByteSink&) = delete;

  /// From now on all bytes written are deflated.
  void startGzip();
  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);
  /// Must be called at the end. @throw InputError when the disk refuses, here and in write()
  void finish();

 private:
  struct State;
  std::unique_ptr<State> mState;
};

}  // namespace velum::io
