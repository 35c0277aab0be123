#include "vector/TraceSteps.h"

#include <algorithm>
#include <cmath>

#include "vector/FitCurves.h"
#include "vector/ThinLines.h"

namespace velum::vector {

namespace {

constexpr double kClasses = 4.0;  // of strength

/// The map of strengths, between pixels, too.
class Strengths {
 public:
  Strengths(glm::ivec2 size, const std::vector<float>& values) : mSize(size), mValues(values) {}
  double at(glm::dvec2 place) const {
    glm::dvec2 p = glm::clamp(place - 0.5, glm::dvec2(0.0), glm::dvec2(mSize - 1));
    glm::ivec2 low = glm::min(glm::ivec2(p), glm::max(mSize - 2, 0));
    glm::dvec2 part = p - glm::dvec2(low);
    auto value = [&](int x, int y) {
      glm::ivec2 q = glm::min(low + glm::ivec2(x, y), mSize - 1);
      return double(mValues[std::size_t(q.y) * std::size_t(mSize.x) + std::size_t(q.x)]);
    };
    return glm::mix(glm::mix(value(0, 0), value(1, 0), part.x), glm::mix(value(0, 1), value(1, 1), part.x), part.y);
  }

 private:
  glm::ivec2 mSize;
  const std::vector<float>& mValues;
};

/// The pixels of bands that are lines somewhere, grown to where they end.
Mask bandsOf(glm::ivec2 size, const std::vector<float>& strengths, double least) {
  Mask mask(size);
  std::vector<glm::ivec2> open;
  auto strengthAt = [&](glm::ivec2 p) { return strengths[std::size_t(p.y) * std::size_t(size.x) + std::size_t(p.x)]; };
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      if (double(strengthAt({x, y})) >= least) open.push_back({x, y});
  for (glm::ivec2 p : open) mask.set(p, true);
  while (!open.empty()) {
    glm::ivec2 p = open.back();
    open.pop_back();
    for (int i = 0; i < 9; ++i) {
      glm::ivec2 there = p + glm::ivec2(i % 3 - 1, i / 3 - 1);
      bool isInside = there.x >= 0 && there.y >= 0 && there.x < size.x && there.y < size.y;
      if (!isInside || mask.at(there) || double(strengthAt(there)) < 0.5 * least) continue;
      mask.set(there, true);
      open.push_back(there);
    }
  }
  return mask;
}

/// A chain as a track: its points moved across to the middle of the band.
Track trackAlong(const PixelChain& chain, const Strengths& strengths, double width) {
  Track track;
  track.isClosed = chain.isClosed;
  auto count = int(chain.pixels.size());
  auto placeOf = [&](int i) {
    i = chain.isClosed ? (i + count) % count : std::clamp(i, 0, count - 1);
    return glm::dvec2(chain.pixels[std::size_t(i)]) + 0.5;
  };
  constexpr int kNear = 4;
  for (int i = 0; i < count; ++i) {
    glm::dvec2 way = placeOf(i + kNear) - placeOf(i - kNear), place = placeOf(i);
    double length = glm::length(way);
    if (length > 0.0) {
      glm::dvec2 across = glm::dvec2(-way.y, way.x) / length;
      double sum = 0.0, moment = 0.0;
      for (double off = -width; off <= width; off += 0.5) {
        double weight = strengths.at(place + off * across);
        sum += weight;
        moment += weight * off;
      }
      if (sum > 0.0) place += across * std::clamp(moment / sum, -1.0, 1.0);
    }
    track.points.push_back(place);
  }
  for (int i = 0; i < count; ++i)
    track.fence.push_back(i == 0 ? track.points.front()
                                 : 0.5 * (track.points[std::size_t(i) - 1] + track.points[std::size_t(i)]));
  track.fence.push_back(track.points.back());
  if (track.isClosed) {
    track.fence.front() = 0.5 * (track.points.front() + track.points.back());
    track.fence.back() = track.fence.front();
  }
  return track;
}

double classOf(double strength) { return std::clamp(std::ceil(strength * kClasses - 0.3), 1.0, kClasses) / kClasses; }

/// The mean strength along a curve.
double strengthAlong(glm::dvec2 from, const Curve& curve, const Strengths& strengths) {
  double sum = 0.0;
  constexpr int kPlaces = 16;
  for (int i = 0; i < kPlaces; ++i) sum += strengths.at(placeOn(from, curve, (i + 0.5) / kPlaces));
  return sum / kPlaces;
}

/// Appends a line as strokes of one strength each.
void bandStrokes(const Outline& line, const Strengths& strengths, int id, std::vector<Stroke>& strokes) {
  std::vector<double> classes;
  glm::dvec2 from = line.start;
  for (const Curve& curve : line.curves) {
    classes.push_back(classOf(strengthAlong(from, curve, strengths)));
    from = curve.end;
  }
  from = line.start;
  for (std::size_t i = 0; i < line.curves.size(); ++i) {
    if (i == 0 || classes[i] != classes[i - 1]) strokes.push_back({{from, {}, false}, classes[i], id});
    strokes.back().line.curves.push_back(line.curves[i]);
    from = line.curves[i].end;
  }
  bool isOne = std::count(classes.begin(), classes.end(), classes.front()) == std::ptrdiff_t(classes.size());
  if (isOne) strokes.back().line.isClosed = line.isClosed;
}

}  // namespace

std::vector<Stroke> traceBands(glm::ivec2 size, std::span<const int> ids, const std::vector<float>& values,
                               const StepOptions& options, Progress& progress) {
  Mask mask = bandsOf(size, values, options.least);
  std::vector<PixelChain> chains = thinLines(mask, int(std::ceil(1.5 * options.width)) + 2);
  progress.report(0.7, "tracing lines");
  Strengths strengths(size, values);
  std::vector<Stroke> strokes;
  double least = options.leastLength * options.width;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (i % 64 == 0) progress.report(0.7 + 0.3 * double(i) / double(chains.size()), "tracing lines");
    if (double(chains[i].pixels.size()) < least) continue;
    Track track = trackAlong(chains[i], strengths, options.width);
    // A band's middle is known less well than an edge between pixels, and nobody sees where in it a line lies.
    Nearness nearness{0.75, 1.5, 0.5};
    Outline line = track.isClosed ? fitClosedCurves(track, nearness)
                                  : fitCurves(track, {track.points.front(), {}}, {track.points.back(), {}}, nearness);
    glm::ivec2 middle = chains[i].pixels[chains[i].pixels.size() / 2];
    bandStrokes(line, strengths, ids[std::size_t(middle.y) * std::size_t(size.x) + std::size_t(middle.x)], strokes);
  }
  progress.report(1.0, "tracing lines");
  return strokes;
}

std::vector<Stroke> traceSteps(const SurfaceMap& map, const View& view, const StepOptions& options,
                               Progress& progress) {
  progress.report(0.0, "tracing lines");
  std::vector<float> values = edgeStrengths(map, view, options);
  progress.report(0.4, "tracing lines");
  return traceBands(map.size, map.ids, values, options, progress);
}

}  // namespace velum::vector
