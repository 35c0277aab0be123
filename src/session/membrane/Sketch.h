#pragma once
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "core/Volume.h"
#include "scene/Membrane.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// Sketch to PFTF [IMC] 3.3: a user draws strokes over what a membrane is to keep whole, or to let its sheet through,
/// and the curve of strengths is fitted to the values under the strokes.

/// A stretch of values from `low` to `high`, the volume's unit.
struct ValueStretch {
  double low = 0, high = 0;
  bool isFirst = false, isLast = false;  ///< reaches that end of the data's range
};

/// The stretches of values that are typical of samples, ascending: values that are more frequent among the samples than
/// in the whole volume, and at least twice as frequent as in `others`. Densities are estimated with Gaussian kernels as
/// wide as the largest heap of the samples asks for. A stretch that holds less than a twentieth of the samples is taken
/// for spill and left out. All three histograms must have the same bins. O(bins^2) at worst, some milliseconds.
std::vector<ValueStretch> typicalStretches(const Histogram& samples, const Histogram& others, const Histogram& whole);

/// The curve of strengths fitted to samples: a trapezoid of kProtectStrength over each typical stretch.
/// Differs: [IMC] fits the curve to the histogram of the stroke; here the whole volume's histogram decides which of the
/// stroke's values are typical, so that air or tissue that lies everywhere does not win.
std::vector<scene::StrengthPoint> fitStrokes(const Histogram& keep, const Histogram& avoid, const Histogram& whole);

/// Replaces the strokes of a field and fits `byValue` to them. Where no stroke keeps, strokes that avoid take their
/// values out of the curve that was there before the first stroke; when the last stroke goes, this curve comes back.
/// @param whole  wholeHistogram() of the layer
void setStrokes(scene::ForceField& field, std::vector<scene::Stroke> strokes, const scene::VolumeLayer& layer,
                const Histogram& whole);

/// A path with as few of its points as keep it within a tolerance of all of them (Douglas and Peucker).
std::vector<glm::dvec3> simplifiedPath(std::span<const glm::dvec3> path, double tolerance);

}  // namespace velum::session
