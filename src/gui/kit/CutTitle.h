#pragma once
#include <QString>

#include "scene/SceneFwd.h"

namespace velum::gui {

/// What a cut is called in lists and messages: its name, or, for a cut without a name, its place among the scene's
/// cuts. Names that the program has given are in the window's language, in the scene they are English. @param index the
/// cut's place, from 0
QString cutTitle(const scene::Cut& cut, int index);
/// The title of the scene's cut with an id; empty where there is no such cut.
QString cutTitle(const scene::Scene& scene, int id);

}  // namespace velum::gui
