#pragma once
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/Task.h"
#include "vector/Drawing.h"

/// Lines within regions: where the surface ends before what lies behind it, and where it turns sharply.
namespace velum::vector {

/// What pixels show of surfaces. Row by row from the top.
struct SurfaceMap {
  glm::ivec2 size{0};                ///< pixels
  std::span<const int> ids;          ///< the region of each pixel; below 1: nothing
  std::span<const float> distances;  ///< from the eye along the ray of the pixel's middle; any number where nothing is
  std::span<const glm::vec3> normals;  ///< unit, in any frame that `View` has, too
  std::span<const float> opacities;    ///< 0..1, of what is seen; empty: all of it is opaque. A haze has no lines
};

/// The camera of a picture.
struct View {
  bool isOrthographic = false;
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, 1};  ///< unit
  double halfHeight =
      0.27;  ///< perspective: tangent of half the angle of view; orthographic: half the height, scene units
};

/// How lines are found: as the finish of the renderer does, whose values these are.
struct StepOptions {
  double steps = 1.0;       ///< how much of a line is where the depth jumps, 0..1: contourSteps
  double creases = 0.6;     ///< where the surface turns, 0..1: contourCreases
  double width = 2.4;       ///< of the lines, pixels of this picture, > 0
  double stepLength = 1.0;  ///< a jump begins to count from there, scene units, > 0: three voxels of a volume
  double least = 0.2;       ///< strength of what is a line, 0..1
  double leastLength = 4.0; /**< of a line that stands alone, in its widths */
};

/// A stroke of a pen.
struct Stroke {
  Outline line;           ///< open, or closed
  double strength = 1.0;  ///< in quarters, over 0 to 1: how dark or how wide it is
  int id = 0;             ///< region on which it lies
};

/// How much of a line each pixel has, 0..1, by the formulas of shaders/render/edges_data.glsl, but for the share
/// of its band that a line covers, which a pen's width says. Without the lines between regions and around them, which
/// are traceRegions()'s. Any thread, on all cores.
std::vector<float> edgeStrengths(const SurfaceMap& map, const View& view, const StepOptions& options);

/// Strokes along the middles of bands. @param strengths  how much of a line each pixel has, 0..1, row by row
/// @param ids  of which a stroke has that of its middle  @param options  of which width, least and leastLength count
/// @throw Cancelled
std::vector<Stroke> traceBands(glm::ivec2 size, std::span<const int> ids, const std::vector<float>& strengths,
                               const StepOptions& options, Progress& progress);

/// Strokes along the middles of the bands that edgeStrengths() finds, within about half a pixel. A line whose strength
/// changes on its way is several strokes, end to end. Any thread; 12 million pixels take a second or two, and some 20
/// bytes a pixel. @throw Cancelled
std::vector<Stroke> traceSteps(const SurfaceMap& map, const View& view, const StepOptions& options, Progress& progress);

}  // namespace velum::vector
