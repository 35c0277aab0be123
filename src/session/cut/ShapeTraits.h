#pragma once
#include <array>
#include <span>

#include "scene/Cut.h"

namespace velum::session {

struct NewCut;

/// How the radius of a shape changes along its axis.
enum class Girth {
  None,    ///< the shape has no radius: it has sides, and turns about its axis
  Ball,    ///< as of a ball, which no turn changes
  Barrel,  ///< the same everywhere
  Taper    ///< from nothing at the low end to the whole radius at the high end
};

/// One of the three numbers of Cut::size.
struct ShapeSize {
  const char* prefix = "";
  const char* tip = nullptr;  ///< null: the shape does not have this number
};

/// Which faces can be taken hold of, in pairs, by the axis across each pair.
constexpr unsigned kFacesX = 1, kFacesY = 2, kFacesZ = 4;

/// All that is known of a shape of cuts, except its distance (shaders/shared/cut.h) and its lines
/// (scene/ShapeOutline.h).
struct ShapeTraits {
  scene::CutShape shape;
  const char* title;
  const char* menuText;  ///< with its mnemonic, of the menu entry that adds a cut of this shape; null: the shape has an
                         ///< entry of its own
  const char* icon;      ///< for paintIcon(): lines in a square from -8 to 8, y down
  std::array<ShapeSize, 3> sizes;
  Girth girth;       ///< for all but None, size.x is the diameter
  unsigned faces;    ///< which can be taken hold of: kFaces*
  double low, high;  ///< where the shape's ends lie along its axis, from `centre`, in parts of its length size.z
  bool isWire;  ///< a section of the shape is the polygon through the points where it crosses the lines of the shape's
                ///< outline: the shape is convex and has straight sides; sections of other shapes are found by their
                ///< distance
  void (*make)(scene::Cut& cut, const NewCut& at);  ///< gives a new cut of this shape its place, axis and size
};

/// One row for each shape.
std::span<const ShapeTraits> allShapes();
const ShapeTraits& traitsOf(scene::CutShape shape);
/// True for shapes with a width, a height and a depth of their own, which a turn about their axis changes.
inline bool hasSides(scene::CutShape shape) {
  return traitsOf(shape).girth == Girth::None && shape != scene::CutShape::Plane;
}

}  // namespace velum::session
