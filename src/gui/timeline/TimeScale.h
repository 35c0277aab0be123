#pragma once
#include <QString>

namespace velum::gui {

/// Where times stand on a line of pixels.
struct TimeScale {
  double start = 0.0;              ///< time at the left edge, seconds
  double pixelsPerSecond = 100.0;  ///< positive
  double left = 0.0;               ///< pixel of the left edge

  double xOf(double time) const { return left + (time - start) * pixelsPerSecond; }
  double timeAt(double x) const { return start + (x - left) / pixelsPerSecond; }
  bool operator==(const TimeScale&) const = default;
};

/// The distance of numbers on a ruler, seconds: 1, 2 or 5 of a power of ten, whole frames, and, over a minute, parts
/// of minutes. @param least  pixels that a number needs
double rulerStep(const TimeScale& scale, double least, double framesPerSecond);

/// A time as a ruler says it: "0", "2.5", "1:30". @param step  of the ruler, which says how many decimals there are
QString rulerText(double time, double step);

/// The scale in which a stretch of time fills pixels.
TimeScale fitted(double from, double to, double left, double width);

/// The scale about a time that stays where it is. @param factor  > 1: nearer
TimeScale zoomed(const TimeScale& scale, double about, double factor);

}  // namespace velum::gui
