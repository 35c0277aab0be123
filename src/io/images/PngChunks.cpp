#include "io/images/PngChunks.h"

#include <array>
#include <cstdint>
#include <cstring>

namespace velum::io {

bool isSoundPng(const FileBytes& file) {
  constexpr std::uint64_t kSignature = 8, kAround = 12;  // length, name and check sum of a chunk
  for (std::uint64_t at = kSignature; at + kAround <= file.size();) {
    std::array<std::byte, 8> head;
    file.read(at, head);
    std::uint64_t length = 0;
    for (int i = 0; i < 4; ++i) length = length << 8 | std::uint64_t(head[std::size_t(i)]);
    if (length > file.size() - at - kAround) return false;
    if (std::memcmp(head.data() + 4, "IEND", 4) == 0) return true;
    at += kAround + length;
  }
  return false;
}

}  // namespace velum::io
