#include "membrane/forces/FieldStrength.h"

#include <algorithm>
#include <cmath>

#include "membrane/forces/Kernels.h"

namespace velum::membrane {

double strongestOf(const scene::ForceField& field) {
  double most = 0.0;
  for (auto* curve : {&field.byValue, &field.byGradient})
    for (const auto& point : *curve) most = std::max(most, point.strength);
  for (const auto& one : field.byLabel) most = std::max(most, one.strength);
  for (const auto& one : field.byType) most = std::max(most, one.strength);
  for (const auto& kernel : field.kernels) most = std::max(most, kernel.strength);
  return most;
}

bool isAlike(const scene::ForceField& field) {
  double strongest = strongestOf(field);
  auto isOne = [&](const auto& one) { return one.strength <= 0.0 || one.strength == strongest; };
  auto isFlat = [&](const std::vector<scene::StrengthPoint>& curve) {
    bool flat = std::all_of(curve.begin(), curve.end(), isOne);
    for (std::size_t i = 1; i < curve.size(); ++i)
      flat = flat && (curve[i].strength == curve[i - 1].strength || curve[i].value == curve[i - 1].value ||
                      std::max(curve[i].strength, curve[i - 1].strength) <= 0.0);
    return flat;
  };
  int attributes = int(!field.byValue.empty()) + int(!field.byGradient.empty()) + int(!field.byLabel.empty()) +
                   int(!field.byType.empty());
  return attributes <= 1 && isFlat(field.byValue) && isFlat(field.byGradient) &&
         std::all_of(field.byLabel.begin(), field.byLabel.end(), isOne) &&
         std::all_of(field.byType.begin(), field.byType.end(), isOne) &&
         std::all_of(field.kernels.begin(), field.kernels.end(), isOne);
}

bool attracts(const scene::ForceField& field) {
  auto isBelow = [](const auto& one) { return one.strength < 0.0; };
  return std::any_of(field.byValue.begin(), field.byValue.end(), isBelow) ||
         std::any_of(field.byGradient.begin(), field.byGradient.end(), isBelow) ||
         std::any_of(field.byLabel.begin(), field.byLabel.end(), isBelow) ||
         std::any_of(field.byType.begin(), field.byType.end(), isBelow);
}

std::uint8_t weightOf(double strength, double strongest) {
  if (!(strength > 0.0)) return 0;
  double weight = std::round(ProtectedVoxels::kStrongest * strength / std::max(strongest, 1e-9));
  return std::uint8_t(std::clamp(weight, 1.0, double(ProtectedVoxels::kStrongest)));
}

}  // namespace velum::membrane
