#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace velum::io {

/// A grid may have at most this many cells for each trace in the file, so that odd line numbers cannot make us allocate
/// too much.
constexpr int kMostCellsPerTrace = 4;

/// The place of a trace, as its header gives it.
struct SegyTrace {
  struct Lines {
    std::int32_t inlineNumber = 0, crosslineNumber = 0;
    auto operator<=>(const Lines&) const = default;
  };
  std::array<Lines, 2> lines;  ///< Bytes 189/193, and 9/21 of older files.
  std::int32_t offset = 0;     ///< Distance from source to receiver; before stacking it differs within a cell.
  glm::dvec2 position{0.0};    ///< CDP X and Y, in the file's unit, scaled.
};

/// The traces on a regular grid.
struct SegyGrid {
  glm::ivec2 size{0};                 ///< Inlines, crosslines.
  std::vector<std::int64_t> traceAt;  ///< [crossline][inline] -> trace, -1: none.
  glm::dvec2 spacing{0.0};            ///< Distance between inlines and between crosslines, file's unit; 0: not known.
  std::vector<std::string> warnings;
};

/// @param sorting  the file's trace sorting code; 0 when the file gives none
/// @throw InputError when the traces do not form a grid, or are unstacked gathers
SegyGrid arrangeTraces(const std::vector<SegyTrace>& traces, int sorting, const std::string& name);

}  // namespace velum::io
