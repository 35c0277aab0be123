#include "velum/mesoscale/FocusRows.h"

#include <algorithm>

namespace velum::mesoscale {

std::vector<FocusRow> focusRows(const scene::Scene& scene) {
  std::vector<FocusRow> rows;
  int place = 0;
  for (const scene::Cut& cut : scene.cuts) {
    if (!cut.enabled) continue;
    if (cut.focus && !cut.focus->types.empty()) {
      bool hasAperture = std::any_of(cut.typeSpares.begin(), cut.typeSpares.end(),
                                     [](const scene::TypeSpare& spare) { return spare.aperture < 1.0; });
      rows.push_back({place, &*cut.focus, hasAperture});
    }
    ++place;
  }
  return rows;
}

std::vector<int> floodSteps(glm::ivec2 size) {
  std::vector<int> steps{0};
  int step = 1;
  while (2 * step < std::max(size.x, size.y)) step *= 2;
  for (; step >= 1; step /= 2) steps.push_back(step);
  steps.push_back(1);
  return steps;
}

}  // namespace velum::mesoscale
