#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace velum::scene {

/// @throw ArgumentError saying that the name is unknown, with the nearest name and all known ones
[[noreturn]] void failNoName(std::string_view what, std::string_view name, const std::vector<std::string>& known);

/// Rows that people know by a name.
/// @tparam Named  the part of a row that others see: a struct with `name`
template <class Row, class Named>
class NamedTable {
 public:
  /// @param what  what a row is, for messages: "finish"
  NamedTable(std::string_view what, std::span<const Row> rows, Named Row::*named)
      : mWhat(what), mRows(rows), mNamed(named) {
    for (const Row& row : rows) mNames.push_back(row.*named);
  }
  std::span<const Row> rows() const { return mRows; }
  std::span<const Named> names() const { return mNames; }
  /// The row with a name; nullptr: there is none.
  const Row* find(std::string_view name) const {
    for (const Row& row : mRows)
      if ((row.*mNamed).name == name) return &row;
    return nullptr;
  }
  /// @throw ArgumentError for an unknown name, listing the known ones
  const Row& at(std::string_view name) const {
    if (const Row* row = find(name)) return *row;
    std::vector<std::string> known;
    for (const Named& named : mNames) known.emplace_back(named.name);
    failNoName(mWhat, name, known);
  }

 private:
  std::string_view mWhat;
  std::span<const Row> mRows;
  Named Row::*mNamed;
  std::vector<Named> mNames;
};

}  // namespace velum::scene
