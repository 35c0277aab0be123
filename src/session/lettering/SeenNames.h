#pragma once
#include <utility>
#include <vector>

#include "core/Image.h"
#include "scene/Lettering.h"
#include "scene/SceneFwd.h"
#include "session/lettering/NamesToPlace.h"
#include "session/lettering/SeenPlaces.h"
#include "session/lettering/VisibleParts.h"

namespace velum::session {

/// What a picture shows of what is named beside it.
struct SeenNames {
  std::vector<SeenName> names;                  ///< that find their own places (scene::Lettering::names)
  std::vector<std::pair<int, SeenName>> marks;  ///< by the ids of marks that have no points: where they point
  Silhouette subject;                           ///< of all that the picture shows
  std::vector<SeenPlace> places;                ///< of marks with leaders from places: where the leaders go
};

/// True where a picture needs seenNames().
bool needsSeenNames(const scene::Lettering& lettering);
/// What of a lettering seenNames() goes by: where two have the same, the same map has the same names. Points of marks
/// count by whether there are any.
scene::Lettering namingOf(const scene::Lettering& lettering);

/// @param map  with structures: ids, 0 for something without one, -1 for nothing  @param before  of the frame before
/// @throw ArgumentError as namesToPlace(). Any thread; time goes with the pixels.
SeenNames seenNames(const scene::Scene& scene, const SeenMap& map, const SeenNames& before = {});

/// The map of a picture with the channels "id" and "instance" (render::Layers), "type" where there is a model, and "Z"
/// where its distances are asked for. Channels are floats, which hold whole numbers up to 2^24 exactly: of larger
/// numbers of instances, those that marks of the scene follow are told by number and type, and of several of a type
/// whose numbers are one float the first is taken; all others are off by a few.
class ImageMap {
 public:
  /// @param step  see SeenMap; 0: mapStep()
  ImageMap(const scene::Scene& scene, const Image& image, int step = 0);
  ImageMap(const ImageMap&) = delete;
  ImageMap& operator=(const ImageMap&) = delete;
  /// Of a small picture whose pixels stand for so many of a larger one, along x and y: the map of that one.
  SeenMap mapOfLarger(int pixels) const;
  const SeenMap& map() const { return mMap; }

 private:
  std::vector<std::int32_t> mStructures, mTypes, mInstances;
  std::vector<float> mDistances;
  SeenMap mMap;
};

/// Of a picture with the channels of an ImageMap.
SeenNames seenNames(const scene::Scene& scene, const Image& image, const SeenNames& before = {});
/// Of a picture in whose film names have their places already: those names, pointing near where they are told to.
SeenNames seenNear(const scene::Scene& scene, const Image& image, const SeenNames& near);

}  // namespace velum::session
