#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/Lettering.h"
#include "session/lettering/VisibleParts.h"

/// Where names stand beside a picture. All places are pixels of the picture from its top left corner, y down.
namespace velum::session {

/// A rectangle of a picture.
struct Rectangle {
  glm::dvec2 low{0}, high{0};
};

/// A name that looks for its place.
struct NameToPlace {
  int key = 0;                      ///< by which it is known from frame to frame; unique
  glm::dvec2 size{0};               ///< of the block of its words
  glm::dvec2 anchor{0};             ///< what it points at
  double weight = 1.0;              ///< what weighs less gives way, >= 0
  std::optional<glm::dvec2> fixed;  ///< low corner of the block, chosen by hand: it stays there, whatever it covers
};

/// What there is beside the names.
struct NameRoom {
  glm::dvec2 size{0};            ///< of the picture
  Silhouette subject;            ///< of what it shows; names stand outside, where there is room
  std::vector<Rectangle> taken;  ///< by other lettering
  scene::NameOrder order = scene::NameOrder::Columns;
  double em = 18.0;  ///< of the letters
};

/// Where a name stands.
struct NamePlace {
  int key = 0;
  Rectangle block;                 ///< of its words
  std::vector<glm::dvec2> leader;  ///< from beside the block to the anchor
  double strength = 1.0;           ///< 0..1: how much of it is to be seen; what is new in a film comes slowly
};

/// How far a block moves at most from a frame of a film to the next where it does not begin anew, along x and along y.
double mostNameStep(double em);

/// Finds places for names, so that no block covers another, a leader of another, what is taken, or its own anchor, no
/// two leaders cross, and all blocks and anchors are in the picture; only what was fixed by hand may. Columns: left and
/// right of the subject, flush towards it, each name as near to the height of its anchor as the others let it
/// ([BOUNDARY]); where the subject leaves no room over its sides. Around: on a line around the subject, in the
/// order of the anchors. A function of its arguments alone: a film is the same however often it is drawn, from the same
/// first frame. Any thread; 10 ms for 40 names.
/// @param before  places in the frame before: names keep their order and side until that would let leaders cross or is
/// clearly worse, and move by mostNameStep() at most; one that must leap, or is new, begins with little strength.
/// Null: a still picture, or the first frame
/// @return of the names that have found room, in their order; those that weigh least are left out first
std::vector<NamePlace> placeNames(const std::vector<NameToPlace>& names, const NameRoom& room,
                                  const std::vector<NamePlace>* before = nullptr);

}  // namespace velum::session
