#pragma once
#include <glm/glm.hpp>
#include <map>
#include <vector>

#include "session/lettering/FreePlaces.h"
#include "session/lettering/LetteringBlock.h"
#include "session/lettering/PlaceNames.h"
#include "session/lettering/SeenNames.h"
#include "session/mark/MarkHands.h"
#include "session/measure/Measure.h"

namespace velum::session {

/// Names that find their places beside a picture, with leaders to what they name.
struct LaidNames {
  std::vector<LetteringBlock> blocks;
  std::vector<NamePlace> places;  ///< for the next frame
  std::vector<PlacedWords> words;
};

/// Names of a frame of a film on their way from their places at one moment to those at another.
struct NamesBetween {
  std::vector<NamePlace> from, to;
  double share = 0.0;  ///< of the way, 0..1
  SeenNames near;      ///< the names of both, with places near which the frame should point
};
/// What moves in one piece stands on its way; what goes far, or is at one of the two moments only, fades.
std::vector<NamePlace> placesBetween(const NamesBetween& names, double em);

/// The picture beside which names stand.
struct NamePaper {
  glm::ivec2 size{0};
  glm::vec3 ground{0.0f};  ///< before which all stands, sRGB
  double leastEm = 0.0;    ///< of letters, pixels
};
/// @param measured  of marks that are regions  @param places  where other lettering stands  @param before  see
/// placeNames()  @param between  of a film: places that are chosen already; null: none are
LaidNames layNames(const scene::Scene& scene, const NamePaper& paper, const SeenNames& seen,
                   const std::map<int, Measured>& measured, const FreePlaces& places,
                   const std::vector<NamePlace>* before, const NamesBetween* between = nullptr);

}  // namespace velum::session
