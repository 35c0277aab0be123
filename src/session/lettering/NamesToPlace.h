#pragma once
#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "scene/SceneFwd.h"

namespace velum::session {

/// What the pixels of a picture show, [y][x], row 0 is the top; of the picture's pixels each `step`-th along x and y.
struct SeenMap {
  glm::ivec2 size{0};
  std::span<const std::int32_t> structures;  ///< ids; 0 and below: none; empty: no pixel has one
  std::span<const std::int32_t> types;  ///< of the model; below 0: none, and what has one has no structure; or empty
  int step = 1;
  std::span<const std::int32_t> instances = {};  ///< of the model, over all copies; below 0: none; or empty
  std::span<const float> distances = {};         ///< from the eye along the ray; infinity: nothing; or empty: not known
};

/// The step of the map of a picture that is so wide: as fine as names need it.
constexpr int mapStep(int width) {
  constexpr int kColumns = 1000;
  return std::max(1, width / kColumns);
}
/// The size of the map of a picture.
inline glm::ivec2 mapSize(glm::ivec2 picture, int step) { return (picture + (step - 1)) / step; }

/// A name for something that a picture shows.
struct SeenName {
  int key = 0;  ///< by which it is known from frame to frame
  std::string name;
  std::uint64_t pixels = 0;  ///< of the picture that show it
  glm::dvec2 anchor{0};      ///< well inside of what is seen of it, pixels of the picture
  int structure = 0;         ///< id of the structure, or of the first of several that share the name; 0: it is none
  std::string type;          ///< path of the type, or of the first; empty: it is none
};

/// What is named in a picture (scene::Lettering::named): what the scene lists, or structures and types of which the
/// picture shows most and more than a dot, at most `mostNames`, the most first. What is called alike shares a name, and
/// a compartment that is listed has one for all that is in it, but what is listed by itself. Any thread; time goes with
/// the pixels.
/// @param before  of the frame before: its names give way only to clearly larger ones, and its anchors stay while they
/// can (computeVisibleParts())
/// @throw ArgumentError where the maps have not as many pixels as their size says
std::vector<SeenName> namesToPlace(const scene::Scene& scene, const SeenMap& map,
                                   std::span<const SeenName> before = {});

}  // namespace velum::session
