#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace velum::io {

/// The largest id of a LabelVolume. Files may have larger ones, which become others here (LabelInfo::fileId).
inline constexpr std::uint64_t kLargestLabel = 65535;

/// What a structure is called that has no name, by its id in the file.
inline std::string segmentName(std::uint64_t fileId) { return fmt::format("segment {}", fileId); }

}  // namespace velum::io
