#pragma once
#include <glm/glm.hpp>

#include "core/Model.h"
#include "core/ReplaceFile.h"
#include "core/Task.h"
#include "io/models/WriteModel.h"

/// The writers behind writeModel(), which hands them a model that has instances and a colour for each type, and commits
/// the file.
namespace velum::io {

void writeCif(const Model& model, const ModelWriting& how, ReplaceFile& file, Progress& progress);
/// @throw InputError when the model does not fit into 4 GB
void writeModelGltf(const Model& model, const ModelWriting& how, ReplaceFile& file, Progress& progress);
void writeModelCsv(const Model& model, const ModelWriting& how, ReplaceFile& file, Progress& progress);
void writeModelPly(const Model& model, const ModelWriting& how, ReplaceFile& file, Progress& progress);

/// The middle of the sphere around an instance.
inline glm::vec3 middleOf(const Model& model, const Instance& instance) {
  return instance.position + instance.rotation * model.molecules[instance.molecule].centre;
}

}  // namespace velum::io
