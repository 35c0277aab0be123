// The voxels under strokes, and what values they have.
#include "session/membrane/StrokeSamples.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "scene/Scene.h"
#include "scene/Shown.h"
#include "session/look/ValueHistogram.h"

namespace velum::session {

namespace {

/// Voxels of one row, `end` not included.
struct Run {
  std::size_t row = 0;
  int first = 0, end = 0;
};

/// A piece of a path with its radius.
struct Capsule {
  glm::dvec3 from{0.0}, to{0.0};
  double radius = 0;
};

double squaredDistance(const Capsule& capsule, glm::dvec3 p) {
  glm::dvec3 along = capsule.to - capsule.from;
  double length2 = glm::dot(along, along);
  double t = length2 > 0 ? std::clamp(glm::dot(p - capsule.from, along) / length2, 0.0, 1.0) : 0.0;
  glm::dvec3 away = p - (capsule.from + along * t);
  return glm::dot(away, away);
}

/// The part of a segment that can matter, so that a path that leads far away costs nothing there.
/// @return false when there is none
bool clipToBall(glm::dvec3& from, glm::dvec3& to, glm::dvec3 centre, double radius) {
  glm::dvec3 along = to - from, o = from - centre;
  double a = glm::dot(along, along), b = glm::dot(o, along), c = glm::dot(o, o) - radius * radius;
  if (!(a > 0)) return c <= 0;
  double root = b * b - a * c;
  if (!(root >= 0)) return false;
  root = std::sqrt(root);
  double t0 = std::max(0.0, (-b - root) / a), t1 = std::min(1.0, (-b + root) / a);
  if (!(t0 <= t1)) return false;
  glm::dvec3 start = from;
  from = start + along * t0;
  to = start + along * t1;
  return true;
}

/// Collects the runs of voxels in capsules.
class RunCollector {
 public:
  explicit RunCollector(const Volume& volume)
      : mDims(volume.dims), mWorldFromVoxel(volume.worldFromVoxel), mVoxelFromWorld(glm::inverse(mWorldFromVoxel)) {}

  /// Rows are narrowed from both ends: a row and a capsule share one stretch at most, as both are convex.
  void add(const Capsule& capsule) {
    glm::dvec3 a(mVoxelFromWorld * glm::dvec4(capsule.from, 1.0)), b(mVoxelFromWorld * glm::dvec4(capsule.to, 1.0));
    glm::dmat3 rows = glm::transpose(glm::dmat3(mVoxelFromWorld));
    glm::dvec3 reach = capsule.radius * glm::dvec3(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
    glm::ivec3 low(glm::clamp(glm::floor(glm::min(a, b) - reach), glm::dvec3(0.0), glm::dvec3(mDims)));
    glm::ivec3 end(glm::clamp(glm::ceil(glm::max(a, b) + reach) + 1.0, glm::dvec3(0.0), glm::dvec3(mDims)));
    double radius2 = capsule.radius * capsule.radius;
    glm::dvec3 step(mWorldFromVoxel[0]);
    for (int z = low.z; z < end.z; ++z)
      for (int y = low.y; y < end.y; ++y) {
        glm::dvec3 start(mWorldFromVoxel * glm::dvec4(0, y, z, 1));
        auto isIn = [&](int x) { return squaredDistance(capsule, start + step * double(x)) <= radius2; };
        int first = low.x, last = end.x - 1;
        while (first <= last && !isIn(first)) ++first;
        while (last > first && !isIn(last)) --last;
        if (first <= last) mRuns.push_back({std::size_t(z) * std::size_t(mDims.y) + std::size_t(y), first, last + 1});
      }
  }

  /// Each voxel once, in the order of the volume.
  std::vector<Run> take() {
    std::sort(mRuns.begin(), mRuns.end(),
              [](const Run& a, const Run& b) { return a.row != b.row ? a.row < b.row : a.first < b.first; });
    std::vector<Run> merged;
    for (const Run& run : mRuns) {
      if (!merged.empty() && merged.back().row == run.row && run.first <= merged.back().end)
        merged.back().end = std::max(merged.back().end, run.end);
      else
        merged.push_back(run);
    }
    return merged;
  }

 private:
  glm::ivec3 mDims;
  glm::dmat4 mWorldFromVoxel, mVoxelFromWorld;
  std::vector<Run> mRuns;
};

bool isFinite(glm::dvec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// A segment in pieces about as long as they are wide: the boxes around long oblique ones would be mostly empty.
void addSegment(RunCollector& collector, glm::dvec3 from, glm::dvec3 to, double radius, const Volume& volume) {
  if (!isFinite(from) || !isFinite(to)) return;
  if (!clipToBall(from, to, centreOf(volume), radiusOf(volume) + radius)) return;
  int pieces = std::max(1, int(std::ceil(glm::length(to - from) / (2.0 * radius))));
  for (int i = 0; i < pieces; ++i)
    collector.add({glm::mix(from, to, double(i) / pieces), glm::mix(from, to, double(i + 1) / pieces), radius});
}

std::vector<Run> runsUnder(const Volume& volume, std::span<const scene::Stroke> strokes, bool avoid) {
  RunCollector collector(volume);
  double thinnest = 0.501 * glm::length(spacingOf(volume));  // half a voxel across its corners
  for (const auto& stroke : strokes) {
    if (stroke.avoid != avoid || stroke.path.empty()) continue;
    double radius = std::max(stroke.radius, thinnest);
    if (stroke.path.size() == 1) addSegment(collector, stroke.path[0], stroke.path[0], radius, volume);
    for (std::size_t i = 0; i + 1 < stroke.path.size(); ++i)
      addSegment(collector, stroke.path[i], stroke.path[i + 1], radius, volume);
  }
  return collector.take();
}

}  // namespace

Histogram wholeHistogram(const scene::VolumeLayer& layer) {
  if (!layer.data) return {};
  const Volume& volume = *layer.data;
  return valueHistogram(volume, scene::shownChannel(layer), scene::shownTimeStep(layer));
}

Histogram strokeHistogram(const scene::VolumeLayer& layer, std::span<const scene::Stroke> strokes, bool avoid,
                          const Histogram& like) {
  Histogram histogram{std::vector<std::uint64_t>(like.counts.size()), like.range};
  double width = like.range.y - like.range.x;
  if (!layer.data || !(width > 0) || like.counts.empty()) return histogram;
  const Volume& volume = *layer.data;
  int bins = int(like.counts.size());
  double factor = bins / width * volume.scale, base = (volume.offset - like.range.x) * bins / width;
  std::size_t stride = std::size_t(volume.channels), line = std::size_t(volume.dims.x);
  std::size_t first =
      std::size_t(scene::shownTimeStep(layer)) * voxelCount(volume) * stride + std::size_t(scene::shownChannel(layer));
  std::vector<Run> runs = runsUnder(volume, strokes, avoid);
  visitSamples(volume, [&](auto* p) {
    using T = std::remove_cvref_t<decltype(*p)>;
    for (const Run& run : runs)
      for (int x = run.first; x < run.end; ++x) {
        T raw = p[first + (run.row * line + std::size_t(x)) * stride];
        if constexpr (std::is_floating_point_v<T>) {
          if (!std::isfinite(raw)) continue;
        }
        ++histogram.counts[std::size_t(std::clamp(int(double(raw) * factor + base), 0, bins - 1))];
      }
  });
  return histogram;
}

}  // namespace velum::session
