#pragma once
#include <cstdint>
#include <vector>

#include "core/Volume.h"
#include "scene/SceneFwd.h"
#include "scene/TransferFunction.h"
#include "session/look/TransferTool.h"

namespace velum::session {

/// How often each value occurs in one channel of one time step; bins as wide as whole numbers are apart, where that
/// makes at most 4096. O(voxels) up to 16 million. Any thread.
Histogram valueHistogram(const Volume& volume, int channel, int timeStep);

/// Keeps the histogram that was counted last, for what asks at every press of a button.
class HistogramMemo {
 public:
  /// Of the channel and time step that a layer shows, which has data. Lives until the next call.
  const Histogram& of(const scene::VolumeLayer& layer);

 private:
  struct Key {
    std::uint64_t volume = 0;
    int channel = 0, timeStep = 0;
    bool operator==(const Key&) const = default;
  };
  Key mKey;
  Histogram mHistogram;
};

/// The same for the length of the gradient, value per, from about a million voxels, up to where all but a thousandth
/// lie.
Histogram gradientHistogram(const Volume& volume, int channel, int timeStep);

/// The stretch of values worth seeing first: that of all but a few voxels, and what of a transfer function lies in the
/// data's range.
AxisView defaultView(const Histogram& histogram, const scene::TransferFunction& transfer);

/// Heights 0..1 of equal columns of an axis. A peak like that of the air around a patient does not flatten the rest.
/// @param logarithmic  by the logarithm of the counts
std::vector<double> histogramHeights(const Histogram& histogram, AxisView view, int columns, bool logarithmic);

}  // namespace velum::session
