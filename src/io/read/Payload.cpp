#include "io/read/Payload.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <string>
#include <utility>

#include "core/SayCount.h"
#include "core/Text.h"
#include "io/read/ByteSource.h"
#include "io/read/FileBytes.h"
#include "io/read/SampleBytes.h"

namespace velum::io {

namespace {

constexpr std::size_t kPayloadPiece = 1 << 20;

template <class T>
void storeNumber(double value, std::byte* to) {
  if (std::is_integral_v<T> && std::isnan(value)) value = 0;
  T sample = T(std::clamp(value, double(std::numeric_limits<T>::lowest()), double(std::numeric_limits<T>::max())));
  std::memcpy(to, &sample, sizeof(T));
}

}  // namespace

std::size_t storedSize(StoredType type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8, 8, 8};
  return kSizes[static_cast<int>(type)];
}

void storeNumber(double value, StoredType type, std::byte* to) {
  switch (type) {
    case StoredType::UInt8:
      return storeNumber<std::uint8_t>(value, to);
    case StoredType::Int8:
      return storeNumber<std::int8_t>(value, to);
    case StoredType::UInt16:
      return storeNumber<std::uint16_t>(value, to);
    case StoredType::Int16:
      return storeNumber<std::int16_t>(value, to);
    case StoredType::UInt32:
      return storeNumber<std::uint32_t>(value, to);
    case StoredType::Int32:
      return storeNumber<std::int32_t>(value, to);
    case StoredType::Float32:
      return storeNumber<float>(value, to);
    default:
      return storeNumber<double>(value, to);
  }
}

std::uint64_t layoutBytes(const Layout& layout, const Path& header) {
  return checkedBytes(header, layout.dims, double(layout.channels), double(layout.timeSteps), storedSize(layout.type),
                      std::numeric_limits<double>::infinity());
}

namespace {

/// The most bytes of samples that the parts can hold together.
double mostBytesOf(std::span<const Payload> parts, const Path& header) {
  double most = 0;
  for (const Payload& part : parts) {
    std::uint64_t size = sizeOfFile(part.file);
    if (part.offset > size)
      refuse(header, fmt::format("the data would start at byte {}, the file ends at {}", part.offset, size));
    size -= part.offset;
    bool isDeflated = part.packing == Packing::Deflate;
    most += double(isDeflated ? size * kDeflateRatio : size - std::min(size, part.skip));
  }
  return most;
}

void readBinary(const Payload& part, std::span<std::byte> to, const Layout& layout, Progress& progress, double from,
                double share) {
  ByteSource source(part.file, part.offset, part.packing == Packing::Deflate);
  if (source.skip(part.skip) != part.skip) refuse(part.file, "ends before the data");
  std::size_t done = 0;
  const std::string what = "Reading " + part.file.filename().string();
  while (done < to.size()) {
    // A piece is a multiple of every sample size, and small enough to be still in cache when its bytes are swapped.
    auto piece = to.subspan(done, std::min(kPayloadPiece, to.size() - done));
    std::size_t now = source.readSome(piece);
    done += now;
    if (now < piece.size())
      refuse(part.file, fmt::format("is cut off: {} bytes of data are missing", to.size() - done));
    toMachineOrder(piece, storedSize(layout.type), layout.bigEndian);
    progress.report(from + share * double(done) / double(to.size()), what);
  }
  source.verifyEnd();
}

void readText(const Payload& part, std::span<std::byte> to, const Layout& layout, Progress& progress) {
  std::string text(sizeOfFile(part.file) - part.offset, '\0');
  ByteSource source(part.file, part.offset, false);
  source.readSome(std::as_writable_bytes(std::span(text)));
  std::string_view rest = text;
  std::size_t step = storedSize(layout.type);
  for (std::size_t i = 0; i < to.size(); i += step) {
    while (!rest.empty() && (std::isspace(static_cast<unsigned char>(rest.front())) || rest.front() == ','))
      rest.remove_prefix(1);
    auto value = takeNumber(rest);
    if (!value) refuse(part.file, "has too few numbers");
    storeNumber(*value, layout.type, to.data() + i);
    if (i % kPayloadPiece < step)
      progress.report(double(i) / double(to.size()), "Reading " + part.file.filename().string());
  }
}

/// 64-bit integers become Int32 where all fit, else Float64; both fit in the bytes that are there.
template <class T>
SampleType narrow(Bytes& bytes, std::vector<std::string>& warnings) {
  std::size_t rounded = 0, count = bytes.size() / 8;
  auto load = [&](std::size_t i) {
    T value;
    std::memcpy(&value, bytes.data() + i * 8, 8);
    return value;
  };
  bool fits = true;
  for (std::size_t i = 0; i < count && fits; ++i) fits = std::in_range<std::int32_t>(load(i));
  for (std::size_t i = 0; i < count; ++i) {
    T value = load(i);
    if (fits) {
      storeNumber<std::int32_t>(double(value), bytes.data() + i * 4);
    } else {
      double asDouble = double(value);
      rounded += static_cast<long double>(value) != static_cast<long double>(asDouble);
      std::memcpy(bytes.data() + i * 8, &asDouble, 8);
    }
  }
  if (rounded > 0)
    warnings.push_back(sayCount(rounded, "{} of {} integers of 64 bits has more digits than a double and is rounded",
                                "{} of {} integers of 64 bits have more digits than a double and are rounded", count));
  if (!fits) return SampleType::Float64;
  bytes.resize(count * 4);
  return SampleType::Int32;
}

/// @param run  voxels of a channel that lie one behind the other
Bytes interleave(const Bytes& planar, std::size_t run, std::size_t channels, std::size_t sampleBytes) {
  Bytes result(planar.size());
  std::size_t count = planar.size() / channels / sampleBytes;
  for (std::size_t first = 0; first < count; first += run)
    for (std::size_t c = 0; c < channels; ++c)
      for (std::size_t i = 0; i < run; ++i)
        std::memcpy(result.data() + ((first + i) * channels + c) * sampleBytes,
                    planar.data() + (first * channels + c * run + i) * sampleBytes, sampleBytes);
  return result;
}

}  // namespace

UnreadVolume promiseSamples(const Layout& layout, std::vector<Payload> parts, const Path& header) {
  // Refuse what the files cannot justify before anything is allocated.
  bool isText = !parts.empty() && parts[0].packing == Packing::Text;
  std::size_t sample = storedSize(layout.type);
  double most = mostBytesOf(parts, header) * (isText ? double(sample) : 1.0);  // a number takes a character at least
  std::size_t bytes =
      checkedBytes(header, layout.dims, double(layout.channels), double(layout.timeSteps), sample, most);
  if (bytes % parts.size()) refuse(header, "the data files do not divide the volume evenly");
  UnreadVolume unread;
  unread.head.dims = glm::ivec3(layout.dims);
  unread.head.channels = int(layout.channels);
  unread.head.timeSteps = int(layout.timeSteps);
  bool isWide = layout.type == StoredType::Int64 || layout.type == StoredType::UInt64;
  unread.head.type = isWide ? SampleType::Float64 : static_cast<SampleType>(layout.type);
  unread.layout = layout;
  unread.parts = std::move(parts);
  unread.header = header;
  return unread;
}

Volume readSamples(UnreadVolume unread, Progress& progress) {
  const Layout& layout = unread.layout;
  Volume& volume = unread.head;
  std::size_t bytes = layoutBytes(layout, unread.header), each = bytes / unread.parts.size();
  try {
    volume.voxels.resize(bytes);
  } catch (const std::bad_alloc&) {
    refuse(unread.header, fmt::format("there is no memory for {} bytes", bytes));
  }
  for (std::size_t i = 0; i < unread.parts.size(); ++i) {
    const Payload& part = unread.parts[i];
    auto to = std::span(volume.voxels).subspan(i * each, each);
    double share = 1.0 / double(unread.parts.size());
    part.packing == Packing::Text ? readText(part, to, layout, progress)
                                  : readBinary(part, to, layout, progress, double(i) * share, share);
  }
  if (layout.type == StoredType::Int64) volume.type = narrow<std::int64_t>(volume.voxels, volume.warnings);
  if (layout.type == StoredType::UInt64) volume.type = narrow<std::uint64_t>(volume.voxels, volume.warnings);
  if (layout.channelOrder != ChannelOrder::Together && layout.channels > 1) {
    std::size_t plane = std::size_t(volume.dims.x) * std::size_t(volume.dims.y);
    std::size_t all = voxelCount(volume) * std::size_t(volume.timeSteps);
    volume.voxels = interleave(volume.voxels, layout.channelOrder == ChannelOrder::Planes ? plane : all,
                               std::size_t(layout.channels), sampleSize(volume.type));
  }
  return std::move(volume);
}

}  // namespace velum::io
