#pragma once
#include "vector/Drawing.h"

struct _cairo;

namespace velum::vector {

class Typeface;

/// Adds an outline to what is filled or stroked next.
void addOutline(_cairo* cairo, const Outline& outline);
/// Strokes what was added.
void strokeWith(_cairo* cairo, const Pen& pen);
void drawShape(_cairo* cairo, const Shape& shape);
/// Draws a text as outlines: its halo, then its letters.
void drawLetters(_cairo* cairo, const Words& words, Typeface& face);
/// Draws its halo alone.
void drawHalo(_cairo* cairo, const Words& words, Typeface& face);
void setColor(_cairo* cairo, const glm::vec3& color, double opacity);
/// Draws an image into its rectangle. @throw ArgumentError when the image is too large
void drawPlate(_cairo* cairo, const Plate& plate);

/// @throw Error when a drawing has failed: there is no memory
void expectDrawn(_cairo* cairo);

}  // namespace velum::vector
