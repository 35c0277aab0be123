#pragma once
#include "render/Renderer.h"

namespace velum::render {

/// How many pixels around a window the window's finish depends on. @param frame  with its sizes
int finishMargin(const Frame& frame);

/// Draws a picture of any size, window by window where it is larger than the driver's textures; seamless, as each ray
/// depends on its place in the whole picture only, and windows overlap by finishMargin(). Where the frame has a window,
/// that part of the picture, the same pixels.
Image renderPicture(Renderer& renderer, const Frame& frame, const Layers& layers, int largestWindow,
                    Progress& progress);

}  // namespace velum::render
