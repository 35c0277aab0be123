#include <fmt/format.h>

#include <string>

#include "core/Error.h"
#include "io/read/ByteSource.h"
#include "io/read/FileBytes.h"
#include "io/read/FileNames.h"
#include "io/read/Payload.h"
#include "io/read/SampleBytes.h"
#include "io/volumes/Readers.h"

namespace velum::io {

namespace {

constexpr const char* kGive =
    "give its size, sample type, byte order and header length (raw.dims, raw.type, raw.bigEndian, raw.headerBytes)";

[[noreturn]] void refuseSize(const Path& path, double expected, double actual) {
  refuse(path, fmt::format("the layout given needs {:.0f} bytes, header included, but the file has {:.0f}", expected,
                           actual));
}

Layout layoutOf(const scene::Source& source) {
  const auto& raw = source.raw;
  if (raw.dims.x < 1 || raw.dims.y < 1 || raw.dims.z < 1)
    refuse(source.path, fmt::format("a file without a header: {}", kGive));
  if (raw.channels < 1 || raw.channels > 4 || raw.headerBytes < 0)
    refuse(source.path,
           fmt::format("raw.channels {} or raw.headerBytes {} makes no sense", raw.channels, raw.headerBytes));
  Layout layout;
  layout.dims = raw.dims;
  layout.channels = raw.channels;
  layout.type = static_cast<StoredType>(raw.type);
  layout.bigEndian = raw.bigEndian;
  return layout;
}

bool isPacked(const Path& path) { return lowerCase(path.extension().string()) == ".gz"; }

/// Bytes of so many planes, header included.
double bytesOf(const scene::RawLayout& raw, int planes) {
  return double(raw.dims.x) * raw.dims.y * planes * raw.channels * double(sampleSize(raw.type)) + raw.headerBytes;
}

void expectSize(const Path& path, double wanted) {
  auto size = double(sizeOfFile(path));
  if (size != wanted) refuseSize(path, wanted, size);
}

std::vector<Payload> slicesOf(const scene::Source& source) {
  auto files = filesInOrder(source.path);
  if (int(files.size()) != source.raw.dims.z)
    refuse(source.path, fmt::format("the layout given needs {} slices, but the folder has {} files", source.raw.dims.z,
                                    files.size()));
  std::vector<Payload> parts;
  for (const Path& path : files) {
    expectSize(path, bytesOf(source.raw, 1));
    parts.push_back({path, std::uint64_t(source.raw.headerBytes)});
  }
  return parts;
}

std::vector<Payload> wholeOf(const scene::Source& source) {
  auto header = std::uint64_t(source.raw.headerBytes);
  if (isPacked(source.path)) return {{source.path, 0, header, Packing::Deflate}};
  expectSize(source.path, bytesOf(source.raw, source.raw.dims.z));
  return {{source.path, header}};
}

/// How much is in a packed file is known at its end: it is read by itself.
Volume readPacked(const scene::Source& source, UnreadVolume unread) {
  Volume& volume = unread.head;
  ByteSource file(source.path);
  auto skipped = file.skip(unread.parts[0].skip);
  volume.voxels.resize(layoutBytes(unread.layout, unread.header));
  std::size_t got = file.readSome(volume.voxels);
  double total = double(skipped + got) + double(file.skip(file.mostBytes()));
  double wanted = bytesOf(source.raw, source.raw.dims.z);
  if (total != wanted) refuseSize(source.path, wanted, total);
  toMachineOrder(volume.voxels, sampleSize(volume.type), source.raw.bigEndian);
  return std::move(volume);
}

}  // namespace

UnreadVolume describeRaw(const scene::Source& source) {
  Layout layout = layoutOf(source);
  auto parts = std::filesystem::is_directory(source.path) ? slicesOf(source) : wholeOf(source);
  UnreadVolume unread = promiseSamples(layout, std::move(parts), source.path);
  unread.head.isColor = unread.head.channels >= 3 && unread.head.type == SampleType::UInt8;
  unread.head.isSpacingKnown = unread.head.isOrientationKnown = false;
  return unread;
}

Volume readRaw(const scene::Source& source, Progress& progress) {
  UnreadVolume unread = describeRaw(source);
  bool isOnePacked = unread.parts[0].packing == Packing::Deflate;
  return isOnePacked ? readPacked(source, std::move(unread)) : readSamples(std::move(unread), progress);
}

}  // namespace velum::io
