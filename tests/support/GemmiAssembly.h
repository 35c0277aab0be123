#pragma once
#include <cstddef>
#include <string>
#include <vector>

/// What gemmi finds in an mmCIF file, in plain types: its headers are C++17 to clang, see src/io/models/GemmiCif.h. So
/// are this header and its source.
namespace velum {

/// A copy of a subchain.
struct GemmiOperator {
  double shift[3], turnedZ[3];  ///< Where it puts the origin, and how it turns (0, 0, 1).
  std::size_t subchains = 0;
};

struct GemmiAssembly {
  std::string block;                     ///< Name of the first.
  std::size_t count = 0, atoms = 0;      ///< Assemblies, and atoms of the first model.
  std::vector<GemmiOperator> operators;  ///< Of the first assembly, in its order.
};

/// @throw std::runtime_error where gemmi does
GemmiAssembly readByGemmi(const std::string& text);

}  // namespace velum
