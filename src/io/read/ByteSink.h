#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include "core/ReplaceFile.h"

namespace velum::io {

/// Writes to a file that replaces another, from some point on as a gzip stream.
class ByteSink {
 public:
  /// The file is borrowed; the caller commits it.
  explicit ByteSink(ReplaceFile& file);
  ~ByteSink();
  ByteSink(const ByteSink&) = delete;
  ByteSink& operator=(const ByteSink&) = delete;

  /// All that is written from here on is deflated.
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
