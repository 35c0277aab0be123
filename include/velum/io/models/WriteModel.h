#pragma once
#include <filesystem>

#include "velum/core/Model.h"
#include "velum/core/Task.h"

namespace velum::io {

/// Writes mmCIF in the flavour of cellPACK, which readModel(), gemmi and Mol* read: an entity for each type, an asym
/// for each molecule, an operator for each instance. A ".gz" is deflated. Beads become atoms without an element.
/// @throw InputError when the disk refuses; ArgumentError for a name that ends otherwise than in .cif or .cif.gz;
/// Cancelled
void writeModel(const Model& model, const std::filesystem::path& path, Progress& progress);

}  // namespace velum::io
