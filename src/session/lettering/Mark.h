#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/Image.h"

namespace velum::session {

/// Something of one colour over a picture: how far it covers each pixel of a rectangle. Lettering is a list of marks,
/// in the order in which they are laid over each other, so that files and views that lay the same marks look alike.
struct Mark {
  glm::ivec2 corner{0}, size{0};     ///< of the rectangle, pixels of the picture; it may reach beyond the picture
  glm::vec3 color{0.0f};             ///< sRGB
  std::vector<std::uint8_t> covers;  ///< row by row from the top; 255: the pixel is covered
};

/// Lays marks over the channels R, G and B of a picture, and over A where it has that.
void layMarks(const std::vector<Mark>& marks, Image& image);

}  // namespace velum::session
