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

/// Adds details from files that lie beside a model of beads: masses and functions from a table of proteins (.csv with
/// columns name, molecular_weight and function), and atoms from structure files named like the molecules, moved into
/// the frame of the beads. Does nothing where there are no such files. @throw InputError for such a file that is
/// damaged
void addBeadDetails(ModelBuilder& builder, const std::vector<BeadMolecule>& molecules, const Path& path,
                    Progress& progress);

}  // namespace velum::io
