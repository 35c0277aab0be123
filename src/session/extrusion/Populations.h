#pragma once
#include <vector>

namespace velum::session {

/// The values of one material among others: a peak of their density, from one valley to the next.
struct Population {
  double middle = 0.0;  ///< where it is densest
  double spread = 0.0;  ///< standard deviation by the steeper flank of the peak: the other flank may belong to another
                        ///< material
  double share = 0.0;   ///< of all values, 0..1

  /// Nearly all of the material's values lie below upperEnd() and above lowerEnd(), as far as they are noise about the
  /// middle.
  double upperEnd() const;
  double lowerEnd() const;
  /// True when a value may be one of this material.
  bool holds(double value) const { return value >= lowerEnd() && value <= upperEnd(); }
};

/// The populations of which a list of values consists, ascending. Values that no valley parts are one population, such
/// as flesh with the long tail of thin bone in it. Small populations are left out.
std::vector<Population> populationsOf(std::vector<double> values);

}  // namespace velum::session
