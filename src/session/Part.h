#pragma once
#include <string_view>

namespace velum::session {

/// The part of a piece of work that a process does, so that several machines do it together: of things in a row, some
/// one after the other, and no part has two more than another.
struct Part {
  int number = 1, parts = 1;  ///< 1 <= number <= parts
  bool operator==(const Part&) const = default;
  int firstOf(int count) const { return int((number - 1ll) * count / parts); }
  int endOf(int count) const { return int(1ll * number * count / parts); }
};

/// Reads "3/16". @throw ArgumentError
Part parsePart(std::string_view text);

}  // namespace velum::session
