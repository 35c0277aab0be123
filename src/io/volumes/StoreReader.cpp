#include <fmt/format.h>

#include "core/BrickCache.h"
#include "core/Memory.h"
#include "io/stores/OpenStore.h"
#include "io/stores/WriteStore.h"
#include "io/volumes/Readers.h"

namespace velum::io {

namespace {

constexpr double kCacheShare = 0.125;   ///< of the memory, that bricks may take
constexpr double kWholeBytes = 512e6;   ///< volumes up to here are read whole
constexpr double kCoarseVoxels = 16e6;  ///< of the level that is in memory besides

/// The level that is kept in memory of an image that is streamed; 0 where it is read whole.
int streamedLevel(const VoxelSource& source) {
  double most = kWholeBytes;
  if (const char* text = std::getenv("VELUM_WHOLE_MB")) most = std::atof(text) * 1e6;
  if (levelBytes(source, 0) <= most) return 0;
  int level = 0, last = int(source.levels().size()) - 1;
  auto voxels = [&](int of) {
    glm::dvec3 dims = source.levels()[std::size_t(of)].dims;
    return dims.x * dims.y * dims.z;
  };
  while (level < last && voxels(level) > std::min(kCoarseVoxels, 0.25 * voxels(0))) ++level;
  return level;
}

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
  int coarse = source.level < 0 ? streamedLevel(*image) : level;
  if (coarse > level) level = coarse;
  Volume volume = readLevel(*image, level, progress);
  sayLevel(volume, *image, source, level);
  if (coarse == level && source.level < 0 && level > 0) {
    std::shared_ptr<const VoxelSource> finest = std::move(image);
    auto most = std::size_t(machineBytes() * kCacheShare);
    volume.finer =
        std::make_shared<FinerLevels>(FinerLevels{std::make_shared<BrickCache>(std::move(finest), most), level});
  }
  return volume;
}

std::vector<std::string> writeZarr(const Volume& volume, const Path& path, Progress& progress) {
  return writeStore(VolumeSource(volume), path, {}, progress);
}

}  // namespace velum::io
