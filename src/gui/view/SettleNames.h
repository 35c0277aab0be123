#pragma once
#include <QElapsedTimer>
#include <algorithm>
#include <vector>

#include "session/lettering/Lettering.h"

namespace velum::gui {

/// Lets names go from their places before to those of a new picture, until none moves any more; too far to go, they
/// stand as in a picture of its own.
/// @param seen  of the new picture  @param lay  gives the lettering of what is seen
template <class Lay>
std::vector<session::NamePlace> settledNames(std::vector<session::NamePlace> places, session::Seen seen, qint64 mostMs,
                                             const Lay& lay) {
  constexpr int kMostSteps = 120;
  QElapsedTimer clock;
  clock.start();
  for (int i = 0; i < kMostSteps && clock.elapsed() <= mostMs; ++i) {
    std::vector<session::NamePlace> before = std::move(places);
    seen.namesBefore = before.empty() ? nullptr : &before;
    places = lay(seen).names;
    bool isStill = std::ranges::equal(before, places, [](const auto& a, const auto& b) {
      return a.key == b.key && a.block.low == b.block.low && a.strength == b.strength;
    });
    if (isStill) return places;
  }
  seen.namesBefore = nullptr;
  return lay(seen).names;
}

}  // namespace velum::gui
