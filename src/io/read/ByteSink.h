#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

namespace velum::io {

/// Writes a file from front to back, from some point on as a gzip stream.
class ByteSink {
 public:
  /// @throw InputError when the file cannot be made
  explicit ByteSink(const std::filesystem::path& file);
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
