#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <string_view>

#include "core/Assert.h"

namespace velum::io {

/// Numbers out of a binary header of either byte order.
struct HeaderFields {
  std::string_view bytes;
  bool swap = false;  ///< The numbers are in the other byte order than the machine's.

  /// @param offset  where the number begins; the whole number must lie in the header
  template <class T>
  T at(std::size_t offset) const {
    VELUM_ASSERT(offset + sizeof(T) <= bytes.size(), "a header has the fields that are asked for");
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes.data() + offset, sizeof(T));
    if (swap) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<T>(raw);
  }
};

}  // namespace velum::io
