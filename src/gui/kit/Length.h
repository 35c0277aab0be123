#pragma once
#include <QDoubleSpinBox>
#include <QString>

#include "velum/scene/Units.h"

namespace velum::gui {

/// How the lengths of a scene are shown and typed in the window.
class Length {
 public:
  explicit Length(const scene::Scene& scene);

  /// "mm".
  QString unit() const;
  /// " mm", behind a number.
  QString suffix() const { return " " + unit(); }
  int decimals() const { return mFormat.decimals; }
  QString number(double length) const { return QString::fromStdString(scene::lengthNumber(mFormat, length)); }
  QString text(double length) const { return QString::fromStdString(scene::lengthText(mFormat, length)); }
  /// A round length in the unit that fits it: "50 \u00b5m", "2 km", "5 nm".
  QString roundText(double length) const;

  /// Makes a number one of a length. Ranges reach a hundred times as far as the data.
  /// @param isPositive  at least one step of the last decimal
  /// @param hasUnit  false where there is no room for it: the row's name tells it
  void showIn(QDoubleSpinBox& spin, bool isPositive, bool hasUnit = true) const;

 private:
  scene::LengthFormat mFormat;
  double mFar;
};

}  // namespace velum::gui
