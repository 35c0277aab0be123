#pragma once
#include "core/Volume.h"

namespace velum {

/// The first time step of a channel between its own least and largest value, where computeHistogram() takes the
/// volume's: beside a bright channel a dim one would lie in a bin or two. O(voxels), all cores. Any thread.
Histogram computeChannelHistogram(const Volume& volume, int channel, int bins = 4096);

}  // namespace velum
