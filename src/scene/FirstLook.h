#pragma once
#include "scene/SceneFwd.h"

namespace velum::scene {

/// Gives a layer and the lighting the look in which new data is first seen: that of choosePreset(), unless the
/// surroundings of the object would hide it. Where more than three fifths of the box's faces would be opaque,
/// background and noise are learnt from the volume's borders, and only material that stands out from them shows. A
/// single plane is unlit. Thick slices are smoothed. The grey window is firstWindow().
void applyFirstLook(Scene& scene);

/// Gives the structures of labels that have just been opened the look in which they are first seen: solid but
/// for the skin, in the colours of their anatomy where the file has none (solidColor()).
void applyFirstLook(LabelLayer& labels);

/// Factor on the opacity of a scan around solid structures, so that these are seen in it.
constexpr double kReceded = 0.06;

}  // namespace velum::scene
