#include "membrane/forces/FinerSource.h"

#include <algorithm>
#include <cmath>

#include "core/FinestVoxels.h"
#include "core/Memory.h"
#include "membrane/forces/KeptWhole.h"
#include "scene/Scene.h"

namespace velum::membrane {

namespace {

constexpr double kMostVoxels = 512.0 * 512.0 * 512.0;
/// So far around what is asked for gradients, means without noise and pieces that are no specks can be told.
constexpr int kAround = 8;

/// The voxels of a level that count for a membrane, with all kernels that reach into its frame: whole super-voxels, so
/// that kernels are those of the whole level.
VoxelBox boxIn(glm::ivec3 dims, const glm::dmat4& worldFromVoxel, const scene::Cut& cut) {
  const scene::ForceField& field = cut.membrane->field;
  int super = 1 << std::clamp(field.level, 0, 6), around = kAround + int(std::ceil(field.areaOfEffect)) * super;
  VoxelBox box = voxelsInReach(dims, worldFromVoxel, cut);
  if (glm::any(glm::lessThanEqual(box.end, box.min))) return {};
  box.min = glm::max(box.min - around, 0) / super * super;
  box.end = glm::min((box.end + around + super - 1) / super * super, dims);
  return box;
}

double voxelsIn(const VoxelBox& box) {
  glm::dvec3 n(box.end - box.min);
  return n.x * n.y * n.z;
}

}  // namespace

double finerVoxelBudget(SampleType type) {
  // A voxel takes its sample, a byte that says whether it is protected, and its share of kernels.
  return std::min(kMostVoxels, 0.5 * brickBudget() / (double(sampleSize(type)) + 2.0));
}

std::optional<FinerBox> finerBoxOf(const PotentialSource& source, const scene::Cut& cut) {
  const scene::ForceField& field = cut.membrane->field;
  if (!source.volume || !source.volume->finer || (source.model.data && !field.byType.empty())) return std::nullopt;
  double most = finerVoxelBudget(source.volume->type);
  const auto& levels = source.volume->finer->bricks->source().levels();
  for (int level = 0; level < source.volume->finer->level; ++level) {
    VoxelBox box = boxIn(levels[std::size_t(level)].dims, worldFromLevel(*source.volume, level), cut);
    if (voxelsIn(box) == 0.0) return std::nullopt;
    if (voxelsIn(box) <= most) return FinerBox{level, box, !field.byValue.empty() || !field.byGradient.empty()};
  }
  return std::nullopt;
}

PotentialSource finerSource(const PotentialSource& source, const FinerBox& box, Progress& progress) {
  PotentialSource finer;
  finer.labels = source.labels;
  finer.unit = source.unit;
  finer.level = box.level;
  finer.dims = box.box.end - box.box.min;
  finer.worldFromVoxel = worldFromLevel(*source.volume, box.level);
  finer.worldFromVoxel[3] = finer.worldFromVoxel * glm::dvec4(glm::dvec3(box.box.min), 1.0);
  if (box.holdsValues)
    finer.volume = Shared<Volume>(FinestVoxels(*source.volume, box.level)
                                      .readAll(box.box.min, finer.dims, source.channel, source.timeStep, progress));
  return finer;
}

}  // namespace velum::membrane
