#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/ModelBuilder.h"

namespace velum::io {

/// The atoms of a phospholipid like POPC, with two tails of carbon and a head of choline: the membrane's middle plane
/// is at z = 0, the head at z = 20 angstrom. Shapes with different numbers differ by bends of the tails.
std::vector<Atom> lipidAtoms(unsigned shape);

/// The atoms of one nucleotide of a strand along z, with the phosphate outside and the base across the axis.
std::vector<Atom> nucleotideAtoms();

struct EnvelopePlan {
  std::vector<std::string> path;  ///< Path of the compartment that the lipids belong to.
  glm::vec3 middle{0.0f};
  float radius = 0.0f;  ///< Of the middle surface between the leaflets, angstrom.
  Origin origin = Origin::File;
};

/// Adds two leaflets of lipids, each as dense as in cells; the lipids are evenly spread and turned at random, but
/// repeatably.
/// @param isFree  whether a lipid may stand in a place, given by the lipid's middle
/// @return how many lipids were added
std::size_t addEnvelope(ModelBuilder& builder, const EnvelopePlan& plan, const std::function<bool(glm::vec3)>& isFree);

/// The i-th of `count` points on a sphere of radius 1, spread as evenly as a spiral allows.
glm::vec3 spiralPoint(std::size_t i, std::size_t count);

}  // namespace velum::io
