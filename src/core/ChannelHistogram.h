#pragma once
#include "core/Volume.h"

namespace velum {

/// Histogram of the first time step of one channel, over the range from that channel's least value to its largest.
/// computeHistogram() takes the range of the whole volume instead, in which a dim channel beside a bright one would
/// fill only a bin or two. O(voxels), all cores. Any thread.
Histogram computeChannelHistogram(const Volume& volume, int channel, int bins = 4096);

}  // namespace velum
