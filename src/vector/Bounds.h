#pragma once
#include <glm/glm.hpp>
#include <limits>
#include <span>
#include <vector>

#include "vector/Drawing.h"

namespace velum::vector {

class Typefaces;

/// A rectangle; empty by default.
struct Box {
  glm::dvec2 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

  bool isEmpty() const { return !(low.x <= high.x && low.y <= high.y); }
  void add(glm::dvec2 point) { low = glm::min(low, point), high = glm::max(high, point); }
  void add(const Box& box) { low = glm::min(low, box.low), high = glm::max(high, box.high); }
  void grow(double by) { low -= by, high += by; }
};

/// Some boxes that together hold all that an item draws: one for each piece of a line, so that they hold little else.
/// Empty: the item draws nothing.
std::vector<Box> boxesOf(const Item& item, Typefaces& faces);
/// The box of all that items draw. Opens fonts.
Box boundsOf(std::span<const Item> items);

/// True for what can be drawn: numbers are finite, sizes are above zero, a plate has an image, a shape has a pen or a
/// fill. Other items are left out of pictures and files.
bool isDrawable(const Item& item);
/// True where a pen's dashes can be drawn; else its lines have none.
bool hasDashes(const Pen& pen);

}  // namespace velum::vector
