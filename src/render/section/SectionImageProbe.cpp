#include <cmath>

#include "core/BrickCache.h"
#include "render/section/SectionImage.h"
#include "scene/Scene.h"
#include "scene/Shown.h"
#include "scene/StructureAt.h"

namespace velum::render {

namespace {

/// The values of the finest voxel there, as far as it is in memory: who moves a pointer waits for no disk.
void takeFinest(const Volume& volume, glm::dvec3 world, int firstChannel, int timeStep, std::vector<double>& values) {
  BrickCache& bricks = *volume.finer->bricks;
  for (int level = 0; level < volume.finer->level; ++level) {
    const VoxelLevel& its = bricks.source().levels()[std::size_t(level)];
    glm::dvec3 place = glm::inverse(worldFromLevel(volume, level)) * glm::dvec4(world, 1.0);
    glm::ivec3 voxel = glm::clamp(glm::ivec3(glm::floor(place + 0.5)), glm::ivec3(0), its.dims - 1);
    bool isThere = true;
    for (std::size_t i = 0; i < values.size() && isThere; ++i) {
      int channel = firstChannel + int(i);
      isThere =
          bool(bricks.find({level, voxel / its.brickSize, channel / its.brickChannels, timeStep / its.brickTimeSteps}));
      if (isThere) values[i] = valueAt(bricks.read({level, voxel, glm::ivec3(1)}, channel, timeStep), glm::ivec3(0));
    }
    if (isThere) return;
  }
}

}  // namespace

Probe probe(const scene::Scene& scene, glm::dvec3 world) {
  Probe out;
  auto voxelOf = [&](const glm::dmat4& worldFromVoxel) {
    return glm::floor(glm::dvec3(glm::inverse(worldFromVoxel) * glm::dvec4(world, 1.0)) + 0.5);
  };
  auto isIn = [](glm::dvec3 voxel, glm::ivec3 dims) {
    return glm::all(glm::greaterThanEqual(voxel, glm::dvec3(0.0))) && glm::all(glm::lessThan(voxel, glm::dvec3(dims)));
  };
  const auto& labels = scene.labels;
  if (labels.data) {
    glm::dvec3 voxel = voxelOf(labels.data->worldFromVoxel());
    bool inside = isIn(voxel, labels.data->dims());
    if (inside && labels.visible) out.structure = scene::structureAt(scene, world).id;
    out.inside = inside && !scene.volume.data;
  }
  if (!scene.volume.data) return out;
  const Volume& v = *scene.volume.data;
  glm::dvec3 voxel = voxelOf(v.worldFromVoxel);
  out.inside = isIn(voxel, v.dims);
  if (!out.inside) return out;
  bool all = v.isColor || scene::mixesChannels(scene.volume);
  int first = all ? 0 : scene::shownChannel(scene.volume);
  int last = all ? v.channels : first + 1, timeStep = scene::shownTimeStep(scene.volume);
  for (int channel = first; channel < last; ++channel)
    out.values.push_back(valueAt(v, glm::ivec3(voxel), channel, timeStep));
  if (v.finer) takeFinest(v, world, first, timeStep, out.values);
  return out;
}

}  // namespace velum::render
