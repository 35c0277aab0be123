#include "CoarseLook.h"

#include "velum/membrane/forces/Limit.h"

namespace velum::session {

namespace {
constexpr int kLooksAlongEdge = 48;
}

CoarseLook::CoarseLook(const scene::Scene& scene, const scene::ForceField& field, Progress& progress) {
  scene::ForceField seen = field;
  seen.byGradient.clear();
  membrane::Potential potential(scene);
  glm::ivec3 dims = potential.dims();
  mStep = glm::max(dims / kLooksAlongEdge, glm::ivec3(1));
  mVoxels.box.end = dims / mStep;
  mVoxels.worldFromVoxel = potential.worldFromVoxel();
  mVoxels.worldFromVoxel[3] = potential.worldFromVoxel() * glm::dvec4(glm::dvec3(mStep / 2), 1.0);
  for (int axis = 0; axis < 3; ++axis) mVoxels.worldFromVoxel[axis] *= double(mStep[axis]);
  for (int z = 0; z < mVoxels.box.end.z; ++z) {
    glm::ivec3 first(0, 0, voxelOf({0, 0, z}).z);
    auto layer = potential.computeProtected(seen, {first, {dims.x, dims.y, first.z + 1}}, progress);
    for (int y = 0; y < mVoxels.box.end.y; ++y)
      for (int x = 0; x < mVoxels.box.end.x; ++x) {
        glm::ivec3 at = voxelOf({x, y, z});
        mVoxels.mask.push_back(layer.mask[std::size_t(at.y) * std::size_t(dims.x) + std::size_t(at.x)]);
      }
  }
}

CoarseLook::Pairs CoarseLook::pairsOf(const scene::Cut& cut, Progress& progress) const {
  membrane::CutLattice lattice = membrane::gatherLattice(mVoxels, cut);
  std::vector<int> flat(std::size_t(lattice.dims.x) * std::size_t(lattice.dims.y), membrane::flatCount(lattice));
  return {membrane::countCutPairs(lattice, flat),
          membrane::computeLeastCut(lattice, cut.membrane->field.side, progress).cutPairs};
}

}  // namespace velum::session
