#pragma once
#include "scene/SceneFwd.h"

namespace velum::scene {

/// The data's file says how the patient lay: letters and names of the patient's directions may be shown. Of models and
/// of surfaces no file does; of labels alone one that has placed them does.
bool hasPatientDirections(const Scene& scene);

}  // namespace velum::scene
