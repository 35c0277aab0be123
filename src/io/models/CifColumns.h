#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "io/models/CifTable.h"
#include "io/read/JsonParts.h"

namespace velum::io {

/// Decodes columns of BinaryCIF: undoes a column's encodings from the last to the first.
class CifDecoder {
 public:
  const Path& path;
  const std::string& column;  ///< For messages.
  std::size_t rows;  ///< Rows of the column; no decoding step may give more values than this, or than it was given.

  /// @param data  {data, encoding}  @throw InputError
  CifColumn decodeColumn(const Json& data) const;
  std::vector<std::int32_t> decodeIntegers(const Json& data) const;

 private:
  using Values = std::variant<std::vector<std::int32_t>, std::vector<double>>;

  [[noreturn]] void fail(const std::string& reason) const;
  Values decodeValues(const Json& binary, std::span<const Json> encodings, std::size_t most) const;
  std::vector<std::int32_t> decodeIntegers(const Json& binary, const Json& encodings, std::size_t most) const;
  CifColumn decodeTexts(const Json& binary, const Json& encoding) const;
  Values undo(const Json& encoding, Values values, std::size_t most) const;
  std::vector<std::int32_t> unpack(const Json& encoding, const std::vector<std::int32_t>& packed) const;
  std::vector<std::int32_t> repeat(const std::vector<std::int32_t>& pairs, std::size_t most) const;
  std::vector<std::int32_t> sumUp(const Json& encoding, std::vector<std::int32_t> deltas) const;
  Values bytesAs(const Json& encoding, std::span<const std::uint8_t> bytes) const;
};

}  // namespace velum::io
