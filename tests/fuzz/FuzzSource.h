#pragma once
#include <memory>

#include "FuzzReader.h"
#include "core/VoxelSource.h"
#include "io/volumes/OpenSource.h"

namespace velum::io {

/// Opens a file as a source and reads those of its levels that are small.
inline int fuzzSource(FuzzFile& file, const std::uint8_t* data, std::size_t size) {
  constexpr double kSmall = 1 << 20;
  file.hold(data, size);
  Progress progress;
  scene::Source from;
  from.path = file.path().string();
  try {
    auto source = openSource(from);
    for (int level = 0; source && level < int(source->levels().size()); ++level) {
      if (levelBytes(*source, level) > kSmall) continue;
      Volume volume = readLevel(*source, level, progress);
      expectSound(volume);
    }
  } catch (const Error& error) {
    expectOneLine(error);
  }
  return 0;
}

}  // namespace velum::io
