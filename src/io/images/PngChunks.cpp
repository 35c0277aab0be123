#include "io/images/PngChunks.h"

#include <zlib.h>

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

void addPngText(std::vector<unsigned char>& png, std::string_view keyword, std::string_view text) {
  constexpr std::ptrdiff_t kBehindHeader = 8 + 25;  // the signature and the chunk IHDR
  std::vector<unsigned char> chunk(4);
  auto put = [&](std::string_view bytes) { chunk.insert(chunk.end(), bytes.begin(), bytes.end()); };
  auto number = [](std::uint32_t value, unsigned char* at) {
    for (int i = 0; i < 4; ++i) at[i] = static_cast<unsigned char>(value >> (24 - 8 * i));
  };
  put("tEXt");
  put(keyword);
  chunk.push_back(0);
  put(text);
  number(std::uint32_t(chunk.size() - 8), chunk.data());
  auto sum = crc32_z(0, chunk.data() + 4, chunk.size() - 4);
  chunk.resize(chunk.size() + 4);
  number(std::uint32_t(sum), chunk.data() + chunk.size() - 4);
  png.insert(png.begin() + kBehindHeader, chunk.begin(), chunk.end());
}

}  // namespace velum::io
