#include "io/volumes/SegyGrid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/Error.h"
#include "core/SayCount.h"

namespace velum::io {

namespace {

using Lines = SegyTrace::Lines;

/// First number, step and count of one axis.
struct Axis {
  std::int64_t first = 0, step = 1, count = 1;
};

Axis axisOf(std::vector<std::int32_t> numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  Axis axis{numbers.front(), 0, 1};
  for (std::int64_t n : numbers) axis.step = std::gcd(axis.step, n - axis.first);
  if (axis.step == 0) axis.step = 1;
  axis.count = (numbers.back() - axis.first) / axis.step + 1;
  return axis;
}

/// Which pair of header bytes tells the traces apart: the standard's unless all are the same there.
std::size_t choosePair(const std::vector<SegyTrace>& traces) {
  for (std::size_t pair = 0; pair < 2; ++pair)
    for (const auto& t : traces)
      if (t.lines[pair] != traces[0].lines[pair]) return pair;
  return 2;
}

/// Least squares of position = p0 + a * x + b * y over the traces; |a| and |b|. Zero where an axis has one line only.
glm::dvec2 spacingOf(const std::vector<SegyTrace>& traces, const SegyGrid& grid) {
  glm::dvec2 lengths(0.0);
  glm::dmat3 normal(0.0);
  glm::dvec3 right[2] = {glm::dvec3(0.0), glm::dvec3(0.0)};
  glm::dvec2 base(0.0);
  double count = 0;
  auto visit = [&](auto body) {
    for (int y = 0; y < grid.size.y; ++y)
      for (int x = 0; x < grid.size.x; ++x)
        if (auto i = grid.traceAt[std::size_t(y) * std::size_t(grid.size.x) + std::size_t(x)]; i >= 0)
          body(glm::dvec3(1.0, x, y), traces[std::size_t(i)].position);
  };
  // Map coordinates are large; taken from their mean they keep their digits.
  visit([&](glm::dvec3, glm::dvec2 p) { base += p, count += 1; });
  base /= std::max(1.0, count);
  visit([&](glm::dvec3 q, glm::dvec2 p) {
    normal += glm::outerProduct(q, q);
    right[0] += q * (p.x - base.x);
    right[1] += q * (p.y - base.y);
  });
  // An axis with one line has no slope; pin it to zero instead of dividing by it.
  if (grid.size.x == 1) normal[1][1] += 1.0;
  if (grid.size.y == 1) normal[2][2] += 1.0;
  if (!(std::abs(glm::determinant(normal)) > 0)) return lengths;
  glm::dmat3 inverse = glm::inverse(normal);
  glm::dvec3 alongX = inverse * right[0], alongY = inverse * right[1];
  lengths = {std::hypot(alongX[1], alongY[1]), std::hypot(alongX[2], alongY[2])};
  // Traces that are not where the fit puts them are not on a grid of the map.
  double worst = 0;
  visit([&](glm::dvec3 q, glm::dvec2 p) {
    worst = std::max(worst, glm::length(glm::dvec2(glm::dot(alongX, q), glm::dot(alongY, q)) - (p - base)));
  });
  double least = std::min(grid.size.x > 1 ? lengths.x : 1e300, grid.size.y > 1 ? lengths.y : 1e300);
  if (!(worst < least)) return glm::dvec2(0.0);
  // A single line has no width of its own; a square cell shows best.
  if (grid.size.x == 1) lengths.x = lengths.y;
  if (grid.size.y == 1) lengths.y = lengths.x;
  return lengths;
}

/// All traces in file order along y: a 2D line without numbers.
SegyGrid arrangeAsLine(const std::vector<SegyTrace>& traces) {
  SegyGrid grid;
  grid.size = {1, int(traces.size())};
  grid.traceAt.resize(traces.size());
  std::iota(grid.traceAt.begin(), grid.traceAt.end(), std::int64_t(0));
  grid.warnings.push_back(
      "the traces have no inline and crossline numbers; they are shown as one line in the file's order");
  return grid;
}

[[noreturn]] void refuseGathers(const std::vector<SegyTrace>& traces, const std::string& name) {
  auto [least, most] =
      std::minmax_element(traces.begin(), traces.end(), [](auto& a, auto& b) { return a.offset < b.offset; });
  throw InputError(
      fmt::format("{}: holds {} traces as they were shot (gathers before stacking, offsets from {} to {}); read are "
                  "stacks with one "
                  "trace for each inline and crossline (bytes 189/193 or 9/21), and single lines: stack it first",
                  name, traces.size(), least->offset, most->offset));
}

}  // namespace

SegyGrid arrangeTraces(const std::vector<SegyTrace>& traces, int sorting, const std::string& name) {
  if (traces.empty()) throw InputError(fmt::format("{}: has no traces", name));
  // Where the line numbers stand; without any the traces are one line.
  std::size_t pair = choosePair(traces);
  bool hasOffsets =
      std::any_of(traces.begin(), traces.end(), [&](const auto& t) { return t.offset != traces[0].offset; });
  constexpr int kOfSource = 5, kOfReceiver = 6;
  bool isShot = hasOffsets || sorting == kOfSource || sorting == kOfReceiver;
  // Bytes 9/21 of what is not stacked are the shot and its midpoints, not lines.
  if (pair > 0 && isShot) refuseGathers(traces, name);
  SegyGrid grid;
  if (pair == 2 && traces.size() > 1) {
    grid = arrangeAsLine(traces);
    grid.spacing = spacingOf(traces, grid);
    return grid;
  }
  pair = std::min<std::size_t>(pair, 1);

  // The grid that the numbers span; damaged ones would span anything.
  std::vector<std::int32_t> numbers;
  for (const auto& t : traces) numbers.push_back(t.lines[pair].inlineNumber);
  Axis inlines = axisOf(numbers);
  std::transform(traces.begin(), traces.end(), numbers.begin(),
                 [&](const auto& t) { return t.lines[pair].crosslineNumber; });
  Axis crosslines = axisOf(std::move(numbers));
  double cells = double(inlines.count) * double(crosslines.count);
  if (cells > double(kMostCellsPerTrace) * double(traces.size()) + 64)
    throw InputError(
        fmt::format("{}: {} traces are too few for a grid of {} inlines by {} crosslines; the line numbers are not in "
                    "bytes 189/193 or 9/21",
                    name, traces.size(), inlines.count, crosslines.count));

  // Each trace to its place, the first that comes.
  grid.size = {int(inlines.count), int(crosslines.count)};
  grid.traceAt.assign(std::size_t(cells), -1);
  std::size_t extra = 0;
  for (std::size_t i = 0; i < traces.size(); ++i) {
    auto x = std::size_t((traces[i].lines[pair].inlineNumber - inlines.first) / inlines.step);
    auto y = std::size_t((traces[i].lines[pair].crosslineNumber - crosslines.first) / crosslines.step);
    auto& cell = grid.traceAt[y * std::size_t(inlines.count) + x];
    extra += cell >= 0;
    if (cell < 0) cell = std::int64_t(i);
  }
  // What the user ought to know.
  auto missing = std::count(grid.traceAt.begin(), grid.traceAt.end(), std::int64_t(-1));
  if (pair > 0 && 2 * extra > traces.size()) refuseGathers(traces, name);
  if (extra > 0)
    grid.warnings.push_back(sayCount(extra, "{1}{0} of {2} traces has the place of an earlier one; {3}",
                                     "{1}{0} of {2} traces share a place with an earlier one; {3}",
                                     hasOffsets ? "the file is prestack: " : "", traces.size(),
                                     hasOffsets ? "the first offset is shown" : "that one is shown"));
  if (missing > 0)
    grid.warnings.push_back(sayCount(missing, "{} of {} traces is missing and shown as 0",
                                     "{} of {} traces are missing and shown as 0", grid.traceAt.size()));
  if (grid.size.x == 1 || grid.size.y == 1)
    grid.warnings.push_back("the file holds a single line; it is shown as one plane");
  grid.spacing = spacingOf(traces, grid);
  return grid;
}

}  // namespace velum::io
