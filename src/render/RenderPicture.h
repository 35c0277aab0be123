#pragma once
#include "render/Renderer.h"

namespace velum::render {

/// Pixels around a window on which its finish depends. @param frame  with its sizes
int finishMargin(const Frame& frame);

/// Draws a picture of any size, window by window where it is larger than the driver's textures; seamless, as each ray
/// depends on its place in the whole picture only, and
/// windows overlap by what the finish looks at.
Image renderPicture(Renderer& renderer, const Frame& frame, const Layers& layers, int largestWindow,
                    Progress& progress);

}  // namespace velum::render
