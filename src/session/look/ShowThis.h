#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "scene/SceneFwd.h"
#include "session/look/ValueHistogram.h"

namespace velum::session {

/// The values of the material at a place.
struct Tissue {
  double value = 0;   ///< the middle of the material's values, the volume's unit
  double spread = 0;  ///< standard deviation of the material's noise, robustly; never less than a 300th of the data's
                      ///< range
  std::optional<double> low, high;  ///< the values halfway to the darker, and to the brighter, material beside this
                                    ///< one, where there is one
  double here = 0;                  ///< the value at the place itself, with its noise
};

/// Measures the material at a place. The 5^3 voxels around the place count first, then those of the 13^3 around it that
/// are like them, unless these are another material: one whose middle lies farther off than the spread of the first. Of
/// both the half with the smaller gradients counts, so that a border nearby does not mix two materials; voxels with
/// values beyond halfway to the materials beside do not count at all, so that a thin vessel is not taken for what is
/// around it. Nothing outside the volume.
std::optional<Tissue> measureTissue(const scene::VolumeLayer& layer, glm::dvec3 world);
/// @param histogram  of the whole data; the layer may have a part of it only
std::optional<Tissue> measureTissue(const scene::VolumeLayer& layer, glm::dvec3 world, const Histogram& histogram);

/// Makes the material at a place opaque: a bump of opacity over its values, in the colour that the colour map has there
/// or, where this colour is dark, a brighter tone of it. All other values become a veil that hides about a third of
/// what is behind half the data.
/// @param add  leaves all other values as they are
/// @return what was measured; nothing, and no change, outside the volume
std::optional<Tissue> showThis(scene::Scene& scene, glm::dvec3 world, bool add = false);

/// The inverse of showThis(): takes the opacity from the values of the material at a place.
std::optional<Tissue> hideThis(scene::Scene& scene, glm::dvec3 world);

}  // namespace velum::session
