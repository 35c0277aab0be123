#pragma once
#include <cstddef>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/SheetShape.h"

namespace velum::membrane {

/// A shape fitted to a frame: where it was made for a frame of another size, x and y are scaled; its rim is put onto
/// the frame at z = 0, and its inside into the rest plane's box. Flat when the shape is empty or invalid.
/// @param flat  particles of a flat sheet along x and y, each at least 2
/// @param size  the rest plane's width, height and reach
scene::SheetShape fitShape(const scene::SheetShape& shape, glm::ivec2 flat, glm::dvec3 size);

/// A sheet in memory with an index that makes queries cheap, laid out as in shaders/shared/sheet.h: places, normals,
/// cells, lists.
struct SheetIndex {
  glm::ivec2 particles{0};
  glm::dvec3 size{0.0};
  std::vector<glm::vec4> rows;
};

/// Any thread. About 0.4 ms for 50 x 50 particles.
SheetIndex makeSheetIndex(const scene::SheetShape& shape, glm::ivec2 flat, glm::dvec3 size);

/// True where the place lies above the sheet or, beyond the rest plane's rectangle, above the plane z = 0: there a
/// clipping membrane removes material.
/// @param place  in the frame
bool isAbove(const SheetIndex& index, glm::vec3 place);

/// A point of a sheet: its place in the frame, and its position among the particles, as a share 0..1 along x and y.
struct SheetTouch {
  glm::dvec3 place{0.0};
  glm::dvec2 share{0.5};
};
/// The first point of the sheet on a ray from `origin`; nothing when the ray misses the sheet. @param direction  unit
std::optional<SheetTouch> touchSheet(const SheetIndex& index, glm::dvec3 origin, glm::dvec3 direction);

/// How many rows a sheet has before the lists of its cells.
constexpr std::size_t fixedRows(glm::ivec2 particles) {
  return 3 * std::size_t(particles.x) * std::size_t(particles.y);
}

}  // namespace velum::membrane
