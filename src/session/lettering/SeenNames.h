#pragma once
#include <utility>
#include <vector>

#include "core/Image.h"
#include "scene/Lettering.h"
#include "scene/SceneFwd.h"
#include "session/lettering/NamesToPlace.h"
#include "session/lettering/VisibleParts.h"

namespace velum::session {

/// What a picture shows of what is named beside it.
struct SeenNames {
  std::vector<SeenName> names;                  ///< that find their own places (scene::Lettering::names)
  std::vector<std::pair<int, SeenName>> marks;  ///< by the ids of marks that have no points: where they point
  Silhouette subject;                           ///< of all that the picture shows
};

/// True where a picture needs seenNames().
bool needsSeenNames(const scene::Lettering& lettering);

/// @param map  with structures: ids, 0 for something without one, -1 for nothing  @param before  of the frame before
/// @throw ArgumentError as namesToPlace(). Any thread; time goes with the pixels.
SeenNames seenNames(const scene::Scene& scene, const SeenMap& map, const SeenNames& before = {});

/// Of a picture with the channels "id" and "instance" (render::Layers), and "type" where there is a model.
SeenNames seenNames(const scene::Scene& scene, const Image& image, const SeenNames& before = {});
/// Of a picture in whose film names have their places already: those names, pointing near where they are told to.
SeenNames seenNear(const scene::Scene& scene, const Image& image, const SeenNames& near);

}  // namespace velum::session
