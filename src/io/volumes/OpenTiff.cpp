#include "io/volumes/OpenTiff.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>

#include "io/read/Placement.h"
#include "io/stores/PyramidPlan.h"
#include "io/volumes/RawSource.h"
#include "io/volumes/TiffSource.h"

namespace velum::io {

namespace {

std::optional<SampleType> sampleTypeOf(const TiffPage& page) {
  struct Row {
    std::uint64_t bits, format;
    SampleType type;
  };
  constexpr Row kTypes[] = {{8, 1, SampleType::UInt8},    {8, 2, SampleType::Int8},    {16, 1, SampleType::UInt16},
                            {16, 2, SampleType::Int16},   {32, 1, SampleType::UInt32}, {32, 2, SampleType::Int32},
                            {32, 3, SampleType::Float32}, {64, 3, SampleType::Float64}};
  for (const Row& row : kTypes)
    if (page.bits == row.bits && page.sampleFormat == row.format) return row.type;
  return std::nullopt;
}

/// Nothing for pages whose samples are not to be taken as they are.
std::optional<PlaneShape> shapeOf(const TiffPage& page) {
  constexpr std::uint64_t kMost = 1u << 30, kMostSamples = 65535;
  auto type = sampleTypeOf(page);
  bool isPlain = page.photometric == 1 || page.photometric == 2;
  bool isSmall = page.width <= kMost && page.height <= kMost && page.samples >= 1 && page.samples <= kMostSamples;
  if (!type || !isPlain || !isSmall) return std::nullopt;
  return PlaneShape{int(page.width), int(page.height), int(page.samples), *type};
}

/// Rows of a strip, or size of a tile. @throw InputError
glm::ivec2 chunkOf(const TiffPage& page, const Path& path) {
  if (page.tileWidth == 0) {
    std::uint64_t rows = page.tileHeight == 0 ? page.height : std::min(page.tileHeight, page.height);
    return {int(page.width), int(rows)};
  }
  bool makesSense = page.tileHeight > 0 && double(page.tileWidth) <= 4096.0 + 2.0 * double(page.width) &&
                    double(page.tileHeight) <= 4096.0 + 2.0 * double(page.height);
  if (!makesSense) refuse(path, fmt::format("tiles of {} x {} make no sense", page.tileWidth, page.tileHeight));
  return {int(page.tileWidth), int(page.tileHeight)};
}

/// Whether both are stored in the same way, but for their sizes.
bool isLike(const TiffPage& a, const TiffPage& b) {
  return a.bits == b.bits && a.samples == b.samples && a.sampleFormat == b.sampleFormat &&
         a.photometric == b.photometric && a.planar == b.planar;
}

bool isPacked(const TiffPage& page) {
  std::uint64_t bytes = page.width * page.height * page.samples * (page.bits / 8);
  bool isPlain = page.compression == 1 && page.tileWidth == 0 && page.isOneStretch && page.fillOrder == 1 &&
                 (page.planar == 1 || page.samples == 1) && page.dataBytes >= bytes;
  return !isPlain;
}

/// Where the directories of a page's coarser levels are: its own, or those that follow it in the chain.
std::vector<std::uint64_t> levelsOf(const TiffStack& stack, std::size_t page) {
  const auto& all = stack.file.pages;
  std::size_t number = std::size_t(stack.pages[page]);
  if (!all[number].subPages.empty()) return all[number].subPages;
  std::vector<std::uint64_t> levels;
  for (++number; number < all.size() && all[number].isReduced; ++number) levels.push_back(all[number].at);
  return levels;
}

/// The pages of the coarser levels of one page.
std::vector<TiffPage> levelPagesOf(const TiffStack& stack, std::size_t page) {
  const auto& all = stack.file.pages;
  std::size_t number = std::size_t(stack.pages[page]);
  std::ifstream file(stack.path, std::ios::binary);
  if (!all[number].subPages.empty()) return scanSubPages(file, stack.path.string(), all[number]);
  std::vector<TiffPage> levels;
  for (++number; number < all.size() && all[number].isReduced; ++number) levels.push_back(all[number]);
  return levels;
}

/// The pages in the order of the source: [time][channel][z].
std::vector<std::size_t> inOrder(const TiffVolume& volume, int channelPlanes) {
  std::vector<std::size_t> pages(volume.planes.size());
  for (const PlaneTarget& plane : volume.planes)
    pages[std::size_t((plane.t * std::uint64_t(channelPlanes) + plane.c) * std::uint64_t(volume.head.dims.z) +
                      plane.z)] = std::size_t(plane.page);
  return pages;
}

TiffSource::Stored storedAs(const TiffPage& page, const Path& path) {
  TiffSource::Stored stored;
  stored.chunk = chunkOf(page, path);
  stored.isTiled = page.tileWidth > 0;
  stored.mostExpansion = std::uint64_t(mostExpansion(page.compression));
  return stored;
}

/// Coarser levels, where all pages have the same number of them. Those of another shape are thumbnails.
void addCoarser(TiffSource& source, const TiffStack& stack, const std::vector<std::size_t>& pages) {
  std::vector<std::vector<std::uint64_t>> levels;
  for (std::size_t page : pages) levels.push_back(levelsOf(stack, page));
  for (const auto& one : levels)
    if (one.size() != levels.front().size()) return;
  const TiffPage& finest = stack.file.pages[std::size_t(stack.pages[pages.front()])];
  glm::ivec2 before(int(finest.width), int(finest.height));
  auto found = levelPagesOf(stack, pages.front());
  for (std::size_t i = 0; i < std::min(found.size(), levels.front().size()); ++i) {
    const TiffPage& page = found[i];
    auto shape = shapeOf(page);
    if (!shape || !isLike(finest, page) || !page.isDataInside) continue;
    glm::ivec2 dims(shape->width, shape->height);
    glm::dvec2 factor(blockFactor(double(finest.width), dims.x), blockFactor(double(finest.height), dims.y));
    bool isSmaller = dims.x <= before.x && dims.y <= before.y && dims != before;
    bool isAlike = std::abs(double(finest.height) / factor.x - dims.y) <= 1.0;
    if (!isSmaller || !isAlike) continue;
    TiffSource::Stored stored = storedAs(page, stack.path);
    for (const auto& one : levels) stored.directories.push_back(one[i]);
    source.addLevel(std::move(stored), dims, factor);
    before = dims;
  }
}

}  // namespace

std::unique_ptr<VoxelSource> openTiff(const scene::Source& from) {
  auto file = std::make_shared<const FileBytes>(from.path);
  TiffStack stack = describeTiff(from.path);
  const TiffPage& first = stack.file.pages[std::size_t(stack.pages[0])];
  auto shape = shapeOf(first);
  if (!shape) return nullptr;
  if (isOnePageStack(stack)) {
    UnreadVolume unread = describeOnePageStack(stack, *shape);
    describeHead(unread.head, stack);
    markAsPlanes(unread.head);
    return openSamples(std::move(unread), from);
  }
  TiffSource::Stored stored = storedAs(first, from.path);
  bool hasPacked = false;
  for (int number : stack.pages) {
    const TiffPage& page = stack.file.pages[std::size_t(number)];
    bool isSame =
        isLike(first, page) && chunkOf(page, from.path) == stored.chunk && (page.tileWidth > 0) == stored.isTiled;
    if (!isSame) return nullptr;
    stored.mostExpansion = std::max(stored.mostExpansion, std::uint64_t(mostExpansion(page.compression)));
    hasPacked = hasPacked || isPacked(page);
  }
  TiffVolume arranged = arrangePlanes(stack, *shape);
  describeHead(arranged.head, stack);
  markAsPlanes(arranged.head);
  completeHead(arranged.head, from);
  auto pages = inOrder(arranged, arranged.head.channels / shape->channels);
  for (std::size_t page : pages) {
    const TiffPage& one = stack.file.pages[std::size_t(stack.pages[page])];
    stored.directories.push_back(one.at);
    if (!hasPacked) stored.plain.push_back(one.firstStrip);
  }
  bool isPlanar = first.planar == 2 && shape->channels > 1;
  auto source = std::make_unique<TiffSource>(file, arranged.head, shape->channels, isPlanar, stack.file.isBigEndian);
  source->addLevel(std::move(stored), {shape->width, shape->height}, {1.0, 1.0});
  addCoarser(*source, stack, pages);
  return source;
}

}  // namespace velum::io
