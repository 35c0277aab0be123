#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/models/CifTable.h"
#include "io/models/ModelParts.h"

namespace velum::io {

/// The rows of _atom_site.
struct CifAtoms {
  std::vector<Atom> atoms;                         ///< Their chains are 0.
  CifColumn::Codes asym, authAsym, entity, comp;   ///< Where a column is missing, one code with an empty name.
  std::vector<std::int32_t> model;                 ///< As numbered in the file; 1 where it does not say.
  std::vector<bool> isHetero;                      ///< HETATM
  bool areBeads = false;                           ///< All are "CA" of the element CA: balls without a size.
  std::vector<std::vector<std::uint32_t>> ofAsym;  ///< Rows of each code.
};

/// @throw InputError where there are none, or without places
CifAtoms readCifAtoms(const CifBlock& block, const Path& path);

MoleculeKind kindOf(const CifAtoms& atoms, const std::vector<std::uint32_t>& rows);

}  // namespace velum::io
