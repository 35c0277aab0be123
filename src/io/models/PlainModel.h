#pragma once
#include <string>
#include <vector>

#include "io/models/ModelParts.h"
#include "io/models/PdbFile.h"

namespace velum::io {

/// Atoms that move together: a chain, or one ligand.
struct StructurePart {
  std::string type;   ///< Name of the part's type; parts with the same name have the same type.
  std::string chain;  ///< Name of its chain, by which PlainStructure::copies refer to it.
  MoleculeKind kind = MoleculeKind::Protein;
  int model = 0;  ///< Counted from 0.
  std::vector<Atom> atoms;
};

/// A structure of one molecule or complex, as the Protein Data Bank has them.
struct PlainStructure {
  std::string title;
  std::vector<StructurePart> parts;
  std::vector<PdbCopies> copies;  ///< Those of the first biological assembly; empty: the atoms stay as they are, once.
};

/// Makes a model of a structure: its chains and ligands become types, with instances in the copies of its biological
/// assembly. Where several models of the file lie in the same place they are alternatives, of which the first is taken;
/// else they are parts of one whole.
/// @throw InputError
Model buildPlainModel(PlainStructure structure, const Path& path);

}  // namespace velum::io
