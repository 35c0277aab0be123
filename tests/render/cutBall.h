#pragma once
#include <functional>

#include "MembranesFixture.h"

/// A ball of solid material that is cut, and on whose face each ray meets it, by formulas.
namespace velum {

inline constexpr double kBallMm = 14.0, kVoxelMm = 0.9;  // the smallest spacing

/// A ball of solid material, whose border lies where the formula says to a hundredth of a voxel.
inline scene::Scene ballScene(bool isIso, bool isShaded) {
  glm::dmat4 place = centredFrame(kDims, {1, 1.1, kVoxelMm}, 0.3);
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume(
      kDims, SampleType::Float32,
      [&](glm::ivec3 v) {
        double radius = glm::length(glm::dvec3(place * glm::dvec4(v, 1.0)));
        return std::clamp(100.0 + 10.0 * (kBallMm - radius), 0.0, 200.0);
      },
      place));
  scene.volume.transfer.colors = {{0, {0.9f, 0.6f, 0.3f}}};
  scene.volume.transfer.opacities = {{99.9, 0}, {100.1, 0.999}, {200, 0.999}};
  scene.volume.transfer.unitDistance = 0.02;
  scene.rayCast.mode = isIso ? scene::RenderMode::Iso : scene::RenderMode::Volume;
  scene.rayCast.isoValue = 100;
  scene.lighting.shaded = isShaded;
  scene.lighting.shadow = scene.lighting.occlusion = 0;
  scene.rayCast.jitter = false;
  scene.rayCast.samplesPerPixel = 1;
  scene.background.transparent = true;
  scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 1.0);
  scene.camera.fieldOfViewDeg = 20;
  return scene;
}

/// A cut by its formula: how far a place is from its surface, millimetres; less than 0: removed.
using CutFormula = std::function<double(glm::dvec3)>;

inline CutFormula formulaOf(const scene::Cut& cut) {
  glm::dmat4 localFromWorld = glm::inverse(scene::worldFromCut(cut));
  glm::dvec3 half = 0.5 * cut.size;
  double side = cut.invert ? -1.0 : 1.0;
  return [=](glm::dvec3 world) {
    glm::dvec3 p(localFromWorld * glm::dvec4(world, 1.0));
    glm::dvec3 beyond = glm::abs(p) - half;
    switch (cut.shape) {
      case scene::CutShape::Box:
        return side * std::max(beyond.x, std::max(beyond.y, beyond.z));
      case scene::CutShape::Sphere:
        return side * (glm::length(p) - half.x);
      case scene::CutShape::Membrane: {
        // The height of domeSheet(), above the plane around it; the side is that of planes.
        bool isWithin = std::abs(p.x) < half.x && std::abs(p.y) < half.y;
        double height = isWithin ? 0.8 * half.z * double(bell(glm::vec2(p.x / half.x, p.y / half.y))) : 0.0;
        return side * (height - p.z);
      }
      default:
        return -side * p.z;
    }
  };
}

/// On which cut's face, plus 1, a ray meets the ball, found step by step; 0: on the ball's own surface; -1: nowhere.
inline int faceByFormula(const std::vector<CutFormula>& cuts, const TestRay& ray) {
  constexpr double kStep = 0.02;
  auto remover = [&](glm::dvec3 p) {
    for (std::size_t i = 0; i < cuts.size(); ++i)
      if (cuts[i](p) < 0.0) return int(i) + 1;
    return 0;
  };
  double nearest = -glm::dot(ray.origin, ray.direction);
  int before = -1;  // outside the ball
  for (double t = nearest - kBallMm - 1.0; t < nearest + kBallMm + 1.0; t += kStep) {
    glm::dvec3 p = ray.at(t);
    bool isInside = glm::length(p) < kBallMm;
    int by = isInside ? remover(p) : -1;
    if (by == 0) return std::max(before, 0);
    before = by;
  }
  return -1;
}

}  // namespace velum
