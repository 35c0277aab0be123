#include "vector/TraceHatching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "core/Assert.h"
#include "core/Parallel.h"
#include "vector/FitCurves.h"
#include "vector/HatchField.h"
#include "vector/Strokes.h"

namespace velum::vector {

namespace {

constexpr double kPerSpacing = 5.0;   // places that are asked from stroke to stroke, a pixel apart at least
constexpr double kMostAcross = 0.6;   // cosine: what goes on across the strokes is none, but where two of them meet
constexpr double kLeastLength = 2.0;  // of a stroke, in spacings
constexpr double kLeastWidth = 0.06;  // where a stroke ends, as a share of the spacing

/// The waves at places on a lattice.
struct WaveGrid {
  double apart = 1.0;  // pixels
  glm::ivec2 count{0};
  struct Wave {
    glm::vec2 across{0.0f};  // 0: nothing is near
    glm::vec2 phase{0.0f};
  };
  std::vector<Wave> waves;
  const Wave& at(int x, int y) const { return waves[std::size_t(y) * std::size_t(count.x) + std::size_t(x)]; }
};

WaveGrid waveGrid(const HatchField& field, const SurfaceMap& map, double apart) {
  WaveGrid grid{apart, glm::ivec2(glm::dvec2(map.size) / apart) + 2, {}};
  grid.waves.resize(std::size_t(grid.count.x) * std::size_t(grid.count.y));
  auto isThere = [&](glm::dvec2 place) {
    glm::ivec2 p = glm::clamp(glm::ivec2(glm::floor(place)), glm::ivec2(0), map.size - 1);
    return map.ids[std::size_t(p.y) * std::size_t(map.size.x) + std::size_t(p.x)] > 0;
  };
  parallelFor(0, grid.count.y, [&](int y) {
    for (int x = 0; x < grid.count.x; ++x) {
      glm::dvec2 place = apart * glm::dvec2(x, y);
      bool isNear = false;
      for (int i = 0; i < 9 && !isNear; ++i) isNear = isThere(place + apart * glm::dvec2(i % 3 - 1, i / 3 - 1));
      if (!isNear) continue;
      HatchField::Phases phases = field.at(place);
      grid.waves[std::size_t(y) * std::size_t(grid.count.x) + std::size_t(x)] = {glm::vec2(phases.across),
                                                                                 glm::vec2(phases.phase)};
    }
  });
  return grid;
}

/// The middles of strokes of a family: lines of points, in the order in which they follow each other.
class Middles {
 public:
  Middles(const WaveGrid& grid, int family) : mGrid(grid), mFamily(family) {
    for (int y = 0; y + 1 < grid.count.y; ++y)
      for (int x = 0; x + 1 < grid.count.x; ++x) square(x, y);
  }

  std::vector<std::vector<glm::dvec2>> lines() {
    std::vector<std::vector<glm::dvec2>> found;
    std::vector<bool> isDone(mPoints.size());
    auto follow = [&](int from) {
      std::vector<glm::dvec2> line;
      for (int at = from; at >= 0 && !isDone[std::size_t(at)];) {
        isDone[std::size_t(at)] = true;
        line.push_back(mPoints[std::size_t(at)].place);
        auto next = mPoints[std::size_t(at)].next;
        at = next[0] >= 0 && !isDone[std::size_t(next[0])] ? next[0] : next[1];
      }
      if (line.size() > 3) found.push_back(std::move(line));
    };
    for (bool isEnd : {true, false})
      for (int i = 0; i < int(mPoints.size()); ++i)
        if (!isDone[std::size_t(i)] && (!isEnd || mPoints[std::size_t(i)].next[1] < 0)) follow(i);
    return found;
  }

 private:
  struct Point {
    glm::dvec2 place;
    std::array<int, 2> next{-1, -1};
  };
  /// The point in which a stroke crosses the edge of a square from a place along an axis; -1: none.
  int crossing(int x, int y, int axis) {
    const WaveGrid::Wave &a = mGrid.at(x, y), &b = mGrid.at(x + 1 - axis, y + axis);
    if (a.across == glm::vec2(0.0f) || b.across == glm::vec2(0.0f)) return -1;
    double own = double(a.phase[mFamily]), other = double(b.phase[mFamily]);
    if (glm::dot(a.across, b.across) < 0.0f) other = -other;
    if ((own < 0.0) == (other < 0.0) || std::abs(own - other) > 3.0) return -1;
    long long key = (static_cast<long long>(y) * mGrid.count.x + x) * 2 + axis;
    auto [at, isNew] = mPointOf.try_emplace(key, int(mPoints.size()));
    if (isNew) {
      glm::dvec2 place(x, y);
      place[axis] += own / (own - other);
      mPoints.push_back({mGrid.apart * place, {-1, -1}});
    }
    return at->second;
  }

  void link(int a, int b, glm::dvec2 across) {
    glm::dvec2 way = mPoints[std::size_t(b)].place - mPoints[std::size_t(a)].place;
    if (std::abs(glm::dot(way, across)) > kMostAcross * glm::length(way)) return;
    for (auto [own, other] : {std::pair(a, b), std::pair(b, a)}) {
      auto& next = mPoints[std::size_t(own)].next;
      (next[0] < 0 ? next[0] : next[1]) = other;
    }
  }

  void square(int x, int y) {
    std::array<int, 4> edges{crossing(x, y, 0), crossing(x + 1, y, 1), crossing(x, y + 1, 0), crossing(x, y, 1)};
    std::array<int, 4> crossed{};
    std::size_t count = 0;
    for (int point : edges)
      if (point >= 0) crossed[count++] = point;
    glm::dvec2 across(mGrid.at(x, y).across);
    if (mFamily == 1) across = glm::dvec2(across.y, -across.x);
    if (count >= 2) link(crossed[0], crossed[1], across);
    if (count == 4) link(crossed[2], crossed[3], across);
  }

  const WaveGrid& mGrid;
  int mFamily;
  std::vector<Point> mPoints;
  std::unordered_map<long long, int> mPointOf;
};

/// What a place on a stroke's middle is like.
struct Pressed {
  glm::dvec2 place;
  double width;  // share of the spacing
  int id;
};

/// Lines as places a pixel apart, with their widths.
class Presser {
 public:
  Presser(const SurfaceMap& map, std::span<const float> tones) : mMap(map), mTones(tones) {}

  std::vector<Pressed> along(const std::vector<glm::dvec2>& line, int family) const {
    std::vector<Pressed> out;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      int steps = std::max(1, int(std::ceil(glm::distance(line[i], line[i + 1]))));
      for (int k = 0; k < steps; ++k) out.push_back(at(glm::mix(line[i], line[i + 1], double(k) / steps), family));
    }
    out.push_back(at(line.back(), family));
    return out;
  }

 private:
  Pressed at(glm::dvec2 place, int family) const {
    glm::ivec2 p = glm::clamp(glm::ivec2(glm::floor(place)), glm::ivec2(0), mMap.size - 1);
    std::size_t i = std::size_t(p.y) * std::size_t(mMap.size.x) + std::size_t(p.x);
    int id = std::max(mMap.ids[i], 0);
    double darkness = 1.0 - std::clamp(double(mTones[i]), 0.0, 1.0);
    return {place, id > 0 ? strokeWidths(place, darkness, 1000.0 / mMap.size.y)[family] : 0.0, id};
  }

  const SurfaceMap& mMap;
  std::span<const float> mTones;
};

/// A hand changes its pressure slowly: means over a way on either side, within a region.
void calmWidths(std::vector<Pressed>& line, int reach) {
  std::vector<double> sums{0.0};
  for (const Pressed& pressed : line) sums.push_back(sums.back() + pressed.width);
  for (std::size_t i = 0; i < line.size(); ++i) {
    std::size_t low = i, high = i;
    while (low > 0 && int(i - low) < reach && line[low - 1].id == line[i].id) --low;
    while (high + 1 < line.size() && int(high - i) < reach && line[high + 1].id == line[i].id) ++high;
    line[i].width = (sums[high + 1] - sums[low]) / double(high + 1 - low);
  }
}

/// What is left of a line when its round ends are to lie where it ended.
std::span<const Pressed> withoutEnds(std::span<const Pressed> line, double spacing) {
  if (line.empty()) return line;
  auto first = std::size_t(0.5 * spacing * line.front().width), last = std::size_t(0.5 * spacing * line.back().width);
  return first + last + 1 < line.size() ? line.subspan(first, line.size() - first - last) : line.first(0);
}

/// Appends the stroke along places that are pressed.
void appendStroke(std::span<const Pressed> line, double spacing, std::vector<Stroke>& strokes) {
  auto stride = std::size_t(std::max(1.0, spacing / kPerSpacing));
  Track track;
  for (std::size_t i = 0; i < line.size(); i += stride) track.points.push_back(line[i].place);
  track.fence.push_back(line.front().place);
  for (std::size_t i = 1; i < track.points.size(); ++i)
    track.fence.push_back(0.5 * (track.points[i - 1] + track.points[i]));
  track.fence.push_back(line.back().place);
  double near = std::max(0.4, 0.05 * spacing);
  Nearness nearness{near, 2.0 * near, near};
  Outline fitted = fitCurves(track, {line.front().place, {}}, {line.back().place, {}}, nearness);
  std::size_t at = 0;
  auto pressureAt = [&](glm::dvec2 place, glm::dvec2) {
    auto off = [&](std::size_t i) { return glm::distance(line[i].place, place); };
    while (at + 1 < line.size() && off(at + 1) <= off(at)) ++at;
    return Pressure{line[at].width, line.front().id};
  };
  appendStrokes(fitted, 0.5 * spacing, pressureAt, strokes);
}

}  // namespace

std::vector<Stroke> traceHatching(const SurfaceMap& map, const View& view, std::span<const float> tones,
                                  const HatchOptions& options, Progress& progress) {
  VELUM_ASSERT(tones.size() == map.ids.size(), "a pixel has a tone");
  progress.report(0.0, "hatching");
  double spacing = std::max(2.0, options.spacing);
  HatchField field(map, seenPixels(map, view), spacing);
  WaveGrid grid = waveGrid(field, map, std::max(1.0, spacing / kPerSpacing));
  Presser presser(map, tones);
  std::vector<Stroke> strokes;
  for (int family = 0; family < (options.crosses ? 2 : 1); ++family) {
    progress.report(0.3 + 0.35 * family, "hatching");
    for (const auto& middle : Middles(grid, family).lines()) {
      std::vector<Pressed> line = presser.along(middle, family);
      calmWidths(line, int(spacing));
      for (std::size_t i = 0; i < line.size();) {
        std::size_t end = i;
        while (end < line.size() && line[end].id == line[i].id && line[end].width > kLeastWidth) ++end;
        auto pressed = withoutEnds(std::span(line).subspan(i, end - i), spacing);
        if (double(pressed.size()) >= kLeastLength * spacing) appendStroke(pressed, spacing, strokes);
        i = std::max(end, i + 1);
      }
    }
    progress.throwIfCancelled();
  }
  progress.report(1.0, "hatching");
  return strokes;
}

}  // namespace velum::vector
