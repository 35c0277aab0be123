#include "session/measure/Quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/Text.h"
#include "scene/Scene.h"
#include "scene/SectionPlane.h"
#include "scene/Units.h"

namespace velum::session {

namespace {

constexpr int kMostDigits = 5;

/// From how much on, and up to what, people say a quantity of one unit in another.
struct Saying {
  const char* unit;
  double from, below;
  const char* said;
  double factor;
};
constexpr double kEndlessly = 1e300;
constexpr Saying kSayings[] = {
    {"mm", 1e4, 1e6, "m", 1e-3},
    {"mm", 1e6, kEndlessly, "km", 1e-6},
    {"mm\u00b2", 1e4, 1e8, "cm\u00b2", 1e-2},
    {"mm\u00b2", 1e8, kEndlessly, "m\u00b2", 1e-6},
    {"mm\u00b3", 1e3, 1e7, "ml", 1e-3},
    {"mm\u00b3", 1e7, 1e10, "l", 1e-6},
    {"mm\u00b3", 1e10, kEndlessly, "m\u00b3", 1e-9},
    {"\u00b5m", 1e4, kEndlessly, "mm", 1e-3},
    {"\u00b5m\u00b2", 1e8, kEndlessly, "mm\u00b2", 1e-6},
    {"\u00b5m\u00b3", 1e10, kEndlessly, "mm\u00b3", 1e-9},
    {"nm", 1e-9, 1.0, "\u00c5", 10.0},
    {"nm", 1e4, kEndlessly, "\u00b5m", 1e-3},
    {"nm\u00b2", 1e6, kEndlessly, "\u00b5m\u00b2", 1e-6},
    {"nm\u00b3", 1e9, kEndlessly, "\u00b5m\u00b3", 1e-9},
};

/// Decimals that a number has which is known to within `doubt`.
int decimalsWithin(double doubt) {
  return doubt > 0.0 ? std::clamp(int(std::floor(0.5 - std::log10(doubt))), -9, 9) : 9;
}

std::string numberText(double value, int decimals) {
  if (double step = std::pow(10.0, -decimals); decimals < 0) value = std::round(value / step) * step;
  if (decimals > 0 && std::abs(value) < 0.5 * std::pow(10.0, -decimals)) value = 0.0;
  return fmt::format("{:.{}f}", value == 0.0 ? 0.0 : value, std::max(decimals, 0));
}

/// No more decimals than leave kMostDigits digits.
int withinDigits(double value, int decimals) {
  if (value == 0.0) return std::min(decimals, kMostDigits);
  return std::min(decimals, kMostDigits - 1 - int(std::floor(std::log10(std::abs(value)))));
}

}  // namespace

std::string quantityText(const Quantity& quantity) {
  if (quantity.name == "voxels")
    return fmt::format("{} {}", grouped(std::uint64_t(quantity.value), ","), quantity.unit);
  double value = quantity.value;
  int decimals = quantity.decimals;
  std::string unit = quantity.unit;
  for (const Saying& saying : kSayings) {
    if (unit != saying.unit || std::abs(value) < saying.from || std::abs(value) >= saying.below) continue;
    value *= saying.factor;
    decimals -= int(std::lround(std::log10(saying.factor)));
    unit = saying.said;
    break;
  }
  decimals = withinDigits(value, decimals);
  // What is less than its own doubt still has a digit.
  while (decimals < 9 && value != 0.0 && std::abs(value) < 0.95 * std::pow(10.0, -decimals)) ++decimals;
  bool isClose = unit.empty() || unit == "\u00b0";
  return numberText(value, decimals) + (isClose ? "" : " ") + unit;
}

std::string quantityNumber(const Quantity& quantity) {
  int decimals = quantity.unit == "voxels" && quantity.name == "voxels" ? 0 : quantity.decimals + 1;
  while (decimals < 9 && quantity.value != 0.0 && std::abs(quantity.value) < 9.5 * std::pow(10.0, -decimals))
    ++decimals;
  return numberText(quantity.value, decimals);
}

Telling tellingOf(const scene::Scene& scene) {
  bool isUnknown = scene.volume.data && !scene.volume.data->isSpacingKnown;
  if (isUnknown) return {"voxels", 1.0, 0.1};
  bool isModel = scene.unit == LengthUnit::Angstrom;
  scene::LengthFormat format = scene::lengthFormat(scene);
  Telling telling{std::string(format.symbol), format.toldPerLength, std::pow(10.0, -format.decimals)};
  bool isEmpty = !scene.volume.data && !scene.labels.data;
  if (!isEmpty) telling.resolution = std::max(telling.resolution, 0.1 * scene::finestStep(scene) * telling.perLength);
  // Molecules are told in nanometres, and places in them are known to a tenth of an angstrom.
  if (isModel) telling = {"nm", 0.1, 0.1 * (scene.model.data ? 0.1 : telling.resolution)};
  return telling;
}

Quantity lengthQuantity(const Telling& telling, double length) {
  return {"length", length * telling.perLength, telling.unit, decimalsWithin(telling.resolution)};
}

Quantity areaQuantity(const Telling& telling, double area) {
  area *= telling.perLength * telling.perLength;
  return {"area", area, telling.unit + "\u00b2", decimalsWithin(telling.resolution * std::sqrt(std::abs(area)))};
}

Quantity volumeQuantity(const Telling& telling, double volume) {
  volume *= std::pow(telling.perLength, 3);
  double edge = std::cbrt(std::abs(volume));
  return {"volume", volume, telling.unit + "\u00b3", decimalsWithin(telling.resolution * edge * edge)};
}

Quantity angleQuantity(const Telling& telling, double degrees, double shortest) {
  constexpr double kDegreesPerRadian = 57.29577951308232;
  double doubt = shortest > 0.0 ? kDegreesPerRadian * telling.resolution / (shortest * telling.perLength) : 180.0;
  return {"angle", degrees, "\u00b0", std::clamp(decimalsWithin(doubt), 0, 1)};
}

}  // namespace velum::session
