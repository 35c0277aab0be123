#pragma once
#include <string>

#include "scene/Mark.h"
#include "scene/SceneFwd.h"

namespace velum::app {

/// Reads a mark as an option has it: its kind, then NAME=VALUE with blanks between them:
/// "distance points=0,0,0;10,0,0 alongSurface=true text=Width structure=aorta". What stands behind text= is all the
/// rest. A structure is given by its name or number. @throw ArgumentError
scene::Mark parseMark(const scene::Scene& scene, const std::string& text);

}  // namespace velum::app
