#include "velum/render/section/KeptInstances.h"

#include "FrameSetup.h"
#include "shared/instance.h"
#include "velum/core/ModelBuilder.h"
#include "velum/core/Parallel.h"
#include "velum/mesoscale/InstanceRows.h"

namespace velum::render {

std::vector<std::uint8_t> keptInstances(const scene::Scene& scene, const SheetIndices& sheets) {
  if (!scene.model.data) return {};
  const Model& model = *scene.model.data;
  scene::ModelBox box = scene::modelBox(scene.model);
  double scale = unitsPer(LengthUnit::Angstrom, scene.unit);
  glm::dvec3 origin = 0.5 * (box.low + box.high) * scale;
  CpuSheets cpuSheets = makeCpuSheets(scene, sheets);
  std::vector<shared::CutData> cuts = makeCutData(scene, origin, cpuSheets.plans);
  std::vector<shared::TypeSpareRow> spares = mesoscale::makeTypeSpareRows(scene);
  std::uint32_t whole = mesoscale::wholeInstanceBits(scene);
  scene::CopyGrid copies = scene::copyGrid(scene.model);
  std::size_t count = model.instances.size(), all = count * std::size_t(std::max(1, scene.model.copies));
  std::vector<std::uint8_t> kept(all, 1);
  if (cuts.empty()) return kept;
  parallelForRanges(std::size_t(0), all, std::size_t(4096), [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      const Instance& instance = model.instances[i % count];
      const Molecule& molecule = model.molecules[instance.molecule];
      int copy = int(i / count);
      glm::ivec3 at(copy % copies.counts.x, copy / copies.counts.x % copies.counts.y,
                    copy / (copies.counts.x * copies.counts.y));
      glm::dvec3 middle = glm::dvec3(instance.position) + glm::dvec3(instance.rotation * molecule.centre) +
                          copies.step * glm::dvec3(at);
      glm::vec3 p(middle * scale - origin);
      float u = randomOf(std::uint32_t(i)), radius = float(molecule.radius * scale);
      shared::CutFold fold = shared::emptyFold();
      for (std::size_t c = 0; c < cuts.size(); ++c) {
        float depth = shared::typeSpareDepth(spares[molecule.type * cuts.size() + c], u);
        float reach = c < 32 && (whole >> c & 1u) != 0 ? radius : 0.0f;
        fold = shared::foldAnswer(fold, shared::cutPart(cuts[c]),
                                  shared::instanceAnswer(cuts[c], depth, reach, p, cpuSheets.view()));
      }
      kept[i] = shared::foldKeeps(fold) ? 1 : 0;
    }
  });
  return kept;
}

Model shownModel(const scene::Scene& scene, const std::vector<std::uint8_t>& kept) {
  const Model& model = *scene.model.data;
  ModelBuilder builder(model.name);
  // Compartments by their paths, types and molecules one by one: what is left empty goes when the model is built.
  std::vector<std::uint32_t> compartmentOf(model.compartments.size());
  for (std::size_t c = 0; c < model.compartments.size(); ++c) {
    std::vector<std::string> path;
    for (auto at = std::int32_t(c); model.compartments[std::size_t(at)].parent >= 0;
         at = model.compartments[std::size_t(at)].parent)
      path.insert(path.begin(), model.compartments[std::size_t(at)].name);
    compartmentOf[c] = builder.compartment(path);
  }
  std::vector<std::uint32_t> moleculeOf(model.molecules.size());
  for (const MoleculeType& type : model.types) {
    MoleculeType copy = type;
    copy.compartment = compartmentOf[type.compartment];
    std::uint32_t number = builder.addType(copy);
    for (std::uint32_t m = type.firstMolecule; m < type.firstMolecule + type.moleculeCount; ++m)
      moleculeOf[m] = builder.addMolecule(number, model.molecules[m].atoms, model.molecules[m].beads);
  }
  for (std::size_t t = 0; t < model.types.size(); ++t) {
    const MoleculeType& type = model.types[t];
    if (!scene::typeLook(scene.model, pathOf(model, type)).visible) continue;
    for (std::uint32_t i = type.firstInstance; i < type.firstInstance + type.instanceCount; ++i)
      if (kept[i])
        builder.addInstance(moleculeOf[model.instances[i].molecule], model.instances[i].position,
                            model.instances[i].rotation);
  }
  return builder.build();
}

}  // namespace velum::render
