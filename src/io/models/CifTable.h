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
  std::vector<std::string> texts;    ///< Each distinct text, once.
  std::vector<std::int32_t> textOf;  ///< For each row, the index of its text in `texts`; -1: none.
  std::vector<std::uint8_t> mask;    ///< Not 0 where the value is unknown or does not apply; empty: all are known.

  std::size_t size() const;
  bool isKnown(std::size_t row) const;
  /// The value of a row; NaN where it is not a number.
  double number(std::size_t row) const;
  /// The text of a row; empty where it is unknown.
  std::string text(std::size_t row) const;

  /// A small number, the code, for each value; equal values have equal codes.
  struct Codes {
    std::vector<std::uint32_t> ofRow;
    std::vector<std::string> names;  ///< The value of each code, as text.
  };
  Codes codes() const;
};

/// A category.
struct CifTable {
  std::size_t rows = 0;
  std::map<std::string, CifColumn, std::less<>> columns;  ///< By lower-case name: "cartn_x". Each column has all rows.

  const CifColumn* find(std::string_view name) const;
  /// The value of a column in a row; empty, or NaN, where there is no such column.
  std::string text(std::string_view name, std::size_t row) const;
  double number(std::string_view name, std::size_t row) const;
};

struct CifBlock {
  std::string header;
  /// By lower-case name without the underscore before it: "atom_site".
  std::map<std::string, CifTable, std::less<>> tables;

  const CifTable* find(std::string_view name) const;
};

/// Whether the readers of models use this column; other columns are not kept. @param category, column  lower case
bool isWanted(std::string_view category, std::string_view column);
/// Whether a column is to be read as numbers, whatever its values look like.
bool isNumeric(std::string_view column);

}  // namespace velum::io
