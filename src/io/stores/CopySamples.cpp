#include "io/stores/CopySamples.h"

#include <fmt/format.h>

#include "io/read/Refuse.h"

namespace velum::io {

bool copySamples(ChunkType type, const std::byte* first, const SampleSteps& steps, const BrickBox& box,
                 const SampleTarget& target) {
  RowConverter convert = rowConverter(type);
  bool fits = true;
  for (int t = 0; t < box.timeSteps; ++t)
    for (int c = 0; c < box.channels; ++c)
      for (int z = 0; z < box.size.z; ++z)
        for (int y = 0; y < box.size.y; ++y)
          fits = convert(first + t * steps.timeStep + c * steps.channel + z * steps.z + y * steps.y, steps.x,
                         target.first + t * target.timeStep + c * target.channel + z * target.z + y * target.y,
                         target.x, box.size.x) &&
                 fits;
  return fits;
}

void refuseWideNumbers(ChunkType type, const std::string& path) {
  refuse(path, fmt::format("holds whole numbers of the type {} that need more than 32 bits, which cannot be held yet",
                           nameOf(type)));
}

}  // namespace velum::io
