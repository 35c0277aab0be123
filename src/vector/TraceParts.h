#pragma once
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/Task.h"
#include "vector/TraceSteps.h"

/// Lines of cell models in the weights that the finish has for them: shaders/render/edges_model.glsl.
namespace velum::vector {

/// What pixels show of parts, which are what lines go around: instances, or types where these are small. Row by row
/// from the top.
struct PartMap {
  glm::ivec2 size{0};             ///< pixels
  std::span<const int> ids;       ///< of parts; below 1: nothing
  std::span<const float> depths;  ///< from the picture plane, scene units
  std::span<const float> sizes;   ///< across the part, pixels of a picture of 1000 rows, or of a smaller one
  std::span<const int> groups;    ///< by id - 1: the compartment of a part
};

/// How the finish draws them.
struct PartOptions {
  double contours = 1.0;    ///< strength, 0..1: finer pens fade with it
  double steps = 1.0;       ///< contourSteps
  double structures = 1.0;  ///< contourStructures
  double width = 2.4;       ///< of lines, pixels of this picture, > 0: contourWidth
  double stepLength = 1.0;  ///< a jump of depth begins to count from there, scene units, > 0
  double deepStep = 3.0;    ///< one that has a strong line, scene units
};

/// How wide the widest lines are, in `width`: the widths of strokes are shares of that.
inline constexpr double kWidestPartLine = 1.6;

/// The lines around parts and within large ones: strong ones around the whole, around compartments and where the depth
/// falls far, fine ones between parts, which go as these become small, faint ones within. Each border is one line,
/// which belongs to the part that is before the other one, and lies in the middle of the finish's band. What the finish
/// draws fainter is as much finer here, so that lines have as much ink. Parts too small for lines of their own are one
/// with those around them in their compartment.
/// @return strokes whose `strength` is their width as a share of kWidestPartLine, in sixteenths or quarters of these,
/// and whose id that of a part; closed where a weight goes all round. Any thread, partly on all cores. @throw Cancelled
std::vector<Stroke> traceParts(const PartMap& map, const PartOptions& options, Progress& progress);

}  // namespace velum::vector
