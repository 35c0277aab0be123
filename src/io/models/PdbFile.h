#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/models/ModelParts.h"

/// Structures in the format of the Protein Data Bank. We read them ourselves and not by gemmi, which searches all
/// chains at every change of chain and refuses files that some programs write.
namespace velum::io {

struct PdbAtom {
  Atom atom;                    ///< Atom::chain is an index into PdbFile::chains.
  std::array<char, 3> residue;  ///< "ALA", with blanks before shorter names.
  std::int32_t residueNumber = 0;
  std::int32_t model = 0;  ///< Counted from 0.
  bool isHetero = false;   ///< A HETATM record.
};

/// A part of the first biological assembly: chains, and the poses in which copies of them stand.
struct PdbCopies {
  std::vector<std::string> chains;
  std::vector<Pose> poses;
};

struct PdbFile {
  std::vector<PdbAtom> atoms;
  std::vector<std::string> chains;
  std::map<std::string, std::string> moleculeOf;  ///< By chain: the name of its molecule, from COMPND.
  std::vector<PdbCopies> copies;
  std::string title;
  bool hasAlphaOnly = false;  ///< All ATOM records are C-alpha atoms; each counts as a residue (kResidue).
};

/// @param path  for the messages of errors @throw InputError
PdbFile parsePdb(std::string_view text, const Path& path);

/// The atoms of an ingredient: the ATOM records of the first model, or its HETATM records where it has no ATOM records.
/// @param withCopies  with the copies of the first biological assembly
std::vector<Atom> ingredientAtoms(const PdbFile& file, bool withCopies);

/// Whether a residue is a nucleotide, by its name; isNucleic(): whether most atoms of a file belong to such residues.
bool isNucleotide(std::string_view residue);
bool isNucleic(const PdbFile& file);

}  // namespace velum::io
