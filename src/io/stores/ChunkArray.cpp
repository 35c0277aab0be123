#include "io/stores/ChunkArray.h"

#include <fmt/format.h>

#include <limits>

#include "io/stores/Codecs.h"

namespace velum::io {

void checkSizes(const ChunkArray& array) {
  std::uint64_t bytes = std::uint64_t(array.type.bytes);
  for (std::size_t axis = 0; axis < array.size.size(); ++axis) {
    constexpr std::uint64_t kMost = std::uint64_t(std::numeric_limits<int>::max());
    if (array.size[axis] < 1 || array.size[axis] > kMost || array.chunk[axis] < 1)
      refuse(array.path, fmt::format("its size of {} in chunks of {} makes no sense", fmt::join(array.size, " x "),
                                     fmt::join(array.chunk, " x ")));
    if (array.chunk[axis] > kMostChunkBytes / bytes)
      refuse(array.path, fmt::format("its chunks of {} samples are larger than 2 GiB", fmt::join(array.chunk, " x ")));
    bytes *= array.chunk[axis];
  }
}

std::string packingOf(const std::vector<std::string>& names) {
  return names.empty() ? "raw" : fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace velum::io
