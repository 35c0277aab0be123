#include "membrane/forces/CoarseVoxels.h"

#include "core/Parallel.h"
#include "scene/Scene.h"

namespace velum::membrane {

namespace {
/// Of thicker blocks only these layers, in their middle, are looked at.
constexpr int kMostLayers = 4;
}  // namespace

scene::ForceField withoutGradients(scene::ForceField field) {
  field.byGradient.clear();
  return field;
}

CoarseVoxels coarseVoxels(const Potential& potential, const scene::ForceField& field, int along, Progress& progress) {
  CoarseVoxels out;
  glm::ivec3 dims = out.dims = potential.dims();
  out.step = glm::max((dims + along - 1) / along, glm::ivec3(1));
  glm::ivec3 blocks = (dims + out.step - 1) / out.step;
  out.grid.box.end = blocks;
  glm::dmat4 toMiddle(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    toMiddle[axis][axis] = out.step[axis];
    toMiddle[3][axis] = 0.5 * (out.step[axis] - 1);
  }
  out.grid.worldFromVoxel = potential.worldFromVoxel() * toMiddle;
  out.grid.mask.resize(std::size_t(blocks.x) * std::size_t(blocks.y) * std::size_t(blocks.z));
  for (int z = 0; z < blocks.z; ++z) {
    int first = z * out.step.z, end = std::min(first + out.step.z, dims.z);
    int spare = std::max(end - first - kMostLayers, 0);
    first += spare / 2;
    end -= spare - spare / 2;
    ProtectedVoxels layer = potential.computeProtected(field, {{0, 0, first}, {dims.x, dims.y, end}}, progress);
    parallelFor(0, blocks.y, [&](int y) {
      std::vector<int> held(std::size_t(blocks.x), 0);
      int low = y * out.step.y, high = std::min(low + out.step.y, dims.y);
      for (int k = 0; k < end - first; ++k)
        for (int j = low; j < high; ++j) {
          const std::uint8_t* row = layer.mask.data() + (std::ptrdiff_t(k) * dims.y + j) * dims.x;
          for (int x = 0; x < dims.x; ++x) held[std::size_t(x / out.step.x)] += row[x] != 0;
        }
      int voxels = (end - first) * (high - low);
      std::uint8_t* to = out.grid.mask.data() + (std::ptrdiff_t(z) * blocks.y + y) * blocks.x;
      for (int x = 0; x < blocks.x; ++x) {
        int wide = std::min(out.step.x, dims.x - x * out.step.x);
        to[x] = 4 * held[std::size_t(x)] >= voxels * wide ? ProtectedVoxels::kOfData : 0;
      }
    });
  }
  return out;
}

}  // namespace velum::membrane
