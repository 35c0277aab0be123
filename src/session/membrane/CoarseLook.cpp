#include "session/membrane/CoarseLook.h"

#include <algorithm>

#include "membrane/forces/Limit.h"
#include "scene/Scene.h"

namespace velum::session {

namespace {
constexpr int kLooksAlongEdge = 48;
}

CoarseLook::CoarseLook(const membrane::Potential& potential, const scene::ForceField& field, Progress& progress)
    : mVoxels(membrane::coarseVoxels(potential, membrane::withoutGradients(field), kLooksAlongEdge, progress)) {}

double CoarseLook::share() const {
  const auto& mask = mVoxels.grid.mask;
  auto held = double(mask.size() - std::size_t(std::count(mask.begin(), mask.end(), 0)));
  return held / double(std::max<std::size_t>(mask.size(), 1));
}

double CoarseLook::depthAlong(glm::dvec3 axis) const {
  glm::dvec3 edges = glm::abs(axis * glm::dmat3(mVoxels.grid.worldFromVoxel));
  return edges.x + edges.y + edges.z;
}

double CoarseLook::wholeDepthAlong(glm::dvec3 axis) const {
  glm::dvec3 edges = glm::abs(axis * glm::dmat3(mVoxels.grid.worldFromVoxel)) * glm::dvec3(mVoxels.grid.box.end);
  return edges.x + edges.y + edges.z;
}

CoarseLook::Outlook CoarseLook::outlookOf(const scene::Cut& cut, Progress& progress) const {
  membrane::CutLattice lattice = membrane::gatherLattice(mVoxels.grid, cut);
  std::vector<int> flat(std::size_t(lattice.dims.x) * std::size_t(lattice.dims.y), membrane::flatCount(lattice));
  membrane::LeastCut least =
      membrane::computeLeastCut(lattice, cut.membrane->field.side, membrane::CutMetric::Pairs, progress);
  return {membrane::countCutPairs(lattice, flat), least.cutPairs,
          membrane::measureFate(mVoxels.grid, cut, membrane::sideOfLeastCut(lattice, least), progress)};
}

}  // namespace velum::session
