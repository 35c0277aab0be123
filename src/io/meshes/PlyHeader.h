#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/read/Refuse.h"

namespace velum::io {

enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };
std::size_t sizeOf(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;
  std::optional<PlyType> countType;  ///< For lists: type of the number of items, which stands before the items.
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  bool isText = false, isBigEndian = false;
  std::vector<PlyElement> elements;
  std::size_t bodyAt = 0;  ///< Offset of the first byte behind the header.
};

/// Reads a header with lines that end in any of the usual ways; blank ones are passed over.
/// @throw InputError naming the line that is not understood
PlyHeader parsePlyHeader(std::string_view file, const Path& path);

}  // namespace velum::io
