#include "io/models/CifAtoms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/models/PdbFile.h"

namespace velum::io {

namespace {

CifColumn::Codes codesOf(const CifTable& table, std::initializer_list<std::string_view> names) {
  for (std::string_view name : names)
    if (const CifColumn* column = table.find(name)) return column->codes();
  return {std::vector<std::uint32_t>(table.rows, 0), {""}};
}

/// Fills elements; whole residues where all atoms but those apart are C-alphas.
void fillElements(CifAtoms& atoms, const CifTable& table) {
  CifColumn::Codes symbols = codesOf(table, {"type_symbol"}), names = codesOf(table, {"label_atom_id"});
  std::vector<std::uint8_t> elementOfCode;
  for (const std::string& symbol : symbols.names) elementOfCode.push_back(elementOf(symbol));
  bool isAlphaOnly = true, hasProper = false;
  for (std::size_t row = 0; row < table.rows; ++row) {
    atoms.atoms[row].element = elementOfCode[symbols.ofRow[row]];
    if (atoms.isHetero[row]) continue;
    hasProper = true;
    isAlphaOnly = isAlphaOnly && names.names[names.ofRow[row]] == "CA";
  }
  if (!hasProper || !isAlphaOnly) return;
  atoms.areBeads = std::all_of(symbols.names.begin(), symbols.names.end(), [](const auto& s) { return s == "CA"; });
  for (std::size_t row = 0; row < table.rows; ++row)
    if (!atoms.isHetero[row]) atoms.atoms[row].element = kResidue;
}

}  // namespace

CifAtoms readCifAtoms(const CifBlock& block, const Path& path) {
  const CifTable* table = block.find("atom_site");
  if (!table) refuse(path, "has no atoms (_atom_site)");
  const CifColumn* places[3] = {table->find("cartn_x"), table->find("cartn_y"), table->find("cartn_z")};
  if (!places[0] || !places[1] || !places[2]) refuse(path, "its atoms have no places (_atom_site.Cartn_x, _y, _z)");
  CifAtoms atoms;
  atoms.atoms.resize(table->rows);
  for (std::size_t row = 0; row < table->rows; ++row)
    for (int axis = 0; axis < 3; ++axis) {
      double value = places[axis]->number(row);
      if (!(std::abs(value) < 1e8)) refuse(path, fmt::format("atom {} has no place", row + 1));
      atoms.atoms[row].position[axis] = float(value);
    }
  atoms.asym = codesOf(*table, {"label_asym_id", "auth_asym_id"});
  atoms.authAsym = codesOf(*table, {"auth_asym_id"});
  atoms.entity = codesOf(*table, {"label_entity_id"});
  atoms.comp = codesOf(*table, {"label_comp_id"});
  atoms.model.assign(table->rows, 1);
  if (const CifColumn* model = table->find("pdbx_pdb_model_num"))
    for (std::size_t row = 0; row < table->rows; ++row) {
      double number = model->number(row);
      if (number >= 0 && number < 2e9) atoms.model[row] = std::int32_t(number);
    }
  CifColumn::Codes groups = codesOf(*table, {"group_pdb"});
  for (std::size_t row = 0; row < table->rows; ++row)
    atoms.isHetero.push_back(groups.names[groups.ofRow[row]] == "HETATM");
  fillElements(atoms, *table);
  atoms.ofAsym.resize(atoms.asym.names.size());
  for (std::size_t row = 0; row < table->rows; ++row) atoms.ofAsym[atoms.asym.ofRow[row]].push_back(std::uint32_t(row));
  return atoms;
}

MoleculeKind kindOf(const CifAtoms& atoms, const std::vector<std::uint32_t>& rows) {
  std::size_t nucleotides = 0, lipids = 0;
  for (std::uint32_t row : rows) {
    const std::string& comp = atoms.comp.names[atoms.comp.ofRow[row]];
    nucleotides += isNucleotide(comp);
    lipids += comp == "LIP";
  }
  if (lipids * 2 > rows.size()) return MoleculeKind::Lipid;
  return nucleotides * 2 > rows.size() ? MoleculeKind::NucleicAcid : MoleculeKind::Protein;
}

}  // namespace velum::io
