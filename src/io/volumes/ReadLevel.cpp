#include "io/volumes/ReadLevel.h"

#include <fmt/format.h>
#include <unistd.h>

#include "io/read/Refuse.h"

namespace velum::io {

namespace {

constexpr double kGb = 1e9;

/// Bytes of the machine's memory.
double machineBytes() { return double(::sysconf(_SC_PHYS_PAGES)) * double(::sysconf(_SC_PAGESIZE)); }

/// "1000 x 1000 x 500"
std::string sizeOf(const VoxelLevel& level) {
  return fmt::format("{} x {} x {}", level.dims.x, level.dims.y, level.dims.z);
}

}  // namespace

int levelToRead(const VoxelSource& of, const scene::Source& source) {
  double machine = machineBytes();
  int count = int(of.levels().size());
  if (source.level >= count)
    refuse(source.path, fmt::format("there is no level {}; they are 0 to {}", source.level, count - 1));
  int level = source.level >= 0 ? source.level : levelWithin(of, machine / 8).value_or(count - 1);
  double most = source.level >= 0 ? machine / 2 : machine / 8, bytes = levelBytes(of, level);
  if (bytes > most)
    refuse(
        source.path,
        fmt::format("its level {} has {:.1f} GB of voxels, and {:.1f} GB, {} of the memory, are the most that is read",
                    level, bytes / kGb, most / kGb, source.level >= 0 ? "a half" : "an eighth"));
  return level;
}

Volume readFitting(std::unique_ptr<VoxelSource> pyramid, const scene::Source& source, bool isAlignedByBorders,
                   Progress& progress) {
  int level = levelToRead(*pyramid, source);
  Volume volume = readLevel(*pyramid, level, progress);
  if (level == 0) return volume;
  const auto& levels = pyramid->levels();
  volume.warnings.push_back(fmt::format("level {} of 0 to {} was read, {} voxels; the finest has {}{}", level,
                                        levels.size() - 1, sizeOf(levels[std::size_t(level)]), sizeOf(levels.front()),
                                        source.level < 0 ? ", which is more than an eighth of the memory holds" : ""));
  if (isAlignedByBorders)
    volume.warnings.push_back(
        "the file does not say where its coarser levels lie; they were taken as means of blocks, border on border");
  return volume;
}

}  // namespace velum::io
