#include "CoarseLook.h"

#include <algorithm>

#include "velum/membrane/forces/Limit.h"

namespace velum::session {

namespace {
constexpr int kLooksAlongEdge = 48;
}

CoarseLook::CoarseLook(const membrane::Potential& potential, const scene::ForceField& field, Progress& progress)
    : mVoxels(membrane::coarseVoxels(potential, field, kLooksAlongEdge, progress)) {}

double CoarseLook::share() const {
  const auto& mask = mVoxels.grid.mask;
  auto held = double(mask.size() - std::size_t(std::count(mask.begin(), mask.end(), 0)));
  return held / double(std::max<std::size_t>(mask.size(), 1));
}

double CoarseLook::depthAlong(glm::dvec3 axis) const {
  glm::dvec3 edges = glm::abs(axis * glm::dmat3(mVoxels.grid.worldFromVoxel));
  return edges.x + edges.y + edges.z;
}

CoarseLook::Pairs CoarseLook::pairsOf(const scene::Cut& cut, Progress& progress) const {
  membrane::CutLattice lattice = membrane::gatherLattice(mVoxels.grid, cut);
  std::vector<int> flat(std::size_t(lattice.dims.x) * std::size_t(lattice.dims.y), membrane::flatCount(lattice));
  return {membrane::countCutPairs(lattice, flat),
          membrane::computeLeastCut(lattice, cut.membrane->field.side, membrane::CutMetric::Pairs, progress).cutPairs};
}

}  // namespace velum::session
