#include "io/volumes/ReadLevel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <unordered_map>

#include "core/BrickCache.h"
#include "core/Error.h"
#include "core/Memory.h"
#include "io/read/Refuse.h"
#include "io/stores/OpenStore.h"
#include "io/volumes/FormatTable.h"
#include "io/volumes/OpenSource.h"

namespace velum::io {

namespace {

constexpr double kGb = 1e9;
constexpr double kCoarseVoxels = 16e6;  ///< of the level that is in memory of those that are streamed

/// "1000 x 1000 x 500"
std::string sizeOf(const VoxelLevel& level) {
  return fmt::format("{} x {} x {}", level.dims.x, level.dims.y, level.dims.z);
}

/// Where a volume has its largest and smallest values, one brick of the finest level each: of the first time step.
std::vector<BrickAddress> extremeBricks(const Volume& volume, int channel) {
  constexpr std::size_t kOfEach = 6;
  const VoxelLevel& finest = volume.finer->bricks->source().levels().front();
  glm::dmat4 finestFromVoxel = glm::inverse(worldFromLevel(volume, 0)) * volume.worldFromVoxel;
  glm::ivec3 grid = bricksOf(finest);
  std::unordered_map<std::size_t, glm::dvec2> ranges;  // by brick
  visitSamples(volume, [&](auto* samples) {
    std::size_t i = 0;
    for (int z = 0; z < volume.dims.z; ++z)
      for (int y = 0; y < volume.dims.y; ++y)
        for (int x = 0; x < volume.dims.x; ++x, ++i) {
          auto value = double(samples[i * std::size_t(volume.channels) + std::size_t(channel)]);
          if (!std::isfinite(value)) continue;
          glm::dvec3 place = finestFromVoxel * glm::dvec4(x, y, z, 1.0);
          glm::ivec3 at = glm::clamp(glm::ivec3(place + 0.5), glm::ivec3(0), finest.dims - 1) / finest.brickSize;
          std::size_t brick =
              (std::size_t(at.z) * std::size_t(grid.y) + std::size_t(at.y)) * std::size_t(grid.x) + std::size_t(at.x);
          auto [found, isNew] = ranges.emplace(brick, glm::dvec2(value));
          found->second = {std::min(found->second.x, value), std::max(found->second.y, value)};
        }
  });
  std::vector<std::pair<std::size_t, glm::dvec2>> sorted(ranges.begin(), ranges.end());
  std::vector<BrickAddress> bricks;
  auto take = [&](const auto& isBefore) {
    std::size_t count = std::min(kOfEach, sorted.size());
    std::partial_sort(sorted.begin(), sorted.begin() + std::ptrdiff_t(count), sorted.end(), isBefore);
    for (std::size_t i = 0; i < count; ++i) {
      auto x = std::size_t(grid.x), y = std::size_t(grid.y), brick = sorted[i].first;
      bricks.push_back(
          {0, {int(brick % x), int(brick / x % y), int(brick / (x * y))}, channel / finest.brickChannels, 0});
    }
  };
  take([](const auto& a, const auto& b) { return std::pair(-a.second.y, a.first) < std::pair(-b.second.y, b.first); });
  take([](const auto& a, const auto& b) { return std::pair(a.second.x, a.first) < std::pair(b.second.x, b.first); });
  return bricks;
}

}  // namespace

double wholeBudget() {
  double whole = memoryBudget().wholeBytes;
  if (whole == MemoryBudget().wholeBytes) whole = std::min(whole, machineBytes() / 8);  // nobody chose it
  if (const char* megabytes = std::getenv("VELUM_WHOLE_MB")) whole = std::atof(megabytes) * 1e6;
  return std::min(whole, machineBytes() / 2);
}

LevelPlan planLevel(const VoxelSource& of, const scene::Source& source) {
  double machine = machineBytes(), whole = wholeBudget();
  int count = int(of.levels().size()), level = std::max(source.level, 0);
  if (source.level >= count)
    refuse(source.path, fmt::format("there is no level {}; they are 0 to {}", source.level, count - 1));
  bool isStreamed = source.level < 0 && count > 1 && levelBytes(of, 0) > whole;
  auto voxelsOf = [&](int i) {
    glm::dvec3 dims = of.levels()[std::size_t(i)].dims;
    return dims.x * dims.y * dims.z;
  };
  if (isStreamed)
    while (level + 1 < count && voxelsOf(level) > std::min(kCoarseVoxels, 0.5 * voxelsOf(0))) ++level;
  double most = source.level >= 0 ? machine / 2 : std::max(whole, machine / 8), bytes = levelBytes(of, level);
  if (bytes > most)
    refuse(source.path, fmt::format("its level {} has {:.1f} GB of voxels, and {:.1f} GB are the most "
                                    "that is read whole; velum-batch convert makes a store with coarser levels of it",
                                    level, bytes / kGb, most / kGb));
  return {level, isStreamed};
}

std::unique_ptr<VoxelSource> openPyramid(const scene::Source& source) {
  std::unique_ptr<VoxelSource> opened;
  if (isStore(source.path))
    opened = openImage(source.path, source.series);
  else if (!hasRawLayout(source))
    opened = openSource(source);
  return opened && opened->levels().size() > 1 ? std::move(opened) : nullptr;
}

int levelNear(const scene::Source& source, int wanted) {
  auto pyramid = openPyramid(source);
  if (!pyramid) return scene::kFittingLevel;
  auto fits = levelWithin(*pyramid, machineBytes() / 2);
  return fits ? std::max(*fits, std::min(wanted, int(pyramid->levels().size()) - 1)) : scene::kFittingLevel;
}

Volume readFitting(std::unique_ptr<VoxelSource> pyramid, const scene::Source& source, bool isAlignedByBorders,
                   Progress& progress) {
  auto [level, isStreamed] = planLevel(*pyramid, source);
  Volume volume = readLevel(*pyramid, level, progress);
  volume.channelWindows = pyramid->channelWindows();
  if (level == 0) return volume;
  const auto& levels = pyramid->levels();
  std::string which =
      fmt::format("level {} of 0 to {}, {} voxels", level, levels.size() - 1, sizeOf(levels[std::size_t(level)]));
  if (isStreamed)
    volume.warnings.push_back(fmt::format(
        "streamed: pictures, sections and what grows have up to {} voxels; what works on all voxels at once works on {}",
        sizeOf(levels.front()), which));
  else
    volume.warnings.push_back(fmt::format("{}, were read; the finest has {}", which, sizeOf(levels.front())));
  if (isAlignedByBorders)
    volume.warnings.push_back(
        "the file does not say where its coarser levels lie; they were taken as means of blocks, border on border");
  if (!isStreamed) return volume;
  auto bricks = std::make_shared<BrickCache>(std::move(pyramid), std::size_t(brickBudget()));
  volume.finer = std::make_shared<FinerLevels>(FinerLevels{std::move(bricks), level});
  return volume;
}

void widenRange(Volume& volume) {
  if (!volume.finer || volume.isColor) return;
  BrickCache& cache = *volume.finer->bricks;
  for (int channel = 0; channel < volume.channels; ++channel)
    for (const BrickAddress& address : extremeBricks(volume, channel)) {
      BrickBox box = boxOf(cache.source(), address);
      try {
        Volume brick = cache.read({0, box.origin, box.size}, channel, 0);
        computeRange(brick);
        volume.range = {std::min(volume.range.x, brick.range.x), std::max(volume.range.y, brick.range.y)};
      } catch (const InputError&) {  // a damaged brick is told of where it is looked at
      }
    }
}

}  // namespace velum::io
