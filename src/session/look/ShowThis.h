#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "scene/SceneFwd.h"
#include "session/look/ValueHistogram.h"

namespace velum::session {

/// The values of the material at a place.
struct Tissue {
  double value = 0;   ///< the middle of its values, the volume's unit
  double spread = 0;  ///< standard deviation of its noise, robustly; never less than a 300th of the data's range
  std::optional<double> low, high;  ///< halfway to the darker, to the brighter material beside it, where there is one
  double here = 0;                  ///< at the place itself, with its noise
};

/// Measures the 5^3 voxels around a place, then those of 13^3 that are like them, unless these are another material:
/// one whose middle lies farther off than the spread of the first. Of both the half with the smaller gradients counts,
/// so that a border nearby does not mix two materials; what lies beyond halfway to the materials beside it does not
/// count at all, so that a thin vessel is not taken for what is around it. Nothing outside the volume.
std::optional<Tissue> measureTissue(const scene::VolumeLayer& layer, glm::dvec3 world);
/// @param histograms  knows the layer's, or will
std::optional<Tissue> measureTissue(const scene::VolumeLayer& layer, glm::dvec3 world, HistogramMemo& histograms);

/// Makes the material at a place opaque: a bump of opacity over its values, in the colour that the colour map has there
/// or, where that is dark, a brighter tone of it. All else becomes a veil that hides about a third of what is behind
/// half the data.
/// @param add  leaves all else as it is
/// @return what was measured; nothing, and no change, outside the volume
std::optional<Tissue> showThis(scene::Scene& scene, glm::dvec3 world, bool add = false);

/// The inverse: takes the opacity from the values of the material at a place.
std::optional<Tissue> hideThis(scene::Scene& scene, glm::dvec3 world);

}  // namespace velum::session
