#include "membrane/forces/TypeGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>
#include "scene/Crowd.h"

namespace velum::membrane {

namespace {

/// Voxels along the longest edge: what a kernel stands for is a few molecules across, as with volumes it is some
/// voxels.
constexpr int kVoxelsAlongEdge = 160;
/// Angstrom. In smaller voxels there would be gaps between the atoms of a molecule.
constexpr double kLeastVoxel = 4.0;
constexpr float kLeastFill = 0.25f;

/// A part of a molecule, in the molecule's own frame.
struct Lump {
  glm::vec3 place{0.0f};
  float volume = 0.0f;  ///< angstrom^3
};

float volumeOf(float radius) { return 4.0f / 3.0f * std::numbers::pi_v<float> * radius * radius * radius; }

/// A ball as lumps of an edge, so that large ones fill all voxels that they lie in.
void addBall(std::vector<Lump>& lumps, glm::vec3 middle, float radius, float edge) {
  int reach = int(radius / edge);
  std::size_t first = lumps.size();
  for (int z = -reach; z <= reach; ++z)
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x)
        if (glm::vec3 aside = glm::vec3(x, y, z) * edge; glm::dot(aside, aside) <= radius * radius)
          lumps.push_back({middle + aside, 0.0f});
  for (std::size_t i = first; i < lumps.size(); ++i) lumps[i].volume = volumeOf(radius) / float(lumps.size() - first);
}

/// What lies in the same cell becomes one lump.
std::vector<Lump> gathered(const std::vector<Lump>& lumps, float edge) {
  std::vector<std::pair<glm::ivec3, std::size_t>> cells;
  for (std::size_t i = 0; i < lumps.size(); ++i) cells.emplace_back(glm::floor(lumps[i].place / edge), i);
  auto key = [](const auto& cell) { return std::tuple(cell.first.z, cell.first.y, cell.first.x, cell.second); };
  std::sort(cells.begin(), cells.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  std::vector<Lump> out;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i == 0 || cells[i].first != cells[i - 1].first) out.emplace_back();
    const Lump& part = lumps[cells[i].second];
    out.back().volume += part.volume;
    out.back().place += part.place * part.volume;
  }
  for (Lump& lump : out) lump.place /= lump.volume;
  return out;
}

std::vector<Lump> lumpsOf(const Molecule& molecule, float edge) {
  std::vector<Lump> lumps;
  for (const Atom& atom : molecule.atoms) addBall(lumps, atom.position, radiusOf(atom.element), edge);
  if (molecule.atoms.empty() && !molecule.beads.empty())
    for (const glm::vec4& bead : molecule.beads[0])
      if (bead.w > 0.0f) addBall(lumps, glm::vec3(bead), bead.w, edge);
  return gathered(lumps, edge);
}

/// Who fills most of each voxel, from type to type.
class Filling {
 public:
  Filling(glm::ivec3 dims, float voxelVolume)
      : mDims(dims), mIds(std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z)) {
    mMost.assign(mIds.size(), kLeastFill * voxelVolume);
    mOwn.assign(mIds.size(), 0.0f);
  }
  /// Of the type at hand. @param voxel  place in voxels; their middles are at integers
  void add(glm::vec3 voxel, float volume) {
    glm::ivec3 at(glm::floor(voxel + 0.5f));
    if (glm::any(glm::lessThan(at, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(at, mDims))) return;
    std::size_t i =
        (std::size_t(at.z) * std::size_t(mDims.y) + std::size_t(at.y)) * std::size_t(mDims.x) + std::size_t(at.x);
    if (mOwn[i] == 0.0f) mTouched.push_back(i);
    mOwn[i] += volume;
  }
  /// The type at hand is complete.
  void finish(std::uint16_t id) {
    for (std::size_t i : mTouched) {
      if (mOwn[i] > mMost[i]) {
        mMost[i] = mOwn[i];
        mIds[i] = id;
      }
      mOwn[i] = 0.0f;
    }
    mTouched.clear();
  }
  const std::vector<std::uint16_t>& ids() const { return mIds; }

 private:
  glm::ivec3 mDims;
  std::vector<std::uint16_t> mIds;
  std::vector<float> mMost, mOwn;
  std::vector<std::size_t> mTouched;
};

std::vector<glm::vec3> shiftsOf(const scene::CopyGrid& copies, int count) {
  std::vector<glm::vec3> shifts;
  for (int z = 0; z < copies.counts.z; ++z)
    for (int y = 0; y < copies.counts.y; ++y)
      for (int x = 0; x < copies.counts.x; ++x)
        if (int(shifts.size()) < count) shifts.emplace_back(copies.step * glm::dvec3(x, y, z));
  return shifts;
}

}  // namespace

TypeLattice typeLattice(const scene::ModelLayer& layer, const scene::ModelFrame& frame) {
  scene::ModelBox box = scene::modelBox(layer);
  glm::dvec3 edges = box.high - box.low;
  TypeLattice lattice;
  lattice.voxel = std::max(kLeastVoxel, std::max(edges.x, std::max(edges.y, edges.z)) / kVoxelsAlongEdge);
  lattice.dims = glm::max(glm::ivec3(glm::ceil(edges / lattice.voxel)), glm::ivec3(1));
  lattice.worldFromVoxel = glm::dmat4(lattice.voxel * frame.length);
  lattice.worldFromVoxel[3] = glm::dvec4(frame.worldOf(box.low + 0.5 * lattice.voxel), 1.0);
  return lattice;
}

LabelVolume makeTypeGrid(const scene::ModelLayer& layer, const scene::ModelFrame& frame, LengthUnit unit) {
  scene::refuseCrowd(layer, "what membranes protect");
  const Model& model = *layer.data;
  scene::ModelBox box = scene::modelBox(layer);
  TypeLattice lattice = typeLattice(layer, frame);
  double voxel = lattice.voxel;
  glm::ivec3 dims = lattice.dims;
  std::vector<glm::vec3> shifts = shiftsOf(scene::copyGrid(layer), scene::copyCount(layer));
  Filling filling(dims, float(voxel * voxel * voxel));
  std::size_t most = std::numeric_limits<std::uint16_t>::max();
  for (std::size_t t = 0; t < std::min(model.types.size(), most); ++t) {
    const MoleculeType& type = model.types[t];
    for (std::uint32_t m = type.firstMolecule; m < type.firstMolecule + type.moleculeCount; ++m) {
      const Molecule& molecule = model.molecules[m];
      std::vector<Lump> lumps = lumpsOf(molecule, float(0.5 * voxel));
      for (std::uint32_t i = molecule.firstInstance; i < molecule.firstInstance + molecule.instanceCount; ++i)
        for (const Lump& lump : lumps) {
          const Instance& instance = model.instances[i];
          glm::vec3 place = instance.position + instance.rotation * lump.place - glm::vec3(box.low);
          for (glm::vec3 shift : shifts) filling.add((place + shift) / float(voxel) - 0.5f, lump.volume);
        }
    }
    filling.finish(std::uint16_t(t + 1));
  }
  LabelVolume grid(dims, lattice.worldFromVoxel, unit);
  grid.write(glm::ivec3(0), dims, filling.ids());
  return grid;
}

}  // namespace velum::membrane
