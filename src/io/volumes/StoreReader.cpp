#include <fmt/format.h>

#include "core/VoxelSource.h"
#include "io/stores/OpenStore.h"
#include "io/stores/WriteStore.h"
#include "io/volumes/Readers.h"

namespace velum::io {

namespace {

/// "1000 x 1000 x 500"
std::string sizeOf(const VoxelLevel& level) {
  return fmt::format("{} x {} x {}", level.dims.x, level.dims.y, level.dims.z);
}

void sayLevel(Volume& volume, const StoreSource& of, const scene::Source& source, int level) {
  int count = int(of.levels().size());
  if (level == 0) return;
  volume.warnings.push_back(fmt::format("level {} of 0 to {} was read, {} voxels; the finest has {}{}", level,
                                        count - 1, sizeOf(of.levels()[std::size_t(level)]), sizeOf(of.levels().front()),
                                        source.level < 0 ? ", which is more than an eighth of the memory holds" : ""));
  if (of.facts().isAlignedByBorders)
    volume.warnings.push_back(
        "the file does not say where its coarser levels lie; they were taken as means of blocks, border on border");
}

}  // namespace

Volume readStore(const scene::Source& source, Progress& progress) {
  progress.report(0.0, "Reading metadata");
  auto image = openImage(source.path, source.series);
  int level = levelToRead(*image, source);
  Volume volume = readLevel(*image, level, progress);
  sayLevel(volume, *image, source, level);
  return volume;
}

std::vector<std::string> writeZarr(const Volume& volume, const Path& path, Progress& progress) {
  return writeStore(VolumeSource(volume), path, {}, progress);
}

}  // namespace velum::io
