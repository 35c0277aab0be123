#pragma once

/// Sizes of the canvas of tracks, pixels.
namespace velum::gui {

constexpr double kTitleWidth = 196, kRulerHeight = 30, kTrackHeight = 23, kTrackMargin = 14;
constexpr double kKeyRadius = 6.0, kKeyReach = 8.0, kFlagReach = 6.0;

}  // namespace velum::gui
