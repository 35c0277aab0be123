#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/Volume.h"
#include "io/read/FileBytes.h"

namespace velum::io {

constexpr std::uint64_t kSegyTraceHeader = 240;

/// The fields of a header, named by byte numbers as in the SEG's standard (from 1; in the binary header from 3201).
class SegyFields {
 public:
  SegyFields(std::span<const std::byte> bytes, std::size_t firstNumber, bool isLittle)
      : mBytes(bytes), mFirst(firstNumber), mIsLittle(isLittle) {}
  std::uint64_t eight(std::size_t number) const { return raw(number, 8); }
  std::int32_t four(std::size_t number) const { return std::int32_t(raw(number, 4)); }
  std::int16_t two(std::size_t number) const { return std::int16_t(raw(number, 2)); }
  std::uint16_t unsignedTwo(std::size_t number) const { return std::uint16_t(raw(number, 2)); }
  std::uint8_t one(std::size_t number) const { return std::uint8_t(raw(number, 1)); }

 private:
  std::uint64_t raw(std::size_t number, std::size_t size) const {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
      value |= std::uint64_t(mBytes[number - mFirst + i]) << (8 * (mIsLittle ? i : size - 1 - i));
    return value;
  }
  std::span<const std::byte> mBytes;
  std::size_t mFirst;
  bool mIsLittle;
};

/// The layout common to all traces of a file.
struct SegyLayout {
  bool isLittle = false;
  bool isIbm = false;  ///< Samples are IBM's floats.
  int samples = 0;
  double interval = 0;  ///< Microseconds, or millimetres of depth.
  int sorting = 0;      ///< Trace sorting code: 4 stacked, 5 and 6 gathers of a source or a receiver.
  bool isFeet = false;
  bool isOneLength = false;  ///< The file promises that all traces have the same length.
  SampleType type = SampleType::Float32;
  std::uint64_t firstTrace = 0, headerBytes = kSegyTraceHeader, traceBytes = 0, traces = 0;
  bool hasRest = false;  ///< There are bytes behind the last whole trace.
  std::vector<std::string> warnings;
};

/// @throw InputError when the headers are not those of SEG-Y, or of a kind that we do not read
SegyLayout findSegyLayout(const FileBytes& file, const std::filesystem::path& path);

}  // namespace velum::io
