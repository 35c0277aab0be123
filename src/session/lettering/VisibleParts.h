#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace velum::session {

/// What each pixel of a picture shows: the id of a structure, or the number of a type.
struct KeyMap {
  glm::ivec2 size{0};
  std::span<const std::int32_t> keys;  ///< [y][x], row 0 is the top; below 0: nothing that has a name
  int step = 1;                        ///< of the picture's pixels each `step`-th is in the map, along x and y
};

/// What a picture shows of one key.
struct VisiblePart {
  std::int32_t key = -1;
  std::uint64_t pixels = 0;  ///< of the picture
  glm::dvec2 anchor{0};      ///< pixels of the picture: the middle of a pixel of the map that has the key
  double depth = 0.0;        ///< how far the anchor is from the edge of what is seen, pixels of the picture
};

/// Finds the keys of a map, and a place to point at for each: well inside its largest connected part, near the middle
/// of it; on thin things on them. A key that has an anchor in `before` keeps it while that is well inside a part that
/// is not much smaller than the largest, and else gets the nearest place that is. Any thread; time goes with the
/// pixels (8 ms for a million).
/// @param before  of the frame before, or with anchors at which its places in the world are seen now
/// @return one for each key >= 0, by key
/// @throw ArgumentError where the map has not as many keys as its size says, or no step
std::vector<VisiblePart> computeVisibleParts(const KeyMap& map, std::span<const VisiblePart> before = {});

/// From where to where a picture shows something, row by row.
struct Silhouette {
  int step = 1;                  ///< rows of the picture that one row stands for
  std::vector<glm::dvec2> rows;  ///< left and right end, pixels of the picture; left >= right: nothing
};

/// The silhouette of all that has a key. Of a picture's alpha: with a map that is -1 where that is 0.
/// @throw ArgumentError as computeVisibleParts()
Silhouette silhouetteOf(const KeyMap& map);

}  // namespace velum::session
