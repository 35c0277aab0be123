#include "session/measure/ValueQuantities.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/GreyWindows.h"

namespace velum::session {

namespace {

int decimalsOfValues(const Volume& volume, glm::dvec2 range) {
  bool isWhole = volume.type != SampleType::Float32 && volume.type != SampleType::Float64;
  double largest = std::max(std::abs(range.x), std::abs(range.y));
  double step = isWhole ? std::abs(volume.scale) : 1e-3 * std::max(range.y - range.x, 1e-3 * largest);
  return step > 0.0 ? std::clamp(int(std::ceil(-std::log10(step) - 1e-6)), 0, 9) : 0;
}

}  // namespace

Quantity valueQuantity(const Volume& volume, std::string name, double value, glm::dvec2 range) {
  return {std::move(name), value, scene::valueUnit(volume), decimalsOfValues(volume, range)};
}

Quantity meanQuantity(const Volume& volume, std::string name, double value, glm::dvec2 range) {
  Quantity quantity = valueQuantity(volume, std::move(name), value, range);
  ++quantity.decimals;
  return quantity;
}

std::string bareText(Quantity quantity) {
  quantity.unit.clear();
  return quantityText(quantity);
}

void addValues(Measured& measured, const Volume& volume, const StructureValues& values) {
  glm::dvec2 range(values.least, values.most);
  Quantity mean = meanQuantity(volume, "mean", values.mean, range);
  Quantity deviation = meanQuantity(volume, "deviation", values.deviation, range);
  Quantity least = valueQuantity(volume, "least", values.least, range);
  Quantity most = valueQuantity(volume, "most", values.most, range);
  Quantity voxels{"voxels", double(values.voxels), "voxels", 0};
  if (!measured.text.empty()) measured.text += '\n';
  measured.text += fmt::format("mean {} \u00b1 {}\n{} to {}\n{}", quantityText(mean), bareText(deviation),
                               bareText(least), quantityText(most), quantityText(voxels));
  for (const Quantity& quantity : {mean, deviation, least, most, voxels}) measured.quantities.push_back(quantity);
}

}  // namespace velum::session
