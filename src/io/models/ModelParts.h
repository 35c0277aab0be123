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

/// More instances than this are no scene but a mistake or malice: files name them by ranges, so that their size says
/// nothing.
constexpr std::size_t kMostInstances = std::size_t(1) << 24;
/// Of one file, inflated.
constexpr std::size_t kMostModelBytes = std::size_t(1) << 30;

/// The whole file, inflated when it is gzip. @throw InputError, also when it is larger than kMostModelBytes
std::string textOf(const Path& path);

/// rotation * x + position
struct Pose {
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
  glm::vec3 position{0.0f};
};
/// The rotation next to a matrix, which files round to three decimals; nothing where it is none: mirrored, flat or no
/// numbers.
std::optional<Pose> poseOf(const glm::dmat3& matrix, const glm::dvec3& position);

/// Atomic number of a symbol in any case, "CL" or "Cl"; carbon for what is none.
std::uint8_t elementOf(std::string_view symbol);

/// Where a molecule has its middle: the mean of its atoms.
glm::vec3 meanOf(std::span<const Atom> atoms);
void move(std::vector<Atom>& atoms, glm::vec3 by);

/// The parts between dots.
std::vector<std::string> partsOf(std::string_view dotted);

/// Adds an instance. @throw InputError past kMostInstances or where the place is no number
void place(ModelBuilder& builder, const Path& path, std::uint32_t molecule, const Pose& pose);

}  // namespace velum::io
