#include "io/stores/Crc32c.h"

#include <array>
#include <cstring>

#if defined(__x86_64__)
#include <nmmintrin.h>
#endif

namespace velum::io {

namespace {

constexpr auto kTable = [] {
  constexpr std::uint32_t kPolynomial = 0x82f63b78u;  // 0x1edc6f41, its bits reversed
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ (value & 1 ? kPolynomial : 0);
    table[i] = value;
  }
  return table;
}();

#if defined(__x86_64__)
__attribute__((target("sse4.2"))) std::uint32_t crc32cBySse(std::span<const std::byte> bytes) {
  std::uint64_t value = 0xffffffffu;
  std::size_t at = 0;
  for (; at + 8 <= bytes.size(); at += 8) {
    std::uint64_t eight;
    std::memcpy(&eight, bytes.data() + at, 8);
    value = _mm_crc32_u64(value, eight);
  }
  auto rest = std::uint32_t(value);
  for (; at < bytes.size(); ++at) rest = _mm_crc32_u8(rest, std::to_integer<std::uint8_t>(bytes[at]));
  return ~rest;
}
#endif

}  // namespace

std::uint32_t crc32cByTable(std::span<const std::byte> bytes) {
  std::uint32_t value = 0xffffffffu;
  for (std::byte byte : bytes) value = (value >> 8) ^ kTable[(value ^ std::to_integer<std::uint32_t>(byte)) & 255];
  return ~value;
}

std::uint32_t crc32c(std::span<const std::byte> bytes) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("sse4.2")) return crc32cBySse(bytes);
#endif
  return crc32cByTable(bytes);
}

}  // namespace velum::io
