#pragma once
#include "scene/Membrane.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// What a new membrane keeps whole: what the scene shows most. Where structures are shown, these are the smaller ones,
/// as the large ones (body, muscle, lung) lie everywhere and can only be cut; else the values that the transfer
/// function shows most opaque, down to the opacity above which they are a small part of the data; for a model alone its
/// compartments of the least mass. Empty without data. One pass over a sample of the data.
scene::ForceField defaultField(const scene::Scene& scene);

}  // namespace velum::session
