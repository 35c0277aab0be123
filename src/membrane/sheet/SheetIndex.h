#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/SheetShape.h"

namespace velum::membrane {

/// A shape that hangs in a frame: scaled across to the frame where it was made for another, its rim on the frame at
/// z = 0, its inside in the rest plane's box. Flat when the shape is empty or makes no sense.
/// @param flat    particles of the flat one, each at least 2
/// @param size  the rest plane's width, height and reach
scene::SheetShape fitShape(const scene::SheetShape& shape, glm::ivec2 flat, glm::dvec3 size);

/// A sheet with what makes queries cheap, as shaders/shared/sheet.h lays it out: places, normals, cells, lists.
struct SheetIndex {
  glm::ivec2 particles{0};
  glm::dvec3 size{0.0};
  std::vector<glm::vec4> rows;
};

/// Any thread. About 0.4 ms for 50 x 50 particles.
SheetIndex makeSheetIndex(const scene::SheetShape& shape, glm::ivec2 flat, glm::dvec3 size);

/// True where the sheet, or the plane z = 0 beyond its rest plane, lies below the place: what a clipping membrane
/// removes.
/// @param place  in the frame
bool isAbove(const SheetIndex& index, glm::vec3 place);

/// A point of a sheet: where it is in the frame, and between which particles, as a share 0..1 of those along x and
/// y.
struct SheetTouch {
  glm::dvec3 place{0.0};
  glm::dvec2 share{0.5};
};
/// The first point of the sheet on a line from a place; nothing when there is none. @param direction  unit
std::optional<SheetTouch> touchSheet(const SheetIndex& index, glm::dvec3 origin, glm::dvec3 direction);

/// Rows of a sheet before the lists of its cells.
constexpr std::size_t fixedRows(glm::ivec2 particles) {
  return 3 * std::size_t(particles.x) * std::size_t(particles.y);
}

}  // namespace velum::membrane
