#include "io/read/SampleBytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

namespace velum::io {

std::size_t checkedBytes(const Path& path, glm::dvec3 dims, double channels, double frames, std::size_t sampleBytes,
                         double mostBytes) {
  constexpr double kMost = 1u << 30;
  for (double d : {dims.x, dims.y, dims.z, channels, frames})
    if (!(d >= 1 && d <= kMost))
      refuse(path, fmt::format(
                       "a volume of {:.0f} x {:.0f} x {:.0f} voxels, {:.0f} channels and {:.0f} frames makes no sense",
                       dims.x, dims.y, dims.z, channels, frames));
  // Five factors of 2^30 fit a double, and products of interest (below 2^53) are exact.
  double bytes = dims.x * dims.y * dims.z * channels * frames * double(sampleBytes);
  mostBytes = std::min(mostBytes, 1e13);
  if (bytes > mostBytes)
    refuse(path, fmt::format("the header promises {:.0f} bytes of voxels, but the file can hold {:.0f} at most", bytes,
                             mostBytes));
  return std::size_t(bytes);
}

void swapBytes(std::span<std::byte> bytes, std::size_t sampleBytes) {
  auto swapAll = [&](auto one, auto swap) {
    for (std::size_t at = 0; at + sizeof(one) <= bytes.size(); at += sizeof(one)) {
      std::memcpy(&one, bytes.data() + at, sizeof(one));
      one = swap(one);
      std::memcpy(bytes.data() + at, &one, sizeof(one));
    }
  };
  if (sampleBytes == 2) swapAll(std::uint16_t{}, [](std::uint16_t v) { return __builtin_bswap16(v); });
  if (sampleBytes == 4) swapAll(std::uint32_t{}, [](std::uint32_t v) { return __builtin_bswap32(v); });
  if (sampleBytes == 8) swapAll(std::uint64_t{}, [](std::uint64_t v) { return __builtin_bswap64(v); });
}

void toMachineOrder(std::span<std::byte> bytes, std::size_t sampleBytes, bool isBigEndian) {
  if (isBigEndian != (std::endian::native == std::endian::big)) swapBytes(bytes, sampleBytes);
}

}  // namespace velum::io
