#include "io/phantoms/Phantom.h"

#include <algorithm>
#include <limits>

#include "core/Parallel.h"

namespace velum::io::phantom {

namespace {

constexpr float kFar = 1e6f;

/// Voxels of a slice that a shape may touch, half open.
struct Rect {
  int x0 = std::numeric_limits<int>::max(), y0 = x0, x1 = 0, y1 = 0;
  bool isEmpty() const { return x0 >= x1 || y0 >= y1; }
  void add(const Rect& r) {
    if (r.isEmpty()) return;
    x0 = std::min(x0, r.x0), y0 = std::min(y0, r.y0), x1 = std::max(x1, r.x1), y1 = std::max(y1, r.y1);
  }
};

Rect clip(const Grid& grid, int z, const Box& box, float marginMm) {
  float zMm = grid.at(0, 0, z).z;
  if (zMm < box.low.z - marginMm || zMm > box.high.z + marginMm) return {};
  Vec half = 0.5f * Vec(grid.dims - 1);
  Vec low = (box.low - marginMm) / grid.spacing + half, high = (box.high + marginMm) / grid.spacing + half;
  Vec end = Vec(grid.dims);
  low = glm::clamp(low, Vec(0.0f), end), high = glm::clamp(high, Vec(-1.0f), end);
  return {int(low.x), int(low.y), std::min(int(high.x) + 1, grid.dims.x), std::min(int(high.y) + 1, grid.dims.y)};
}

Box boundsOf(const Segment& s, Vec squash) {
  float r = std::max(s.radiusA, s.radiusB);
  return {glm::min(s.a, s.b) - r / squash, glm::max(s.a, s.b) + r / squash};
}

/// Takes the minimum of `nearest` and the solid's distance. Where the distance is large the voxels that cannot reach
/// the surface are filled without asking; half the distance, because distances may be twice the true one.
void addSolid(const Slice& slice, const Solid& solid, const Rect& rect, float edgeMm, std::vector<float>& nearest) {
  const Grid& grid = slice.grid;
  for (int y = rect.y0; y < rect.y1; ++y) {
    float* row = nearest.data() + std::size_t(y) * std::size_t(grid.dims.x);
    for (int x = rect.x0; x < rect.x1;) {
      float d = solid.distance(grid.at(x, y, slice.z));
      int run = 1 + int(std::max(0.0f, std::abs(d) - edgeMm) * 0.5f / grid.spacing.x);
      for (int end = std::min(rect.x1, x + run); x < end; ++x) row[x] = std::min(row[x], d);
    }
  }
}

void addTube(const Slice& slice, Segment segment, Vec squash, const Rect& rect, std::vector<float>& nearest) {
  const Grid& grid = slice.grid;
  segment.a *= squash, segment.b *= squash;
  for (int y = rect.y0; y < rect.y1; ++y) {
    float* row = nearest.data() + std::size_t(y) * std::size_t(grid.dims.x);
    for (int x = rect.x0; x < rect.x1; ++x)
      row[x] = std::min(row[x], distance(segment, grid.at(x, y, slice.z) * squash));
  }
}

/// Mixes the layer's material into the slice by coverage, which goes from all to nothing within edgeMm of its surface.
/// It is as smooth as a scanner's: a ramp with corners shows the voxels of a surface as wood grain.
void cover(const Slice& slice, const Layer& layer, const Rect& rect, float edgeMm, const std::vector<float>& nearest) {
  const Grid& grid = slice.grid;
  for (int y = rect.y0; y < rect.y1; ++y)
    for (int x = rect.x0; x < rect.x1; ++x) {
      std::size_t i = std::size_t(y) * std::size_t(grid.dims.x) + std::size_t(x);
      if (nearest[i] >= edgeMm) continue;
      float coverage = glm::smoothstep(-edgeMm, edgeMm, -nearest[i]);
      auto& label = slice.labels[i];
      if (!layer.onto.empty() && std::find(layer.onto.begin(), layer.onto.end(), label) == layer.onto.end()) continue;
      float value = layer.value + (layer.texture ? layer.texture(grid.at(x, y, slice.z)) : 0.0f);
      slice.values[i] += (value - slice.values[i]) * std::min(coverage, 1.0f);
      if (coverage >= 0.5f && layer.label != kKeepLabel) label = layer.label;
    }
}

void paintLayer(const Slice& slice, const Layer& layer, std::vector<float>& nearest) {
  const Grid& grid = slice.grid;
  float edgeMm = 0.75f * layer.edge * (grid.spacing.x + grid.spacing.y + grid.spacing.z) / 3.0f;
  auto rectOf = [&](const Box& box) { return clip(grid, slice.z, box, edgeMm); };
  // Find what the layer may touch, and clear that.
  Rect all;
  for (const auto& solid : layer.solids) all.add(rectOf(solid.box));
  for (const auto& segment : layer.tubes) all.add(rectOf(boundsOf(segment, layer.squash)));
  if (all.isEmpty()) return;
  for (int y = all.y0; y < all.y1; ++y) {
    auto row = nearest.begin() + std::ptrdiff_t(y) * grid.dims.x;
    std::fill(row + all.x0, row + all.x1, kFar);
  }
  // Unite the shapes, then paint once: overlapping shapes of a layer leave no seams.
  for (const auto& solid : layer.solids) addSolid(slice, solid, rectOf(solid.box), edgeMm, nearest);
  for (const auto& segment : layer.tubes)
    addTube(slice, segment, layer.squash, rectOf(boundsOf(segment, layer.squash)), nearest);
  cover(slice, layer, all, edgeMm, nearest);
}

template <class T>
void store(std::span<const float> from, T* to) {
  if constexpr (std::is_floating_point_v<T>) {
    std::copy(from.begin(), from.end(), to);
  } else {
    constexpr float kLow = float(std::numeric_limits<T>::min()), kHigh = float(std::numeric_limits<T>::max());
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = T(std::floor(std::clamp(from[i], kLow, kHigh) + 0.5f));
  }
}

void store(std::span<const float> from, SampleType type, std::byte* to) {
  switch (type) {
    case SampleType::UInt8:
      return store(from, reinterpret_cast<std::uint8_t*>(to));
    case SampleType::UInt16:
      return store(from, reinterpret_cast<std::uint16_t*>(to));
    case SampleType::Int16:
      return store(from, reinterpret_cast<std::int16_t*>(to));
    default:
      return store(from, reinterpret_cast<float*>(to));
  }
}

}  // namespace

Vec Random::direction() {
  // Marsaglia: a point in the unit disc gives a point on the sphere.
  for (;;) {
    float x = uniform(-1.0f, 1.0f), y = uniform(-1.0f, 1.0f), s = x * x + y * y;
    if (s >= 1.0f) continue;
    float f = 2.0f * std::sqrt(1.0f - s);
    return {x * f, y * f, 1.0f - 2.0f * s};
  }
}

float noise(Vec p, std::uint64_t seed) {
  Vec cell = glm::floor(p), t = p - cell;
  t = t * t * (3.0f - 2.0f * t);
  glm::ivec3 i(cell);
  auto corner = [&](int x, int y, int z) {
    auto key = std::uint64_t(std::uint32_t(i.x + x)) * 0x9e3779b97f4a7c15ull ^
               std::uint64_t(std::uint32_t(i.y + y)) * 0xc2b2ae3d27d4eb4full ^
               std::uint64_t(std::uint32_t(i.z + z)) * 0x165667b19e3779f9ull;
    return unit(hash(key + seed)) * 2.0f - 1.0f;
  };
  auto along = [&](int y, int z) { return glm::mix(corner(0, y, z), corner(1, y, z), t.x); };
  return glm::mix(glm::mix(along(0, 0), along(1, 0), t.y), glm::mix(along(0, 1), along(1, 1), t.y), t.z);
}

float ellipsoid(Vec p, Vec centre, Vec radii) {
  Vec q = (p - centre) / radii;
  float k0 = glm::length(q), k1 = glm::length(q / radii);
  float deepest = -std::min({radii.x, radii.y, radii.z});
  return k1 > 0.0f ? std::max(k0 * (k0 - 1.0f) / k1, deepest) : deepest;
}

float ellipse(glm::vec2 p, glm::vec2 centre, glm::vec2 radii) {
  glm::vec2 q = (p - centre) / radii;
  float k0 = glm::length(q), k1 = glm::length(q / radii);
  float deepest = -std::min(radii.x, radii.y);
  return k1 > 0.0f ? std::max(k0 * (k0 - 1.0f) / k1, deepest) : deepest;
}

float roundBox(Vec p, Vec centre, Vec halfSize, float radius) {
  Vec q = glm::abs(p - centre) - (halfSize - radius);
  return glm::length(glm::max(q, Vec(0.0f))) + std::min(std::max({q.x, q.y, q.z}), 0.0f) - radius;
}

float curve(std::span<const glm::vec2> knots, float x) {
  if (x <= knots.front().x) return knots.front().y;
  if (x >= knots.back().x) return knots.back().y;
  std::size_t i = 1;
  while (knots[i].x < x) ++i;
  // Cubic Hermite with finite-difference slopes.
  auto slope = [&](std::size_t k) {
    std::size_t a = k > 0 ? k - 1 : k, b = std::min(k + 1, knots.size() - 1);
    return (knots[b].y - knots[a].y) / (knots[b].x - knots[a].x);
  };
  float width = knots[i].x - knots[i - 1].x, t = (x - knots[i - 1].x) / width;
  float t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * knots[i - 1].y + (t3 - 2 * t2 + t) * width * slope(i - 1) +
         (3 * t2 - 2 * t3) * knots[i].y + (t3 - t2) * width * slope(i);
}

float distance(const Segment& s, Vec p) {
  Vec ab = s.b - s.a, ap = p - s.a;
  float length2 = glm::dot(ab, ab);
  float t = length2 > 0.0f ? glm::clamp(glm::dot(ap, ab) / length2, 0.0f, 1.0f) : 0.0f;
  return glm::length(ap - t * ab) - glm::mix(s.radiusA, s.radiusB, t);
}

std::vector<Segment> tube(std::span<const glm::vec4> points, int steps) {
  std::vector<Segment> segments;
  auto last = points.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const auto &p0 = points[i > 0 ? i - 1 : 0], &p1 = points[i], &p2 = points[i + 1],
               &p3 = points[std::min(i + 2, last)];
    auto at = [&](float t) {
      return 0.5f * (2.0f * p1 + (p2 - p0) * t + (2.0f * p0 - 5.0f * p1 + 4.0f * p2 - p3) * t * t +
                     (3.0f * p1 - p0 - 3.0f * p2 + p3) * t * t * t);
    };
    for (int k = 0; k < steps; ++k) {
      glm::vec4 a = at(float(k) / float(steps)), b = at(float(k + 1) / float(steps));
      segments.push_back({Vec(a), Vec(b), a.w, b.w});
    }
  }
  return segments;
}

void append(std::vector<Segment>& to, std::span<const Segment> from) { to.insert(to.end(), from.begin(), from.end()); }

glm::dmat4 Grid::worldFromVoxel() const {
  glm::dvec3 step = glm::dvec3(spacing) * unitMm;
  glm::dvec3 origin = -0.5 * glm::dvec3(dims - 1) * step;
  glm::dmat4 m(1.0);
  for (int axis = 0; axis < 3; ++axis) m[axis][axis] = step[axis];
  m[3] = glm::dvec4(origin, 1.0);
  return m;
}

void paint(const Slice& slice, std::span<const Layer> layers) {
  std::vector<float> nearest(slice.values.size());
  for (const auto& layer : layers) paintLayer(slice, layer, nearest);
}

Sample fill(const Description& description, const Grid& grid, Progress& progress,
            const std::function<void(const Slice&)>& body) {
  progress.report(0.0, "making " + description.name);
  Sample sample;
  Volume& volume = sample.volume;
  volume.dims = grid.dims;
  volume.type = description.type;
  volume.worldFromVoxel = grid.worldFromVoxel();
  volume.modality = description.modality;
  volume.unit = description.unit;
  volume.name = description.name;
  volume.voxels.resize(timeStepBytes(volume));
  sample.labels = LabelVolume(grid.dims, volume.worldFromVoxel);
  sample.labels.name = description.name;
  sample.labels.table = description.table;

  // Work in slabs of whole label bricks: between two of them the caller's thread reports and may be cancelled.
  std::size_t sliceVoxels = std::size_t(grid.dims.x) * std::size_t(grid.dims.y);
  constexpr int kSlab = LabelVolume::kBrickSize;
  std::vector<std::uint16_t> ids(sliceVoxels * kSlab);
  for (int first = 0; first < grid.dims.z; first += kSlab) {
    int end = std::min(first + kSlab, grid.dims.z);
    std::fill(ids.begin(), ids.end(), std::uint16_t(0));
    parallelFor(first, end, [&](int z) {
      std::vector<float> values(sliceVoxels, 0.0f);
      body({grid, z, values, {ids.data() + sliceVoxels * std::size_t(z - first), sliceVoxels}});
      store(values, volume.type, volume.voxels.data() + sliceVoxels * std::size_t(z) * sampleSize(volume.type));
    });
    sample.labels.write({0, 0, first}, {grid.dims.x, grid.dims.y, end - first}, ids);
    progress.report(double(end) / double(grid.dims.z), "making " + description.name);
  }
  progress.throwIfCancelled();
  // A coarse grid may miss the smallest structures; then the table must not promise them.
  auto used = sample.labels.idsInUse();
  std::erase_if(sample.labels.table,
                [&](const LabelInfo& info) { return !std::binary_search(used.begin(), used.end(), info.id); });
  computeRange(volume);
  return sample;
}

}  // namespace velum::io::phantom
