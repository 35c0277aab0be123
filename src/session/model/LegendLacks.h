#pragma once
#include <string>

#include "scene/SceneFwd.h"

namespace velum::session {

/// Says what the legend lists that the scene's data do not have, in one line; empty: there is nothing of the kind.
std::string whatLegendLacks(const scene::Scene& scene);

}  // namespace velum::session
