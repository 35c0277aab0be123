#include "session/extrusion/PulledEnd.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "session/extrusion/Extrusion.h"
#include "session/extrusion/Pull.h"
#include "session/growth/Growths.h"

namespace velum::session {

namespace {

/// Of the corners of a box of voxels the one that lies deepest before a flat cut.
double deepestCorner(const scene::Cut& cut, const glm::dmat4& worldFromVoxel, glm::dvec3 first, glm::dvec3 last) {
  double deepest = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < 8; ++i) {
    glm::dvec3 corner = glm::mix(first, last, glm::dvec3(i & 1, i >> 1 & 1, i >> 2));
    deepest = std::max(deepest, depthInCut(cut, glm::dvec3(worldFromVoxel * glm::dvec4(corner, 1.0))));
  }
  return deepest;
}

/// The end of the data before a cut.
double dataEnd(const scene::Scene& scene, const scene::Cut& cut) {
  double deepest = 0.0;
  auto edges = boxEdges(scene);
  for (const auto& edge : edges)
    for (glm::dvec3 corner : edge) deepest = std::max(deepest, depthInCut(cut, corner));
  // What a sphere removes lies within it.
  return isFlat(cut) ? deepest : std::max({deepest, cut.size.x, cut.size.y, cut.size.z});
}

/// How deep the middle of a structure's deepest voxel lies; below 0 where none is before the cut.
double deepestVoxel(const LabelVolume& labels, const scene::Cut& cut, int structure) {
  constexpr int kBrick = LabelVolume::kBrickSize;
  glm::dmat4 worldFromVoxel = labels.worldFromVoxel();
  struct Box {
    double deepest;
    glm::ivec3 first, end;
  };
  std::vector<Box> boxes;
  for (glm::ivec3 b(0); b.z < labels.brickGrid().z; ++b.z)
    for (b.y = 0; b.y < labels.brickGrid().y; ++b.y)
      for (b.x = 0; b.x < labels.brickGrid().x; ++b.x) {
        const auto& brick = labels.brick(b);
        if (std::find(brick.begin(), brick.end(), structure) == brick.end()) continue;
        glm::ivec3 first = b * kBrick, end = glm::min(first + kBrick, labels.dims());
        double corner =
            isFlat(cut) ? deepestCorner(cut, worldFromVoxel, first, end - 1) : std::numeric_limits<double>::infinity();
        boxes.push_back({corner, first, end});
      }
  // The first of them mostly says it.
  std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.deepest > b.deepest; });
  double deepest = -1.0;
  for (const auto& [corner, first, end] : boxes) {
    if (corner <= deepest) break;
    for (glm::ivec3 v = first; v.z < end.z; ++v.z)
      for (v.y = first.y; v.y < end.y; ++v.y)
        for (v.x = first.x; v.x < end.x; ++v.x)
          if (int(labels.at(v)) == structure)
            deepest = std::max(deepest, depthInCut(cut, glm::dvec3(worldFromVoxel * glm::dvec4(v, 1.0))));
  }
  return deepest;
}

/// What has grown up to its distance may go on behind it, and out of another cut there may be more.
/// @param deepest  where it ends before the cut
bool mayGoOn(const scene::Growth& last, const scene::Cut& cut, double deepest) {
  if (last.axis == glm::dvec3(0.0)) return false;  // it grew everywhere
  if (!growsOutOf(last, cut)) return true;
  return deepest + glm::dot(cut.centre - last.centre, last.axis) >= last.distance;
}

}  // namespace

double pulledEnd(const scene::Scene& scene, const scene::Cut& cut, int structure) {
  double end = dataEnd(scene, cut);
  const auto& labels = scene.labels.data;
  const scene::Growth* last = lastGrowth(scene, structure);
  if (structure == 0 || !labels || (last && !isGrown(scene))) return end;
  double half = 0.0;  // of a voxel, along the normal
  glm::dvec3 out = pullDirection(cut, cut.centre);
  for (int axis = 0; axis < 3; ++axis)
    half += 0.5 * std::abs(glm::dot(out, glm::dvec3(labels->worldFromVoxel()[axis])));
  double deepest = deepestVoxel(*labels, cut, structure);
  if (deepest < 0.0) return 0.0;
  return last && mayGoOn(*last, cut, deepest + 2.0 * half) ? end : std::min(end, deepest + half);
}

}  // namespace velum::session
