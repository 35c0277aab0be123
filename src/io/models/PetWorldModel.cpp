#include <fmt/format.h>

#include <map>

#include "io/models/Assembly.h"
#include "io/models/CifAtoms.h"
#include "io/models/CifModels.h"
#include "io/read/FileNames.h"

/// Models of YASARA PetWorld: each model of the file is a type, and operators move all of it.
namespace velum::io {

Model petWorldModel(const CifBlock& block, const Path& path, Progress& progress) {
  CifAtoms atoms = readCifAtoms(block, path);
  progress.report(0.5, "reading model");
  const CifTable& models = *block.find("pdbx_model");
  const CifTable* generators = block.find("pdbx_struct_assembly_gen");
  if (!generators) refuse(path, "has models but no instances of them (_pdbx_struct_assembly_gen)");
  std::map<std::int32_t, std::vector<std::uint32_t>> rowsOf;
  for (std::size_t row = 0; row < atoms.atoms.size(); ++row) rowsOf[atoms.model[row]].push_back(std::uint32_t(row));
  ModelBuilder builder(titleOf(path));
  std::map<std::int32_t, std::uint32_t> moleculeOf;
  for (std::size_t m = 0; m < models.rows; ++m) {
    auto rows = rowsOf.find(std::int32_t(m + 1));
    if (rows == rowsOf.end()) continue;
    MoleculeType type{.name = models.text("name", m), .kind = kindOf(atoms, rows->second)};
    type.description = models.text("description", m);
    if (type.name.starts_with("membrane")) type.kind = MoleculeKind::Lipid;
    std::vector<Atom> own;
    std::map<std::uint32_t, std::uint16_t> chains;
    for (std::uint32_t row : rows->second) {
      own.push_back(atoms.atoms[row]);
      own.back().chain = chains.try_emplace(atoms.asym.ofRow[row], std::uint16_t(chains.size())).first->second;
    }
    moleculeOf[std::int32_t(m + 1)] = builder.addMolecule(builder.addType(std::move(type)), std::move(own));
  }
  Operators operators(block.find("pdbx_struct_oper_list"), path);
  for (std::size_t row = 0; row < generators->rows; ++row) {
    double number = generators->number("pdb_model_num", row);
    auto molecule = moleculeOf.find(number > 0 && number < 2e9 ? std::int32_t(number) : std::int32_t(row + 1));
    if (molecule == moleculeOf.end()) continue;
    operators.forEach(generators->text("oper_expression", row),
                      [&](const Pose& pose) { place(builder, path, molecule->second, pose); });
  }
  Model model = builder.build();
  if (model.instances.empty()) refuse(path, "has no instances of its models");
  return model;
}

}  // namespace velum::io
