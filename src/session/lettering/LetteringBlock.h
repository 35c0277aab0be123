#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/Image.h"
#include "vector/Drawing.h"
#include "vector/Paint.h"

namespace velum::session {

/// A part of the lettering of a picture: lines and letters, on a glow of the ground's colour that keeps them readable
/// before anything. Files of pixels, files of lines and views are made of the same blocks, so that they look alike.
struct LetteringBlock {
  std::string layer;                ///< what it belongs to: "legend"
  std::vector<vector::Item> items;  ///< in the order in which they are drawn, pixels of the picture
  glm::vec3 ground{0.0f};           ///< colour of the glow, sRGB
  double em = 12.0;                 ///< size of its letters, pixels
  double halo = 1.0;                ///< how much of the glow there is, 0..1
  double opacity = 1.0;             ///< of all of it, 0..1
};

/// A block as pixels, as far as it lies in a picture of so many: its items over their glow. O(pixels of the block).
vector::Raster stampOf(const LetteringBlock& block, glm::ivec2 picture);

/// Lays blocks over the channels R, G and B of a picture, and over A where it has that.
void layOver(const std::vector<LetteringBlock>& blocks, Image& image);

/// Blocks as layers of a drawing, those of one name together. What is a glow in pixels is a line around letters and
/// lines there.
std::vector<vector::Layer> layersOf(const std::vector<LetteringBlock>& blocks);

}  // namespace velum::session
