#pragma once
#include "vector/TraceSteps.h"

namespace velum::vector {

struct HatchOptions {
  double spacing = 5.0;  ///< from stroke to stroke, pixels of this picture, at least 2: hatchWidth
  bool crosses = true;   ///< strokes across the others where it is darkest
};

/// Hatching round the form: the strokes of the finish [PHASOR], each a line along its middle. They are its strokes for
/// the same camera and the same first sample, and lie on the drawn ones nearly everywhere. Differs: between places
/// where strokes end or meet, a driver's rounding may decide on which of two ways they go, half a spacing apart: draw
/// the picture without strokes under these. On small instances of models the finish draws fewer and finer ones, as it
/// knows how large they are. Strokes shorter than twice the spacing are left out; one ends at the border of a region.
/// Where its width changes on its way a stroke is several, end to end.
/// @param tones  how light each pixel is without strokes, 0..1: 0.30 R + 0.59 G + 0.11 B
/// @return strokes whose `strength` is their width as a share of the spacing, in sixteenths or quarters of these. Any
/// thread, partly on all cores; 12 million pixels take two seconds. @throw Cancelled
std::vector<Stroke> traceHatching(const SurfaceMap& map, const View& view, std::span<const float> tones,
                                  const HatchOptions& options, Progress& progress);

}  // namespace velum::vector
