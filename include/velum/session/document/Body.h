#pragma once
#include "velum/core/Task.h"
#include "velum/scene/Scene.h"

namespace velum::session {

/// A scan without what lies beside the patient or the specimen.
struct Body {
  Volume volume;             ///< Everything that is not part of the body has the air's value.
  double removedVolume = 0;  ///< Of tissue, table or head rest that was left out, cubed lengths of the volume.
};

/// Finds the largest body and leaves out the rest: table, head rest, cables, cushions. Of what is
/// denser than air thin shells are dropped, and what is left is filled plane by plane along z, so that lungs and bowel
/// stay. It is opened by 6 mm, so that a plate comes off what lies on it; of its pieces the largest is taken and grows
/// back, 15 mm along tissue. Works on a grid of at most 192 voxels along an axis; the body's edge is kept one of them
/// wide, and with it what touches it there.
/// @param volume  one channel; its first time step says where the body is
/// @throw InputError for colours and several channels, or where nothing but air is there; Cancelled. Any thread.
/// @note O(voxels); memory: a copy of the volume.
Body findBody(const Volume& volume, Progress& progress);

/// Makes the volume's data fit `bodyOnly`: its body alone, or all of it again. As findBody().
/// @return what was left out, as findBody(); 0 where nothing had to be found
double settleBody(scene::Scene& scene, Progress& progress);

}  // namespace velum::session
