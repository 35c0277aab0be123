#include "gui/rows/Amounts.h"

#include <QLocale>
#include <cmath>
#include <span>

namespace velum::gui {

namespace {

struct Measure {
  double size;   ///< in powers of a millimetre
  double least;  ///< the smallest amount that is told in it, likewise
  const char* symbol;
};

/// Without marks between thousands.
QString plainNumber(double number, char form, int digits) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(number, form, digits);
}

/// Three digits that matter.
QString amountText(double amount, std::span<const Measure> units) {
  std::size_t i = 0;
  while (i + 1 < units.size() && amount < units[i].least) ++i;
  double number = amount / units[i].size;
  QString digits = number >= 100.0  ? plainNumber(number, 'f', 0)
                   : number >= 10.0 ? plainNumber(number, 'f', 1)
                   : number >= 1.0  ? plainNumber(number, 'f', 2)
                                    : plainNumber(number, 'g', 3);
  return digits + " " + QString::fromUtf8(units[i].symbol);
}

}  // namespace

QString volumeText(double volume, LengthUnit unit) {
  static constexpr Measure kUnits[] = {{1e6, 1e7, "l"},
                                       {1e3, 100.0, "ml"},
                                       {1.0, 1e-4, "mm\u00b3"},
                                       {1e-9, 1e-13, "\u00b5m\u00b3"},
                                       {1e-18, 0.0, "nm\u00b3"}};
  return amountText(volume * std::pow(millimetresPer(unit), 3), kUnits);
}

QString areaText(double area, LengthUnit unit) {
  static constexpr Measure kUnits[] = {
      {1e2, 10.0, "cm\u00b2"}, {1.0, 1e-2, "mm\u00b2"}, {1e-6, 1e-8, "\u00b5m\u00b2"}, {1e-12, 0.0, "nm\u00b2"}};
  return amountText(area * std::pow(millimetresPer(unit), 2), kUnits);
}

}  // namespace velum::gui
