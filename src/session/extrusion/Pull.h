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

/// A structure that a click has chosen to be pulled out of a cut: the labels have it, or it is to be grown from the
/// place.
struct Pull {
  int cut = 0;  ///< id of the supporting cut
  int structure = 0;
  std::optional<scene::Structure> added;  ///< the row of the structure, where the click makes a new one
  std::optional<scene::Growth> growth;    ///< the step that grows its labels as it is pulled; nothing where labels were
                                          ///< given
};

/// A row for a structure that is grown: it keeps the transfer function's colours until it gets a colour of its own.
/// @param value  of its material, the volume's unit
scene::Structure newStructure(const scene::Scene& scene, int id, double value);
/// Adds a row to the labels, unless they have a row for this structure.
void addStructure(scene::LabelLayer& labels, const scene::Structure& row);

/// What a click on a place of a cut's face, or on a structure that stands out of the face, is about to pull. Measures
/// the material there where the place has no label ([ACS] 4.2).
/// @param structure  id of the label at the place; 0: none
/// @param histograms  holds the volume's histogram, or counts the values, some milliseconds for a large volume
/// @return nothing where the place has no label and no structure can be grown from it: outside the volume, in a scene
/// without one, or with all ids taken
std::optional<Pull> beginPull(const scene::Scene& scene, int cut, glm::dvec3 world, int structure,
                              HistogramMemo& histograms);
/// The same for a single call, with the histogram counted anew.
std::optional<Pull> beginPull(const scene::Scene& scene, int cut, glm::dvec3 world, int structure);

/// What a click is about to pull of a structure whose labels were given: the part of it that is joined to the place,
/// before the cut. The part becomes a structure of its own, which looks as the whole does.
/// @return nothing where there is no volume, no such label in front of the place, or no id left
std::optional<Pull> beginPartPull(const scene::Scene& scene, int cut, glm::dvec3 world, int structure);

/// Pulls a structure out up to a distance, scene units: sets the spare, adds the row of a new structure, and sets the
/// step of growth, which goes as far as the structure has ever been pulled. A structure that has grown before grows on
/// from where its last step ended, unless the cut has moved. To be called again and again for one drag, on the scene
/// with which the drag began or on the result of the last call.
void pullTo(scene::Scene& scene, const Pull& pull, double distance);

/// The pull that goes on with a structure that stands out already: to set its distance by a number rather than by a
/// drag.
Pull pullAgain(const scene::Scene& scene, const Extrusion& extrusion);

/// True when a step of growth reaches out of a cut as the cut lies now: the step begins at the cut's plane, or grows
/// past it.
bool growsOutOf(const scene::Growth& growth, const scene::Cut& cut);

/// Carries along what stands out of a cut that was put elsewhere: structures that grew out of the cut grow as far out
/// of its new place. Steps that grew from places that somebody pressed stay; a step that only carried them along is
/// grown anew.
/// @param before  the cut as it was; nothing happens where the cut lies as it did
void carryPulled(scene::Scene& scene, const scene::Cut& before);

/// Puts a cut elsewhere, with the structures that stand out of it. A membrane keeps the shape of its sheet.
void moveCut(scene::Scene& scene, scene::Cut moved);

}  // namespace velum::session
