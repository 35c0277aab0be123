#include "session/document/Body.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <type_traits>
#include <utility>

#include "core/Error.h"
#include "core/Parallel.h"
#include "scene/Scene.h"

namespace velum::session {

namespace {

constexpr int kMostCells = 192;
constexpr double kOpening = 6.0;        ///< Millimetres.
constexpr double kBridge = 0.02;        ///< Of a piece's cells, by which it may touch the body and not be part of it.
constexpr double kLeastBody = 0.6;      ///< Of all tissue: less is no body with something beside it.
constexpr double kTwoKinds = 0.8;       ///< Share of the variance between two classes that are no single bell.
constexpr int kKeptEdge = 1;            ///< Cells around the body that stay as they are.
constexpr double kAirBelowHu = -300.0;  ///< Air, cushions and lungs are below, tissue is above.
constexpr double kHounsfieldAir = -500.0;  ///< A CT that reaches down to it is in Hounsfield units.

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
              auto* row =
                  samples + (std::size_t(k) * std::size_t(volume.dims.y) + std::size_t(j)) * std::size_t(volume.dims.x);
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

/// Calls visit(cell) for those that share a face with one.
template <class Visit>
void eachNeighbour(const Grid& grid, std::size_t at, const Visit& visit) {
  std::size_t row = std::size_t(grid.dims.x), plane = row * std::size_t(grid.dims.y);
  std::size_t x = at % row, y = at / row % std::size_t(grid.dims.y), z = at / plane;
  if (x > 0) visit(at - 1);
  if (x + 1 < row) visit(at + 1);
  if (y > 0) visit(at - row);
  if (y + 1 < std::size_t(grid.dims.y)) visit(at + row);
  if (z > 0) visit(at - plane);
  if (z + 1 < std::size_t(grid.dims.z)) visit(at + plane);
}

/// The cells that hang together with one by their faces. @param seen  marks them
std::vector<std::size_t> pieceAt(const Grid& grid, std::size_t first, std::vector<std::uint8_t>& seen) {
  std::vector<std::size_t> piece{first};
  seen[first] = 1;
  for (std::size_t i = 0; i < piece.size(); ++i)
    eachNeighbour(grid, piece[i], [&](std::size_t other) {
      if (seen[other] || !grid.cells[other]) return;
      seen[other] = 1;
      piece.push_back(other);
    });
  return piece;
}

/// The pieces of a grid by number, from 1; the largest is 1.
std::vector<std::uint32_t> piecesOf(const Grid& grid) {
  std::vector<std::uint8_t> seen(grid.cells.size());
  std::vector<std::uint32_t> pieces(grid.cells.size());
  std::size_t largest = 0;
  std::uint32_t count = 1, first = 0;
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (!grid.cells[i] || seen[i]) continue;
    auto piece = pieceAt(grid, i, seen);
    ++count;
    if (piece.size() > largest) {
      largest = piece.size();
      first = count;
    }
    for (std::size_t cell : piece) pieces[cell] = count;
  }
  for (std::uint32_t& piece : pieces)
    if (piece == first && first != 0) piece = 1;
  return pieces;
}

/// Lets pieces grow along cells, layer by layer and all at once, until they meet: each cell is that piece's which is
/// nearest along what is there.
void growAlong(std::vector<std::uint32_t>& pieces, const Grid& grid) {
  std::vector<std::size_t> front, next;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (pieces[i]) front.push_back(i);
  for (; !front.empty(); front.swap(next), next.clear())
    for (std::size_t at : front)
      eachNeighbour(grid, at, [&](std::size_t other) {
        if (pieces[other] || !grid.cells[other]) return;
        pieces[other] = pieces[at];
        next.push_back(other);
      });
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

/// Joins pieces to the first one, and to what is joined to it, that touch it along more than a bridge: a shell of bone
/// falls apart where it is thin, and is one nevertheless.
void joinTouching(std::vector<std::uint32_t>& pieces, const Grid& grid) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> contacts;
  std::map<std::uint32_t, std::size_t> sizes;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i]) continue;
    ++sizes[pieces[i]];
    eachNeighbour(grid, i, [&](std::size_t other) {
      // Each pair once.
      if (other > i && pieces[other] && pieces[other] != pieces[i]) ++contacts[std::minmax(pieces[i], pieces[other])];
    });
  }
  std::set<std::uint32_t> joined{1};
  for (bool goesOn = true; goesOn;) {
    goesOn = false;
    for (const auto& [pair, count] : contacts) {
      bool hasFirst = joined.contains(pair.first), hasSecond = joined.contains(pair.second);
      std::uint32_t other = hasFirst ? pair.second : pair.first;
      if (hasFirst == hasSecond || double(count) < kBridge * double(sizes[other])) continue;
      joined.insert(other);
      goesOn = true;
    }
  }
  for (std::uint32_t& piece : pieces)
    if (joined.contains(piece)) piece = 1;
}

/// Thin shells go first, as those of hollow tables, so that what is filled then is the body's alone. What an opening
/// parts are pieces; what it takes away, as ears, belongs to the piece that is nearest along tissue.
Grid bodyOf(const Grid& tissue, glm::ivec3 opening) {
  Grid solid = spread(spread(tissue, glm::ivec3(1), false), glm::ivec3(1), true);
  keepBoth(solid, tissue);
  fillPlanes(solid);
  auto pieces = piecesOf(spread(solid, opening, false));
  for (std::size_t i = 0; i < solid.cells.size(); ++i) solid.cells[i] |= tissue.cells[i];
  growAlong(pieces, solid);
  joinTouching(pieces, solid);
  Grid body{tissue.dims, std::vector<std::uint8_t>(tissue.cells.size())};
  for (std::size_t i = 0; i < pieces.size(); ++i) body.cells[i] = pieces[i] == 1;
  return body;
}

/// Of all tissue.
double shareOf(const Grid& body, const Grid& tissue) {
  double all = 0, inside = 0;
  for (std::size_t i = 0; i < tissue.cells.size(); ++i) {
    all += tissue.cells[i];
    inside += tissue.cells[i] && body.cells[i];
  }
  return all > 0 ? inside / all : 0.0;
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
  if (volume.channels != 1 || volume.finer) throw InputError("the table is known in whole volumes of one channel only");
  progress.report(0.0, "Finding the body");
  double threshold = thresholdOf(volume);
  glm::ivec3 cell = cellOf(volume);
  Grid tissue = cellsAbove(volume, cell, threshold);
  progress.report(0.4, "Finding the body");
  glm::dvec3 edge = spacingOf(volume) * glm::dvec3(cell) * millimetresPer(volume.lengthUnit);
  // Of specimens a twentieth of the whole is as thin as a table is beside a patient.
  glm::dvec3 extent = spacingOf(volume) * glm::dvec3(volume.dims) * millimetresPer(volume.lengthUnit);
  double opening = std::min(kOpening, std::max({extent.x, extent.y, extent.z}) / 50.0);
  Grid body = bodyOf(tissue, glm::ivec3(glm::round(glm::dvec3(opening) / edge)));
  if (shareOf(body, tissue) < kLeastBody) throw InputError("no single body stands out from the air of this volume");
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

bool bodyFits(const scene::Scene& scene) {
  const scene::VolumeLayer& layer = scene.volume;
  return !layer.data || layer.bodyOnly == bool(layer.given);
}

double settleBody(scene::Scene& scene, Progress& progress) {
  if (bodyFits(scene)) return 0.0;
  scene::VolumeLayer& layer = scene.volume;
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
