#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/Focus.h"
#include "scene/SceneFwd.h"

namespace velum::model {

/// A focus in force: that of an enabled cut which keeps some types of the model in view.
struct FocusRow {
  int cut = 0;  ///< index of the cut among the enabled cuts
  const scene::Focus* focus = nullptr;
  bool hasAperture = false;  ///< for some type only a part of the view is cleared
};
std::vector<FocusRow> focusRows(const scene::Scene& scene);

/// The steps of jump flooding [JFA] over a picture, in pixels: 0, which places the seeds, then from half of the
/// picture's edge down to 1, and 1 once more. Differs: the last step is done twice, which mends most errors of the
/// method.
std::vector<int> floodSteps(glm::ivec2 size);

}  // namespace velum::model
