#pragma once
#include "core/Task.h"
#include "core/Volume.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// A scan without what lies beside the patient or the specimen.
struct Body {
  Volume volume;             ///< Everything that is not part of the body has the air's value.
  double removedVolume = 0;  ///< Of tissue, table or head rest that was left out, cubed lengths of the volume.
};

/// Finds the largest body and leaves out the rest: table, head rest, cables, cushions. What is denser than air is
/// filled plane by plane along z, so that lungs and bowel stay, without its thin shells, and opened by 6 mm; of the
/// pieces the largest is the body, and what was opened away belongs to the piece that is nearest along tissue; pieces
/// that touch it along more than a bridge are part of it. Nothing of a body is lost: what lies on it flat stays with
/// it. Works on a grid of at most 192 voxels along an axis; the body's edge is kept one of them wide.
/// @param volume  one channel; its first time step says where the body is
/// @throw InputError for colours and several channels, or where the largest body is less than 60 % of what is denser
/// than air; Cancelled. Any thread.
/// @note O(voxels); memory: a copy of the volume.
Body findBody(const Volume& volume, Progress& progress);

/// The volume's data is what `bodyOnly` says; settleBody() has nothing to do.
bool bodyFits(const scene::Scene& scene);

/// Makes the volume's data fit `bodyOnly`: its body alone, or all of it again. As findBody().
/// @return what was left out, as findBody(); 0 where nothing had to be found
double settleBody(scene::Scene& scene, Progress& progress);

}  // namespace velum::session
