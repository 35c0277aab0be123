#pragma once
#include "scene/SceneFwd.h"

namespace velum::scene {

/// Membranes of scenes of before protected the types of a model that was alone as labels with the types' numbers
/// (ForceField::byLabel, counted from 1): these become types by their paths (ForceField::byType). To be called when the
/// model is read. Does nothing where there is other data, whose labels they may be.
void typesFromLabels(Scene& scene);

}  // namespace velum::scene
