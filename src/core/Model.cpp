#include "core/Model.h"

#include <array>

namespace velum {

namespace {

struct ElementRow {
  std::uint8_t number;
  float radius;
  float mass;
};
// What molecules are made of; everything else is as large as carbon and a little heavier than two of it per proton.
constexpr ElementRow kElements[] = {
    {kResidue, 3.2f, 110.0f}, {1, 1.1f, 1.008f},   {5, 1.92f, 10.81f},   {6, 1.7f, 12.011f},   {7, 1.55f, 14.007f},
    {8, 1.52f, 15.999f},      {9, 1.47f, 18.998f}, {11, 2.27f, 22.99f},  {12, 1.73f, 24.305f}, {14, 2.1f, 28.085f},
    {15, 1.8f, 30.974f},      {16, 1.8f, 32.06f},  {17, 1.75f, 35.45f},  {19, 2.75f, 39.098f}, {20, 2.31f, 40.078f},
    {25, 1.7f, 54.938f},      {26, 1.7f, 55.845f}, {27, 1.7f, 58.933f},  {28, 1.63f, 58.693f}, {29, 1.4f, 63.546f},
    {30, 1.39f, 65.38f},      {34, 1.9f, 78.971f}, {35, 1.85f, 79.904f}, {53, 1.98f, 126.9f},
};

const ElementRow* rowOf(std::uint8_t element) {
  for (const ElementRow& row : kElements)
    if (row.number == element) return &row;
  return nullptr;
}

/// The finaliser of MurmurHash3, 32 bits: every bit of the input changes half of the result's.
std::uint32_t mixed(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x85ebca6bu;
  x ^= x >> 13;
  x *= 0xc2b2ae35u;
  return x ^ (x >> 16);
}

}  // namespace

float radiusOf(std::uint8_t element) {
  const ElementRow* row = rowOf(element);
  return row ? row->radius : 1.7f;
}

double massOf(std::uint8_t element) {
  const ElementRow* row = rowOf(element);
  return row ? double(row->mass) : 2.2 * element;
}

std::string pathOf(const Model& model, const MoleculeType& type) {
  std::string path = type.name;
  for (auto at = std::int32_t(type.compartment); at >= 0; at = model.compartments[std::size_t(at)].parent)
    path = model.compartments[std::size_t(at)].name + "." + path;
  return path;
}

float randomOf(std::uint32_t instance, std::uint32_t stream) {
  // Numbers that differ in one bit would else stay alike; the constant is 2^32 over the golden ratio.
  std::uint32_t bits = mixed(instance + 0x9e3779b9u * (stream + 1u));
  return float(bits >> 8) * (1.0f / 16777216.0f);
}

std::uint64_t atomCount(const Model& model, const MoleculeType& type) {
  std::uint64_t count = 0;
  for (std::uint32_t m = type.firstMolecule; m < type.firstMolecule + type.moleculeCount; ++m)
    count += std::uint64_t(model.molecules[m].instanceCount) * model.molecules[m].atoms.size();
  return count;
}

std::uint64_t beadCount(const Model& model, const MoleculeType& type) {
  std::uint64_t count = 0;
  for (std::uint32_t m = type.firstMolecule; m < type.firstMolecule + type.moleculeCount; ++m)
    if (const auto& beads = model.molecules[m].beads; !beads.empty())
      count += std::uint64_t(model.molecules[m].instanceCount) * beads.front().size();
  return count;
}

std::uint64_t storedBytes(const Model& model) {
  std::uint64_t bytes = model.instances.capacity() * sizeof(Instance) + model.molecules.capacity() * sizeof(Molecule) +
                        model.types.capacity() * sizeof(MoleculeType);
  for (const Molecule& molecule : model.molecules) {
    bytes += molecule.atoms.capacity() * sizeof(Atom);
    for (const auto& level : molecule.beads) bytes += level.capacity() * sizeof(glm::vec4);
  }
  for (const Fibre& fibre : model.fibres) bytes += fibre.points.capacity() * sizeof(glm::vec3);
  return bytes;
}

}  // namespace velum
