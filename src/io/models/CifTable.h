#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace velum::io {

/// A column of a category, as text or as numbers, whichever the file has.
struct CifColumn {
  std::vector<std::int32_t> integers;
  std::vector<double> numbers;
  std::vector<std::string> texts;    ///< Those that there are, once each.
  std::vector<std::int32_t> textOf;  ///< In texts, for each row; -1: none.
  std::vector<std::uint8_t> mask;    ///< Not 0 where the value is unknown or does not apply; empty: all are known.

  std::size_t size() const;
  bool isKnown(std::size_t row) const;
  /// NaN where it is none.
  double number(std::size_t row) const;
  /// Empty where it is unknown.
  std::string text(std::size_t row) const;

  /// A small number for each value, alike for alike ones.
  struct Codes {
    std::vector<std::uint32_t> ofRow;
    std::vector<std::string> names;  ///< Of each code.
  };
  Codes codes() const;
};

/// A category.
struct CifTable {
  std::size_t rows = 0;
  std::map<std::string, CifColumn, std::less<>> columns;  ///< Lower case: "cartn_x". Each has all rows.

  const CifColumn* find(std::string_view name) const;
  /// Empty and NaN where there is no such column.
  std::string text(std::string_view name, std::size_t row) const;
  double number(std::string_view name, std::size_t row) const;
};

struct CifBlock {
  std::string header;
  std::map<std::string, CifTable, std::less<>> tables;  ///< Lower case, without the line before it: "atom_site".

  const CifTable* find(std::string_view name) const;
};

/// Whether the models read this column; others are not kept. @param category, column  lower case
bool isWanted(std::string_view category, std::string_view column);
/// Whether it holds numbers, whatever they look like.
bool isNumeric(std::string_view column);

}  // namespace velum::io
