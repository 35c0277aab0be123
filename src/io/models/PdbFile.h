#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/models/ModelParts.h"

/// Structures in the format of the Protein Data Bank. Read by us and not by gemmi, which looks through all chains at
/// every change of chain, and refuses files that other programs wrote.
namespace velum::io {

struct PdbAtom {
  Atom atom;                    ///< Its chain is an index of PdbFile::chains.
  std::array<char, 3> residue;  ///< "ALA", with blanks before shorter names.
  std::int32_t residueNumber = 0;
  std::int32_t model = 0;  ///< Counted from 0.
  bool isHetero = false;   ///< A HETATM record.
};

/// Chains that operators move, of the first biological assembly.
struct PdbCopies {
  std::vector<std::string> chains;
  std::vector<Pose> poses;
};

struct PdbFile {
  std::vector<PdbAtom> atoms;
  std::vector<std::string> chains;
  std::map<std::string, std::string> moleculeOf;  ///< What COMPND calls a chain.
  std::vector<PdbCopies> copies;
  std::string title;
  bool hasAlphaOnly = false;  ///< All ATOM records are C-alpha atoms; they are kResidue.
};

/// @param path  named by errors  @throw InputError
PdbFile parsePdb(std::string_view text, const Path& path);

/// What an ingredient is made of: the ATOM records of the first model, or the HETATM records where there is no other.
/// @param withCopies  as the first biological assembly has them
std::vector<Atom> ingredientAtoms(const PdbFile& file, bool withCopies);

/// Whether most atoms are of nucleotides, by the names of their residues.
bool isNucleotide(std::string_view residue);
bool isNucleic(const PdbFile& file);

}  // namespace velum::io
