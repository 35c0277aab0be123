#include "core/ModelBuilder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/Assert.h"

namespace velum {

namespace {

/// Dalton of an angstrom^3 of protein: 1.35 g/cm^3 (H. Fischer et al., 2004) times 0.6022.
constexpr double kProteinDensity = 0.813;
/// No index.
constexpr std::uint32_t kNone = 0xffffffff;

bool isFinite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Indices in the order of their keys; those of equal keys stay as they were.
template <class Key>
std::vector<std::uint32_t> orderBy(std::size_t count, const Key& key) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  return order;
}

template <class T>
std::vector<T> arranged(std::vector<T>& from, const std::vector<std::uint32_t>& order) {
  std::vector<T> to;
  to.reserve(order.size());
  for (std::uint32_t i : order) to.push_back(std::move(from[i]));
  return to;
}

}  // namespace

glm::vec4 sphereAround(std::span<const Atom> atoms, std::span<const std::vector<glm::vec4>> beads) {
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  auto forAll = [&](auto&& body) {
    for (const Atom& a : atoms) body(a.position, radiusOf(a.element));
    for (const auto& level : beads)
      for (const glm::vec4& bead : level) body(glm::vec3(bead), bead.w);
  };
  forAll([&](glm::vec3 p, float radius) {
    low = glm::min(low, p - radius);
    high = glm::max(high, p + radius);
  });
  if (low.x > high.x) return glm::vec4(0.0f);
  glm::vec3 centre = 0.5f * (low + high);
  float radius = 0.0f;
  forAll([&](glm::vec3 p, float own) { radius = std::max(radius, glm::length(p - centre) + own); });
  return glm::vec4(centre, radius);
}

ModelBuilder::ModelBuilder(std::string name) {
  mModel.name = std::move(name);
  mModel.compartments.push_back({"root", -1});
}

std::uint32_t ModelBuilder::compartment(std::span<const std::string> path) {
  std::uint32_t at = 0;
  for (const std::string& name : path) {
    auto [child, isNew] = mChildren.try_emplace({at, name}, std::uint32_t(mModel.compartments.size()));
    if (isNew) mModel.compartments.push_back({name, std::int32_t(at)});
    at = child->second;
  }
  return at;
}

std::uint32_t ModelBuilder::addType(MoleculeType type) {
  VELUM_ASSERT(type.compartment < mModel.compartments.size(), "a type lies in a compartment");
  // Counted from nothing, also where it comes out of another model.
  type.firstMolecule = type.moleculeCount = type.firstInstance = type.instanceCount = 0;
  mModel.types.push_back(std::move(type));
  return std::uint32_t(mModel.types.size() - 1);
}

std::uint32_t ModelBuilder::addMolecule(std::uint32_t type, std::vector<Atom> atoms,
                                        std::vector<std::vector<glm::vec4>> beads) {
  VELUM_ASSERT(type < mModel.types.size(), "a molecule has a type");
  std::erase_if(beads, [](const auto& level) { return level.empty(); });
  glm::vec4 sphere = sphereAround(atoms, beads);
  mModel.molecules.push_back({.type = type,
                              .atoms = std::move(atoms),
                              .beads = std::move(beads),
                              .centre = glm::vec3(sphere),
                              .radius = sphere.w});
  return std::uint32_t(mModel.molecules.size() - 1);
}

void ModelBuilder::setAtoms(std::uint32_t molecule, std::vector<Atom> atoms) {
  Molecule& of = mModel.molecules[molecule];
  of.atoms = std::move(atoms);
  glm::vec4 sphere = sphereAround(of.atoms, of.beads);
  of.centre = glm::vec3(sphere);
  of.radius = sphere.w;
}

void ModelBuilder::addInstance(std::uint32_t molecule, glm::vec3 position, glm::quat rotation) {
  VELUM_ASSERT(molecule < mModel.molecules.size(), "an instance has a molecule");
  VELUM_ASSERT(isFinite(position), "an instance is somewhere");
  float length = glm::length(rotation);
  bool isRotation = std::isfinite(length) && length > 1e-6f;
  mModel.instances.push_back({position, molecule, isRotation ? rotation / length : glm::quat(1, 0, 0, 0)});
}

void ModelBuilder::beginFibre() { mFibreBegin = mModel.instances.size(); }

void ModelBuilder::addFibre(std::uint32_t type, std::vector<glm::vec3> points) {
  mModel.fibres.push_back({.type = type,
                           .points = std::move(points),
                           .firstInstance = std::uint32_t(mFibreBegin),
                           .instanceCount = std::uint32_t(mModel.instances.size() - mFibreBegin)});
  mFibreBegin = mModel.instances.size();
}

void ModelBuilder::sortMolecules() {
  auto& molecules = mModel.molecules;
  std::vector<std::uint32_t> countOf(molecules.size(), 0);
  for (const Instance& instance : mModel.instances) ++countOf[instance.molecule];
  std::vector<std::uint32_t> order = orderBy(molecules.size(), [&](std::uint32_t i) { return molecules[i].type; });
  std::erase_if(order, [&](std::uint32_t i) {
    return countOf[i] == 0 || (molecules[i].atoms.empty() && molecules[i].beads.empty());
  });
  std::vector<std::uint32_t> placeOf(molecules.size(), kNone);
  for (std::size_t i = 0; i < order.size(); ++i) placeOf[order[i]] = std::uint32_t(i);
  molecules = arranged(molecules, order);
  for (Instance& instance : mModel.instances) instance.molecule = placeOf[instance.molecule];
}

void ModelBuilder::dropEmptyTypes() {
  std::vector<std::uint32_t> placeOf(mModel.types.size(), kNone);
  std::vector<MoleculeType> kept;
  for (std::size_t i = 0; i < mModel.molecules.size(); ++i) {
    Molecule& molecule = mModel.molecules[i];
    std::uint32_t& place = placeOf[molecule.type];
    if (place == kNone) {
      place = std::uint32_t(kept.size());
      kept.push_back(std::move(mModel.types[molecule.type]));
      kept.back().firstMolecule = std::uint32_t(i);
    }
    molecule.type = place;
    ++kept[place].moleculeCount;
  }
  mModel.types = std::move(kept);
  std::erase_if(mModel.fibres, [&](const Fibre& fibre) { return placeOf[fibre.type] == kNone; });
  for (Fibre& fibre : mModel.fibres) fibre.type = placeOf[fibre.type];
}

void ModelBuilder::sortInstances() {
  auto& instances = mModel.instances;
  std::vector<std::uint32_t> order = orderBy(instances.size(), [&](std::uint32_t i) { return instances[i].molecule; });
  auto isDropped = [&](std::uint32_t i) { return instances[i].molecule >= mModel.molecules.size(); };
  std::erase_if(order, isDropped);
  std::vector<std::uint32_t> placeOf(instances.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i) placeOf[order[i]] = std::uint32_t(i);
  // Those of a fibre are of one molecule, and so still stand in a row.
  for (Fibre& fibre : mModel.fibres) {
    if (fibre.instanceCount > 0 && isDropped(fibre.firstInstance)) fibre.instanceCount = 0;
    fibre.firstInstance = fibre.instanceCount > 0 ? placeOf[fibre.firstInstance] : 0;
  }
  instances = arranged(instances, order);
  for (std::size_t i = 0; i < instances.size(); ++i) {
    Molecule& molecule = mModel.molecules[instances[i].molecule];
    if (molecule.instanceCount++ == 0) molecule.firstInstance = std::uint32_t(i);
    MoleculeType& type = mModel.types[molecule.type];
    if (type.instanceCount++ == 0) type.firstInstance = std::uint32_t(i);
  }
}

void ModelBuilder::computeMass(MoleculeType& type) const {
  if (type.massSource != MassSource::Unknown || type.moleculeCount == 0) return;
  double ofAtoms = 0.0, ofBeads = 0.0;
  for (std::uint32_t m = type.firstMolecule; m < type.firstMolecule + type.moleculeCount; ++m) {
    const Molecule& molecule = mModel.molecules[m];
    for (const Atom& atom : molecule.atoms) ofAtoms += massOf(atom.element);
    if (molecule.atoms.empty())
      for (const glm::vec4& bead : molecule.beads.front())
        ofBeads += 4.0 / 3.0 * 3.14159265358979 * std::pow(double(bead.w), 3.0) * kProteinDensity;
  }
  type.mass = (ofAtoms + ofBeads) / double(type.moleculeCount);
  type.massSource = ofBeads > 0.0 ? MassSource::Beads : MassSource::Atoms;
}

void ModelBuilder::computeBounds() {
  if (mModel.instances.empty()) return;
  mModel.low = glm::vec3(std::numeric_limits<float>::max());
  mModel.high = -mModel.low;
  for (const Instance& instance : mModel.instances) {
    const Molecule& molecule = mModel.molecules[instance.molecule];
    glm::vec3 centre = instance.position + instance.rotation * molecule.centre;
    mModel.low = glm::min(mModel.low, centre - molecule.radius);
    mModel.high = glm::max(mModel.high, centre + molecule.radius);
  }
}

Model ModelBuilder::build() {
  sortMolecules();
  dropEmptyTypes();
  sortInstances();
  for (MoleculeType& type : mModel.types) computeMass(type);
  computeBounds();
  return std::move(mModel);
}

}  // namespace velum
