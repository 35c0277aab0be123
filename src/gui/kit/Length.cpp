#include "gui/kit/Length.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/kit/Preferences.h"
#include "scene/PatientDirections.h"
#include "scene/Scene.h"

namespace velum::gui {

bool hasPatientLetters(const scene::Scene& scene) { return scene::hasPatientDirections(scene); }

Length::Length(const scene::Scene& scene) : mFormat(scene::lengthFormat(scene)) {
  takeChosenUnit();
  scene::Bounds bounds = scene::computeBounds(scene);
  double diameter =
      std::clamp(glm::length(bounds.max - bounds.min), 100.0 * std::pow(10.0, -decimals()) / shownPerLength(), 1e9);
  double farthest = std::max(glm::length(bounds.max), glm::length(bounds.min));
  mFar = std::pow(10.0, std::ceil(std::log10(std::max(100.0 * diameter, farthest))));
}

/// Takes the unit that the user has chosen in place of the one that suits the data, with as many digits.
void Length::takeChosenUnit() {
  struct Unit {
    const char* symbol;
    double millimetres;
  };
  static constexpr Unit kUnits[] = {{"mm", 1.0}, {"\u00b5m", 1e-3}, {"nm", 1e-6}, {"\u00c5", 1e-7}};
  const QString& chosen = Preferences::habits().lengthUnit;
  if (chosen.isEmpty()) return;
  for (const Unit& unit : kUnits) {
    if (chosen != QString::fromUtf8(unit.symbol)) continue;
    double told = millimetresPer(mFormat.unit) / unit.millimetres;
    mFormat.decimals = std::clamp(mFormat.decimals - int(std::lround(std::log10(told / mFormat.toldPerLength))), 0, 9);
    mFormat.toldPerLength = told;
    mFormat.symbol = unit.symbol;
  }
}

QString Length::unit() const { return QString::fromUtf8(mFormat.symbol.data(), int(mFormat.symbol.size())); }

QString Length::sceneUnit() const {
  auto symbol = symbolOf(mFormat.unit);
  return QString::fromUtf8(symbol.data(), int(symbol.size()));
}

double Length::step() const {
  double last = std::pow(10.0, -decimals()) / mFormat.toldPerLength;
  return last * (decimals() > 1 ? 5 : decimals() == 1 ? 10 : 1);
}

QString Length::roundText(double length) const {
  constexpr std::pair<double, const char*> kUnits[] = {{1e6, "km"},       {1e3, "m"},   {1.0, "mm"},
                                                       {1e-3, "\u00b5m"}, {1e-6, "nm"}, {1e-7, "\u00c5"}};
  double mm = length * millimetresPer(mFormat.unit);
  // The unit that people use for so much of it: mm from a half to ten metres.
  constexpr double kLeast[] = {1e6, 1e4, 0.5, 0.5e-3, 1e-6, 0.0};
  std::size_t i = 0;
  while (mm < kLeast[i]) ++i;
  return QString("%1 %2").arg(mm / kUnits[i].first, 0, 'g', 6).arg(QString::fromUtf8(kUnits[i].second));
}

}  // namespace velum::gui
