#include "gui/timeline/TimeScale.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace velum::gui {

namespace {
constexpr double kLeastPerSecond = 1e-3, kMostPerSecond = 20'000.0;  ///< pixels
}

double rulerStep(const TimeScale& scale, double least, double framesPerSecond) {
  double wanted = std::max(least / scale.pixelsPerSecond, 1e-6);
  for (double minutes : {15.0, 30.0, 60.0, 120.0, 300.0, 600.0, 1800.0, 3600.0, 7200.0, 14400.0, 43200.0})
    if (wanted > 10.0 && wanted <= minutes) return minutes;
  double power = std::pow(10.0, std::floor(std::log10(wanted)));
  double step = power;
  for (double each : {1.0, 2.0, 5.0, 10.0}) {
    step = each * power;
    if (step >= wanted * (1.0 - 1e-9)) break;
  }
  return std::max(step, 1.0 / framesPerSecond);
}

QString rulerText(double time, double step) {
  if (step >= 15.0) {
    auto seconds = qint64(std::llround(time));
    return QString("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QChar('0'));
  }
  int decimals = std::clamp(int(std::ceil(-std::log10(step) - 1e-9)), 0, 3);
  return QLocale().toString(time, 'f', decimals);
}

TimeScale fitted(double from, double to, double left, double width) {
  double span = std::max(to - from, 1e-3);
  return {from, std::clamp(std::max(width, 1.0) / span, kLeastPerSecond, kMostPerSecond), left};
}

TimeScale zoomed(const TimeScale& scale, double about, double factor) {
  double pixels = std::clamp(scale.pixelsPerSecond * factor, kLeastPerSecond, kMostPerSecond);
  double x = scale.xOf(about);
  return {std::max(0.0, about - (x - scale.left) / pixels), pixels, scale.left};
}

}  // namespace velum::gui
