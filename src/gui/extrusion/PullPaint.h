#pragma once
#include "gui/tool/Manipulator.h"

namespace velum::gui {

/// What shows where things can be pulled out ([ACS] 4.3): the data's box as wires, the outline of each plane, that of
/// the supporting one twice as wide, and, of planes that open a wedge together, the parts pale that the other one
/// leaves.
/// @param supporting  id of the cut; 0: none
void paintPlanes(ViewPainter& over, const scene::Scene& scene, int supporting);

}  // namespace velum::gui
