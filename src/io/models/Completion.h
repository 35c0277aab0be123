#pragma once
#include "io/models/ModelParts.h"

namespace velum::io {

/// Adds to a virus the parts that its file leaves out: lipids of the envelope on which its proteins stand, and the
/// strand of RNA in its capsid. Does nothing where the model has no envelope, or already has lipids. What was added is
/// noted in Model::added.
/// @param path  file of the model; control points of a strand may lie in a file beside it
void completeVirus(ModelBuilder& builder, const Path& path);

}  // namespace velum::io
