#include "velum/session/document/Body.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <type_traits>
#include <vector>

#include "velum/core/Error.h"
#include "velum/core/Parallel.h"

namespace velum::session {

namespace {

constexpr int kMostCells = 192;
constexpr double kOpening = 6.0;  ///< Millimetres.
constexpr double kRegrowthOfOpening = 2.5;  ///< How far thin parts grow back.
constexpr double kTwoKinds = 0.8;  ///< Share of the variance between two classes that are no single bell.
constexpr int kKeptEdge = 1;              ///< Cells around the body that stay as they are.
constexpr double kAirBelowHu = -300.0;    ///< Air, cushions and lungs are below, tissue is above.
constexpr double kHounsfieldAir = -500.0; ///< A CT that reaches down to it is in Hounsfield units.

/// A coarse grid of yes and no. [z][y][x]
struct Grid {
  glm::ivec3 dims{0};
  std::vector<std::uint8_t> cells;
  std::size_t at(int x, int y, int z) const {
    return (std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x) + std::size_t(x);
  }
};

/// A threshold between two classes of bins, and how well it parts them.
struct Parting {
  std::size_t bin = 0;  ///< The first one above.
  double share = 0.0;   ///< Of the variance that lies between the classes; 0.64 where a bell is cut in two.
};

/// Between the two classes of the first `end` bins that differ most from each other (Otsu 1979).
Parting part(const std::vector<std::uint64_t>& counts, std::size_t end) {
  double all = 0, sum = 0, squares = 0;
  for (std::size_t i = 0; i < end; ++i) {
    double count = double(counts[i]), place = double(i);
    all += count;
    sum += place * count;
    squares += place * place * count;
  }
  double below = 0, sumBelow = 0, best = 0, variance = all > 0 ? squares / all - sum * sum / (all * all) : 0;
  Parting found;
  for (std::size_t i = 0; i + 1 < end; ++i) {
    below += double(counts[i]);
    sumBelow += double(i) * double(counts[i]);
    if (below <= 0 || below >= all) continue;
    double apart = sumBelow / below - (sum - sumBelow) / (all - below);
    double between = below * (all - below) * apart * apart / (all * all);
    if (between <= best) continue;
    best = between;
    found = {i + 1, variance > 0 ? between / variance : 0.0};
  }
  return found;
}

/// Above air. What is most unlike the rest may be bone and contrast before everything else: then what is below parts
/// once more.
double thresholdOf(const Volume& volume) {
  if (volume.modality == Modality::CT && volume.range.x < kHounsfieldAir) return kAirBelowHu;
  Histogram histogram = computeHistogram(volume, 512);
  Parting found = part(histogram.counts, histogram.counts.size());
  if (Parting lower = part(histogram.counts, found.bin); lower.share > kTwoKinds) found = lower;
  double width = histogram.range.y - histogram.range.x;
  return histogram.range.x + width * double(found.bin) / double(histogram.counts.size());
}

/// Voxels along an edge of a cell.
glm::ivec3 cellOf(const Volume& volume) {
  glm::dvec3 spacing = spacingOf(volume), extent = spacing * glm::dvec3(volume.dims);
  double edge = std::max({extent.x, extent.y, extent.z}) / kMostCells;
  return glm::max(glm::ivec3(1), glm::ivec3(glm::ceil(glm::dvec3(edge) / spacing - 1e-9)));
}

/// Cells whose mean is above a value, in the volume's own unit.
Grid cellsAbove(const Volume& volume, glm::ivec3 cell, double threshold) {
  Grid grid;
  grid.dims = (volume.dims + cell - 1) / cell;
  grid.cells.resize(std::size_t(grid.dims.x) * std::size_t(grid.dims.y) * std::size_t(grid.dims.z));
  double raw = (threshold - volume.offset) / volume.scale;
  bool flips = volume.scale < 0;
  visitSamples(volume, [&](auto* samples) {
    parallelFor(0, grid.dims.z, [&](int z) {
      for (int y = 0; y < grid.dims.y; ++y)
        for (int x = 0; x < grid.dims.x; ++x) {
          glm::ivec3 from = glm::ivec3(x, y, z) * cell, to = glm::min(from + cell, volume.dims);
          double sum = 0;
          for (int k = from.z; k < to.z; ++k)
            for (int j = from.y; j < to.y; ++j) {
              auto* row = samples + (std::size_t(k) * std::size_t(volume.dims.y) + std::size_t(j)) *
                                        std::size_t(volume.dims.x);
              for (int i = from.x; i < to.x; ++i) sum += double(row[i]);
            }
          double mean = sum / double((to.x - from.x) * (to.y - from.y) * (to.z - from.z));
          grid.cells[grid.at(x, y, z)] = flips ? mean < raw : mean > raw;
        }
    });
  });
  return grid;
}

/// Least (erosion) or greatest (dilation) of a box around each cell. Beyond the grid it goes on as at its border.
Grid spread(const Grid& grid, glm::ivec3 radius, bool grows) {
  Grid from = grid, to = grid;
  for (int axis = 0; axis < 3; ++axis) {
    if (radius[axis] == 0) continue;
    parallelFor(0, grid.dims.z, [&](int z) {
      for (int y = 0; y < grid.dims.y; ++y)
        for (int x = 0; x < grid.dims.x; ++x) {
          glm::ivec3 place(x, y, z), other = place;
          std::uint8_t found = !grows;
          for (int d = -radius[axis]; d <= radius[axis]; ++d) {
            other[axis] = std::clamp(place[axis] + d, 0, grid.dims[axis] - 1);
            std::uint8_t cell = from.cells[from.at(other.x, other.y, other.z)];
            found = grows ? found | cell : found & cell;
          }
          to.cells[to.at(x, y, z)] = found;
        }
    });
    from = to;
  }
  return to;
}

/// The cells that hang together with one by their faces. @param seen  marks them
std::vector<std::size_t> pieceAt(const Grid& grid, std::size_t first, std::vector<std::uint8_t>& seen) {
  std::vector<std::size_t> piece{first};
  seen[first] = 1;
  std::size_t row = std::size_t(grid.dims.x), plane = row * std::size_t(grid.dims.y);
  for (std::size_t i = 0; i < piece.size(); ++i) {
    std::size_t at = piece[i], x = at % row, y = at / row % std::size_t(grid.dims.y), z = at / plane;
    auto visit = [&](bool isInside, std::size_t other) {
      if (!isInside || seen[other] || !grid.cells[other]) return;
      seen[other] = 1;
      piece.push_back(other);
    };
    visit(x > 0, at - 1);
    visit(x + 1 < row, at + 1);
    visit(y > 0, at - row);
    visit(y + 1 < std::size_t(grid.dims.y), at + row);
    visit(z > 0, at - plane);
    visit(z + 1 < std::size_t(grid.dims.z), at + plane);
  }
  return piece;
}

Grid largestPiece(const Grid& grid) {
  std::vector<std::uint8_t> seen(grid.cells.size());
  std::vector<std::size_t> largest;
  for (std::size_t i = 0; i < grid.cells.size(); ++i)
    if (grid.cells[i] && !seen[i])
      if (auto piece = pieceAt(grid, i, seen); piece.size() > largest.size()) largest = std::move(piece);
  Grid out{grid.dims, std::vector<std::uint8_t>(grid.cells.size())};
  for (std::size_t i : largest) out.cells[i] = 1;
  return out;
}

void keepBoth(Grid& grid, const Grid& other) {
  for (std::size_t i = 0; i < grid.cells.size(); ++i) grid.cells[i] &= other.cells[i];
}

/// What the outside of a plane does not reach from the plane's border.
void fillPlanes(Grid& grid) {
  std::size_t plane = std::size_t(grid.dims.x) * std::size_t(grid.dims.y);
  parallelFor(0, grid.dims.z, [&](int z) {
    Grid outside{{grid.dims.x, grid.dims.y, 1}, std::vector<std::uint8_t>(plane)};
    std::uint8_t* cells = grid.cells.data() + plane * std::size_t(z);
    for (std::size_t i = 0; i < plane; ++i) outside.cells[i] = !cells[i];
    std::vector<std::uint8_t> reached(plane);
    auto start = [&](int x, int y) {
      std::size_t i = outside.at(x, y, 0);
      if (outside.cells[i] && !reached[i]) pieceAt(outside, i, reached);
    };
    for (int x = 0; x < grid.dims.x; ++x)
      for (int y : {0, grid.dims.y - 1}) start(x, y);
    for (int y = 0; y < grid.dims.y; ++y)
      for (int x : {0, grid.dims.x - 1}) start(x, y);
    for (std::size_t i = 0; i < plane; ++i) cells[i] = !reached[i];
  });
}

/// Thin shells go first, as those of hollow tables, so that what is filled then is the body's alone; ears and noses
/// that went with them grow back along what is tissue.
Grid bodyOf(const Grid& tissue, glm::ivec3 opening, int regrowth) {
  Grid solid = spread(spread(tissue, glm::ivec3(1), false), glm::ivec3(1), true);
  keepBoth(solid, tissue);
  fillPlanes(solid);
  Grid body = largestPiece(spread(solid, opening, false));
  Grid allowed = solid;
  for (std::size_t i = 0; i < allowed.cells.size(); ++i) allowed.cells[i] |= tissue.cells[i];
  body = spread(body, opening + 1, true);
  keepBoth(body, allowed);
  for (int i = 0; i < regrowth; ++i) {
    body = spread(body, glm::ivec3(1), true);
    keepBoth(body, allowed);
  }
  return body;
}

/// Sums over what is outside of the body.
struct Outside {
  double airSum = 0, airCount = 0, otherCount = 0;
};

template <class T>
Outside measureOutside(const Volume& volume, const T* samples, const Grid& body, glm::ivec3 cell, double threshold) {
  std::vector<Outside> planes(std::size_t(volume.dims.z));
  parallelFor(0, volume.dims.z, [&](int z) {
    Outside& here = planes[std::size_t(z)];
    const T* row = samples + std::size_t(z) * std::size_t(volume.dims.x) * std::size_t(volume.dims.y);
    for (int y = 0; y < volume.dims.y; ++y, row += volume.dims.x)
      for (int x = 0; x < volume.dims.x; ++x) {
        if (body.cells[body.at(x / cell.x, y / cell.y, z / cell.z)]) continue;
        double value = double(row[x]) * volume.scale + volume.offset;
        if (!(value < threshold)) {
          here.otherCount += 1;
          continue;
        }
        here.airSum += double(row[x]);
        here.airCount += 1;
      }
  });
  Outside all;
  for (const Outside& plane : planes) {
    all.airSum += plane.airSum;
    all.airCount += plane.airCount;
    all.otherCount += plane.otherCount;
  }
  return all;
}

template <class T>
void clearOutside(Volume& volume, T* samples, const Grid& body, glm::ivec3 cell, double air) {
  T value = std::is_integral_v<T> ? T(std::lround(air)) : T(air);
  parallelFor(0, volume.dims.z * volume.timeSteps, [&](int plane) {
    int z = plane % volume.dims.z;
    T* row = samples + std::size_t(plane) * std::size_t(volume.dims.x) * std::size_t(volume.dims.y);
    for (int y = 0; y < volume.dims.y; ++y, row += volume.dims.x)
      for (int x = 0; x < volume.dims.x; ++x)
        if (!body.cells[body.at(x / cell.x, y / cell.y, z / cell.z)]) row[x] = value;
  });
}

}  // namespace

Body findBody(const Volume& volume, Progress& progress) {
  if (volume.channels != 1) throw InputError("the table is known in volumes of one channel only");
  progress.report(0.0, "Finding the body");
  double threshold = thresholdOf(volume);
  glm::ivec3 cell = cellOf(volume);
  Grid tissue = cellsAbove(volume, cell, threshold);
  progress.report(0.4, "Finding the body");
  glm::dvec3 edge = spacingOf(volume) * glm::dvec3(cell) * millimetresPer(volume.lengthUnit);
  // Of specimens a twentieth of the whole is as thin as a table is beside a patient.
  glm::dvec3 extent = spacingOf(volume) * glm::dvec3(volume.dims) * millimetresPer(volume.lengthUnit);
  double opening = std::min(kOpening, std::max({extent.x, extent.y, extent.z}) / 50.0);
  Grid body = bodyOf(tissue, glm::ivec3(glm::round(glm::dvec3(opening) / edge)),
                     int(std::ceil(kRegrowthOfOpening * opening / std::min({edge.x, edge.y, edge.z}))));
  if (std::find(body.cells.begin(), body.cells.end(), 1) == body.cells.end())
    throw InputError("no body stands out from the air of this volume");
  body = spread(body, glm::ivec3(kKeptEdge), true);
  progress.report(0.6, "Finding the body");
  Body out{volume, 0.0};
  visitSamples(volume, [&](auto* samples) {
    using T = std::remove_cvref_t<decltype(*samples)>;
    Outside outside = measureOutside(volume, samples, body, cell, threshold);
    glm::dvec3 spacing = spacingOf(volume);
    out.removedVolume = outside.otherCount * spacing.x * spacing.y * spacing.z;
    double least = (volume.range.x - volume.offset) / volume.scale;
    double air = outside.airCount > 0 ? outside.airSum / outside.airCount : least;
    clearOutside(out.volume, reinterpret_cast<T*>(out.volume.voxels.data()), body, cell, air);
  });
  computeRange(out.volume);
  progress.report(1.0, "Found the body");
  return out;
}

double settleBody(scene::Scene& scene, Progress& progress) {
  scene::VolumeLayer& layer = scene.volume;
  if (!layer.data || layer.bodyOnly == bool(layer.given)) return 0.0;
  if (!layer.bodyOnly) {
    layer.data = std::exchange(layer.given, {});
    return 0.0;
  }
  Body body = findBody(*layer.data, progress);
  layer.given = layer.data;
  layer.data = Shared<Volume>(std::move(body.volume));
  return body.removedVolume;
}

}  // namespace velum::session
