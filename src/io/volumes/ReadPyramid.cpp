#include "io/volumes/ReadPyramid.h"

#include <fmt/format.h>

#include "io/stores/OpenStore.h"

namespace velum::io {

namespace {

/// "1000 x 1000 x 500"
std::string sizeOf(const VoxelLevel& level) {
  return fmt::format("{} x {} x {}", level.dims.x, level.dims.y, level.dims.z);
}

}  // namespace

Volume readPyramid(const VoxelSource& of, const scene::Source& source, bool isAlignedByBorders, Progress& progress) {
  int level = levelToRead(of, source);
  Volume volume = readLevel(of, level, progress);
  if (level == 0) return volume;
  const auto& levels = of.levels();
  volume.warnings.push_back(fmt::format("level {} of 0 to {} was read, {} voxels; the finest has {}{}", level,
                                        levels.size() - 1, sizeOf(levels[std::size_t(level)]), sizeOf(levels.front()),
                                        source.level < 0 ? ", which is more than an eighth of the memory holds" : ""));
  if (isAlignedByBorders)
    volume.warnings.push_back(
        "the file does not say where its coarser levels lie; they were taken as means of blocks, border on border");
  return volume;
}

}  // namespace velum::io
