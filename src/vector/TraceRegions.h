#pragma once
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/Task.h"
#include "vector/Drawing.h"

/// From the ids of pixels to smooth lines. Regions are a planar map: a border of two is one line, which both have.
namespace velum::vector {

/// What is beyond the edge of the picture.
inline constexpr int kOutside = -1;

/// Which region each pixel belongs to.
struct IdMap {
  glm::ivec2 size{0};               ///< pixels
  std::span<const int> ids;         ///< row by row from the top; below 1: nothing
  std::span<const float> coverage;  ///< empty, or how much of each pixel is covered by anything, 0..1: alpha
};

struct RegionOptions {
  double leastArea = 12.0;  ///< what is smaller, also a hole, becomes part of what is around it, pixels
};

/// A border of two regions.
struct Border {
  Outline line;            ///< closed where no third region touches it; along the edge of the picture exactly straight
  int left = 0, right = 0; /**< ids as seen by who walks along it; 0: nothing; kOutside: the edge of the picture */
};

/// All pixels of an id.
struct Region {
  int id = 0;         ///< at least 1
  double area = 0.0;  ///< pixels
  std::vector<Outline>
      outlines;  ///< closed, holes among them, for the even-odd rule; along the edge of the picture, too
};

struct RegionMap {
  std::vector<Border> borders;  ///< each once
  std::vector<Region> regions;  ///< by id; made of the same curves as the borders
};

/// The smooth borders of regions. Coordinates: a pixel is a square of edge 1, the picture's corner is 0, 0. Curves lie
/// within 0.53 of the edges of pixels that they go along everywhere, mostly 0.2 (with coverage 0.6, corners and nodes
/// 0.8); of what was drawn sharply they know the place to a quarter. Corners stay corners. Borders
/// with nothing follow the coverage where it is given, so that they lie on what is drawn to an eighth. Any thread,
/// partly on all cores; takes about a second for 12 million pixels and 300 regions, and 12 bytes a pixel. @throw
/// Cancelled
RegionMap traceRegions(const IdMap& map, const RegionOptions& options, Progress& progress);

}  // namespace velum::vector
