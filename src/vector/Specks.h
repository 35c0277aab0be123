#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace velum::vector {

/// Gives pieces of regions, and of nothing, that are smaller than an area to the neighbour with which they have the
/// longest border. Pixels that touch at a corner alone hang together as in findPixelBorders(). Any thread, linear in
/// pixels. @param ids  0 or more; row by row  @param least  pixels
void absorbSpecks(glm::ivec2 size, std::vector<int>& ids, double least);

}  // namespace velum::vector
