#pragma once
#include "core/Task.h"
#include "core/Volume.h"

namespace velum::membrane {

/// Standard deviation of noise that differs from voxel to voxel, in the volume's unit: by the median of second
/// differences along x, which edges hardly change. Noise that is smooth, as of some scanners, seems less than it is. 0
/// where there is none. A million voxels at most.
double noiseOf(const Volume& volume, int channel, int timeStep);

/// One channel of one time step with its noise taken out, so that a curve over values tells thin structures from what
/// is around them: each voxel becomes the mean of those of its 27 neighbours, itself among them, that look like it
/// where all is smoothed a little. In voxels, whatever their spacing. 16 bits a voxel of data of up to 16 bits, else
/// floats. All cores.
/// @param noise  standard deviation, in the volume's unit; 0 leaves all as it is  @throw Cancelled
Volume denoise(const Volume& volume, int channel, int timeStep, double noise, const Progress& progress);

}  // namespace velum::membrane
