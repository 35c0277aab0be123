#include "render/kept/KeptVoxels.h"

#include <algorithm>

#include "core/Parallel.h"
#include "render/kept/RowCuts.h"
#include "scene/Shown.h"
#include "scene/StructureAt.h"

namespace velum::render {

namespace {

/// Whose the middles of a row of voxels are.
void readIds(const StructureField& field, const glm::dmat4& labelFromVoxel, int y, int z,
             std::vector<std::uint16_t>& ids) {
  const LabelVolume& labels = *field.cover().labels();
  for (std::size_t x = 0; x < ids.size(); ++x) {
    glm::dvec3 place(labelFromVoxel * glm::dvec4(double(x), y, z, 1.0)), nearest = glm::floor(place + 0.5);
    // The middle of a label's voxel is that label's.
    bool isMiddle = glm::length(place - nearest) < 1e-3;
    ids[x] = isMiddle ? labels.at(glm::ivec3(nearest)) : field.at(place).id;
  }
}

bool sparesAny(const scene::Scene& scene) {
  return std::ranges::any_of(scene::enabledOf(scene.cuts), [](const scene::Cut& cut) { return !cut.spares.empty(); });
}

}  // namespace

std::vector<std::uint8_t> keptVoxels(const scene::Scene& scene, glm::ivec3 dims, const glm::dmat4& worldFromVoxel,
                                     Progress& progress) {
  scene::SectionPlane plane;
  plane.centre = glm::dvec3(worldFromVoxel * glm::dvec4(0.5 * glm::dvec3(dims - 1), 1.0));
  RowCuts cuts(scene, plane, {});
  std::vector<std::uint8_t> kept(std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z), 1);
  if (cuts.isEmpty()) return kept;
  const auto& labels = scene.labels;
  bool usesLabels = labels.data && labels.visible && sparesAny(scene);
  std::shared_ptr<const StructureField> field = usesLabels ? scene::structureFieldOf(scene) : nullptr;
  glm::dmat4 labelFromVoxel(1.0);
  if (usesLabels) labelFromVoxel = glm::inverse(labels.data->worldFromVoxel()) * worldFromVoxel;
  double step = glm::length(glm::dvec3(worldFromVoxel[0]));
  glm::vec3 along(glm::dvec3(worldFromVoxel[0]) / step);
  for (int z = 0; z < dims.z; ++z) {
    progress.report(double(z) / dims.z, "cutting");
    parallelFor(0, dims.y, [&](int y) {
      std::vector<std::uint16_t> ids(usesLabels ? std::size_t(dims.x) : 0);
      if (usesLabels) readIds(*field, labelFromVoxel, y, z, ids);
      glm::vec3 start(glm::dvec3(worldFromVoxel * glm::dvec4(0.0, y, z, 1.0)) - plane.centre);
      std::vector<char> removed = cuts.removedOf({start, along, dims.x, step}, ids);
      std::size_t row = (std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x);
      for (std::size_t x = 0; x < removed.size(); ++x) kept[row + x] = removed[x] ? 0 : 1;
    });
  }
  return kept;
}

}  // namespace velum::render
