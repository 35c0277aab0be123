#pragma once
#include <QString>

#include "gui/kit/Words.h"
#include "scene/Units.h"

namespace velum::gui {

/// Letters of the patient's directions may be shown: the data's file says how the patient lay.
bool hasPatientLetters(const scene::Scene& scene);

/// How the lengths of a scene are shown and typed in the window.
class Length {
 public:
  explicit Length(const scene::Scene& scene);

  /// The unit in which lengths are shown: "mm".
  QString unit() const;
  /// The unit of the scene's own lengths, and of values per length: "mm".
  QString sceneUnit() const;
  double shownPerLength() const { return mFormat.toldPerLength; }
  /// How many millimetres the shown unit has.
  double millimetresShown() const { return millimetresPer(mFormat.unit) / mFormat.toldPerLength; }
  /// " mm", behind a number.
  QString suffix() const { return " " + unit(); }
  int decimals() const { return mFormat.decimals; }
  QString number(double length) const { return localNumber(scene::lengthNumber(mFormat, length)); }
  QString text(double length) const { return localNumber(scene::lengthText(mFormat, length)); }
  /// A round length in the unit that fits it: "50 \u00b5m", "2 km", "5 nm".
  QString roundText(double length) const;

  /// A length far beyond the data: the limit of fields in which a length is typed.
  double far() const { return mFar; }
  /// The step of a field in which a length is typed.
  double step() const;

 private:
  void takeChosenUnit();
  scene::LengthFormat mFormat;
  double mFar;
};

}  // namespace velum::gui
