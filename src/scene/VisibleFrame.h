#pragma once
#include "scene/Camera.h"
#include "scene/SceneFwd.h"

namespace velum::scene {

/// A camera like that of frameCamera(), but so near that the visible part of the volume (or of labels alone) fills the
/// picture, and not the whole box: half of a scan, or nearly all, is air. Specks of noise and hidden structures do not
/// count; cuts are ignored. With surfaces or a model in the scene it is the same as frameCamera(). Some ms for each
/// million voxels; at most two million are looked at.
Camera frameVisible(const Scene& scene, StandardView view, double aspect);

/// The camera from which new data is first seen. A patient is seen from defaultView(). For other objects nothing says
/// which side is up: an object stands on its flat base if it has one at one end only, else as it lies in its box; and
/// it is seen from a corner, across its longest extents; a model alone, from its bestSide(). Cost as frameVisible().
Camera firstCamera(const Scene& scene, double aspect);

}  // namespace velum::scene
