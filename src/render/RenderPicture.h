#pragma once
#include "render/Renderer.h"

namespace velum::render {

/// How many pixels around a window the window's pixels depend on: for its finish, and for how open a model lies.
/// @param frame  with its sizes
int windowMargin(const Frame& frame);

/// Draws a picture of any size, window by window where it is larger than the driver's textures; seamless, as each ray
/// depends on its place in the whole picture only, and windows overlap by windowMargin(). Where the frame has a window,
/// that part of the picture, the same pixels.
Image renderPicture(Renderer& renderer, const Frame& frame, const Layers& layers, int largestWindow,
                    Progress& progress);

}  // namespace velum::render
