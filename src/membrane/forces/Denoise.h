#pragma once
#include "core/Task.h"
#include "core/Volume.h"

namespace velum::membrane {

/// Standard deviation of the noise of one channel at one time step, in the volume's unit, estimated by the median of
/// second differences along x, which edges hardly change. Noise that is smooth from voxel to voxel, as of some
/// scanners, is underestimated. 0 where there is no noise. Looks at a million voxels at most.
double noiseOf(const Volume& volume, int channel, int timeStep);

/// One channel of one time step with its noise taken out, so that a curve over values tells thin structures from what
/// is around them: each voxel becomes the mean of those of the 27 voxels around it, itself included, that are like it
/// in a slightly smoothed copy of the data. Distances are in voxels, whatever the spacing. The result has 16 bits a
/// voxel for data of up to 16 bits, else floats. All cores.
/// @param noise  standard deviation of the noise, in the volume's unit; 0: nothing is changed @throw Cancelled
Volume denoise(const Volume& volume, int channel, int timeStep, double noise, const Progress& progress);

}  // namespace velum::membrane
