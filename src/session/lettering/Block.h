#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "session/lettering/Mark.h"

namespace velum::session {

/// Marks of one rectangle, for a part of the lettering.
class Block {
 public:
  /// @param corner, size  of the rectangle, pixels of the picture
  Block(glm::ivec2 corner, glm::ivec2 size) : mCorner(corner), mSize(size) {}

  /// A mark of the whole block, that covers nothing yet.
  Mark& add(glm::vec3 color) { return add(color, mCorner, mCorner + mSize); }
  /// A mark of a part of the block. @param low, high  pixels of the picture
  Mark& add(glm::vec3 color, glm::dvec2 low, glm::dvec2 high) {
    glm::ivec2 corner(glm::floor(low)), size = glm::ivec2(glm::ceil(high)) - corner;
    std::size_t pixels = std::size_t(size.x) * std::size_t(size.y);
    return mMarks.emplace_back(Mark{corner, size, color, std::vector<std::uint8_t>(pixels)});
  }
  /// All marks, on a glow of the ground's colour.
  std::vector<Mark> onGlow(glm::vec3 ground, double em) const;

 private:
  glm::ivec2 mCorner, mSize;
  std::vector<Mark> mMarks;
};

/// Adds a rectangle with round corners to a mark. @param low, high  pixels of the picture
/// @param from, to  only the part of it between these, along x
void addRectangle(Mark& mark, glm::dvec2 low, glm::dvec2 high, double radius, double from, double to);

/// Makes marks of onGlow() with one mark on the glow fainter: laid over a picture they change it by that share of what
/// they would else. @param opacity  0..1
void fade(std::vector<Mark>& marks, double opacity);

}  // namespace velum::session
