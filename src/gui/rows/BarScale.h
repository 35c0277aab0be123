#pragma once
#include <algorithm>
#include <cmath>

namespace velum::gui {

/// How numbers of instances lie along a bar: in percent of the row's own total, or as numbers on a logarithmic ruler
/// that all rows share, so that rare types show beside common ones ([VE] 7.2).
struct BarScale {
  bool isPercent = true;
  double most = 1.0;  ///< the end of the ruler: the largest total

  /// Where a count lies along the bar: 0 at the left end to 1 at the right end.
  double place(double count, double total) const {
    if (isPercent) return total > 0.0 ? count / total : 0.0;
    return std::log1p(count) / std::log1p(std::max(1.0, most));
  }
  /// The count at a place along the bar, from 0 to the total.
  double count(double place, double total) const {
    double number = isPercent ? place * total : std::expm1(place * std::log1p(std::max(1.0, most)));
    return std::clamp(number, 0.0, total);
  }
};

}  // namespace velum::gui
