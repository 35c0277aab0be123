#include <fmt/format.h>

#include <string>

#include "core/Error.h"
#include "io/read/ByteSource.h"
#include "io/read/FileBytes.h"
#include "io/read/FileNames.h"
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

Volume emptyVolume(const scene::Source& source) {
  const auto& raw = source.raw;
  if (raw.dims.x < 1 || raw.dims.y < 1 || raw.dims.z < 1)
    refuse(source.path, fmt::format("a file without a header: {}", kGive));
  if (raw.channels < 1 || raw.channels > 4 || raw.headerBytes < 0)
    refuse(source.path,
           fmt::format("raw.channels {} or raw.headerBytes {} makes no sense", raw.channels, raw.headerBytes));
  Volume volume;
  volume.dims = raw.dims;
  volume.type = raw.type;
  volume.channels = raw.channels;
  volume.isColor = raw.channels >= 3 && raw.type == SampleType::UInt8;
  volume.isSpacingKnown = volume.isOrientationKnown = false;
  return volume;
}

void readPlain(const scene::Source& source, Volume& volume) {
  FileBytes file(source.path);
  double header = source.raw.headerBytes;
  double wanted =
      double(volume.dims.x) * volume.dims.y * volume.dims.z * volume.channels * double(sampleSize(volume.type));
  if (wanted + header != double(file.size())) refuseSize(source.path, wanted + header, double(file.size()));
  volume.voxels.resize(std::size_t(wanted));
  file.read(std::uint64_t(header), volume.voxels);
}

void readGzip(const scene::Source& source, Volume& volume) {
  ByteSource file(source.path);
  double header = source.raw.headerBytes;
  std::size_t bytes =
      checkedBytes(source.path, volume.dims, volume.channels, 1, sampleSize(volume.type), double(file.mostBytes()));
  auto skipped = file.skip(std::uint64_t(header));
  volume.voxels.resize(bytes);
  std::size_t got = file.readSome(volume.voxels);
  double total = double(skipped + got) + double(file.skip(file.mostBytes()));
  if (total != double(bytes) + header) refuseSize(source.path, double(bytes) + header, total);
}

void readSlices(const scene::Source& source, Volume& volume, Progress& progress) {
  auto files = filesInOrder(source.path);
  if (int(files.size()) != volume.dims.z)
    refuse(source.path,
           fmt::format("the layout given needs {} slices, but the folder has {} files", volume.dims.z, files.size()));
  std::size_t header = std::size_t(source.raw.headerBytes);
  double slice = double(volume.dims.x) * volume.dims.y * volume.channels * double(sampleSize(volume.type));
  // Every slice is measured before the volume is allocated.
  for (const auto& path : files) {
    auto size = double(std::filesystem::file_size(path));
    if (size != slice + double(header)) refuseSize(path, slice + double(header), size);
  }
  volume.voxels.resize(std::size_t(slice) * files.size());
  for (std::size_t z = 0; z < files.size(); ++z) {
    progress.report(double(z) / double(files.size()), "reading slices");
    FileBytes(files[z]).read(header,
                             std::span<std::byte>(volume.voxels).subspan(z * std::size_t(slice), std::size_t(slice)));
  }
}

}  // namespace

Volume readRaw(const scene::Source& source, Progress& progress) {
  progress.report(0, "reading raw voxels");
  Volume volume = emptyVolume(source);
  if (std::filesystem::is_directory(source.path))
    readSlices(source, volume, progress);
  else if (lowerCase(std::filesystem::path(source.path).extension().string()) == ".gz")
    readGzip(source, volume);
  else
    readPlain(source, volume);
  toMachineOrder(volume.voxels, sampleSize(volume.type), source.raw.bigEndian);
  progress.report(1, "reading raw voxels");
  return volume;
}

}  // namespace velum::io
