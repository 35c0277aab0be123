#pragma once
#include <span>
#include <string>
#include <string_view>

#include "core/LabelVolume.h"
#include "core/Task.h"
#include "core/Volume.h"

namespace velum::io {

/// A phantom with its ground truth on the same grid; the labels describe its first time step.
struct Sample {
  Volume volume;
  LabelVolume labels;
};

/// One phantom that we can make.
struct SampleInfo {
  std::string_view name;  ///< "torso"
  std::string_view doc;
};
/// two-spheres, vessels, torso, skull, hand, foot, lesion, seismic, neurons, fibres, ultrasound, heart.
std::span<const SampleInfo> samples();

/// Makes a phantom. Deterministic: the same name and size give the same bytes.
/// @param size  voxels along the longest axis, 16..1024; 0 takes the phantom's own default
/// @param timeSteps  time steps of a phantom that moves (heart), 1..100; 0 takes its own default; else 0 or 1
/// @param contrast  of all fibres to the haze around them, in standard deviations of the noise, up to 20; 0: from 2 to
/// 4, different for each fibre. For other phantoms it must be 0
/// @throw ArgumentError for an unknown name or size, or time steps for a phantom that does not move; Cancelled
Sample makeSample(std::string_view name, int size, Progress& progress, int timeSteps = 0, double contrast = 0.0);

}  // namespace velum::io
