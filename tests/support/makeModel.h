#pragma once
#include <random>
#include <string>
#include <vector>

#include "core/ModelBuilder.h"

namespace velum {

/// A molecule of atoms at random in a ball.
inline std::vector<Atom> randomAtoms(int count, float radius, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  std::vector<Atom> atoms;
  while (int(atoms.size()) < count) {
    glm::vec3 p(unit(random), unit(random), unit(random));
    if (glm::dot(p, p) <= 1.0f) atoms.push_back({radius * p, 6, std::uint16_t(atoms.size() % 3)});
  }
  return atoms;
}

inline glm::quat randomTurn(std::mt19937& random) {
  std::normal_distribution<float> normal;
  return glm::normalize(glm::quat(normal(random), normal(random), normal(random), normal(random)));
}

/// Types of one molecule each, in compartments root.a and root.b by turns, with instances at random in a cube about the
/// origin.
struct ModelMaker {
  int types = 3, atoms = 60, instances = 200;
  float moleculeRadius = 12.0f, halfEdge = 200.0f;
  unsigned seed = 1;

  Model make() const {
    ModelBuilder builder("made");
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(-halfEdge, halfEdge);
    std::vector<std::uint32_t> molecules;
    for (int t = 0; t < types; ++t) {
      std::vector<std::string> path{t % 2 ? "b" : "a"};
      MoleculeType type;
      type.name = "type" + std::to_string(t);
      type.compartment = builder.compartment(path);
      std::uint32_t number = builder.addType(type);
      molecules.push_back(builder.addMolecule(number, randomAtoms(atoms, moleculeRadius, seed * 131u + unsigned(t))));
    }
    for (int i = 0; i < instances; ++i) {
      glm::vec3 at(unit(random), unit(random), unit(random));
      builder.addInstance(molecules[std::size_t(i) % molecules.size()], at, randomTurn(random));
    }
    return builder.build();
  }
};

/// Single atoms of given radii class (carbon), one type, at given places.
inline Model modelOfAtoms(const std::vector<glm::vec3>& places, std::uint8_t element = 6) {
  ModelBuilder builder("atoms");
  MoleculeType type;
  type.name = "atom";
  type.compartment = builder.compartment(std::vector<std::string>{});
  std::uint32_t molecule = builder.addMolecule(builder.addType(type), {{glm::vec3(0.0f), element, 0}});
  for (const glm::vec3& place : places) builder.addInstance(molecule, place, glm::quat(1, 0, 0, 0));
  return builder.build();
}

}  // namespace velum
