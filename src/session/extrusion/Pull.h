#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "scene/Cut.h"
#include "scene/Growth.h"
#include "scene/SceneFwd.h"
#include "scene/Structure.h"
#include "session/extrusion/Extrusion.h"
#include "session/extrusion/MaterialRange.h"

namespace velum::session {

/// A structure that a click has chosen to be pulled out of a cut: found in the labels, or to be grown from the place.
struct Pull {
  int cut = 0;  ///< id of the supporting cut
  int structure = 0;
  std::optional<scene::Structure> added;  ///< the structure's row, where the click makes a new one
  std::optional<scene::Growth> growth;    ///< what makes its labels as it is pulled; nothing where labels were given
};

/// The row of a structure that is grown: it keeps the transfer function's colours until it gets one of its own.
/// @param value  of its material, the volume's unit
scene::Structure newStructure(const scene::Scene& scene, int id, double value);
/// Adds the row of a structure that has none yet.
void addStructure(scene::LabelLayer& labels, const scene::Structure& row);

/// What a click on a place of a cut's face, or of what stands out of it, is about to pull. Measures the material there
/// where it has no label ([ACS] 4.2).
/// @param structure  label there; 0: none
/// @param histograms  counts the volume's values, some milliseconds for a large one, or knows them
/// @return nothing where there is neither: outside the volume, in a scene without labels, or with all ids taken
std::optional<Pull> beginPull(const scene::Scene& scene, int cut, glm::dvec3 world, int structure,
                              HistogramMemo& histograms);
/// The same, once.
std::optional<Pull> beginPull(const scene::Scene& scene, int cut, glm::dvec3 world, int structure);

/// What a click is about to pull of a label that was given: the part of it that is joined to the place, before the cut.
/// Becomes a structure of its own, which looks as the whole does.
/// @return nothing where there is no volume, no such label in front of the place, or no id left
std::optional<Pull> beginPartPull(const scene::Scene& scene, int cut, glm::dvec3 world, int structure);

/// Pulls it out so far: the spare, the new structure's row, and the step of growth, which goes as far as it has ever
/// been pulled. Of a structure that has grown before it goes on where the last step ended, unless the cut has moved.
/// Called again and again for one drag, on the scene with which it began or on its own last result.
void pullTo(scene::Scene& scene, const Pull& pull, double distance);

/// What pulls something on that stands out already: by a number rather than by a drag.
Pull pullAgain(const scene::Scene& scene, const Extrusion& extrusion);

/// True when a step of growth reaches out of a cut as that lies: from its plane, or past it.
bool growsOutOf(const scene::Growth& growth, const scene::Cut& cut);

/// What stands out of a cut goes along when the cut is put elsewhere: what was grown out of it grows as far out of
/// where it is now. What grew from places that somebody pressed stays; a part that was only carried is grown anew.
/// @param before  the cut as it was; nothing happens where it lies as it did
void carryPulled(scene::Scene& scene, const scene::Cut& before);

/// Puts a cut elsewhere, with what stands out of it. Its membrane keeps the sheet's shape.
void moveCut(scene::Scene& scene, scene::Cut moved);

}  // namespace velum::session
