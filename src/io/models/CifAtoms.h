#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/models/CifTable.h"
#include "io/models/ModelParts.h"

namespace velum::io {

/// The rows of _atom_site.
struct CifAtoms {
  std::vector<Atom> atoms;                         ///< Atom::chain is 0 in all of them.
  CifColumn::Codes asym, authAsym, entity, comp;   ///< Where a column is missing, one code with an empty name.
  std::vector<std::int32_t> model;                 ///< As numbered in the file; 1 where the file gives no number.
  std::vector<bool> isHetero;                      ///< The row is a HETATM record.
  bool areBeads = false;                           ///< All atoms are "CA" of the element CA: balls of unknown size.
  std::vector<std::vector<std::uint32_t>> ofAsym;  ///< For each code of `asym`, its rows.
};

/// @throw InputError where the block has no atoms, or atoms without places
CifAtoms readCifAtoms(const CifBlock& block, const Path& path);

MoleculeKind kindOf(const CifAtoms& atoms, const std::vector<std::uint32_t>& rows);

}  // namespace velum::io
