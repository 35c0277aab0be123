#pragma once
#include "scene/Camera.h"
#include "scene/SceneFwd.h"

namespace velum::scene {

/// A camera as frameCamera() gives one, but so near that what shows of the volume, or of labels alone, fills the
/// picture, and not the box around them: air is half of a scan, or nearly all. Specks of noise and hidden structures do
/// not count; cuts do not matter. Where surfaces or a model are in the scene it is frameCamera(). Some ms for each
/// million voxels, at most two of which are looked at.
Camera frameVisible(const Scene& scene, StandardView view, double aspect);

/// The camera by which new data is first seen. A patient is met from defaultView(). Of what is none nobody says which
/// side is up: it stands on a flat base, if it has one at one end alone, or else as it lies in its box; and it is seen
/// from a corner, across its longest ways. Cost as frameVisible().
Camera firstCamera(const Scene& scene, double aspect);

}  // namespace velum::scene
