#pragma once
#include <string>

#include "scene/SceneFwd.h"

/// Where labels lie beside the scan that they are of.
namespace velum::session {

/// What to say where the scene's labels are not where its scan is: less than a twentieth of what is labelled lies in
/// it, or all of it in a few of its voxels. Empty where they fit, and where there is nothing to compare. Looks at some
/// hundred thousand voxels: milliseconds.
std::string misplacedLabels(const scene::Scene& scene);

}  // namespace velum::session
