#pragma once
#include <QString>
#include <optional>

namespace velum::gui {

/// What the number of a field is of, so that what people type can be read.
struct NumberKind {
  QString prefix;  ///< Stands before the number, as "az "; need not be typed.
  QString unit;    ///< Stands behind it and need not be typed, as "HU"; empty: there is none.
  /// Millimetres in the unit; 0: it is none of length. Of lengths km, m, cm, mm, um, nm, A and in are understood, too.
  double millimetres = 0.0;
  QString positive, negative;  ///< Letters of the direction that the sign means: "L", "R"; empty: it means none.
};

/// A number as people type it: "12.5", "12,5", "8 cm", "R 12,5", "12.5 mm R". Directions are capitals or not; where a
/// letter could be a direction or a unit, as A, it is the direction.
/// @return in the kind's unit; nothing for what is not understood, or could be understood in two ways ("1,234.5")
std::optional<double> readTyped(const QString& text, const NumberKind& kind);

}  // namespace velum::gui
