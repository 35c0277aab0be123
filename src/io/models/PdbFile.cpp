#include "io/models/PdbFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/Text.h"

namespace velum::io {

namespace {

/// Columns as the format counts them, from 1; fewer where the line ends.
std::string_view columns(std::string_view line, std::size_t first, std::size_t last) {
  return line.size() < first ? std::string_view() : line.substr(first - 1, last - first + 1);
}

class PdbParser {
 public:
  PdbParser(std::string_view text, const Path& path) : mRest(text), mPath(path) {}

  PdbFile parse() {
    while (!mRest.empty()) {
      takeLine();
      std::string_view record = columns(mLine, 1, 6);
      if (record == "ATOM  " || record == "HETATM")
        addAtom(record == "HETATM");
      else if (record == "ENDMDL")
        ++mModel;
      else if (record == "COMPND")
        mCompound += std::string(columns(mLine, 11, 80));
      else if (record == "TITLE ")
        mFile.title += std::string(trimmed(columns(mLine, 11, 80))) + " ";
      else if (record == "REMARK" && columns(mLine, 8, 10) == "350")
        readAssembly(columns(mLine, 12, 80));
    }
    mFile.title = std::string(trimmed(mFile.title));
    nameChains();
    markResidues();
    return std::move(mFile);
  }

 private:
  void takeLine() {
    std::size_t end = std::min(mRest.find('\n'), mRest.size());
    mLine = mRest.substr(0, end);
    while (!mLine.empty() && mLine.back() == '\r') mLine.remove_suffix(1);
    mRest.remove_prefix(std::min(end + 1, mRest.size()));
    ++mNumber;
  }

  float coordinate(std::size_t first) const {
    auto value = numberIn(trimmed(columns(mLine, first, first + 7)));
    if (!value || !(std::abs(*value) < 1e8)) refuse(mPath, fmt::format("line {} has no coordinates", mNumber));
    return float(*value);
  }

  void addAtom(bool isHetero) {
    PdbAtom a;
    a.isHetero = isHetero;
    a.model = mModel;
    a.atom.position = {coordinate(31), coordinate(39), coordinate(47)};
    a.atom.element = element();
    a.atom.chain = chainOf(std::string(trimmed(columns(mLine, 21, 22))));
    std::string_view residue = columns(mLine, 18, 20);
    a.residue.fill(' ');
    std::copy(residue.begin(), residue.end(), a.residue.end() - std::ptrdiff_t(residue.size()));
    a.residueNumber = std::int32_t(numberIn(trimmed(columns(mLine, 23, 26))).value_or(0));
    if (!isHetero) mHasOthers |= trimmed(columns(mLine, 13, 16)) != "CA";
    mFile.atoms.push_back(a);
  }

  /// By its columns, else by the atom's name, in which the symbol is right-aligned in two columns.
  std::uint8_t element() const {
    std::string_view symbol = trimmed(columns(mLine, 77, 78));
    if (!symbol.empty() && std::isalpha(static_cast<unsigned char>(symbol.front()))) return elementOf(symbol);
    std::string_view name = columns(mLine, 13, 14);
    if (name.size() < 2) return 6;
    bool isOneLetter = name[0] == ' ' || std::isdigit(static_cast<unsigned char>(name[0])) || name[0] == 'H' ||
                       columns(mLine, 1, 4) == "ATOM";
    if (!isOneLetter) return elementOf(name);
    bool isSecond = name[0] == ' ' || std::isdigit(static_cast<unsigned char>(name[0]));
    return elementOf(name.substr(isSecond ? 1 : 0, 1));
  }

  std::uint16_t chainOf(std::string name) {
    auto [at, isNew] = mChains.try_emplace(std::move(name), mFile.chains.size());
    if (isNew) mFile.chains.push_back(at->first);
    return std::uint16_t(at->second);
  }

  void readAssembly(std::string_view text) {
    std::string_view said = trimmed(text);
    if (said.starts_with("BIOMOLECULE:")) {
      ++mAssembly;
    } else if (mAssembly > 1) {
      return;
    } else if (said.starts_with("APPLY THE FOLLOWING TO CHAINS:") || said.starts_with("AND CHAINS:")) {
      if (said.front() == 'A' && said[1] == 'P') mFile.copies.emplace_back();
      if (mFile.copies.empty()) mFile.copies.emplace_back();
      std::string names(said.substr(said.find(':') + 1));
      std::replace(names.begin(), names.end(), ',', ' ');
      for (std::string& name : wordsOf(names)) mFile.copies.back().chains.push_back(std::move(name));
    } else if (said.starts_with("BIOMT")) {
      readOperator(said);
    }
  }

  /// "BIOMT1   1  1.0 0.0 0.0  0.0": a row of an operator.
  void readOperator(std::string_view said) {
    int row = said.size() > 5 ? said[5] - '1' : -1;
    if (row < 0 || row > 2) return;
    said.remove_prefix(6);
    takeNumber(said);
    for (int column = 0; column < 4; ++column) {
      auto value = takeNumber(said);
      if (!value) refuse(mPath, fmt::format("line {} is no operator", mNumber));
      (column < 3 ? mMatrix[column][row] : mShift[row]) = *value;
    }
    if (row != 2) return;
    if (mFile.copies.empty()) mFile.copies.emplace_back();
    auto pose = poseOf(mMatrix, mShift);
    if (!pose) refuse(mPath, fmt::format("line {} ends an operator that is no rotation", mNumber));
    mFile.copies.back().poses.push_back(*pose);
  }

  /// "MOL_ID: 1; MOLECULE: CAPSID PROTEIN; CHAIN: A, B;"
  void nameChains() {
    std::string molecule;
    std::string_view rest = mCompound;
    while (!rest.empty()) {
      std::size_t end = std::min(rest.find(';'), rest.size());
      std::string_view item = trimmed(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
      std::size_t colon = item.find(':');
      if (colon == std::string_view::npos) continue;
      std::string_view key = trimmed(item.substr(0, colon)), value = trimmed(item.substr(colon + 1));
      if (key.ends_with("MOLECULE")) molecule = std::string(value);
      if (!key.ends_with("CHAIN")) continue;
      std::string chains(value);
      std::replace(chains.begin(), chains.end(), ',', ' ');
      for (std::string& chain : wordsOf(chains)) mFile.moleculeOf.emplace(std::move(chain), molecule);
    }
  }

  void markResidues() {
    mFile.hasAlphaOnly = !mHasOthers && std::any_of(mFile.atoms.begin(), mFile.atoms.end(),
                                                    [](const PdbAtom& a) { return !a.isHetero; });
    if (!mFile.hasAlphaOnly) return;
    for (PdbAtom& a : mFile.atoms)
      if (!a.isHetero) a.atom.element = kResidue;
  }

  std::string_view mRest, mLine;
  const Path& mPath;
  PdbFile mFile;
  std::map<std::string, std::size_t> mChains;
  std::string mCompound;
  glm::dmat3 mMatrix{1.0};
  glm::dvec3 mShift{0.0};
  std::size_t mNumber = 0;
  std::int32_t mModel = 0;
  int mAssembly = 0;
  bool mHasOthers = false;
};

}  // namespace

PdbFile parsePdb(std::string_view text, const Path& path) { return PdbParser(text, path).parse(); }

std::vector<Atom> ingredientAtoms(const PdbFile& file, bool withCopies) {
  std::vector<Atom> atoms;
  auto isProper = [](const PdbAtom& a) { return !a.isHetero && a.model == 0; };
  bool hasProper = std::any_of(file.atoms.begin(), file.atoms.end(), isProper);
  for (const PdbAtom& a : file.atoms)
    if (hasProper ? isProper(a) : a.model == 0) atoms.push_back(a.atom);
  if (!withCopies || file.copies.empty()) return atoms;
  std::vector<Atom> copied;
  for (const PdbCopies& copies : file.copies)
    for (const Pose& pose : copies.poses)
      for (Atom atom : atoms) {
        const std::string& chain = file.chains[atom.chain];
        bool isMoved = copies.chains.empty() ||
                       std::find(copies.chains.begin(), copies.chains.end(), chain) != copies.chains.end();
        if (!isMoved) continue;
        if (copied.size() >= kMostInstances) return copied;
        atom.position = pose.rotation * atom.position + pose.position;
        copied.push_back(atom);
      }
  return copied;
}

bool isNucleotide(std::string_view residue) {
  std::string_view name = trimmed(residue);
  constexpr std::string_view kNames[] = {"A",  "C",  "G",  "U",   "T",   "I",   "DA",  "DC",  "DG",
                                         "DT", "DU", "DI", "ADE", "CYT", "GUA", "URA", "THY", "N"};
  return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
}

bool isNucleic(const PdbFile& file) {
  auto count = std::count_if(file.atoms.begin(), file.atoms.end(), [](const PdbAtom& a) {
    return isNucleotide(std::string_view(a.residue.data(), a.residue.size()));
  });
  return std::size_t(count) * 2 > file.atoms.size();
}

}  // namespace velum::io
