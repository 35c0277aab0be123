#pragma once
#include <iterator>
#include <vector>

#include "scene/Cut.h"

namespace velum {

/// From the list of their names: a shape that is added is tried by every test that goes over these.
inline std::vector<scene::CutShape> everyCutShape() {
  std::vector<scene::CutShape> shapes;
  for (std::size_t i = 0; i < std::size(EnumNames<scene::CutShape>::kNames); ++i)
    shapes.push_back(static_cast<scene::CutShape>(i));
  return shapes;
}

/// Those whose surface is the formula's alone.
inline std::vector<scene::CutShape> everyShapeButMembranes() {
  auto shapes = everyCutShape();
  std::erase(shapes, scene::CutShape::Membrane);
  std::erase(shapes, scene::CutShape::Everywhere);  // has no surface
  return shapes;
}

/// Those with an inside and an outside.
inline std::vector<scene::CutShape> everyClosedShape() {
  auto shapes = everyShapeButMembranes();
  std::erase(shapes, scene::CutShape::Plane);
  return shapes;
}

}  // namespace velum
