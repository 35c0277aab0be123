#pragma once
#include <glm/glm.hpp>
#include <map>
#include <vector>

#include "session/lettering/FreePlaces.h"
#include "session/lettering/LetteringBlock.h"
#include "session/lettering/PlaceNames.h"
#include "session/lettering/SeenNames.h"
#include "session/measure/Measure.h"

namespace velum::session {

/// Names that find their places beside a picture, with leaders to what they name.
struct LaidNames {
  std::vector<LetteringBlock> blocks;
  std::vector<NamePlace> places;  ///< for the next frame
};

/// @param ground  before which all stands, sRGB  @param measured  of marks that are regions  @param places  where other
/// lettering stands  @param before  see placeNames()
LaidNames layNames(const scene::Scene& scene, glm::ivec2 size, const SeenNames& seen,
                   const std::map<int, Measured>& measured, glm::vec3 ground, const FreePlaces& places,
                   const std::vector<NamePlace>* before);

}  // namespace velum::session
