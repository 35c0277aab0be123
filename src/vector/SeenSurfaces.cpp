#include "vector/SeenSurfaces.h"

#include <algorithm>
#include <cmath>

#include "core/Assert.h"
#include "core/Parallel.h"

namespace velum::vector {

namespace {

// As in shaders/render/edges_data.glsl.
constexpr double kStepPixels = 3.0;
constexpr double kLeastCrease = 0.35, kFullCrease = 0.95;

// Where half of solidity() of shaders/render/finish.glsl is reached.
constexpr double kLeastSolid = 0.43;

double smooth(double low, double high, double x) {
  double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}
double middleOf(double x, double y, double z) { return std::max(std::min(x, y), std::min(std::max(x, y), z)); }

/// The formulas of the shader at a pixel, with the names that it has.
class EdgeAt {
 public:
  EdgeAt(const std::vector<SeenPixel>& seen, glm::ivec2 size, const View& view, const StepOptions& options)
      : mSeen(seen),
        mSize(size),
        mView(view),
        mOptions(options),
        mReach(std::max(1, int(std::lround(options.width / 2)))) {}

  /// 0 next to other regions.
  double strength(glm::ivec2 pixel) const {
    const SeenPixel& own = at(pixel);
    if (own.id < 1) return 0.0;
    SeenPixel s[8];
    constexpr glm::ivec2 kEight[8] = {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}};
    for (int i = 0; i < 8; ++i) {
      s[i] = at(pixel + mReach * kEight[i]);
      if (s[i].id != own.id) return 0.0;
    }
    auto [a, b, c, d, e, f, g, h] = s;
    glm::dvec2 before(middleOf(a.depth, d.depth, f.depth), middleOf(a.depth, b.depth, c.depth));
    glm::dvec2 after(middleOf(c.depth, e.depth, h.depth), middleOf(f.depth, g.depth, h.depth));
    double jump = jumpOf(before + after - 2.0 * double(own.depth), own.depth);
    glm::vec2 across = c.normal + 2.0f * e.normal + h.normal - a.normal - 2.0f * d.normal - f.normal;
    glm::vec2 down = f.normal + 2.0f * g.normal + h.normal - a.normal - 2.0f * b.normal - c.normal;
    glm::vec2 left = a.normal - 2.0f * d.normal + f.normal, right = c.normal - 2.0f * e.normal + h.normal;
    glm::vec2 top = a.normal - 2.0f * b.normal + c.normal, bottom = f.normal - 2.0f * g.normal + h.normal;
    double rough = std::sqrt(
        double(glm::dot(left, left) + glm::dot(right, right) + glm::dot(top, top) + glm::dot(bottom, bottom)));
    double turn = 0.25 * (std::sqrt(double(glm::dot(across, across) + glm::dot(down, down))) - rough);
    double edge = std::max(mOptions.steps * jump, mOptions.creases * smooth(kLeastCrease, kFullCrease, turn));
    return std::min(edge, 1.0);
  }

 private:
  const SeenPixel& at(glm::ivec2 p) const {
    p = glm::clamp(p, glm::ivec2(0), mSize - 1);
    return mSeen[std::size_t(p.y) * std::size_t(mSize.x) + std::size_t(p.x)];
  }
  double jumpOf(glm::dvec2 bend, double depth) const {
    double along = mView.isOrthographic ? depth : 1.0 / std::max(depth, 1e-9);
    double pixel = 2.0 * mView.halfHeight / mSize.y * (mView.isOrthographic ? 1.0 : along);
    double least = std::max(mOptions.stepLength, kStepPixels * pixel * mReach);
    return smooth(least, 2.0 * least, glm::length(bend) * (mView.isOrthographic ? 1.0 : along * along));
  }

  const std::vector<SeenPixel>& mSeen;
  glm::ivec2 mSize;
  View mView;
  StepOptions mOptions;
  int mReach;
};

SeenPixel seenPixel(const SurfaceMap& map, const View& view, glm::ivec2 pixel, std::size_t i) {
  int id = map.ids[i];
  double distance = double(map.distances[i]);
  if (id < 1 || !std::isfinite(distance) || (!map.opacities.empty() && double(map.opacities[i]) < kLeastSolid))
    return {};
  glm::dvec3 ray = view.forward;
  if (!view.isOrthographic) {
    glm::dvec2 off = (glm::dvec2(pixel) + 0.5 - 0.5 * glm::dvec2(map.size)) * (2.0 * view.halfHeight / map.size.y);
    ray = glm::normalize(view.forward + off.x * view.right - off.y * view.up);
  }
  glm::dvec3 toEye = -ray, normal(map.normals[i]);
  glm::dvec3 right = glm::normalize(view.right - toEye * glm::dot(view.right, toEye));
  glm::dvec3 up = glm::cross(toEye, right);
  if (glm::dot(normal, toEye) < 0.0) normal = -normal;
  double along = std::max(distance * glm::dot(ray, view.forward), 1e-9);
  // The renderer keeps them in 16 bits: on what is nearly flat this decides which way strokes go.
  auto kept = [](double part) { return float(std::round(std::clamp(part, -1.0, 1.0) * 32767.0) / 32767.0); };
  return {{kept(glm::dot(normal, right)), kept(glm::dot(normal, up))},
          float(view.isOrthographic ? along : 1.0 / along),
          id};
}

}  // namespace

std::vector<SeenPixel> seenPixels(const SurfaceMap& map, const View& view) {
  auto count = std::size_t(map.size.x) * std::size_t(map.size.y);
  VELUM_ASSERT(map.ids.size() == count && map.distances.size() == count && map.normals.size() == count,
               "a pixel has an id, a distance and a normal");
  std::vector<SeenPixel> seen(count);
  parallelFor(0, map.size.y, [&](int y) {
    for (int x = 0; x < map.size.x; ++x) {
      std::size_t i = std::size_t(y) * std::size_t(map.size.x) + std::size_t(x);
      seen[i] = seenPixel(map, view, {x, y}, i);
    }
  });
  return seen;
}

std::vector<float> edgeStrengths(const SurfaceMap& map, const View& view, const StepOptions& options) {
  std::vector<SeenPixel> seen = seenPixels(map, view);
  std::vector<float> strengths(seen.size());
  EdgeAt edges(seen, map.size, view, options);
  parallelFor(0, map.size.y, [&](int y) {
    for (int x = 0; x < map.size.x; ++x)
      strengths[std::size_t(y) * std::size_t(map.size.x) + std::size_t(x)] = float(edges.strength({x, y}));
  });
  return strengths;
}

}  // namespace velum::vector
