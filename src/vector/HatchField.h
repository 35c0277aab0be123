#pragma once
#include "vector/SeenSurfaces.h"

namespace velum::vector {

/// The waves of strokes, as shaders/render/stroke_turns.comp, stroke_field.comp, stroke_align.comp and strokes.glsl
/// make them: cells with a direction and the phases of two families of strokes, one across the other.
class HatchField {
 public:
  /// @param spacing  from stroke to stroke, pixels
  HatchField(const SurfaceMap& map, const std::vector<SeenPixel>& seen, double spacing);

  /// A place's: a stroke's middle is where a phase is 0. They have the sign of `across`, which directions have not.
  struct Phases {
    glm::dvec2 across;
    glm::dvec2 phase;  ///< of either family, -pi..pi
  };
  Phases at(glm::dvec2 place) const;

 private:
  struct Cell {
    glm::dvec2 across{1.0, 0.0};
    glm::dvec2 phase{0.0};
  };
  const Cell& cellAt(glm::ivec2 cell) const;
  glm::dvec2 middleOf(glm::ivec2 cell) const { return (glm::dvec2(cell) + 0.5) * mCellPixels; }
  void align();

  double mWave, mCellPixels;
  glm::ivec2 mCount{0};
  std::vector<Cell> mCells;
};

/// Widths of strokes at a place, as shares of the spacing: x along the form, y across; 0: none.
/// @param unitsPerPixel  pixels of a picture of 1000 rows in one of this one
glm::dvec2 strokeWidths(glm::dvec2 place, double darkness, double unitsPerPixel);

}  // namespace velum::vector
