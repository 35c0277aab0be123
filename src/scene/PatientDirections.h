#pragma once
#include "scene/SceneFwd.h"

namespace velum::scene {

/// True when the data's file says how the patient lay, so that letters and names of the patient's directions may be
/// shown. Files of models and surfaces never say so; a file of labels alone does when it has placed the labels.
bool hasPatientDirections(const Scene& scene);

}  // namespace velum::scene
