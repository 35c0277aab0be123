#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "render/FrameData.h"

namespace velum::render {

/// True where rays, each by itself, are all that makes the picture: then parts of it can be drawn again.
bool canPatch(const FrameData& data);

/// Where the picture of a streamed volume changes by the bricks that have come since Residency::noteDrawn(): rectangles
/// of the window that do not overlap, x, y of the corner; width, height. Cost: with the pages that have changed.
std::vector<glm::ivec4> changedRects(const FrameData& data);

}  // namespace velum::render
