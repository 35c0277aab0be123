#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "vector/Drawing.h"

namespace velum::vector {

/// Items without plates as a PDF that has a page for each list; text stays text.
/// @param size  of a page, pixels of the drawing  @param points  1/72 inch for a pixel
std::string pagesOf(const std::vector<std::vector<const Item*>>& pages, glm::dvec2 size, double points);

}  // namespace velum::vector
