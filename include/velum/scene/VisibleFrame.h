#pragma once
#include "velum/scene/Scene.h"

namespace velum::scene {

/// A camera as frameCamera() gives one, but so near that what shows of the volume, or of labels alone, fills the
/// picture, and not the box around them: air is half of a scan, or nearly all. Specks of noise and hidden structures do
/// not count; cuts do not matter. Where surfaces or a model are in the scene it is frameCamera(). Some ms for each
/// million voxels, at most two of which are looked at.
Camera frameVisible(const Scene& scene, StandardView view, double aspect);

}  // namespace velum::scene
