#pragma once
#include "scene/Membrane.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// What a new membrane keeps whole: what the scene shows most. Where structures are shown, the smaller ones among them,
/// as the large ones (body, muscle, lung) lie everywhere and can only be cut; else the values that the transfer
/// function shows most opaque, from the opacity on above which they are a small part of the data; of a model alone its
/// compartments of the least mass. Empty without data. One pass over a sample of it.
scene::ForceField defaultField(const scene::Scene& scene);

}  // namespace velum::session
