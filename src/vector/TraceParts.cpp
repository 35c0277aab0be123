#include "vector/TraceParts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/Assert.h"
#include "core/Parallel.h"
#include "vector/Strokes.h"
#include "vector/TraceRegions.h"

namespace velum::vector {

namespace {

// As in shaders/shared/finish.h and shaders/render/edges_model.glsl.
constexpr double kStrongLine = kWidestPartLine, kFineLine = 0.85, kLineCircle = 0.606;
constexpr double kFullShare = 3.0;
constexpr double kNoLine = 6.0, kFullLine = 16.0;
constexpr double kMostPen = 0.035, kFinestPen = 0.65;
constexpr double kNoneWithin = 25.0, kFullWithin = 55.0, kFaint = 0.27;
constexpr double kLeastOutline = 0.5, kLeastBorder = 0.7;
constexpr int kPlaces = 12;

constexpr double kUnseen = 0.02;  // of a line's darkness
constexpr double kRows = 1000.0;

/// Regions that are smaller have no outlines of their own, pixels.
double leastAreaOf(glm::ivec2 size) { return std::clamp(12.0 * size.y * size.y / (4.0 * kRows * kRows), 3.0, 12.0); }

double riseOf(double low, double high, double x) {
  double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}
double shownOf(double size) { return riseOf(kNoLine, kFullLine, size); }

/// The band of a line: how much ink it has, as the width of a line that is all dark, and where its middle is.
struct Band {
  double ink = 0.0;  // pixels
  double off = 0.0;  // of its middle to the right of the border, pixels
  int id = 0;        // whose it is
};

/// Which ids borders are traced of: parts that have no lines of their own are one in each compartment.
struct JoinedParts {
  std::vector<int> ids;     // of pixels
  std::vector<int> firsts;  // by id - 1: a part that it stands for
};

JoinedParts joinSmall(const PartMap& map) {
  std::vector<float> sizes(map.groups.size());
  for (std::size_t i = 0; i < map.ids.size(); ++i)
    if (map.ids[i] > 0) {
      float& size = sizes[std::size_t(map.ids[i]) - 1];
      size = std::max(size, map.sizes[i]);
    }
  JoinedParts joined;
  std::map<int, int> smallOf;  // by compartment
  std::vector<int> idOf(sizes.size());
  for (std::size_t part = 0; part < sizes.size(); ++part) {
    int next = int(joined.firsts.size()) + 1;
    idOf[part] = next;
    if (shownOf(double(sizes[part])) < kUnseen) idOf[part] = smallOf.try_emplace(map.groups[part], next).first->second;
    if (idOf[part] == next) joined.firsts.push_back(int(part) + 1);
  }
  for (int id : map.ids) joined.ids.push_back(id > 0 ? idOf[std::size_t(id) - 1] : 0);
  return joined;
}

/// The formulas of the shader, with the names that it has.
class PartEdges {
 public:
  PartEdges(const PartMap& map, const JoinedParts& joined, const PartOptions& options)
      : mMap(map), mJoined(joined), mOptions(options), mUnits(std::min(1.0, kRows / map.size.y)) {}

  double penOf(double size) const {
    double most = std::max(kFinestPen, kMostPen * size) / (mOptions.contours * mUnits);
    return size > 0.0 ? std::min(mOptions.width, most) : mOptions.width;
  }

  /// The band at a place of a border. @param way  unit
  Band bandAt(glm::dvec2 place, glm::dvec2 way) const {
    glm::dvec2 toRight(-way.y, way.x);
    // A border that is smooth may lie a little beside that of the pixels.
    for (double off : {0.6, 1.1, 1.7}) {
      Seen left = at(place - off * toRight), right = at(place + off * toRight);
      if (left.id == right.id) continue;
      double wide = 0.5 * kStrongLine * kLineCircle * mOptions.width;
      Seen farLeft = at(place - (off + wide) * toRight), farRight = at(place + (off + wide) * toRight);
      double deep = deepOf(left, right);
      if (farLeft.id == left.id && farRight.id == right.id) deep = 0.5 * (deep + deepOf(farLeft, farRight));
      return bandBetween(left, right, deep);
    }
    return {};
  }

  /// How much a pixel is a fold's: where the depth falls on one side of it alone.
  double foldAt(glm::ivec2 pixel) const {
    Seen own = at(pixel);
    if (own.id < 1 || own.size <= kNoneWithin) return 0.0;
    double radius = kFineLine * kLineCircle * penOf(own.size), folds = 0.0;
    radius *= std::min(0.6 + 0.4 * radius, 1.0);
    for (int i = 0; i < kPlaces / 2; ++i) {
      double turn = 6.2831853 / kPlaces * i;
      glm::ivec2 way(glm::round(radius * glm::dvec2(std::cos(turn), std::sin(turn))));
      Seen a = at(pixel + way), b = at(pixel - way);
      if (a.id != own.id || b.id != own.id) continue;
      double before = std::abs(a.depth - own.depth), after = std::abs(b.depth - own.depth);
      double fall = std::max(before, after) - 3.0 * std::min(before, after);
      folds += riseOf(mOptions.stepLength, 2.0 * mOptions.stepLength, fall);
    }
    return std::min(1.0, kFullShare * folds / (0.5 * kPlaces));
  }

  double faintInk(glm::dvec2 place) const {
    double size = at(place).size;
    return kFaint * mOptions.steps * riseOf(kNoneWithin, kFullWithin, size) * kFineLine * penOf(size);
  }

 private:
  struct Seen {
    int id = 0, part = 0;
    double depth = 0.0, size = 0.0;
  };
  Seen at(glm::dvec2 place) const { return at(glm::ivec2(glm::floor(place))); }
  Seen at(glm::ivec2 p) const {
    p = glm::clamp(p, glm::ivec2(0), mMap.size - 1);
    std::size_t i = std::size_t(p.y) * std::size_t(mMap.size.x) + std::size_t(p.x);
    int id = mJoined.ids[i];
    return {id, mMap.ids[i], double(mMap.depths[i]), id > 0 ? double(mMap.sizes[i]) : 0.0};
  }
  int groupOf(const Seen& seen) const { return mMap.groups[std::size_t(seen.part) - 1]; }
  double deepOf(const Seen& a, const Seen& b) const {
    return riseOf(0.5 * mOptions.deepStep, 1.5 * mOptions.deepStep, std::abs(a.depth - b.depth));
  }

  Band bandBetween(const Seen& left, const Seen& right, double deep) const {
    bool isLeft = right.id < 1 || (left.id > 0 && left.depth < right.depth);
    const Seen& nearer = isLeft ? left : right;
    double shown = shownOf(nearer.size), strong, fine = 0.0, outline = glm::mix(kLeastOutline, 1.0, shown);
    if (left.id < 1 || right.id < 1) {
      strong = mOptions.steps * outline;
    } else {
      double least = groupOf(left) != groupOf(right) ? kLeastBorder * outline : 0.0;
      strong = std::max(mOptions.steps, mOptions.structures) * std::max(least, deep * shown);
      fine = mOptions.structures * shown;
    }
    if (std::max(strong, fine) < kUnseen) return {};
    // Where the fine line is darker than the strong one it lies within it.
    double ink = strong * kStrongLine + std::max(fine - strong, 0.0) * kFineLine;
    double toLeft = penOf(left.size), toRight = penOf(right.size);
    return {0.5 * ink * (toLeft + toRight), 0.25 * ink / std::max(strong, fine) * (toRight - toLeft),
            mJoined.firsts[std::size_t(nearer.id) - 1]};
  }

  const PartMap& mMap;
  const JoinedParts& mJoined;
  const PartOptions& mOptions;
  double mUnits;
};

void appendFolds(const PartMap& map, const PartEdges& edges, const PartOptions& options, double widest,
                 std::vector<Stroke>& strokes, Progress& progress) {
  std::vector<float> folds(map.ids.size());
  parallelFor(0, map.size.y, [&](int y) {
    for (int x = 0; x < map.size.x; ++x)
      folds[std::size_t(y) * std::size_t(map.size.x) + std::size_t(x)] = float(edges.foldAt({x, y}));
  });
  StepOptions bands;
  bands.width = kFineLine * options.width;
  for (const Stroke& fold : traceBands(map.size, map.ids, folds, bands, progress))
    appendStrokes(
        fold.line, options.width,
        [&](glm::dvec2 place, glm::dvec2) {
          return Pressure{fold.strength * edges.faintInk(place) / widest, fold.id};
        },
        strokes);
}

}  // namespace

std::vector<Stroke> traceParts(const PartMap& map, const PartOptions& options, Progress& progress) {
  std::size_t count = std::size_t(map.size.x) * std::size_t(map.size.y);
  VELUM_ASSERT(map.ids.size() == count && map.depths.size() == count && map.sizes.size() == count,
               "a pixel has an id, a depth and a size");
  if (count == 0) return {};
  JoinedParts joined = joinSmall(map);
  PartEdges edges(map, joined, options);
  RegionMap regions = traceRegions({map.size, joined.ids, {}}, {leastAreaOf(map.size)}, progress);
  double widest = kWidestPartLine * options.width;
  std::vector<Stroke> strokes;
  auto pressureAt = [&](glm::dvec2 place, glm::dvec2 way) {
    Band band = edges.bandAt(place, way);
    return Pressure{band.ink / widest, band.id};
  };
  for (const Border& border : regions.borders)
    if (border.left != kOutside && border.right != kOutside)
      appendStrokes(border.line, 2.0 * options.width, pressureAt, strokes);
  strokes = joinedStrokes(std::move(strokes));
  parallelFor(0, int(strokes.size()), [&](int i) {
    moveAcross(strokes[std::size_t(i)].line,
               [&](glm::dvec2 place, glm::dvec2 way) { return edges.bandAt(place, way).off; });
  });
  appendFolds(map, edges, options, widest, strokes, progress);
  return strokes;
}

}  // namespace velum::vector
