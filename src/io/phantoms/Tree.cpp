#include "io/phantoms/Tree.h"

#include <algorithm>

#include "core/Parallel.h"

namespace velum::io::phantom {

namespace {

constexpr int kSteps = 8;  // Segments per branch: enough for a bend to look round.

class Grower {
 public:
  explicit Grower(const TreeOptions& options) : mOptions(options), mRandom(options.seed) {}

  Tree grow(std::span<Vec> targets) {
    mTree.push_back({mOptions.root, mOptions.rootRadiusMm, -1});
    mTargetCount = float(targets.size());
    Vec end = mOptions.root + mOptions.reach * (centre(targets) - mOptions.root);
    Vec heading = glm::normalize(end - mOptions.root);
    int tip = addBranch(0, mOptions.direction, end, heading, mOptions.rootRadiusMm);
    split(tip, heading, targets);
    return std::move(mTree);
  }

 private:
  static Vec centre(std::span<const Vec> targets) {
    Vec sum(0.0f);
    for (const auto& p : targets) sum += p;
    return sum / float(targets.size());
  }

  float radiusFor(std::size_t fed) const {
    return std::max(mOptions.rootRadiusMm * std::cbrt(float(fed) / mTargetCount), mOptions.leastRadiusMm);
  }

  /// The direction across the branch along which the targets spread most.
  static Vec widestAcross(std::span<const Vec> targets, Vec heading) {
    Vec side = glm::normalize(glm::cross(heading, std::abs(heading.x) < 0.7f ? Vec(1, 0, 0) : Vec(0, 1, 0)));
    Vec other = glm::cross(heading, side), middle = centre(targets);
    float aa = 0.0f, ab = 0.0f, bb = 0.0f;
    for (const auto& p : targets) {
      float a = glm::dot(p - middle, side), b = glm::dot(p - middle, other);
      aa += a * a, ab += a * b, bb += b * b;
    }
    float angle = 0.5f * std::atan2(2.0f * ab, aa - bb);
    return std::cos(angle) * side + std::sin(angle) * other;
  }

  void split(int node, Vec heading, std::span<Vec> targets) {
    if (targets.size() < 2) return;
    Vec axis = widestAcross(targets, heading);
    std::sort(targets.begin(), targets.end(), [&](const Vec& p, const Vec& q) {
      float a = glm::dot(p, axis), b = glm::dot(q, axis);
      return a != b ? a < b : p.x < q.x;
    });
    auto cut = std::size_t(float(targets.size()) * mRandom.uniform(0.36f, 0.64f) + 0.5f);
    cut = std::clamp<std::size_t>(cut, 1, targets.size() - 1);
    for (auto part : {targets.first(cut), targets.subspan(cut)}) {
      Vec start = mTree[std::size_t(node)].position;
      Vec end = part.size() == 1 ? part[0] : start + mOptions.reach * (centre(part) - start);
      if (glm::length(end - start) < 1e-3f) continue;
      Vec way = glm::normalize(end - start);
      int tip = addBranch(node, glm::normalize(heading + way), end, way, radiusFor(part.size()));
      split(tip, way, part);
    }
  }

  /// A Hermite curve from a node to `end`; the radius eases from the node's to the branch's own.
  int addBranch(int from, Vec leave, Vec end, Vec arrive, float radius) {
    TreeNode start = mTree[std::size_t(from)];
    float length = glm::length(end - start.position);
    Vec sway = glm::cross(arrive, mRandom.direction()) * (mOptions.wobble * length);
    float turns = mRandom.uniform(0.8f, 2.2f);
    int parent = from;
    for (int k = 1; k <= kSteps; ++k) {
      float t = float(k) / float(kSteps), t2 = t * t, t3 = t2 * t;
      Vec p = (2 * t3 - 3 * t2 + 1) * start.position + (t3 - 2 * t2 + t) * length * leave + (3 * t2 - 2 * t3) * end +
              (t3 - t2) * length * arrive;
      p += sway * (t * (1.0f - t) * 4.0f * std::sin(3.1415927f * turns * t));
      mTree.push_back({p, glm::mix(start.radius, radius, smoothStep(0.0f, 0.45f, t)), parent});
      parent = int(mTree.size()) - 1;
    }
    return parent;
  }

  TreeOptions mOptions;
  Random mRandom;
  Tree mTree;
  float mTargetCount = 1.0f;
};

}  // namespace

std::vector<Vec> scatter(const Box& box, float pitchMm, const Distance& region, float marginMm, std::uint64_t seed) {
  std::vector<Vec> points;
  Random random(seed);
  for (float z = box.low.z; z < box.high.z; z += pitchMm)
    for (float y = box.low.y; y < box.high.y; y += pitchMm)
      for (float x = box.low.x; x < box.high.x; x += pitchMm) {
        Vec jitter(random.uniform(), random.uniform(), random.uniform());
        Vec p = Vec(x, y, z) + jitter * pitchMm;
        if (region(p) < -marginMm) points.push_back(p);
      }
  return points;
}

Tree growTree(std::vector<Vec> targets, const TreeOptions& options) {
  if (targets.empty()) return {{options.root, options.rootRadiusMm, -1}};
  return Grower(options).grow(targets);
}

void pushApart(Tree& tree, const Tree& fixed, float gapMm) {
  std::vector<Segment> walls = segments(fixed);
  for (int turn = 0; turn < 6; ++turn) {
    Tree moved = tree;
    parallelFor(std::size_t(1), tree.size(), [&](std::size_t i) {
      TreeNode& node = moved[i];
      for (const auto& wall : walls) {
        // Most walls are far away: ask the middle first.
        Vec away = node.position - 0.5f * (wall.a + wall.b);
        float reach = wall.radiusA + wall.radiusB + node.radius + gapMm + glm::length(wall.b - wall.a);
        if (glm::dot(away, away) > reach * reach) continue;
        float lack = node.radius + gapMm - distance(wall, node.position);
        if (lack > 0.0f && glm::length(away) > 1e-4f) node.position += glm::normalize(away) * (lack * 0.7f);
      }
    });
    // Ease each node between its parent and itself, so that the push leaves no kinks.
    tree = moved;
    for (std::size_t i = 1; i + 1 < tree.size(); ++i)
      if (moved[i + 1].parent == int(i) && moved[i].parent >= 0) {
        Vec middle = 0.5f * (moved[std::size_t(moved[i].parent)].position + moved[i + 1].position);
        tree[i].position = glm::mix(moved[i].position, middle, 0.35f);
      }
  }
}

std::vector<Segment> segments(const Tree& tree) {
  std::vector<Segment> out;
  for (const auto& node : tree)
    if (node.parent >= 0) {
      const auto& from = tree[std::size_t(node.parent)];
      out.push_back({from.position, node.position, from.radius, node.radius});
    }
  return out;
}

}  // namespace velum::io::phantom
