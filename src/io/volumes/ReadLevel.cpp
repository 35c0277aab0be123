#include "io/volumes/ReadLevel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "core/BrickCache.h"
#include "core/Memory.h"
#include "io/read/Refuse.h"

namespace velum::io {

namespace {

constexpr double kGb = 1e9;
constexpr double kWholeBytes = 512e6;   ///< volumes up to here are read whole
constexpr double kCoarseVoxels = 16e6;  ///< of the level that is in memory of those that are streamed
constexpr double kCacheShare = 0.125;   ///< of the machine's memory, that bricks may take

/// "1000 x 1000 x 500"
std::string sizeOf(const VoxelLevel& level) {
  return fmt::format("{} x {} x {}", level.dims.x, level.dims.y, level.dims.z);
}

}  // namespace

LevelPlan planLevel(const VoxelSource& of, const scene::Source& source) {
  double machine = machineBytes(), whole = kWholeBytes;
  if (const char* megabytes = std::getenv("VELUM_WHOLE_MB")) whole = std::atof(megabytes) * 1e6;
  int count = int(of.levels().size()), level = std::max(source.level, 0);
  if (source.level >= count)
    refuse(source.path, fmt::format("there is no level {}; they are 0 to {}", source.level, count - 1));
  bool isStreamed = source.level < 0 && count > 1 && levelBytes(of, 0) > std::min(whole, machine / 8);
  auto voxelsOf = [&](int i) {
    glm::dvec3 dims = of.levels()[std::size_t(i)].dims;
    return dims.x * dims.y * dims.z;
  };
  if (isStreamed)
    while (level + 1 < count && voxelsOf(level) > std::min(kCoarseVoxels, 0.5 * voxelsOf(0))) ++level;
  double most = source.level >= 0 ? machine / 2 : machine / 8, bytes = levelBytes(of, level);
  if (bytes > most)
    refuse(source.path,
           fmt::format("its level {} has {:.1f} GB of voxels, and {:.1f} GB, {} of the memory, are the most "
                       "that is read whole; velum-batch convert makes a store with coarser levels of it",
                       level, bytes / kGb, most / kGb, source.level >= 0 ? "a half" : "an eighth"));
  return {level, isStreamed};
}

Volume readFitting(std::unique_ptr<VoxelSource> pyramid, const scene::Source& source, bool isAlignedByBorders,
                   Progress& progress) {
  auto [level, isStreamed] = planLevel(*pyramid, source);
  Volume volume = readLevel(*pyramid, level, progress);
  if (level == 0) return volume;
  const auto& levels = pyramid->levels();
  std::string which =
      fmt::format("level {} of 0 to {}, {} voxels", level, levels.size() - 1, sizeOf(levels[std::size_t(level)]));
  if (isStreamed)
    volume.warnings.push_back(fmt::format(
        "streamed: pictures and sections show up to {} voxels; what works on all voxels at once works on {}",
        sizeOf(levels.front()), which));
  else
    volume.warnings.push_back(fmt::format("{}, were read; the finest has {}", which, sizeOf(levels.front())));
  if (isAlignedByBorders)
    volume.warnings.push_back(
        "the file does not say where its coarser levels lie; they were taken as means of blocks, border on border");
  if (!isStreamed) return volume;
  auto bricks = std::make_shared<BrickCache>(std::move(pyramid), std::size_t(machineBytes() * kCacheShare));
  volume.finer = std::make_shared<FinerLevels>(FinerLevels{std::move(bricks), level});
  return volume;
}

}  // namespace velum::io
