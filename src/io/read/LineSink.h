#pragma once
#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>

#include "core/ReplaceFile.h"

namespace velum::io {

/// Collects text and writes it to a file in pieces of kPiece characters, not a line at a time. finish() must be called
/// at the end.
class LineSink {
 public:
  explicit LineSink(ReplaceFile& file) : mFile(file) {}

  template <class... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(mText), format, std::forward<Values>(values)...);
    if (mText.size() > kPiece) finish();
  }
  void finish() {
    mFile.write(std::string_view(mText.data(), mText.size()));
    mText.clear();
  }

 private:
  static constexpr std::size_t kPiece = 1 << 18;
  ReplaceFile& mFile;
  fmt::memory_buffer mText;
};

}  // namespace velum::io
