#pragma once
#include <glm/glm.hpp>

#include "core/Image.h"

namespace velum::scene {

/// Edge of the largest picture of paper that is drawn with, pixels.
constexpr int kPaperSize = 2048;

/// A user's picture of paper as one to draw with: R, G, B, smaller where it is larger than ours.
/// @throw ArgumentError of an empty one
Image fitPaper(const Image& picture);

/// True, across and down, of a picture whose opposite edges fit, so that several side by side show no seam.
/// @param paper  R, G, B
glm::bvec2 tilesOf(const Image& paper);

}  // namespace velum::scene
