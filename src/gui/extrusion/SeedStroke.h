#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/Volume.h"
#include "gui/tool/Manipulator.h"

namespace velum::gui {

/// A stroke over faces of cuts, in pieces: a straight line between places on two different structures or cuts would
/// lead through parts that nobody has drawn on.
class SeedStroke {
 public:
  /// What the pointer is on: a structure, and the cut that holds it.
  struct Ground {
    int structure = 0, cut = 0;
    bool operator==(const Ground&) const = default;
  };
  void goOn(glm::dvec3 world, Ground ground);
  /// The pointer is on nothing that can be drawn on; the next place begins a new piece.
  void lift() { mGround.reset(); }
  /// The middles of the voxels under the stroke, see session::placesAlong().
  std::vector<glm::dvec3> places(const Volume& volume) const;
  void paint(ViewPainter& over, double radius, const QColor& color) const;

 private:
  std::vector<std::vector<glm::dvec3>> mPieces;
  std::optional<Ground> mGround;
};

}  // namespace velum::gui
