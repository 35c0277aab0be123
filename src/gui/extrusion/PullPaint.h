#pragma once
#include "gui/tool/Manipulator.h"

namespace velum::gui {

/// Paints what shows where structures can be pulled out ([ACS] 4.3): the data's box as wires, and the outline of each
/// plane, twice as wide for the supporting plane. Where planes open a wedge together, the parts of a plane that the
/// other plane leaves are filled pale. @param supporting  id of the cut out of which structures are pulled; 0: none
void paintPlanes(ViewPainter& over, const scene::Scene& scene, int supporting);

}  // namespace velum::gui
