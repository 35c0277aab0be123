#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/ModelBuilder.h"
#include "io/read/Refuse.h"

/// What the readers of models share.
namespace velum::io {

/// A model with more instances than this is taken for a mistake or malice. Files name instances by ranges, so that the
/// size of the file says nothing of their number.
constexpr std::size_t kMostInstances = std::size_t(1) << 24;
/// Most bytes of one file, inflated.
constexpr std::size_t kMostModelBytes = std::size_t(1) << 30;

/// The whole file, inflated when it is gzip. @throw InputError, also when it is larger than kMostModelBytes
std::string textOf(const Path& path);

/// A place and a rotation: x becomes rotation * x + position.
struct Pose {
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
  glm::vec3 position{0.0f};
};
/// The pose whose rotation is nearest to a matrix, which files round to three decimals; nothing where the matrix is no
/// rotation: it is mirrored, flat or has values that are not numbers.
std::optional<Pose> poseOf(const glm::dmat3& matrix, const glm::dvec3& position);

/// Atomic number of an element's symbol in any case, "CL" or "Cl"; that of carbon for an unknown symbol.
std::uint8_t elementOf(std::string_view symbol);

/// The middle of a molecule: the mean of its atoms' positions.
glm::vec3 meanOf(std::span<const Atom> atoms);
void move(std::vector<Atom>& atoms, glm::vec3 by);

/// The parts of a text between its dots.
std::vector<std::string> partsOf(std::string_view dotted);

/// Adds an instance. @throw InputError past kMostInstances or where the place is no number
void place(ModelBuilder& builder, const Path& path, std::uint32_t molecule, const Pose& pose);

}  // namespace velum::io
