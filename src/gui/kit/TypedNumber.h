#pragma once
#include <QString>
#include <optional>

namespace velum::gui {

/// What kind of number a field holds, which decides how a typed text is read.
struct NumberKind {
  QString prefix;  ///< Shown before the number, as "az "; need not be typed.
  QString unit;    ///< Shown behind the number, as "HU"; need not be typed. Empty: the number has no unit.
  /// Millimetres in the unit; 0: it is no unit of length. For a length km, m, cm, mm, um, nm, A and in are understood,
  /// too.
  double millimetres = 0.0;
  QString positive, negative;  ///< Letters of the directions that the number's sign means: "L", "R"; empty: the sign
                               ///< means no direction.
};

/// A number as people type it: "12.5", "12,5", "8 cm", "R 12,5", "12.5 mm R". Directions may be capital letters or not;
/// a letter that could be a direction or a unit, as A, is the direction.
/// @return the number in the kind's unit; nothing for a text that is not understood, or that could be understood in two
/// ways ("1,234.5")
std::optional<double> readTyped(const QString& text, const NumberKind& kind);

}  // namespace velum::gui
