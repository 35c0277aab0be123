#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/ModelBuilder.h"

namespace velum::io {

/// A phospholipid with two tails of carbon and a head of choline, in the way of POPC: its leaflet's middle plane at
/// z = 0, its head at 20 angstrom. Shapes of other numbers differ by bends of the tails.
std::vector<Atom> lipidAtoms(unsigned shape);

/// One nucleotide of a strand, with the phosphate outside and the base across its axis, z.
std::vector<Atom> nucleotideAtoms();

struct EnvelopePlan {
  std::vector<std::string> path;  ///< Of the compartment.
  glm::vec3 middle{0.0f};
  float radius = 0.0f;  ///< Of the middle plane, angstrom.
  Origin origin = Origin::File;
};

/// Two leaflets of lipids, each as dense as in cells, evenly spread and turned at random, but repeatably.
/// @param isFree  whether a lipid may stand there: the place of its middle
/// @return how many
std::size_t addEnvelope(ModelBuilder& builder, const EnvelopePlan& plan, const std::function<bool(glm::vec3)>& isFree);

/// The i-th of so many points on a sphere of radius 1 that are as evenly spread as a spiral allows.
glm::vec3 spiralPoint(std::size_t i, std::size_t count);

}  // namespace velum::io
