#pragma once
#include "io/models/ModelParts.h"

namespace velum::io {

/// Adds to a virus what its file leaves out: lipids of the envelope on which its proteins stand, and the strand of RNA
/// in its capsid. Does nothing where it finds no envelope, or where there are lipids. Says what it made.
/// @param path  beside which control points of a strand may lie
void completeVirus(ModelBuilder& builder, const Path& path);

}  // namespace velum::io
