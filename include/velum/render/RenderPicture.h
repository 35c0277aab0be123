#pragma once
#include "velum/render/Renderer.h"

namespace velum::render {

/// Draws a picture of any size, window by window where it is larger than the driver's textures; seamless, as each ray
/// depends on its place in the whole picture only.
Image renderPicture(Renderer& renderer, const Frame& frame, const Layers& layers, int largestWindow,
                    Progress& progress);

}  // namespace velum::render
