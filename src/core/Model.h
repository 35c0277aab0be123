#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/Fields.h"

namespace velum {

/// One atom in the frame of its molecule.
struct Atom {
  glm::vec3 position{0.0f};  ///< angstrom
  std::uint8_t element = 6;  ///< Atomic number; kResidue: a whole residue, as in files that have C-alpha atoms only.
  std::uint16_t chain = 0;   ///< Chains of the molecule, counted from 0.
  bool operator==(const Atom&) const = default;
};
constexpr std::uint8_t kResidue = 0;

/// Van der Waals radius of an element (A. Bondi, 1964), angstrom; for kResidue the radius of a ball of a residue's
/// volume.
float radiusOf(std::uint8_t element);
/// Standard atomic weight of an element, dalton; for kResidue the mean mass of a residue in proteins.
double massOf(std::uint8_t element);

/// The shape that instances are copies of: atoms, or beads (balls that stand for several atoms), or both.
struct Molecule {
  std::uint32_t type = 0;   ///< in Model::types
  std::vector<Atom> atoms;  ///< Empty where only beads are known.
  /// Levels of beads, finest first; each bead is centre and radius, angstrom.
  std::vector<std::vector<glm::vec4>> beads;
  std::uint32_t firstInstance = 0, instanceCount = 0;
  glm::vec3 centre{0.0f};  ///< Centre of a sphere around the whole molecule, angstrom.
  float radius = 0.0f;
};

enum class MoleculeKind { Protein, Lipid, NucleicAcid, Other };
template <>
struct EnumNames<MoleculeKind> {
  static constexpr std::string_view kNames[] = {"protein", "lipid", "nucleic acid", "other"};
};

/// Where a mass comes from.
enum class MassSource { Unknown, File, Atoms, Beads };
template <>
struct EnumNames<MassSource> {
  static constexpr std::string_view kNames[] = {"unknown", "file", "atoms", "beads"};
};

/// Where the instances of a type come from.
enum class Origin {
  File,    ///< The file has them.
  Curves,  ///< The file has curves, along which they were put.
  Added    ///< They were made to complete the model.
};
template <>
struct EnumNames<Origin> {
  static constexpr std::string_view kNames[] = {"file", "curves", "added"};
};

/// An ingredient. A type has one molecule or several, as lipids of one kind have many shapes.
struct MoleculeType {
  std::string name;
  std::uint32_t compartment = 0;  ///< in Model::compartments
  MoleculeKind kind = MoleculeKind::Protein;
  std::string function;     ///< "DNA repair"; empty when unknown.
  std::string description;  ///< For people; may be Markdown.
  std::string structure;    ///< The database entry or file that the type's atoms come from.
  double mass = 0.0;        ///< Of one instance, dalton.
  MassSource massSource = MassSource::Unknown;
  std::optional<glm::vec3> color;  ///< sRGB, where the file gives one.
  Origin origin = Origin::File;
  std::uint32_t firstMolecule = 0, moleculeCount = 0;
  std::uint32_t firstInstance = 0, instanceCount = 0;
};

/// A copy of a molecule: rotation * x + position.
struct Instance {
  glm::vec3 position{0.0f};  ///< angstrom, world
  std::uint32_t molecule = 0;
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};  ///< unit
  bool operator==(const Instance&) const = default;
};

/// A part of the tree that types hang in.
struct Compartment {
  std::string name;
  std::int32_t parent = -1;  ///< Index of the compartment around this one, always smaller than its own; -1: this is the
                             ///< root, the first of all.
};

/// A strand: instances of one type along a curve.
struct Fibre {
  std::uint32_t type = 0;
  std::vector<glm::vec3> points;  ///< As the file has them, angstrom.
  std::uint32_t firstInstance = 0, instanceCount = 0;
};

/// Molecules and where their copies stand, as cells and viruses are described. World: angstrom, right-handed.
///
/// Instances are sorted by molecule, and molecules by type, so that all instances of a type, and of a molecule, follow
/// each other. Made by a ModelBuilder, then held as `Shared<Model>` and never changed.
struct Model {
  std::vector<Compartment> compartments;
  std::vector<MoleculeType> types;
  std::vector<Molecule> molecules;
  std::vector<Instance> instances;
  std::vector<Fibre> fibres;
  glm::vec3 low{0.0f}, high{0.0f};    ///< A box around the spheres of all instances.
  std::string name;                   ///< For people.
  std::vector<std::string> warnings;  ///< What the reader had to assume or leave out, one line each.
  std::vector<std::string> added;     ///< What was made to complete the model, and how, one line each.
};

/// The names from the root to the type with dots between them: "root.capsid.surface.CA".
std::string pathOf(const Model& model, const MoleculeType& type);

/// A random number from 0 to before 1, fixed for each instance: a share of a type's instances are those whose number is
/// below the share.
/// @param stream  numbers of different streams are independent of each other
float randomOf(std::uint32_t instance, std::uint32_t stream = 0);

/// How many atoms, and how many beads of the finest level, all instances of a type have together.
std::uint64_t atomCount(const Model& model, const MoleculeType& type);
std::uint64_t beadCount(const Model& model, const MoleculeType& type);
/// Bytes that the model takes.
std::uint64_t storedBytes(const Model& model);

}  // namespace velum
