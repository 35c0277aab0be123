#include "session/measure/MeshWay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <unordered_map>
#include <unordered_set>

#include "core/Parallel.h"
#include "session/measure/MeshNeighbours.h"
#include "session/measure/Strip.h"

namespace velum::session {

namespace {

using Strip = std::vector<std::uint32_t>;
using Neighbours = std::vector<std::array<std::uint32_t, 3>>;

/// The place of a triangle that is nearest to a point.
glm::dvec3 nearestIn(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 p) {
  auto onEdge = [&](glm::dvec3 from, glm::dvec3 to) {
    double length = glm::dot(to - from, to - from);
    double share = length > 0.0 ? glm::clamp(glm::dot(p - from, to - from) / length, 0.0, 1.0) : 0.0;
    return from + share * (to - from);
  };
  glm::dvec3 normal = glm::cross(b - a, c - a);
  double size = glm::dot(normal, normal);
  if (size > 0.0) {
    glm::dvec3 in = p - glm::dot(p - a, normal) / size * normal;
    bool isIn = glm::dot(glm::cross(b - a, in - a), normal) >= 0.0 &&
                glm::dot(glm::cross(c - b, in - b), normal) >= 0.0 &&
                glm::dot(glm::cross(a - c, in - c), normal) >= 0.0;
    if (isIn) return in;
  }
  glm::dvec3 best = onEdge(a, b);
  for (glm::dvec3 other : {onEdge(b, c), onEdge(c, a)})
    if (glm::distance(other, p) < glm::distance(best, p)) best = other;
  return best;
}

glm::dvec3 middleOf(const WayMesh& mesh, std::uint32_t triangle) {
  const std::uint32_t* i = &mesh.indices[3 * std::size_t(triangle)];
  return (mesh.points[i[0]] + mesh.points[i[1]] + mesh.points[i[2]]) / 3.0;
}

/// The triangles about one, by how many sides are between.
class Surroundings {
 public:
  explicit Surroundings(const Neighbours& neighbours) : mNeighbours(neighbours) {}

  /// Those that are reached through few sides, each with the one from which it was reached, itself first.
  struct Reached {
    std::uint32_t triangle, from;
    int sides;
  };
  const std::vector<Reached>& about(std::uint32_t triangle) {
    constexpr int kMostSides = 7;  // enough ways that each direction is near one of them
    mReached.assign(1, {triangle, triangle, 0});
    mKnown.clear();
    mKnown.insert(triangle);
    for (std::size_t i = 0; i < mReached.size(); ++i) {
      auto [at, from, sides] = mReached[i];
      if (sides == kMostSides) break;
      for (std::uint32_t next : mNeighbours[at])
        if (mKnown.insert(next).second) mReached.push_back({next, at, sides + 1});
    }
    return mReached;
  }
  /// The triangles between one and another that is about it, the first left out.
  void addWay(Strip& strip, std::uint32_t from, std::uint32_t to) {
    const auto& reached = about(from);
    Strip back;
    while (to != from) {
      back.push_back(to);
      to = std::find_if(reached.begin(), reached.end(), [&](const Reached& r) { return r.triangle == to; })->from;
    }
    strip.insert(strip.end(), back.rbegin(), back.rend());
  }

 private:
  const Neighbours& mNeighbours;
  std::vector<Reached> mReached;
  std::unordered_set<std::uint32_t> mKnown;
};

/// The triangles of a short way, each a neighbour of the one before it; empty where there is none.
Strip firstStrip(const WayMesh& mesh, const Neighbours& neighbours, const MeshPlace& from, const MeshPlace& to,
                 Progress& progress) {
  constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<double> lengths(neighbours.size(), 1e300);
  std::vector<std::uint32_t> before(neighbours.size(), kNone);
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  auto placeOf = [&](std::uint32_t triangle) {
    return triangle == from.triangle ? from.place : triangle == to.triangle ? to.place : middleOf(mesh, triangle);
  };
  // The rest is as long as the straight line to the end, at least.
  auto rest = [&](std::uint32_t triangle) { return glm::distance(placeOf(triangle), to.place); };
  Surroundings surroundings(neighbours);
  lengths[from.triangle] = 0.0;
  open.push({rest(from.triangle), from.triangle});
  for (std::size_t steps = 0; !open.empty(); ++steps) {
    if (steps % 4096 == 0) progress.throwIfCancelled();
    auto [sum, at] = open.top();
    open.pop();
    if (at == to.triangle) break;
    glm::dvec3 here = placeOf(at);
    if (sum > lengths[at] + rest(at) * (1.0 + 1e-12) + 1e-12) continue;
    for (const auto& next : surroundings.about(at)) {
      double length = lengths[at] + glm::distance(here, placeOf(next.triangle));
      if (length >= lengths[next.triangle]) continue;
      lengths[next.triangle] = length;
      before[next.triangle] = at;
      open.push({length + rest(next.triangle), next.triangle});
    }
  }
  if (lengths[to.triangle] >= 1e300) return {};
  Strip steps;
  for (std::uint32_t at = to.triangle; at != kNone; at = before[at]) steps.push_back(at);
  Strip strip{from.triangle};
  for (std::size_t i = steps.size() - 1; i-- > 0;) surroundings.addWay(strip, steps[i + 1], steps[i]);
  return strip;
}

/// Leads strips past the other sides of points.
class Rerouting {
 public:
  Rerouting(const WayMesh& mesh, const Neighbours& neighbours) : mMesh(mesh), mNeighbours(neighbours) {}

  /// The triangles of a strip that have a point: those about a gate.
  std::pair<std::size_t, std::size_t> runOf(const Strip& strip, const StripCorner& corner) const {
    std::size_t first = corner.gate, last = corner.gate + 1;
    while (first > 0 && has(strip[first - 1], corner.point)) --first;
    while (last + 1 < strip.size() && has(strip[last + 1], corner.point)) ++last;
    return {first, last};
  }

  /// The triangles between the first and the last one of a run on the other side of the point; nothing where a border
  /// is in the way, or it is no shorter there.
  std::optional<Strip> otherSide(const Strip& strip, std::pair<std::size_t, std::size_t> run,
                                 const StripCorner& corner) const {
    double about = 0.0;
    for (std::size_t i = run.first; i <= run.second; ++i) about += angleAt(strip[i], corner.point);
    Strip fan;
    std::uint32_t at = strip[run.first], cameFrom = strip[run.first + 1];
    constexpr std::size_t kMostAbout = 1000;
    while (fan.size() < kMostAbout) {
      std::uint32_t next = nextAbout(at, cameFrom, corner.point);
      if (next == at) return std::nullopt;
      if (next == strip[run.second]) {
        if (about - corner.angle < M_PI - 1e-7) return fan;
        return std::nullopt;
      }
      about += angleAt(next, corner.point);
      fan.push_back(next);
      cameFrom = at;
      at = next;
    }
    return std::nullopt;
  }

 private:
  bool has(std::uint32_t triangle, std::uint32_t point) const {
    const std::uint32_t* i = &mMesh.indices[3 * std::size_t(triangle)];
    return i[0] == point || i[1] == point || i[2] == point;
  }
  double angleAt(std::uint32_t triangle, std::uint32_t point) const {
    const std::uint32_t* i = &mMesh.indices[3 * std::size_t(triangle)];
    std::size_t k = i[0] == point ? 0 : i[1] == point ? 1 : 2;
    glm::dvec3 a = mMesh.points[i[(k + 1) % 3]] - mMesh.points[point];
    glm::dvec3 b = mMesh.points[i[(k + 2) % 3]] - mMesh.points[point];
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
  }
  /// The neighbour about a point that is not the one that one came from; the triangle itself at a border.
  std::uint32_t nextAbout(std::uint32_t triangle, std::uint32_t cameFrom, std::uint32_t point) const {
    const std::uint32_t* i = &mMesh.indices[3 * std::size_t(triangle)];
    for (std::size_t side = 0; side < 3; ++side) {
      bool isAbout = i[side] == point || i[(side + 1) % 3] == point;
      if (isAbout && mNeighbours[triangle][side] != cameFrom) return mNeighbours[triangle][side];
    }
    return triangle;
  }

  const WayMesh& mMesh;
  const Neighbours& mNeighbours;
};

/// A strip that comes back to a triangle need not have left it.
Strip withoutLoops(const Strip& strip) {
  std::unordered_map<std::uint32_t, std::size_t> places;
  Strip kept;
  for (std::uint32_t triangle : strip) {
    auto known = places.find(triangle);
    if (known == places.end()) {
      places[triangle] = kept.size();
      kept.push_back(triangle);
      continue;
    }
    std::size_t length = known->second + 1;
    for (std::size_t i = length; i < kept.size(); ++i) places.erase(kept[i]);
    kept.resize(length);
  }
  return kept;
}

/// The strip led past the other side of each corner where that is shorter; nothing where there is no such corner.
std::optional<Strip> improved(const Rerouting& rerouting, const Strip& strip, const std::vector<StripCorner>& corners) {
  Strip better;
  std::size_t taken = 0;
  for (const StripCorner& corner : corners) {
    auto run = rerouting.runOf(strip, corner);
    if (run.first < taken) continue;
    auto fan = rerouting.otherSide(strip, run, corner);
    if (!fan) continue;
    better.insert(better.end(), strip.begin() + std::ptrdiff_t(taken), strip.begin() + std::ptrdiff_t(run.first) + 1);
    better.insert(better.end(), fan->begin(), fan->end());
    taken = run.second;
  }
  if (taken == 0) return std::nullopt;
  better.insert(better.end(), strip.begin() + std::ptrdiff_t(taken), strip.end());
  return withoutLoops(better);
}

}  // namespace

MeshPlace nearestPlace(const WayMesh& mesh, glm::dvec3 point) {
  auto body = [&](std::size_t first, std::size_t end) {
    MeshPlace best;
    for (std::size_t t = first; t < end; ++t) {
      const std::uint32_t* i = &mesh.indices[3 * t];
      glm::dvec3 place = nearestIn(mesh.points[i[0]], mesh.points[i[1]], mesh.points[i[2]], point);
      double distance = glm::distance(place, point);
      if (distance < best.distance) best = {std::uint32_t(t), place, distance};
    }
    return best;
  };
  auto nearer = [](const MeshPlace& a, const MeshPlace& b) { return b.distance < a.distance ? b : a; };
  return parallelReduce(std::size_t(0), mesh.indices.size() / 3, std::size_t(8192), MeshPlace(), body, nearer);
}

std::optional<MeshWay> wayOverMesh(const WayMesh& mesh, const MeshPlace& from, const MeshPlace& to,
                                   Progress& progress) {
  constexpr int kMostRounds = 5000;
  Neighbours neighbours = neighboursOf(mesh.indices);
  Strip strip = withoutLoops(firstStrip(mesh, neighbours, from, to, progress));
  if (strip.empty()) return std::nullopt;
  Rerouting rerouting(mesh, neighbours);
  StripWay best = straightWay(mesh, strip, from.place, to.place);
  // Takes a better strip where its way is shorter.
  auto takes = [&](std::optional<Strip> better) {
    if (!better) return false;
    StripWay next = straightWay(mesh, *better, from.place, to.place);
    if (!(next.way.length < best.way.length * (1.0 - 1e-12))) return false;
    strip = std::move(*better);
    best = std::move(next);
    return true;
  };
  for (int round = 0; round < kMostRounds; ++round) {
    progress.throwIfCancelled();
    // All corners at once, or, where their new ways are in each other's way, one of them.
    bool isBetter = takes(improved(rerouting, strip, best.corners));
    for (std::size_t i = 0; i < best.corners.size() && !isBetter; ++i)
      isBetter = takes(improved(rerouting, strip, {best.corners[i]}));
    if (!isBetter) break;
  }
  return std::move(best.way);
}

}  // namespace velum::session
