#include "app/ModelInfo.h"

#include <algorithm>

namespace velum::app {

namespace {

Json describe(const Model& model, const MoleculeType& type) {
  std::size_t atoms = 0, beads = 0;
  for (std::uint32_t m = type.firstMolecule; m < type.firstMolecule + type.moleculeCount; ++m) {
    const Molecule& molecule = model.molecules[m];
    atoms = std::max(atoms, molecule.atoms.size());
    if (!molecule.beads.empty()) beads = std::max(beads, molecule.beads.front().size());
  }
  Json json = {{"name", type.name},
               {"path", pathOf(model, type)},
               {"kind", std::string(enumName(type.kind))},
               {"function", type.function},
               {"instances", type.instanceCount},
               {"atoms", atoms},
               {"beads", beads},
               {"atomsInAll", atomCount(model, type)},
               {"mass", type.mass},
               {"massFrom", std::string(enumName(type.massSource))},
               {"structure", type.structure}};
  if (type.moleculeCount > 1) json["molecules"] = type.moleculeCount;
  return json;
}

}  // namespace

Json describeModel(const Model& model) {
  std::size_t types = 0;
  std::uint64_t instances = 0, atoms = 0, beads = 0;
  Json perType = Json::array(), added = Json::array(), fibres = Json::array();
  for (std::size_t i = 0; i < model.types.size(); ++i) {
    const MoleculeType& type = model.types[i];
    std::size_t curves = 0, points = 0;
    for (const Fibre& fibre : model.fibres)
      if (fibre.type == i) ++curves, points += fibre.points.size();
    if (curves > 0)
      fibres.push_back(
          {{"name", type.name}, {"curves", curves}, {"points", points}, {"instances", type.instanceCount}});
    if (type.origin == Origin::Added) added.push_back(describe(model, type));
    if (type.origin != Origin::File) continue;
    ++types;
    instances += type.instanceCount;
    atoms += atomCount(model, type);
    beads += beadCount(model, type);
    perType.push_back(describe(model, type));
  }
  return {{"kind", "model"},
          {"name", model.name},
          {"types", types},
          {"instances", instances},
          {"atoms", atoms},
          {"beads", beads},
          {"bounds", {listOf(model.low, 3), listOf(model.high, 3)}},
          {"lengthUnit", std::string(enumName(LengthUnit::Angstrom))},
          {"perType", perType},
          {"fibres", fibres},
          {"added", added},
          {"completed", model.added},
          {"warnings", model.warnings}};
}

}  // namespace velum::app
