#pragma once
#include <vector>

namespace velum::session {

/// The values of one material among others: a peak of their density, from one valley to the next.
struct Population {
  double middle = 0.0;  ///< where it is densest
  double spread = 0.0;  ///< standard deviation by the steeper of its flanks: the other may be somebody else's
  double share = 0.0;   ///< of all values, 0..1

  /// Nearly all of it lies below, as far as it is noise about its middle.
  double upperEnd() const;
  double lowerEnd() const;
  /// True when a value may be one of it.
  bool holds(double value) const { return value >= lowerEnd() && value <= upperEnd(); }
};

/// Those that a list of values consists of, ascending. What no valley parts is one, such as flesh with the long tail of
/// thin bone in it. Small ones are left out.
std::vector<Population> populationsOf(std::vector<double> values);

}  // namespace velum::session
