#include "io/stores/ChunkType.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

namespace velum::io {

namespace {

struct Half {
  std::uint16_t bits;
};

float valueOf(Half half) {
  std::uint32_t sign = std::uint32_t(half.bits & 0x8000u) << 16, exponent = (half.bits >> 10) & 31u,
                mantissa = half.bits & 1023u;
  if (exponent == 31) return std::bit_cast<float>(sign | 0x7f800000u | (mantissa << 13));
  if (exponent > 0) return std::bit_cast<float>(sign | ((exponent + 112u) << 23) | (mantissa << 13));
  float small = float(mantissa) * 0x1p-24f;
  return sign ? -small : small;
}

template <class Stored>
Stored take(const std::byte* from, bool isSwapped) {
  std::byte bytes[sizeof(Stored)];
  std::memcpy(bytes, from, sizeof(Stored));
  if (isSwapped) std::reverse(bytes, bytes + sizeof(Stored));
  Stored value;
  std::memcpy(&value, bytes, sizeof(Stored));
  return value;
}

template <class Stored, class Sample, bool isSwapped>
bool convertAll(const std::byte* from, std::ptrdiff_t fromStep, std::byte* to, std::ptrdiff_t toStep, int count) {
  constexpr bool isNarrowed = std::is_integral_v<Stored> && sizeof(Stored) > sizeof(Sample);
  constexpr bool isSame = std::is_same_v<Stored, Sample> && !isSwapped;
  if (isSame && fromStep == sizeof(Stored) && toStep == sizeof(Sample)) {
    std::memcpy(to, from, std::size_t(count) * sizeof(Sample));
    return true;
  }
  bool fits = true;
  for (int i = 0; i < count; ++i) {
    auto stored = take<Stored>(from + i * fromStep, isSwapped);
    Sample sample;
    if constexpr (std::is_same_v<Stored, Half>)
      sample = valueOf(stored);
    else
      sample = Sample(stored);
    if constexpr (isNarrowed) fits = fits && Stored(sample) == stored;
    std::memcpy(to + i * toStep, &sample, sizeof(Sample));
  }
  return fits;
}

/// Calls body with one sample of the stored type and one of the volume's.
template <class Body>
RowConverter visitTypes(ChunkType type, Body&& body) {
  using Kind = ChunkType::Kind;
  if (type.kind == Kind::Float) {
    if (type.bytes == 2) return body(Half{}, float{});
    return type.bytes == 4 ? body(float{}, float{}) : body(double{}, double{});
  }
  bool isSigned = type.kind == Kind::Signed;
  switch (type.bytes) {
    case 1:
      return isSigned ? body(std::int8_t{}, std::int8_t{}) : body(std::uint8_t{}, std::uint8_t{});
    case 2:
      return isSigned ? body(std::int16_t{}, std::int16_t{}) : body(std::uint16_t{}, std::uint16_t{});
    case 4:
      return isSigned ? body(std::int32_t{}, std::int32_t{}) : body(std::uint32_t{}, std::uint32_t{});
    default:
      return isSigned ? body(std::int64_t{}, std::int32_t{}) : body(std::uint64_t{}, std::uint32_t{});
  }
}

}  // namespace

SampleType sampleTypeOf(ChunkType type) {
  if (type.kind == ChunkType::Kind::Float) return type.bytes == 8 ? SampleType::Float64 : SampleType::Float32;
  bool isSigned = type.kind == ChunkType::Kind::Signed;
  if (type.bytes == 1) return isSigned ? SampleType::Int8 : SampleType::UInt8;
  if (type.bytes == 2) return isSigned ? SampleType::Int16 : SampleType::UInt16;
  return isSigned ? SampleType::Int32 : SampleType::UInt32;
}

std::string nameOf(ChunkType type) {
  if (type.kind == ChunkType::Kind::Bool) return "bool";
  constexpr std::string_view kNames[] = {"bool", "uint", "int", "float"};
  return fmt::format("{}{}", kNames[int(type.kind)], 8 * type.bytes);
}

RowConverter rowConverter(ChunkType type) {
  bool isSwapped = type.bytes > 1 && type.isBigEndian != (std::endian::native == std::endian::big);
  return visitTypes(type, [&](auto stored, auto sample) -> RowConverter {
    using Stored = decltype(stored);
    using Sample = decltype(sample);
    return isSwapped ? convertAll<Stored, Sample, true> : convertAll<Stored, Sample, false>;
  });
}

}  // namespace velum::io
