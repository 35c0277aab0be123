#include "gui/kit/Length.h"

#include <algorithm>
#include <cmath>

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

QString Length::roundText(double length) const { return localNumber(scene::roundLengthText(length, mFormat.unit)); }

}  // namespace velum::gui
