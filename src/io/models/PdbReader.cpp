#include <fmt/format.h>

#include <map>
#include <tuple>

#include "core/Text.h"
#include "io/models/ModelReaders.h"
#include "io/models/PdbFile.h"
#include "io/models/PlainModel.h"

namespace velum::io {

namespace {

bool isWater(std::string_view residue) { return residue == "HOH" || residue == "DOD" || residue == "WAT"; }

std::string nameOfChain(const PdbFile& file, const std::string& chain) {
  auto at = file.moleculeOf.find(chain);
  if (at != file.moleculeOf.end() && !at->second.empty()) return at->second;
  return chain.empty() ? "chain" : "chain " + chain;
}

}  // namespace

Model readPdb(const Path& path, Progress& progress, const ModelReading&) {
  PdbFile file = parsePdb(textOf(path), path);
  progress.report(0.5, "reading model");
  PlainStructure structure{.title = file.title, .parts = {}, .copies = std::move(file.copies)};
  // Chains by model; of what is no chain each residue by itself.
  std::map<std::tuple<int, std::uint16_t, bool, std::int32_t, std::string>, std::size_t> partOf;
  for (const PdbAtom& a : file.atoms) {
    std::string residue(trimmed(std::string_view(a.residue.data(), a.residue.size())));
    if (a.isHetero && isWater(residue)) continue;
    auto key = std::tuple(int(a.model), a.atom.chain, a.isHetero, a.isHetero ? a.residueNumber : 0,
                          a.isHetero ? residue : std::string());
    auto [at, isNew] = partOf.try_emplace(key, structure.parts.size());
    const std::string& chain = file.chains[a.atom.chain];
    if (isNew)
      structure.parts.push_back({.type = a.isHetero ? residue : nameOfChain(file, chain),
                                 .chain = chain,
                                 .kind = a.isHetero              ? MoleculeKind::Other
                                         : isNucleotide(residue) ? MoleculeKind::NucleicAcid
                                                                 : MoleculeKind::Protein,
                                 .model = a.model,
                                 .atoms = {}});
    structure.parts[at->second].atoms.push_back(a.atom);
    structure.parts[at->second].atoms.back().chain = 0;
  }
  return buildPlainModel(std::move(structure), path);
}

}  // namespace velum::io
