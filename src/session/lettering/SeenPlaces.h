#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "render/SheetIndices.h"
#include "scene/Lettering.h"
#include "scene/SceneFwd.h"
#include "session/lettering/NamesToPlace.h"

namespace velum::session {

/// Where the leader of a mark goes in a picture.
struct SeenPlace {
  int mark = 0;                  ///< its id
  std::optional<glm::dvec2> at;  ///< pixels of the picture; none: the mark's own place
  double share =
      1.0;  ///< 0..1: how much of the mark is drawn; 0: nothing of what it points at is seen, see seenPlaces()
  bool operator==(const SeenPlace&) const = default;
};

/// True where a picture needs seenPlaces(): marks with leaders from places are shown.
bool needsSeenPlaces(const scene::Lettering& lettering);

/// Where the leaders of labels and names go that have a place, so that none points at what is hidden: behind other
/// things, removed by a cut, or out of the picture.
/// - Of a structure or type, or of the instance that its point follows: at the place where that is seen, else at the
///   nearest pixel that shows it, rather inside than at its edge. It fades as less than about a letter of it is seen.
/// - Of neither: at the place alone. It fades as things come before the place, judged by the pixels about it.
/// So a frame of a film depends on its own picture alone, and nothing comes or goes at once.
/// @param scene  of the map's picture; where it holds no shapes of its membranes they are taken for flat
/// @param sheets  of the scene's membranes as they stand; those that are not given are made from the shapes
/// @return one for each mark that is shown, has a leader and a place. Any thread; time goes with the pixels, once for
/// all marks.
std::vector<SeenPlace> seenPlaces(const scene::Scene& scene, const SeenMap& map,
                                  const render::SheetIndices& sheets = {});

}  // namespace velum::session
