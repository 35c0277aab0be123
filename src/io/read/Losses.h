#pragma once
#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace velum::io {

/// The list of what a writer could not keep, one line each, for people.
class Losses {
 public:
  /// Adds a line, but only when `isLost` is true.
  template <class... Values>
  void say(bool isLost, fmt::format_string<Values...> text, Values&&... values) {
    if (isLost) mLines.push_back(fmt::format(text, std::forward<Values>(values)...));
  }
  std::vector<std::string> take() { return std::move(mLines); }

 private:
  std::vector<std::string> mLines;
};

}  // namespace velum::io
