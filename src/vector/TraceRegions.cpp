#include "vector/TraceRegions.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/Assert.h"
#include "core/Parallel.h"
#include "vector/FitCurves.h"
#include "vector/Junctions.h"
#include "vector/PixelBorders.h"
#include "vector/Specks.h"

namespace velum::vector {

namespace {

// So far from the edge of its pixel may coverage move a border, pixels: farther off is what is seen through, and no
// border.
constexpr double kMostOff = 0.75;
constexpr double kHeld = 0.5;  // pixels

bool isEdge(const PixelBorder& border) { return border.left == kOutside || border.right == kOutside; }

/// Moves a track's points between a region and nothing by how much of the pixels across the border is covered: two to
/// each side, so that the sum is where the border crosses their row or column in the mean.
void followCoverage(const IdMap& map, const PixelBorder& border, Track& track) {
  if (map.coverage.empty() || isEdge(border) || (border.left > 0) == (border.right > 0)) return;
  auto indexAt = [&](glm::dvec2 place) {
    glm::ivec2 pixel = glm::clamp(glm::ivec2(glm::floor(place)), glm::ivec2(0), map.size - 1);
    return std::size_t(pixel.y) * std::size_t(map.size.x) + std::size_t(pixel.x);
  };
  for (std::size_t i = 0; i < track.points.size(); ++i) {
    glm::dvec2 way = track.fence[i + 1] - track.fence[i];
    glm::dvec2 toRight(-way.y, way.x), outwards = border.right > 0 ? -toRight : toRight;
    double off = -2.0;
    for (double across : {-1.5, -0.5, 0.5, 1.5}) {
      std::size_t pixel = indexAt(track.points[i] + across * outwards);
      bool isCovered = across < 0.0, isOwn = (map.ids[pixel] > 0) == isCovered;
      off += isOwn || std::abs(across) < 1.0 ? double(map.coverage[pixel]) : isCovered ? 1.0 : 0.0;
    }
    if (std::abs(off) < kMostOff) track.points[i] += off * outwards;
  }
}

/// A line of straight pieces: the edge of the picture.
Outline edgeLine(const PixelBorder& border, glm::dvec2 from, glm::dvec2 to) {
  std::vector<glm::dvec2> points{from};
  for (std::size_t i = 1; i + 1 < border.corners.size(); ++i)
    if (border.corners[i - 1] + border.corners[i + 1] != 2 * border.corners[i]) points.emplace_back(border.corners[i]);
  points.push_back(to);
  Outline line = outlineThrough(points, false);
  line.isClosed = border.isClosed();
  return line;
}

/// What is too small for anything else: through the middles of edges, with the corners as handles.
Outline roundLine(const Track& track) {
  constexpr double kRound = 0.55;
  std::size_t count = track.points.size();
  Outline line{track.points.front(), {}, true};
  for (std::size_t i = 0; i < count; ++i) {
    glm::dvec2 from = track.points[i], to = track.points[(i + 1) % count], corner = track.fence[i + 1];
    line.curves.push_back({glm::mix(from, corner, kRound), glm::mix(to, corner, kRound), to});
  }
  return line;
}

constexpr std::size_t kSmallest = 12;  // edges of pixels

/// @param held  see Nearness
Outline smoothLine(const PixelBorder& border, const Track& track, const PixelBorders& borders,
                   const std::vector<Junction>& junctions, double held) {
  Nearness nearness;
  nearness.held = held;
  if (border.isClosed()) {
    if (isEdge(border)) return edgeLine(border, track.fence.front(), track.fence.front());
    return track.points.size() < kSmallest ? roundLine(track) : fitClosedCurves(track, nearness);
  }
  auto endAt = [&](int node, glm::ivec2 next, double sign) {
    const Junction& junction = junctions[std::size_t(node)];
    int way = wayOf(borders.nodes[std::size_t(node)].corner, next);
    CurveEnd end{junction.place, junction.leaving[std::size_t(way)]};
    if (end.direction) *end.direction *= sign;
    return end;
  };
  CurveEnd from = endAt(border.startNode, border.corners[1], 1.0);
  CurveEnd to = endAt(border.endNode, border.corners[border.corners.size() - 2], -1.0);
  return isEdge(border) ? edgeLine(border, from.place, to.place) : fitCurves(track, from, to, nearness);
}

/// Appends a line to another one, which it goes on from. @param isBackwards  from its end to its start
void append(Outline& outline, const Outline& line, bool isBackwards) {
  if (!isBackwards) {
    if (outline.curves.empty()) outline.start = line.start;
    outline.curves.insert(outline.curves.end(), line.curves.begin(), line.curves.end());
    return;
  }
  if (outline.curves.empty()) outline.start = line.curves.back().end;
  for (std::size_t i = line.curves.size(); i-- > 0;) {
    const Curve& curve = line.curves[i];
    outline.curves.push_back({curve.control2, curve.control1, i > 0 ? line.curves[i - 1].end : line.start});
  }
}

/// The border that follows one around the region to its right: as far to the right as there is one.
int nextAround(const PixelBorders& borders, int leaving) {
  const PixelBorder& border = borders.borders[std::size_t(leaving / 2)];
  bool isBackwards = leaving % 2 == 1;
  const auto& corners = border.corners;
  int way = isBackwards ? wayOf(corners[1], corners[0]) : wayOf(corners[corners.size() - 2], corners.back());
  const BorderNode& node = borders.nodes[std::size_t(isBackwards ? border.startNode : border.endNode)];
  for (int turn : {1, 0, 3})
    if (int next = node.leaving[std::size_t((way + turn) % 4)]; next >= 0) return next;
  VELUM_ASSERT(false, "a node has three borders");
  return leaving;
}

/// The outlines of all regions, made of the borders.
std::map<int, Region> outlinesOf(const PixelBorders& borders, const std::vector<Border>& lines) {
  std::map<int, Region> regions;
  std::vector<bool> isDone(2 * lines.size());
  for (int first = 0; first < int(isDone.size()); ++first) {
    const Border& border = lines[std::size_t(first / 2)];
    int id = first % 2 == 0 ? border.right : border.left;
    if (id < 1 || isDone[std::size_t(first)]) continue;
    Outline outline{{}, {}, true};
    int at = first;
    do {
      isDone[std::size_t(at)] = true;
      append(outline, lines[std::size_t(at / 2)].line, at % 2 == 1);
      if (!borders.borders[std::size_t(at / 2)].isClosed()) at = nextAround(borders, at);
    } while (at != first);
    Region& region = regions[id];
    region.id = id;
    region.outlines.push_back(std::move(outline));
  }
  return regions;
}

}  // namespace

RegionMap traceRegions(const IdMap& map, const RegionOptions& options, Progress& progress) {
  auto count = std::size_t(map.size.x) * std::size_t(map.size.y);
  VELUM_ASSERT(map.ids.size() == count, "a pixel has an id");
  VELUM_ASSERT(map.coverage.empty() || map.coverage.size() == count, "each or no pixel has a coverage");
  if (count == 0) return {};
  progress.report(0.0, "tracing regions");
  std::vector<int> ids(map.ids.begin(), map.ids.end());
  for (int& id : ids) id = std::max(id, 0);
  absorbSpecks(map.size, ids, options.leastArea);
  progress.report(0.3, "tracing regions");
  PixelBorders borders = findPixelBorders({map.size, ids});
  progress.report(0.5, "tracing regions");
  std::vector<Track> tracks;
  for (const PixelBorder& border : borders.borders) {
    tracks.push_back(trackOf(border));
    followCoverage(map, border, tracks.back());
  }
  std::vector<Junction> junctions = placeJunctions(borders, tracks);
  double held = map.coverage.empty() ? kHeld : 0.0;  // what coverage moves is nearer to it than to the edges of pixels
  RegionMap out;
  out.borders.resize(tracks.size());
  parallelForRanges(std::size_t(0), tracks.size(), std::size_t(16), [&](std::size_t first, std::size_t end) {
    progress.throwIfCancelled();
    for (std::size_t i = first; i < end; ++i) {
      const PixelBorder& border = borders.borders[i];
      out.borders[i] = {smoothLine(border, tracks[i], borders, junctions, held), border.left, border.right};
    }
  });
  progress.report(0.9, "tracing regions");
  std::map<int, Region> regions = outlinesOf(borders, out.borders);
  for (int id : ids)
    if (id > 0) regions[id].area += 1.0;
  for (auto& [id, region] : regions) out.regions.push_back(std::move(region));
  progress.report(1.0, "tracing regions");
  return out;
}

}  // namespace velum::vector
