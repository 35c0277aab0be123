#pragma once
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/gtc/constants.hpp>
#include <vector>

#include "GeneratedSource.h"
#include "core/Error.h"
#include "core/ReplaceFile.h"
#include "io/stores/OmeDescription.h"
#include "io/stores/ReduceBlocks.h"
#include "io/stores/WriteStore.h"

/// A store as large as one wants, of real files: it says the same again and again, so that its shards, which fill the
/// disk once, are there many times by hard links.
namespace velum::io {

/// A formula that repeats itself along each axis: a net of vessels in one half of a gyroid, and cells in the other. Its
/// levels are means of 2 x 2 x 2, as writeStore() makes them.
class RepeatedField {
 public:
  static constexpr int kPeriod = 256;  ///< voxels of the finest level
  static constexpr int kLevels = 8;
  RepeatedField() {
    std::vector<std::uint16_t>& finest = mTiles[0];
    finest.resize(std::size_t(kPeriod) * kPeriod * kPeriod);
    auto* to = finest.data();
    for (int z = 0; z < kPeriod; ++z)
      for (int y = 0; y < kPeriod; ++y)
        for (int x = 0; x < kPeriod; ++x) *to++ = formula({x, y, z});
    for (int level = 1; level < kLevels; ++level) {
      int n = period(level);
      mTiles[std::size_t(level)].resize(std::size_t(n) * std::size_t(n) * std::size_t(n));
      reduceBlocks(SampleType::UInt16, Reduction::Mean,
                   reinterpret_cast<const std::byte*>(mTiles[std::size_t(level) - 1].data()), glm::ivec3(2 * n),
                   glm::ivec3(n), glm::ivec3(2), reinterpret_cast<std::byte*>(mTiles[std::size_t(level)].data()));
    }
  }
  static constexpr int period(int level) { return kPeriod >> level; }

  /// @param p  a voxel of a level, anywhere
  std::uint16_t at(int level, glm::ivec3 p) const {
    auto n = std::size_t(period(level));
    auto place = [&](int i) { return std::size_t(i) & (n - 1); };
    return mTiles[std::size_t(level)][(place(p.z) * n + place(p.y)) * n + place(p.x)];
  }

 private:
  static std::uint16_t formula(glm::ivec3 p) {
    static const auto kSines = [] {
      std::array<double, kPeriod> sines{};
      for (int i = 0; i < kPeriod; ++i) sines[std::size_t(i)] = std::sin(glm::two_pi<double>() * i / kPeriod);
      return sines;
    }();
    auto sine = [](int turns, int i) { return kSines[std::size_t(turns * i + 8 * kPeriod) % kPeriod]; };
    auto cosine = [&](int turns, int i) { return sine(turns, i + kPeriod / (4 * turns)); };
    double gyroid = sine(1, p.x) * cosine(1, p.y) + sine(1, p.y) * cosine(1, p.z) + sine(1, p.z) * cosine(1, p.x);
    double cells = sine(8, p.x + 3) * sine(8, p.y + p.x / 64) * sine(8, p.z + 9);
    double value = 500.0 + 60.0 * sine(16, p.x) * sine(16, p.y + p.z);
    value += 2600.0 * glm::smoothstep(1.02, 1.2, gyroid);
    value += 3800.0 * glm::smoothstep(0.45, 0.75, cells) * glm::smoothstep(0.3, 0.6, -gyroid);
    return std::uint16_t(std::lround(value));
  }
  std::array<std::vector<std::uint16_t>, kLevels> mTiles;  ///< one period of each level, x fastest
};

/// Lays the shards of a level, which were written once, into all places that they have in it.
/// @param tile  the folder of the array that was written
inline void linkShards(const std::filesystem::path& tile, const std::filesystem::path& level, glm::ivec3 shards,
                       int distinct) {
  namespace fs = std::filesystem;
  for (int z = 0; z < shards.z; ++z)
    for (int y = 0; y < shards.y; ++y) {
      fs::path row = level / "c" / std::to_string(z) / std::to_string(y);
      fs::create_directories(row);
      for (int x = 0; x < shards.x; ++x)
        fs::create_hard_link(tile / "c" / std::to_string(z % distinct) / "0" / "0", row / std::to_string(x));
    }
}

/// Writes a folder of OME-Zarr 0.5 that holds the field in as many voxels of 16 bits as one asks for.
/// @param dims  voxels; whole numbers of 2^(RepeatedField::kLevels - 1), so that each level's blocks are whole, and so
///              many that there are no more levels
/// @throw InputError, std::filesystem::filesystem_error where the disk has no hard links
inline void writeRepeatedStore(const std::filesystem::path& folder, glm::ivec3 dims, const RepeatedField& field) {
  namespace fs = std::filesystem;
  Volume head;
  head.dims = dims;
  head.type = SampleType::UInt16;
  for (int axis = 0; axis < 3; ++axis) head.worldFromVoxel[axis][axis] = 0.001;  // a micrometre
  OmeLayout layout;
  layout.levels = planPyramid(dims, glm::dvec3(1.0), 64, sizeof(std::uint16_t));
  layout.zstdLevel = 1;
  fs::create_directories(folder);
  for (int level = 0; level < int(layout.levels.size()); ++level) {
    const PlannedLevel& planned = layout.levels[std::size_t(level)];
    int period = RepeatedField::period(level), distinct = std::max(1, period / planned.shard.z);
    GeneratedSource tile({planned.shard.x, planned.shard.y, planned.shard.z * distinct}, planned.brick,
                         [&](glm::ivec3 p) { return field.at(level, p); });
    fs::path written = folder / ("tile" + std::to_string(level) + ".zarr"), array = folder / std::to_string(level);
    Progress progress;
    writeStore(tile, written, {}, progress);
    glm::ivec3 shards = (planned.dims + planned.shard - 1) / planned.shard;
    linkShards(written / "0", array, shards, distinct);
    fs::remove_all(written);
    MetadataFile file = describeArray(layout, head, level);
    replaceFile(array / file.name, file.text);
  }
  for (const MetadataFile& file : describeImage(layout, head, {}, {})) replaceFile(folder / file.name, file.text);
}

}  // namespace velum::io
