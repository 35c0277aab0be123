#pragma once
#include <array>
#include <span>

#include "scene/Cut.h"

namespace velum::session {

struct NewCut;

/// How the radius of a shape goes along its axis.
enum class Girth {
  None,    ///< it has none: it has sides, and turns about its axis
  Ball,    ///< a ball's, which no turn changes
  Barrel,  ///< the same everywhere
  Taper    ///< from nothing at the low end to all of it at the high one
};

/// One of the three numbers of Cut::size.
struct ShapeSize {
  const char* prefix = "";
  const char* tip = nullptr;  ///< null: the shape does not have it
};

/// Faces that can be taken hold of, in pairs, by the axis across them.
constexpr unsigned kFacesX = 1, kFacesY = 2, kFacesZ = 4;

/// What there is to know of a shape of cuts beside its distance (shaders/shared/cut.h) and its lines
/// (scene/ShapeOutline.h).
struct ShapeTraits {
  scene::CutShape shape;
  const char* title;
  const char* menuText;  ///< with its mnemonic, of the entry that adds one; null: it has an entry of its own
  const char* icon;      ///< for paintIcon(): lines in a square from -8 to 8, y down
  std::array<ShapeSize, 3> sizes;
  Girth girth;       ///< but for None, size.x is its diameter
  unsigned faces;    ///< kFaces*
  double low, high;  ///< where its ends lie along its axis, from `centre`, in parts of its length size.z
  bool isWire;       ///< a section of it is the polygon through where it crosses the lines of its outline: it is convex
                     ///< and has straight sides; sections of others are found by their distance
  void (*make)(scene::Cut& cut, const NewCut& at);  ///< gives a new one its place, axis and size
};

/// A row a shape.
std::span<const ShapeTraits> allShapes();
const ShapeTraits& traitsOf(scene::CutShape shape);
/// True for shapes with a width, a height and a depth of their own, which a turn about their axis changes.
inline bool hasSides(scene::CutShape shape) {
  return traitsOf(shape).girth == Girth::None && shape != scene::CutShape::Plane;
}

}  // namespace velum::session
