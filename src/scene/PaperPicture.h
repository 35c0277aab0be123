#pragma once
#include <glm/glm.hpp>

#include "core/Image.h"

namespace velum::scene {

/// Largest edge of a picture of paper as the renderer uses it, pixels.
constexpr int kPaperSize = 2048;

/// A user's picture of paper as the renderer needs it: R, G, B, reduced where it is larger than kPaperSize.
/// @throw ArgumentError for an empty picture
Image fitPaper(const Image& picture);

/// Whether the opposite edges of a picture fit, across and down, so that copies side by side show no seam.
/// @param paper  R, G, B
glm::bvec2 tilesOf(const Image& paper);

}  // namespace velum::scene
