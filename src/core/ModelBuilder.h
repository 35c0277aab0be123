#pragma once
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/Model.h"

namespace velum {

/// Builds a model out of parts that may be added in any order.
class ModelBuilder {
 public:
  explicit ModelBuilder(std::string name);

  /// The compartment at the end of a path below the root; made where it is missing.
  std::uint32_t compartment(std::span<const std::string> path);
  /// @param type  name, compartment and what is known; its ranges are filled by build()
  std::uint32_t addType(MoleculeType type);
  /// @return number of the molecule, for addInstance()
  std::uint32_t addMolecule(std::uint32_t type, std::vector<Atom> atoms,
                            std::vector<std::vector<glm::vec4>> beads = {});
  /// Replaces the atoms of a molecule.
  void setAtoms(std::uint32_t molecule, std::vector<Atom> atoms);
  /// @param position  finite
  /// @param rotation  normalised here; where it cannot be, the instance is not rotated
  void addInstance(std::uint32_t molecule, glm::vec3 position, glm::quat rotation);
  /// addFibre() adds a fibre of the instances that were added since the last fibre, or since the last call of
  /// beginFibre(), in the order of the strand.
  void beginFibre();
  void addFibre(std::uint32_t type, std::vector<glm::vec3> points);

  const Compartment& compartmentAt(std::uint32_t index) const { return mModel.compartments[index]; }
  MoleculeType& type(std::uint32_t index) { return mModel.types[index]; }
  const Molecule& molecule(std::uint32_t index) const { return mModel.molecules[index]; }
  std::size_t typeCount() const { return mModel.types.size(); }
  std::size_t instanceCount() const { return mModel.instances.size(); }
  std::span<const Instance> instances() const { return mModel.instances; }
  void warn(std::string line) { mModel.warnings.push_back(std::move(line)); }
  void sayAdded(std::string line) { mModel.added.push_back(std::move(line)); }

  /// Sorts, drops types and molecules without instances or without atoms and beads, and computes spheres, bounds and
  /// the masses that no file gave. Once.
  Model build();

 private:
  void sortMolecules();
  void dropEmptyTypes();
  void sortInstances();
  void computeMass(MoleculeType& type) const;
  void computeBounds();

  Model mModel;
  std::map<std::pair<std::uint32_t, std::string>, std::uint32_t> mChildren;  ///< Compartments by parent and name.
  std::size_t mFibreBegin = 0;
};

/// A sphere around atoms and beads: not the smallest one, but at most 1.3 times as large.
/// @return centre and radius
glm::vec4 sphereAround(std::span<const Atom> atoms, std::span<const std::vector<glm::vec4>> beads);

}  // namespace velum
