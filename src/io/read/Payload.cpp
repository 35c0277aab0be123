#include "Payload.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "velum/core/Error.h"

namespace velum::io {

namespace {

constexpr std::size_t kPiece = 1 << 20;
/// Deflate cannot do better than 258 bytes in two bits; 8 is for the stream's own frame.
constexpr std::uint64_t kDeflateRatio = 1040;
/// Longest tail behind the samples that is read to reach the checksum.
constexpr std::uint64_t kLongestTail = 64 << 20;

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

void failInput(const Path& file, std::string_view reason) {
  throw InputError(fmt::format("{}: {}", file.string(), reason));
}

std::string inQuotes(std::string_view text) {
  std::string result(text.substr(0, 60));
  for (char& c : result)
    if (static_cast<unsigned char>(c) < 32 || c == 127) c = '?';
  return "'" + result + (text.size() > 60 ? "...'" : "'");
}

std::string lowerCase(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return result;
}

std::string lowerExtension(const Path& file) {
  std::string extension = lowerCase(file.extension().string());
  return extension == ".gz" ? lowerCase(file.stem().extension().string()) + ".gz" : extension;
}

std::uint64_t sizeOfFile(const Path& file) {
  std::error_code error;
  auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) failInput(file, "there is no such file");
  if (!std::filesystem::is_regular_file(status)) failInput(file, "is not a regular file");
  std::uint64_t size = std::filesystem::file_size(file, error);
  if (error) failInput(file, error.message());
  return size;
}

struct ByteSource::State {
  Path path;
  std::unique_ptr<std::FILE, FileCloser> file;
  bool deflated = false;
  bool atStreamEnd = false;
  z_stream stream{};
  std::vector<Bytef> input;

  bool refill() {
    stream.next_in = input.data();
    stream.avail_in = uInt(std::fread(input.data(), 1, input.size(), file.get()));
    return stream.avail_in > 0;
  }
  std::size_t inflateInto(std::span<std::byte> to);
};

ByteSource::ByteSource(const Path& file, std::uint64_t offset, bool deflated) : mState(std::make_unique<State>()) {
  sizeOfFile(file);
  mState->path = file;
  mState->file.reset(std::fopen(file.c_str(), "rb"));
  if (!mState->file) failInput(file, std::strerror(errno));
  if (offset && fseeko(mState->file.get(), off_t(offset), SEEK_SET) != 0) failInput(file, "cannot be positioned");
  mState->deflated = deflated;
  if (!deflated) return;
  mState->input.resize(kPiece / 4);
  // 15 + 32: the largest window, gzip and zlib frames both known by their first bytes.
  if (inflateInit2(&mState->stream, 15 + 32) != Z_OK) failInput(file, "cannot be inflated");
}

ByteSource::~ByteSource() {
  if (mState->deflated) inflateEnd(&mState->stream);
}

std::size_t ByteSource::State::inflateInto(std::span<std::byte> to) {
  std::size_t done = 0;
  while (done < to.size()) {
    if (stream.avail_in == 0 && !refill()) {
      if (atStreamEnd) break;
      failInput(path, "the compressed data is cut off");
    }
    if (atStreamEnd) {
      // More members may follow, as pigz and bgzip write them; anything else behind the stream is padding.
      if (stream.next_in[0] != 0x1f) break;
      inflateReset(&stream);
      atStreamEnd = false;
    }
    uInt room = uInt(std::min<std::size_t>(to.size() - done, 1u << 30));
    stream.next_out = reinterpret_cast<Bytef*>(to.data() + done);
    stream.avail_out = room;
    int result = inflate(&stream, Z_NO_FLUSH);
    done += room - stream.avail_out;
    if (result == Z_STREAM_END) {
      atStreamEnd = true;
    } else if (result != Z_OK && result != Z_BUF_ERROR) {
      failInput(path, fmt::format("the compressed data is damaged ({})", stream.msg ? stream.msg : "zlib"));
    }
  }
  return done;
}

std::size_t ByteSource::read(std::span<std::byte> to) {
  if (mState->deflated) return mState->inflateInto(to);
  return std::fread(to.data(), 1, to.size(), mState->file.get());
}

bool ByteSource::skip(std::uint64_t count) {
  std::vector<std::byte> scratch(std::min<std::uint64_t>(count, kPiece));
  while (count > 0) {
    std::size_t now = read(std::span(scratch).first(std::min<std::uint64_t>(count, scratch.size())));
    if (now == 0) return false;
    count -= now;
  }
  return true;
}

void ByteSource::verifyEnd() {
  if (!mState->deflated) return;
  std::vector<std::byte> scratch(kPiece / 4);
  for (std::uint64_t tail = 0; tail < kLongestTail;) {
    std::size_t now = mState->inflateInto(scratch);
    if (now < scratch.size()) return;
    tail += now;
  }
}

bool isGzip(const Path& file) {
  std::unique_ptr<std::FILE, FileCloser> f(std::fopen(file.c_str(), "rb"));
  unsigned char magic[2] = {};
  return f && std::fread(magic, 1, 2, f.get()) == 2 && magic[0] == 0x1f && magic[1] == 0x8b;
}

std::string readHead(const Path& file, std::size_t count) {
  std::string head;
  try {
    ByteSource source(file, 0, isGzip(file));
    // In small steps, so that what comes before a cut is still seen.
    std::array<std::byte, 4096> piece;
    while (head.size() < count) {
      std::size_t now = source.read(std::span(piece).first(std::min(piece.size(), count - head.size())));
      head.append(reinterpret_cast<const char*>(piece.data()), now);
      if (now < piece.size()) break;
    }
  } catch (const InputError&) {
    if (!std::filesystem::is_regular_file(file)) throw;
  }
  return head;
}

std::size_t storedSize(StoredType type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8, 8, 8};
  return kSizes[static_cast<int>(type)];
}

std::uint64_t layoutBytes(const Layout& layout, const Path& header) {
  const std::int64_t factors[] = {layout.dims.x, layout.dims.y, layout.dims.z, layout.channels, layout.frames};
  std::uint64_t bytes = storedSize(layout.type);
  for (std::int64_t factor : factors) {
    if (factor < 1 || factor > 0x7fffffff) failInput(header, fmt::format("a size of {} is not possible", factor));
    if (__builtin_mul_overflow(bytes, std::uint64_t(factor), &bytes)) failInput(header, "the sizes are too large");
  }
  return bytes;
}

void checkJustified(std::span<const Payload> parts, std::uint64_t bytes, const Path& header) {
  std::uint64_t held = 0;
  for (const Payload& part : parts) {
    std::uint64_t size = sizeOfFile(part.file);
    if (part.offset > size)
      failInput(header, fmt::format("the data would start at byte {}, the file ends at {}", part.offset, size));
    size -= part.offset;
    if (part.packing == Packing::Deflate) {
      held += size * kDeflateRatio;
    } else {
      held += size - std::min(size, part.skip);
    }
  }
  if (bytes > held)
    failInput(header, fmt::format("the header asks for {} bytes of data, the file can hold {} at most", bytes, held));
}

namespace {

template <class T>
void swapSamples(std::span<std::byte> bytes) {
  for (std::size_t i = 0; i + sizeof(T) <= bytes.size(); i += sizeof(T)) {
    T value;
    std::memcpy(&value, bytes.data() + i, sizeof(T));
    if constexpr (sizeof(T) == 2) value = __builtin_bswap16(value);
    if constexpr (sizeof(T) == 4) value = __builtin_bswap32(value);
    if constexpr (sizeof(T) == 8) value = __builtin_bswap64(value);
    std::memcpy(bytes.data() + i, &value, sizeof(T));
  }
}

void toMachineOrder(std::span<std::byte> bytes, std::size_t sampleBytes, bool bigEndian) {
  if (bigEndian == (std::endian::native == std::endian::big)) return;
  if (sampleBytes == 2) swapSamples<std::uint16_t>(bytes);
  if (sampleBytes == 4) swapSamples<std::uint32_t>(bytes);
  if (sampleBytes == 8) swapSamples<std::uint64_t>(bytes);
}

void readBinary(const Payload& part, std::span<std::byte> to, const Layout& layout, Progress& progress, double from,
                double share) {
  ByteSource source(part.file, part.offset, part.packing == Packing::Deflate);
  if (part.skip && !source.skip(part.skip)) failInput(part.file, "ends before the data");
  std::size_t done = 0;
  const std::string what = "Reading " + part.file.filename().string();
  while (done < to.size()) {
    // A piece is a multiple of every sample size, and small enough to be still in cache when its bytes are swapped.
    auto piece = to.subspan(done, std::min(kPiece, to.size() - done));
    std::size_t now = source.read(piece);
    done += now;
    if (now < piece.size())
      failInput(part.file, fmt::format("is cut off: {} bytes of data are missing", to.size() - done));
    toMachineOrder(piece, storedSize(layout.type), layout.bigEndian);
    progress.report(from + share * double(done) / double(to.size()), what);
  }
  source.verifyEnd();
}

template <class T>
void storeNumber(double value, std::byte* to) {
  T sample = T(std::clamp(value, double(std::numeric_limits<T>::lowest()), double(std::numeric_limits<T>::max())));
  std::memcpy(to, &sample, sizeof(T));
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

void readText(const Payload& part, std::span<std::byte> to, const Layout& layout, Progress& progress) {
  std::string text(sizeOfFile(part.file) - part.offset, '\0');
  ByteSource source(part.file, part.offset, false);
  source.read(std::as_writable_bytes(std::span(text)));
  const char* at = text.c_str();
  std::size_t step = storedSize(layout.type);
  for (std::size_t i = 0; i < to.size(); i += step) {
    while (*at && (std::isspace(static_cast<unsigned char>(*at)) || *at == ',')) ++at;
    char* end = nullptr;
    double value = std::strtod(at, &end);
    if (end == at) failInput(part.file, "has too few numbers");
    at = end;
    storeNumber(value, layout.type, to.data() + i);
    if (i % kPiece < step) progress.report(double(i) / double(to.size()), "Reading " + part.file.filename().string());
  }
}

/// 64-bit integers become Int32 where all fit, else Float64; both fit in the bytes that are there.
template <class T>
SampleType narrow(Bytes& bytes) {
  std::size_t count = bytes.size() / 8;
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
      std::memcpy(bytes.data() + i * 8, &asDouble, 8);
    }
  }
  if (!fits) return SampleType::Float64;
  bytes.resize(count * 4);
  return SampleType::Int32;
}

Bytes interleave(const Bytes& planar, std::size_t channels, std::size_t sampleBytes) {
  Bytes result(planar.size());
  std::size_t count = planar.size() / channels / sampleBytes;
  for (std::size_t c = 0; c < channels; ++c)
    for (std::size_t i = 0; i < count; ++i)
      std::memcpy(result.data() + (i * channels + c) * sampleBytes, planar.data() + (c * count + i) * sampleBytes,
                  sampleBytes);
  return result;
}

}  // namespace

Volume readSamples(const Layout& layout, std::span<const Payload> parts, const Path& header, Progress& progress) {
  // Refuse what the files cannot justify before anything is allocated.
  std::uint64_t bytes = layoutBytes(layout, header);
  bool isText = !parts.empty() && parts[0].packing == Packing::Text;
  checkJustified(parts, isText ? bytes / storedSize(layout.type) : bytes, header);
  if (bytes % parts.size()) failInput(header, "the data files do not divide the volume evenly");

  Volume volume;
  volume.dims = glm::ivec3(layout.dims);
  volume.channels = int(layout.channels);
  volume.frames = int(layout.frames);
  try {
    volume.voxels.resize(bytes);
  } catch (const std::bad_alloc&) {
    failInput(header, fmt::format("there is no memory for {} bytes", bytes));
  }
  std::size_t each = bytes / parts.size();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    auto to = std::span(volume.voxels).subspan(i * each, each);
    double share = 1.0 / double(parts.size());
    isText ? readText(parts[i], to, layout, progress)
           : readBinary(parts[i], to, layout, progress, double(i) * share, share);
  }
  if (layout.type == StoredType::Int64) {
    volume.type = narrow<std::int64_t>(volume.voxels);
  } else if (layout.type == StoredType::UInt64) {
    volume.type = narrow<std::uint64_t>(volume.voxels);
  } else {
    volume.type = static_cast<SampleType>(layout.type);
  }
  if (layout.planarChannels && layout.channels > 1)
    volume.voxels = interleave(volume.voxels, std::size_t(layout.channels), sampleSize(volume.type));
  return volume;
}

bool isInvertible(const glm::dmat3& columns) {
  double lengths = glm::length(columns[0]) * glm::length(columns[1]) * glm::length(columns[2]);
  double volume = std::abs(glm::determinant(columns));
  // A millionth of a box's volume: no scanner shears so far, and the inverse is still good to nine digits.
  return std::isfinite(lengths) && lengths > 0 && volume > 1e-6 * lengths;
}

void placeInWorld(Volume& volume, const glm::dmat3& columns, const glm::dvec3& origin,
                  const glm::dvec3& fallbackSpacing) {
  glm::dmat3 axes = columns;
  if (!isInvertible(axes)) {
    glm::dvec3 spacing;
    for (int i = 0; i < 3; ++i) {
      bool usable = std::isfinite(fallbackSpacing[i]) && fallbackSpacing[i] > 0;
      spacing[i] = usable ? fallbackSpacing[i] : 1.0;
      if (!usable) volume.isSpacingKnown = false;
    }
    axes = glm::dmat3(spacing.x, 0, 0, 0, spacing.y, 0, 0, 0, spacing.z);
    volume.isOrientationKnown = false;
    volume.warnings.push_back(
        fmt::format("the orientation in the file cannot be used; axes along x, y, z with {} x {} x {} mm were taken",
                    spacing.x, spacing.y, spacing.z));
  }
  glm::dvec3 start = origin;
  for (int i = 0; i < 3; ++i)
    if (!std::isfinite(start[i])) {
      start[i] = 0.0;
      volume.warnings.push_back("the origin in the file is not a number; 0 was taken");
    }
  volume.worldFromVoxel = glm::dmat4(axes);
  volume.worldFromVoxel[3] = glm::dvec4(start, 1.0);
}

Path siblingFile(const Path& header, std::string_view name) {
  Path relative = Path(std::string(name)).lexically_normal();
  if (name.empty() || relative.is_absolute() || relative.begin()->string() == "..")
    failInput(header, fmt::format("its data file {} lies outside the header's folder", inQuotes(name)));
  Path file = header.parent_path() / relative;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    failInput(header, fmt::format("its data file {} is missing", inQuotes(name)));
  return file;
}

}  // namespace velum::io
