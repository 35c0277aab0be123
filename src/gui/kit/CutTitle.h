#pragma once
#include <QString>

#include "scene/SceneFwd.h"

namespace velum::gui {

/// What a cut is called in lists and messages: by its name, or where it has none by its place among the scene's.
/// @param index  its place, from 0
QString cutTitle(const scene::Cut& cut, int index);
/// The same of a scene's cut by its id; empty where there is none.
QString cutTitle(const scene::Scene& scene, int id);

}  // namespace velum::gui
