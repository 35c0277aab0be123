#include "model/FocusRows.h"

#include <algorithm>

#include "scene/Scene.h"
#include "scene/Shown.h"

namespace velum::model {

std::vector<FocusRow> focusRows(const scene::Scene& scene) {
  std::vector<FocusRow> rows;
  int place = 0;
  for (const scene::Cut& cut : scene::enabledOf(scene.cuts)) {
    if (cut.model.focus && !cut.model.focus->types.empty()) {
      bool hasAperture = std::any_of(cut.model.spares.begin(), cut.model.spares.end(),
                                     [](const scene::TypeSpare& spare) { return spare.aperture < 1.0; });
      rows.push_back({place, &*cut.model.focus, hasAperture});
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

}  // namespace velum::model
