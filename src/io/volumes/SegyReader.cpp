#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/Error.h"
#include "core/SayCount.h"
#include "io/read/FileBytes.h"
#include "io/read/Placement.h"
#include "io/read/SampleBytes.h"
#include "io/volumes/Readers.h"
#include "io/volumes/SegyGrid.h"
#include "io/volumes/SegyLayout.h"

/// SEG-Y, revisions 0 to 2 with traces of one length.
///
/// Axes: x inline, y crossline, z time or depth. The earth's z runs down and the world's up, so the third column of
/// worldFromVoxel points to -z. World: 1 mm is 1 mm in the earth; a millisecond of two-way time is shown as a metre
/// (2000 m/s), which makes the sample interval the same number for time (microseconds) and depth (millimetres).
namespace velum::io {

namespace {

SegyTrace traceOf(std::span<const std::byte> header, bool isLittle) {
  SegyFields f(header, 1, isLittle);
  SegyTrace t;
  t.lines = {{{f.four(189), f.four(193)}, {f.four(9), f.four(21)}}};
  t.offset = f.four(37);
  int scalar = f.two(71);
  double factor = scalar > 0 ? scalar : scalar < 0 ? -1.0 / scalar : 1.0;
  t.position = {f.four(181) * factor, f.four(185) * factor};
  return t;
}

/// @param[out] warnings  what trace headers say against the file's
std::vector<SegyTrace> readHeaders(const FileBytes& file, const SegyLayout& layout, const Path& path,
                                   std::vector<std::string>& warnings, Progress& progress) {
  std::vector<SegyTrace> traces;
  std::uint64_t others = 0;
  std::array<std::byte, kSegyTraceHeader> header;
  for (std::uint64_t i = 0; i < layout.traces; ++i) {
    if (i % 65536 == 0) progress.report(0.3 * double(i) / double(layout.traces), "reading trace headers");
    file.read(layout.firstTrace + i * layout.traceBytes, header);
    traces.push_back(traceOf(header, layout.isLittle));
    int samples = SegyFields(header, 1, layout.isLittle).unsignedTwo(115);
    if (layout.isOneLength || samples == 0 || samples == (layout.samples & 0xffff)) continue;
    // Where traces of one length fill the file the trace's header is what is wrong.
    if (layout.hasRest)
      refuse(path, fmt::format("has traces of several lengths ({} and {} samples); only files of one are read",
                               layout.samples, samples));
    ++others;
  }
  if (others > 0)
    warnings.push_back(sayCount(others,
                                "{} of {} traces claims another length than the file's {} samples, which was taken",
                                "{} of {} traces claim another length than the file's {} samples, which was taken",
                                layout.traces, layout.samples));
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
void decode(std::span<std::byte> samples, const SegyLayout& layout) {
  toMachineOrder(samples, sampleSize(layout.type), !layout.isLittle);
  if (!layout.isIbm) return;
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
void readTraces(const FileBytes& file, const SegyLayout& layout, const SegyGrid& grid, Volume& v, Progress& progress) {
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
        file.read(layout.firstTrace + std::uint64_t(index) * layout.traceBytes + layout.headerBytes, to);
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

void setPlace(Volume& v, const SegyLayout& layout, const SegyGrid& grid) {
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
  SegyLayout layout = findSegyLayout(file, path);
  Volume v;
  v.type = layout.type;
  v.warnings = layout.warnings;
  SegyGrid grid = arrangeTraces(readHeaders(file, layout, path, v.warnings, progress), layout.sorting, path.string());
  v.warnings.insert(v.warnings.end(), grid.warnings.begin(), grid.warnings.end());
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
