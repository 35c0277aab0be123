#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/Parallel.h"
#include "core/ReplaceFile.h"
#include "io/read/JsonParts.h"
#include "io/stores/Crc32c.h"
#include "io/stores/StoreWriter.h"

/// What the writer says of a store before and after its arrays are written.
namespace velum::io {

namespace {

std::string textIn(const Path& path) {
  auto store = openStore(path.parent_path());
  return textOf(*store, path.filename().string());
}

/// A check sum of all bytes, on all cores.
std::uint32_t sumOf(std::span<const std::byte> bytes) {
  constexpr std::size_t kPiece = 4 << 20;
  std::vector<std::uint32_t> sums((bytes.size() + kPiece - 1) / kPiece);
  parallelFor(std::size_t(0), sums.size(), [&](std::size_t i) {
    sums[i] = crc32c(bytes.subspan(i * kPiece, std::min(kPiece, bytes.size() - i * kPiece)));
  });
  return crc32c(std::as_bytes(std::span(sums)));
}

}  // namespace

void makeFolders(const Path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) refuse(folder, fmt::format("the folder cannot be made: {}", error.message()));
}

/// A check sum by which another source is known: of all voxels where they are in memory, else of some bricks and of
/// what the source says of itself.
std::uint32_t StoreWriter::fingerprint() const {
  if (!mSource.head().voxels.empty()) return sumOf(mSource.head().voxels);
  constexpr int kBricks = 7;
  const VoxelLevel& level = mSource.levels()[std::size_t(mOptions.level)];
  glm::ivec3 grid = bricksOf(level);
  int channels = channelBricksOf(mSource, mOptions.level), times = timeBricksOf(mSource, mOptions.level);
  std::string identity = mSource.identity();
  std::uint32_t sums[kBricks + 1] = {};
  sums[kBricks] = crc32c(std::as_bytes(std::span(identity)));
  for (int i = 0; i < kBricks; ++i) {
    auto part = [&](int count) { return int(std::int64_t(count) * i / kBricks); };
    BrickAddress address{mOptions.level, {part(grid.x), part(grid.y), part(grid.z)}, part(channels), part(times)};
    BrickBox box = boxOf(mSource, address);
    Bytes samples(bytesOf(box, mHead.type));
    mSource.read(address, targetIn(samples.data(), box, mHead.type));
    sums[i] = crc32c(samples);
  }
  return crc32c(std::as_bytes(std::span(sums)));
}

/// All that must be the same when the writer goes on.
std::string StoreWriter::planText() const {
  Json arrays = Json::array();
  for (int level = 0; level < int(mLayout.levels.size()); ++level)
    arrays.push_back(Json::parse(describeArray(mLayout, mHead, level).text));
  Json plan = {{"what", "A store that is being written. This file is removed when it is whole."},
               {"arrays", arrays},
               {"labels", mLayout.isLabels},
               {"source", fingerprint()}};
  return plan.dump(1) + "\n";
}

void StoreWriter::begin() {
  makeFolders(mFolder);
  Path mark = mFolder / kUnfinishedName;
  std::string plan = planText();
  mResumes = isUnfinished(mFolder);
  if (mResumes && textIn(mark) != plan)
    refuse(mFolder,
           "holds what was written of another volume, or in another way, and is not whole; remove it, or "
           "give another name");
  if (!mResumes && !std::filesystem::is_empty(mFolder))
    refuse(mFolder, "is there already; remove it, or give another name");
  replaceFile(mark, plan);
  for (int level = 0; level < int(mLayout.levels.size()); ++level) {
    makeFolders(mFolder / std::to_string(level));
    MetadataFile file = describeArray(mLayout, mHead, level);
    replaceFile(mFolder / std::to_string(level) / file.name, file.text);
  }
}

std::vector<glm::dvec2> StoreWriter::findWindows() const {
  if (mLayout.isLabels || !mSource.channelWindows().empty()) return mSource.channelWindows();
  ZarrSource coarsest = written(int(mLayout.levels.size()) - 1);
  std::vector<glm::dvec2> windows;
  for (int c = 0; c < mHead.channels; ++c) {
    Volume found = mHead;
    BrickBox box;
    found.dims = box.size = coarsest.levels().front().dims;
    found.channels = 1;
    box.channel = c;
    found.timeSteps = 1;
    found.voxels = readBox(coarsest, 0, box, mProgress);
    computeRange(found);
    windows.push_back((found.range - found.offset) / found.scale);
    if (windows.back().x > windows.back().y) std::swap(windows.back().x, windows.back().y);
  }
  return windows;
}

void StoreWriter::describe(const std::vector<glm::dvec2>& windows) {
  mLayout.hasChosenWindows = !mSource.channelWindows().empty();
  for (const MetadataFile& file : describeImage(mLayout, mHead, windows, mOptions.structures))
    replaceFile(mFolder / file.name, file.text);
}

}  // namespace velum::io
