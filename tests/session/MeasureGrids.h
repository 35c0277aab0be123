#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "makeVolume.h"
#include "scene/Mark.h"
#include "scene/Scene.h"

/// Phantoms whose sizes are known, on grids of all kinds, for tests of measures.
namespace velum::session {

/// How voxels lie in the world.
struct MeasureGrid {
  std::string name;
  glm::dvec3 spacing{1.0};
  double turnRad = 0.0;
  double tilt = 0.0;  ///< how far sections are shifted along y for each length along z: a gantry's tilt
};
inline std::vector<MeasureGrid> measureGrids() {
  return {{"cubes", glm::dvec3(1.0), 0.0, 0.0},
          {"oblique", {0.7, 0.7, 1.5}, 0.4, 0.0},
          {"odd", {0.61, 0.83, 0.47}, 0.9, 0.0},
          {"backwards", {-0.8, 0.8, -1.1}, 0.3, 0.0},
          {"tilted", {0.6, 0.6, 1.2}, 0.0, 0.35}};
}

constexpr double kMeasureEdge = 44.0;  // of the data's box, about

inline glm::ivec3 dimsOf(const MeasureGrid& grid) { return glm::ivec3(kMeasureEdge / glm::abs(grid.spacing)); }
inline glm::dmat4 frameOf(const MeasureGrid& grid) {
  glm::dmat4 tilt(1.0);
  tilt[2][1] = grid.tilt;
  return tilt * centredFrame(dimsOf(grid), grid.spacing, grid.turnRad);
}
/// The middle of phantoms: beside the voxels.
inline const glm::dvec3 kMeasureMiddle(0.13, 0.21, -0.17);

/// A scene whose structure 1 is where a function of the place from kMeasureMiddle says.
template <class IsIn>
scene::Scene sceneOfBody(const MeasureGrid& grid, IsIn isIn) {
  glm::dmat4 frame = frameOf(grid);
  scene::Scene scene;
  scene.labels.data = Shared<LabelVolume>(makeLabels(
      dimsOf(grid), [&](glm::ivec3 v) { return isIn(glm::dvec3(frame * glm::dvec4(v, 1.0)) - kMeasureMiddle) ? 1 : 0; },
      frame));
  scene::completeStructures(scene.labels);
  return scene;
}
inline scene::Scene sceneOfBall(const MeasureGrid& grid, double radius) {
  return sceneOfBody(grid, [&](glm::dvec3 p) { return glm::length(p) < radius; });
}

/// A cut about kMeasureMiddle.
inline scene::Cut cutAt(scene::CutShape shape, glm::dvec3 off, glm::dvec3 axis, glm::dvec3 size = glm::dvec3(1.0)) {
  scene::Cut cut;
  cut.shape = shape;
  cut.centre = kMeasureMiddle + off;
  cut.axis = axis;
  cut.size = size;
  if (scene::isMembrane(cut)) cut.membrane.emplace();
  return cut;
}

inline scene::Mark markOf(scene::MarkKind kind, std::vector<glm::dvec3> points) {
  scene::Mark mark;
  mark.kind = kind;
  mark.points = std::move(points);
  return mark;
}

/// Values as a plain loop sums them.
struct PlainSum {
  double count = 0, sum = 0, squares = 0, least = 1e9, most = -1e9;
  void add(double value) {
    ++count, sum += value, squares += value * value;
    least = std::min(least, value), most = std::max(most, value);
  }
};
/// Of the voxels whose middles are where isIn(world) says.
template <class IsIn>
PlainSum sumWhere(const Volume& volume, IsIn isIn) {
  PlainSum sum;
  glm::ivec3 v;
  for (v.z = 0; v.z < volume.dims.z; ++v.z)
    for (v.y = 0; v.y < volume.dims.y; ++v.y)
      for (v.x = 0; v.x < volume.dims.x; ++v.x)
        if (isIn(glm::dvec3(volume.worldFromVoxel * glm::dvec4(v, 1.0)))) sum.add(valueAt(volume, v));
  return sum;
}

}  // namespace velum::session
