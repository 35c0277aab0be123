#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/Focus.h"
#include "scene/SceneFwd.h"

namespace velum::model {

/// A focus that is in force: an enabled cut keeps some types of the model in view.
struct FocusRow {
  int cut = 0;  ///< of the enabled ones
  const scene::Focus* focus = nullptr;
  bool hasAperture = false;  ///< some type is cleared by a part of the view only
};
std::vector<FocusRow> focusRows(const scene::Scene& scene);

/// The steps of jump flooding over a picture, pixels: seeds are laid (0), then from half of its edge to 1, and once
/// more 1. [JFA]; Differs: the last step is done twice, which mends most of its errors.
std::vector<int> floodSteps(glm::ivec2 size);

}  // namespace velum::model
