#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <numeric>
#include <optional>

#include "Readers.h"
#include "SegyGrid.h"
#include "read/FileBytes.h"
#include "read/Placement.h"
#include "read/SampleBytes.h"
#include "velum/core/Error.h"

/// SEG-Y, revisions 0 to 2 with traces of one length, as the SEG's standard has it: byte numbers count from 1.
///
/// Axes: x inline, y crossline, z time or depth. The earth's z runs down and the world's up, so the third column of
/// worldFromVoxel points to -z. World: 1 mm is 1 mm in the earth; a millisecond of two-way time is shown as a metre
/// (2000 m/s), which makes the sample interval the same number for time (microseconds) and depth (millimetres).
namespace velum::io {

namespace {

constexpr std::uint64_t kTextHeader = 3200, kBinaryHeader = 400, kTraceHeader = 240;

enum class Code {
  Ibm = 1,
  Int32 = 2,
  Int16 = 3,
  Ieee32 = 5,
  Ieee64 = 6,
  Int8 = 8,
  UInt32 = 10,
  UInt16 = 11,
  UInt8 = 16
};

std::optional<SampleType> typeOf(int code) {
  switch (static_cast<Code>(code)) {
    case Code::Ibm:
    case Code::Ieee32:
      return SampleType::Float32;
    case Code::Int32:
      return SampleType::Int32;
    case Code::Int16:
      return SampleType::Int16;
    case Code::Ieee64:
      return SampleType::Float64;
    case Code::Int8:
      return SampleType::Int8;
    case Code::UInt32:
      return SampleType::UInt32;
    case Code::UInt16:
      return SampleType::UInt16;
    case Code::UInt8:
      return SampleType::UInt8;
  }
  return {};
}

/// A header, with byte numbers as in the standard (from 1, counted in the binary header from 3201).
class Fields {
 public:
  Fields(std::span<const std::byte> bytes, std::size_t firstNumber, bool isLittle)
      : mBytes(bytes), mFirst(firstNumber), mIsLittle(isLittle) {}
  std::int32_t four(std::size_t number) const { return std::int32_t(raw(number, 4)); }
  std::int16_t two(std::size_t number) const { return std::int16_t(raw(number, 2)); }
  std::uint16_t unsignedTwo(std::size_t number) const { return std::uint16_t(raw(number, 2)); }

 private:
  std::uint32_t raw(std::size_t number, std::size_t size) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
      value |= std::uint32_t(mBytes[number - mFirst + i]) << (8 * (mIsLittle ? i : size - 1 - i));
    return value;
  }
  std::span<const std::byte> mBytes;
  std::size_t mFirst;
  bool mIsLittle;
};

/// What the file says of all its traces.
struct Layout {
  bool isLittle = false;
  int code = 0, samples = 0, interval = 0;  ///< Interval in microseconds, or millimetres of depth.
  bool isFeet = false;
  SampleType type = SampleType::Float32;
  std::uint64_t firstTrace = 0, traceBytes = 0, traces = 0;
  bool hasRest = false;  ///< Bytes behind the last whole trace.
};

/// The layout in one byte order, if it makes sense so.
std::optional<Layout> layoutOf(const FileBytes& file, std::span<const std::byte> binary, bool isLittle) {
  Fields f(binary, 3201, isLittle);
  Layout out;
  out.isLittle = isLittle;
  out.code = f.two(3225);
  out.samples = f.unsignedTwo(3221);
  out.interval = f.unsignedTwo(3217);
  out.isFeet = f.two(3255) == 2;
  auto type = typeOf(out.code);
  if (!type) return {};
  out.type = *type;
  // Extended text headers exist since revision 1.
  int revision = f.unsignedTwo(3501), extended = f.two(3505);
  out.firstTrace = kTextHeader + kBinaryHeader;
  if (revision >= 0x0100 && extended > 0 && extended < 10'000) out.firstTrace += std::uint64_t(extended) * kTextHeader;
  if (out.samples == 0 && out.firstTrace + kTraceHeader <= file.size()) {
    std::array<std::byte, kTraceHeader> header;
    file.read(out.firstTrace, header);
    out.samples = Fields(header, 1, isLittle).unsignedTwo(115);
  }
  if (out.samples == 0) return {};
  out.traceBytes = kTraceHeader + std::uint64_t(out.samples) * sampleSize(out.type);
  std::uint64_t body = file.size() > out.firstTrace ? file.size() - out.firstTrace : 0;
  out.traces = body / out.traceBytes;
  out.hasRest = body % out.traceBytes != 0;
  return out;
}

Layout findLayout(const FileBytes& file, const Path& path) {
  std::string head = file.head(64);
  if (head.starts_with("version https://git-lfs"))
    refuse(path, "is a Git LFS pointer and not the data; fetch it with 'git lfs pull'");
  if (file.size() < kTextHeader + kBinaryHeader)
    refuse(path, fmt::format("is not SEG-Y: {} bytes are fewer than its headers ({})", file.size(),
                             kTextHeader + kBinaryHeader));
  std::array<std::byte, kBinaryHeader> binary;
  file.read(kTextHeader, binary);
  auto big = layoutOf(file, binary, false), little = layoutOf(file, binary, true);
  if (!big && !little)
    refuse(path, fmt::format("is not SEG-Y, or of a kind that is not read (sample format {}, {} samples a trace)",
                             Fields(binary, 3201, false).two(3225), Fields(binary, 3201, false).unsignedTwo(3221)));
  // Both make sense rarely; then traces that fill the file decide, else the standard's order.
  Layout out = big && little ? (little->traces > 0 && !little->hasRest && big->hasRest ? *little : *big)
               : big         ? *big
                             : *little;
  if (out.traces == 0) refuse(path, "has headers but no whole trace");
  if (out.traces > 200'000'000) refuse(path, fmt::format("has {} traces; that many are not read", out.traces));
  return out;
}

SegyTrace traceOf(std::span<const std::byte> header, bool isLittle) {
  Fields f(header, 1, isLittle);
  SegyTrace t;
  t.lines = {{{f.four(189), f.four(193)}, {f.four(9), f.four(21)}}};
  t.offset = f.four(37);
  int scalar = f.two(71);
  double factor = scalar > 0 ? scalar : scalar < 0 ? -1.0 / scalar : 1.0;
  t.position = {f.four(181) * factor, f.four(185) * factor};
  return t;
}

std::vector<SegyTrace> readHeaders(const FileBytes& file, const Layout& layout, Progress& progress) {
  std::vector<SegyTrace> traces;
  std::array<std::byte, kTraceHeader> header;
  for (std::uint64_t i = 0; i < layout.traces; ++i) {
    if (i % 65536 == 0) progress.report(0.3 * double(i) / double(layout.traces), "reading trace headers");
    file.read(layout.firstTrace + i * layout.traceBytes, header);
    traces.push_back(traceOf(header, layout.isLittle));
  }
  return traces;
}

/// IBM System/360 hexadecimal: sign, exponent of 16 less 64, 24 bits of fraction. Exact in a float but for exponents
/// that a float has not.
float floatFromIbm(std::uint32_t bits) {
  double fraction = double(bits & 0x00ffffff) / 16777216.0;
  int exponent = int((bits >> 24) & 0x7f) - 64;
  double value = std::ldexp(fraction, 4 * exponent);
  return float(bits >> 31 ? -value : value);
}

/// Turns the samples of a trace, as stored, into machine numbers in place.
void decode(std::span<std::byte> samples, const Layout& layout) {
  toMachineOrder(samples, sampleSize(layout.type), !layout.isLittle);
  if (static_cast<Code>(layout.code) != Code::Ibm) return;
  for (std::size_t at = 0; at + 4 <= samples.size(); at += 4) {
    std::uint32_t bits;
    std::memcpy(&bits, samples.data() + at, 4);
    float value = floatFromIbm(bits);
    std::memcpy(samples.data() + at, &value, 4);
  }
}

/// Copies a block of traces, shape [rows][nx][nz], into the volume, shape [nz][ny][nx], rows y0 and on.
template <class T>
void transpose(const std::byte* block, int rows, int y0, Volume& v) {
  auto nx = std::size_t(v.dims.x), ny = std::size_t(v.dims.y), nz = std::size_t(v.dims.z);
  auto* to = reinterpret_cast<T*>(v.voxels.data());
  const auto* from = reinterpret_cast<const T*>(block);
  for (std::size_t z = 0; z < nz; ++z)
    for (std::size_t y = 0; y < std::size_t(rows); ++y)
      for (std::size_t x = 0; x < nx; ++x) to[(z * ny + std::size_t(y0) + y) * nx + x] = from[(y * nx + x) * nz + z];
}

/// Reads the traces a few crosslines at a time: rows of x are then written whole, while a trace at a time would touch a
/// line of memory for each sample.
void readTraces(const FileBytes& file, const Layout& layout, const SegyGrid& grid, Volume& v, Progress& progress) {
  std::size_t trace = std::size_t(layout.samples) * sampleSize(layout.type);
  std::size_t row = trace * std::size_t(v.dims.x);
  int rows = int(std::clamp<std::size_t>((std::size_t(8) << 20) / row, 1, std::size_t(v.dims.y)));
  Bytes block(row * std::size_t(rows));
  for (int y0 = 0; y0 < v.dims.y; y0 += rows) {
    progress.report(0.3 + 0.7 * y0 / v.dims.y, "reading traces");
    int used = std::min(rows, v.dims.y - y0);
    for (int x = 0; x < v.dims.x; ++x)
      for (int y = y0; y < y0 + used; ++y) {
        std::span<std::byte> to(block.data() + row * std::size_t(y - y0) + trace * std::size_t(x), trace);
        std::int64_t index = grid.traceAt[std::size_t(y) * std::size_t(v.dims.x) + std::size_t(x)];
        if (index < 0) {
          std::memset(to.data(), 0, to.size());
          continue;
        }
        file.read(layout.firstTrace + std::uint64_t(index) * layout.traceBytes + kTraceHeader, to);
        decode(to, layout);
      }
    switch (sampleSize(v.type)) {
      case 1:
        transpose<std::uint8_t>(block.data(), used, y0, v);
        break;
      case 2:
        transpose<std::uint16_t>(block.data(), used, y0, v);
        break;
      case 4:
        transpose<std::uint32_t>(block.data(), used, y0, v);
        break;
      default:
        transpose<std::uint64_t>(block.data(), used, y0, v);
        break;
    }
  }
}

void setPlace(Volume& v, const Layout& layout, const SegyGrid& grid) {
  constexpr double kFoot = 0.3048;
  glm::dvec2 metres = grid.spacing * (layout.isFeet ? kFoot : 1.0);
  auto isSane = [](double m) { return m >= 0.05 && m <= 2000.0; };
  v.isSpacingKnown = isSane(metres.x) && isSane(metres.y) && layout.interval > 0;
  glm::dvec3 spacing(1.0);
  if (v.isSpacingKnown) {
    spacing = {metres.x * 1000.0, metres.y * 1000.0, double(layout.interval)};
    v.warnings.push_back(fmt::format("sample interval {}: {} ms of time shown as {} m, or {} m if the file is in depth",
                                     layout.interval, layout.interval / 1000.0, layout.interval / 1000.0,
                                     layout.interval / 1000.0));
  }
  spacing.z = -spacing.z;
  v.worldFromVoxel = gridMatrix(spacing);
  v.isOrientationKnown = false;
}

}  // namespace

Volume readSegy(const scene::Source& source, Progress& progress) {
  const Path path = source.path;
  progress.report(0, "reading SEG-Y");
  FileBytes file(path);
  Layout layout = findLayout(file, path);
  SegyGrid grid = arrangeTraces(readHeaders(file, layout, progress), path.string());
  Volume v;
  v.type = layout.type;
  v.warnings = grid.warnings;
  if (layout.hasRest) v.warnings.push_back("the file ends within a trace, which is left out");
  // arrangeTraces() lets at most kMostCellsPerTrace cells be for each trace that is there.
  double most = double(file.size()) * kMostCellsPerTrace;
  v.voxels.resize(checkedBytes(path, {grid.size.x, grid.size.y, layout.samples}, 1, 1, sampleSize(v.type), most));
  v.dims = {grid.size.x, grid.size.y, layout.samples};
  readTraces(file, layout, grid, v, progress);
  setPlace(v, layout, grid);
  v.modality = Modality::Seismic;
  progress.report(1, "reading SEG-Y");
  return v;
}

}  // namespace velum::io
