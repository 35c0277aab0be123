#pragma once
#include "FuzzReader.h"
#include "core/Model.h"
#include "io/models/ModelReaders.h"

namespace velum::io {

inline void expectSound(const Model& model) {
  std::uint32_t molecules = 0, instances = 0;
  for (const MoleculeType& type : model.types) {
    require(type.firstMolecule == molecules && type.firstInstance == instances);
    require(type.compartment < model.compartments.size() && std::isfinite(type.mass));
    molecules += type.moleculeCount;
    instances += type.instanceCount;
    require(!pathOf(model, type).empty());
  }
  require(molecules == model.molecules.size() && instances == model.instances.size());
  for (const Molecule& molecule : model.molecules) {
    require(molecule.type < model.types.size() && std::isfinite(molecule.radius));
    require(!molecule.atoms.empty() || !molecule.beads.empty());
  }
  for (const Instance& instance : model.instances) {
    require(instance.molecule < model.molecules.size());
    require(std::abs(glm::length(instance.rotation) - 1.0f) < 1e-3f);
    require(std::isfinite(instance.position.x) && std::isfinite(instance.position.y) &&
            std::isfinite(instance.position.z));
  }
  for (const Fibre& fibre : model.fibres) {
    require(fibre.type < model.types.size());
    require(std::size_t(fibre.firstInstance) + fibre.instanceCount <= model.instances.size());
  }
}

template <class Read>
int fuzzModel(FuzzFile& file, Read read, const std::uint8_t* data, std::size_t size) {
  file.hold(data, size);
  Progress progress;
  try {
    expectSound(read(file.path(), progress, ModelReading{}));
  } catch (const Error& error) {
    expectOneLine(error);
  }
  return 0;
}

}  // namespace velum::io
