#pragma once
#include <string>
#include <vector>

#include "io/models/ModelParts.h"
#include "io/models/PdbFile.h"

namespace velum::io {

/// Atoms that move together: a chain, or one ligand.
struct StructurePart {
  std::string type;   ///< Parts of one name are of one type.
  std::string chain;  ///< What copies name.
  MoleculeKind kind = MoleculeKind::Protein;
  int model = 0;  ///< Counted from 0.
  std::vector<Atom> atoms;
};

/// A structure of one molecule or complex, as the Protein Data Bank has them.
struct PlainStructure {
  std::string title;
  std::vector<StructurePart> parts;
  std::vector<PdbCopies> copies;  ///< Of the first biological assembly; empty: the atoms as they are.
};

/// Its chains and ligands as types, in the copies of its biological assembly. Several models that lie in one place are
/// different views of the same thing, of which the first is taken; else they are parts of one.
/// @throw InputError
Model buildPlainModel(PlainStructure structure, const Path& path);

}  // namespace velum::io
