#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "io/models/Assembly.h"
#include "io/models/CifAtoms.h"
#include "io/models/CifModels.h"
#include "io/models/PlainModel.h"

/// Entries of the Protein Data Bank and of prediction servers: entities are types, their asyms the molecules.
namespace velum::io {

namespace {

struct EntityNames {
  std::map<std::string, std::string> description, type;

  explicit EntityNames(const CifTable* entities) {
    for (std::size_t row = 0; entities && row < entities->rows; ++row) {
      description[entities->text("id", row)] = entities->text("pdbx_description", row);
      type[entities->text("id", row)] = entities->text("type", row);
    }
  }
};

/// What the first assembly copies. Each row of generators is one set of copies.
std::vector<PdbCopies> copiesOf(const CifBlock& block, const Path& path) {
  std::vector<PdbCopies> all;
  const CifTable* generators = block.find("pdbx_struct_assembly_gen");
  if (!generators) return all;
  Operators operators(block.find("pdbx_struct_oper_list"), path);
  std::string first = generators->text("assembly_id", 0);
  std::size_t count = 0;
  for (std::size_t row = 0; row < generators->rows; ++row) {
    if (generators->text("assembly_id", row) != first) continue;
    PdbCopies copies;
    std::string asyms = generators->text("asym_id_list", row);
    for (std::string_view asym : itemsOf(asyms)) copies.chains.emplace_back(asym);
    if (copies.chains.empty()) continue;
    operators.forEach(generators->text("oper_expression", row), [&](const Pose& pose) {
      if (++count > kMostInstances) refuse(path, fmt::format("names more than {} instances", kMostInstances));
      copies.poses.push_back(pose);
    });
    all.push_back(std::move(copies));
  }
  return all;
}

}  // namespace

Model plainCifModel(const CifBlock& block, const Path& path, Progress& progress) {
  CifAtoms atoms = readCifAtoms(block, path);
  progress.report(0.5, "reading model");
  EntityNames entities(block.find("entity"));
  PlainStructure structure;
  if (const CifTable* about = block.find("struct")) structure.title = about->text("title", 0);
  std::map<std::pair<std::int32_t, std::uint32_t>, std::vector<std::uint32_t>> rowsOf;
  for (std::size_t row = 0; row < atoms.atoms.size(); ++row)
    rowsOf[{atoms.model[row], atoms.asym.ofRow[row]}].push_back(std::uint32_t(row));
  for (const auto& [key, rows] : rowsOf) {
    const std::string& entity = atoms.entity.names[atoms.entity.ofRow[rows.front()]];
    const std::string& comp = atoms.comp.names[atoms.comp.ofRow[rows.front()]];
    if (entities.type[entity] == "water" || comp == "HOH") continue;
    StructurePart part;
    part.chain = atoms.asym.names[key.second];
    part.type = entities.description[entity];
    if (part.type.empty()) part.type = entity.empty() ? "chain " + part.chain : "entity " + entity;
    part.kind =
        atoms.isHetero[rows.front()] && entities.type[entity] != "polymer" ? MoleculeKind::Other : kindOf(atoms, rows);
    part.model = key.first;
    for (std::uint32_t row : rows) part.atoms.push_back(atoms.atoms[row]);
    structure.parts.push_back(std::move(part));
  }
  structure.copies = copiesOf(block, path);
  return buildPlainModel(std::move(structure), path);
}

}  // namespace velum::io
