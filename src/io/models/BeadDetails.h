#pragma once
#include <string>
#include <vector>

#include "core/Task.h"
#include "io/models/ModelParts.h"

namespace velum::io {

/// A molecule of which the model has beads.
struct BeadMolecule {
  std::string name;
  std::uint32_t type, molecule;
};

/// Adds what lies beside a model of beads: masses and functions of a table of proteins (.csv with columns name,
/// molecular_weight and function), and atoms of structures of the same names, moved into the frame of the beads.
/// Does nothing where nothing lies there. @throw InputError for a file that is there and damaged
void addBeadDetails(ModelBuilder& builder, const std::vector<BeadMolecule>& molecules, const Path& path,
                    Progress& progress);

}  // namespace velum::io
