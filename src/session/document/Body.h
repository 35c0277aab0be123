#pragma once
#include "core/Task.h"
#include "core/Volume.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// A scan without what lies beside the patient or the specimen.
struct Body {
  Volume volume;             ///< the scan, with the value of air in everything that is not part of the body
  double removedVolume = 0;  ///< of the tissue, table or head rest that was left out, cubed lengths of the volume
};

/// Finds the largest body and leaves out the rest: table, head rest, cables, cushions. What is denser than air is
/// filled plane by plane along z, so that lungs and bowel stay, without its thin shells, and opened by 6 mm. The
/// largest of the pieces is then the body; what was opened away belongs to the piece that is nearest along tissue, and
/// pieces that touch the body along more than a bridge are part of the body. Nothing of a body is lost: what lies flat
/// on the body stays with it. Works on a grid of at most 192 voxels along an axis; the body's edge is kept one voxel of
/// this grid wide.
/// @param volume  one channel; its first time step says where the body is
/// @throw InputError for colours and several channels, or where the largest body is less than 60 % of what is denser
/// than air; Cancelled. Any thread.
/// @note O(voxels); memory: a copy of the volume.
Body findBody(const Volume& volume, Progress& progress);

/// True when the volume's data is what `bodyOnly` asks for, so that settleBody() has nothing to do.
bool bodyFits(const scene::Scene& scene);

/// Makes the volume's data what `bodyOnly` asks for: the body alone, or the whole scan again. Throws as findBody().
/// @return Body::removedVolume; 0 where no body had to be found
double settleBody(scene::Scene& scene, Progress& progress);

}  // namespace velum::session
