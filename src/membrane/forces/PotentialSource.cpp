#include "membrane/forces/PotentialSource.h"

#include <algorithm>

#include "core/BrickCache.h"
#include "membrane/forces/Kernels.h"
#include "membrane/forces/TypeGrid.h"
#include "scene/Scene.h"
#include "scene/Shown.h"

namespace velum::membrane {

namespace {

/// A model that is far larger than the rest does not make the grid so: this many times its voxels, or this many.
constexpr double kMostWider = 4.0, kFewVoxels = 1 << 26;

/// The voxels of a grid, and outside of it, that a box in the world reaches into.
VoxelBox voxelsOf(const scene::ModelBox& world, const glm::dmat4& worldFromVoxel) {
  glm::dmat4 voxelFromWorld = glm::inverse(worldFromVoxel);
  glm::dvec3 low(1e9), high(-1e9);
  for (int corner = 0; corner < 8; ++corner) {
    glm::bvec3 isHigh(corner & 1, corner & 2, corner & 4);
    glm::dvec3 voxel(voxelFromWorld * glm::dvec4(glm::mix(world.low, world.high, isHigh), 1.0));
    low = glm::min(low, voxel);
    high = glm::max(high, voxel);
  }
  low = glm::clamp(glm::floor(low), -1e8, 1e8), high = glm::clamp(glm::ceil(high) + 1.0, -1e8, 1e8);
  return {glm::ivec3(low), glm::ivec3(high)};
}

double voxelsIn(glm::ivec3 size) { return double(size.x) * size.y * size.z; }

scene::ModelBox worldBoxOf(const PotentialSource& source) {
  scene::ModelBox box = scene::modelBox(source.model);
  return {source.frame.worldOf(box.low), source.frame.worldOf(box.high)};
}

/// Adds voxels around the volume, or the labels, so that the grid holds the model, too.
void widenToModel(PotentialSource& source) {
  VoxelBox of = voxelsOf(worldBoxOf(source), source.worldFromVoxel);
  glm::ivec3 low = glm::min(of.min, glm::ivec3(0)), high = glm::max(of.end, source.dims);
  if (voxelsIn(high - low) > std::max(kMostWider * voxelsIn(source.dims), kFewVoxels)) return;
  source.volumeFrom = -low;
  source.dims = high - low;
  source.worldFromVoxel[3] = source.worldFromVoxel * glm::dvec4(low, 1.0);
}

}  // namespace

PotentialSource sourceOf(const scene::Scene& scene) {
  PotentialSource source;
  source.volume = scene.volume.data;
  source.labels = scene.labels.data;
  source.unit = scene.unit;
  if (scene.model.data) source.model = scene.model, source.frame = scene::modelFrame(scene);
  if (source.volume) {
    source.timeStep = scene::shownTimeStep(scene.volume);
    source.channel = scene::shownChannel(scene.volume);
    source.level = source.volume->finer ? source.volume->finer->level : 0;
    source.dims = source.volume->dims;
    source.worldFromVoxel = source.volume->worldFromVoxel;
  } else if (source.labels) {
    source.dims = source.labels->dims();
    source.worldFromVoxel = source.labels->worldFromVoxel();
  }
  if (!source.model.data) return source;
  if (source.dims.x > 0) {
    widenToModel(source);
  } else {
    TypeLattice lattice = typeLattice(source.model, source.frame);
    source.dims = lattice.dims;
    source.worldFromVoxel = lattice.worldFromVoxel;
  }
  return source;
}

bool holdsModel(const PotentialSource& source) {
  if (!source.model.data) return false;
  VoxelBox of = voxelsOf(worldBoxOf(source), source.worldFromVoxel);
  // What reaches out by less than a voxel is rounding.
  return glm::all(glm::greaterThanEqual(of.min, glm::ivec3(-1))) &&
         glm::all(glm::lessThanEqual(of.end, source.dims + 1));
}

}  // namespace velum::membrane
