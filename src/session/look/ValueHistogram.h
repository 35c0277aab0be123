#pragma once
#include <cstdint>
#include <vector>

#include "core/Volume.h"
#include "scene/SceneFwd.h"
#include "scene/TransferFunction.h"
#include "session/look/TransferTool.h"

namespace velum::session {

/// How often each value occurs in one channel of one time step. The bins are as wide as whole numbers are apart, where
/// that makes at most 4096 bins. O(voxels) up to 16 million. Any thread.
Histogram valueHistogram(const Volume& volume, int channel, int timeStep);

/// Keeps the histogram that was counted last, for tools that ask for it at every press of a button.
class HistogramMemo {
 public:
  /// The histogram of the channel and time step that a layer shows; the layer must have data. Valid until the next
  /// call.
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

/// How often each length of the gradient occurs (value per unit of length), from about a million voxels, up to the
/// length that all but a thousandth of them stay below.
Histogram gradientHistogram(const Volume& volume, int channel, int timeStep);

/// The stretch of values worth seeing first: the values of all but a few voxels, and the part of a transfer function
/// that lies in the data's range.
AxisView defaultView(const Histogram& histogram, const scene::TransferFunction& transfer);

/// Heights 0..1 of a histogram in equal columns of an axis. A peak such as that of the air around a patient does not
/// flatten the other columns.
/// @param logarithmic  heights go by the logarithm of the counts
std::vector<double> histogramHeights(const Histogram& histogram, AxisView view, int columns, bool logarithmic);

}  // namespace velum::session
