#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "session/plate/Plate.h"

namespace velum::session {

namespace {

constexpr double kPoints = 72.0;  // an inch
constexpr double kLeastDpi = 300.0, kLeastLinePoints = 0.5, kLeastTextPoints = 6.0, kMostTextPoints = 8.0;
constexpr double kRounding = 1e-3;

/// The thinnest line, and the smallest and largest letters, pixels.
struct Extremes {
  double line = std::numeric_limits<double>::infinity(), smallest = line, largest = 0.0;
  void take(const vector::Plate&) {}
  void take(const vector::Shape& shape) {
    if (shape.pen) line = std::min(line, shape.pen->width);
  }
  void take(const vector::Words& words) {
    smallest = std::min(smallest, words.em);
    largest = std::max(largest, words.em);
  }
};

}  // namespace

std::vector<std::string> journalNotes(const vector::Drawing& drawing) {
  Extremes found;
  for (const vector::Layer& layer : drawing.layers) {
    if (layer.isHidden) continue;
    for (const vector::Item& item : layer.items) std::visit([&](const auto& of) { found.take(of); }, item);
  }
  double points = kPoints / drawing.dpi;
  std::vector<std::string> notes;
  if (drawing.dpi < kLeastDpi - kRounding)
    notes.push_back(
        fmt::format("the plate has {:.0f} pixels an inch; journals ask for {:.0f} or more: make it {:.0f} pixels wide",
                    drawing.dpi, kLeastDpi, std::ceil(drawing.size.x * kLeastDpi / drawing.dpi)));
  if (found.line * points < kLeastLinePoints - kRounding)
    notes.push_back(fmt::format("the thinnest line is {:.2g} pt wide; journals ask for {:.1f} pt or more",
                                found.line * points, kLeastLinePoints));
  if (found.smallest * points < kLeastTextPoints - kRounding)
    notes.push_back(fmt::format("the smallest letters have {:.2g} pt; journals ask for {:.0f} pt or more",
                                found.smallest * points, kLeastTextPoints));
  if (found.largest * points > kMostTextPoints + kRounding)
    notes.push_back(fmt::format("the largest letters have {:.3g} pt; journals ask for {:.0f} pt or less",
                                found.largest * points, kMostTextPoints));
  return notes;
}

}  // namespace velum::session
