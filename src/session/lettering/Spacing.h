#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace velum::session {

/// Something that wants a place on a line.
struct Spaced {
  double wanted = 0.0;  ///< where its middle should be
  double size = 0.0;
};

/// Finds the middles of things on a line that keep their order and a gap, with the least sum of squared ways from where
/// they are wanted: exact, by pooling neighbours that are too near ([PAV]).
/// @param low, high  between which all must lie  @return none: they do not fit
std::optional<std::vector<double>> spaceOut(std::span<const Spaced> things, double gap, double low, double high);

/// The same where only some stretches of the line are free: which thing lies in which is found by the least sum of
/// ways to the stretch, over all ways to share them out in their order.
/// @param stretches  (low, high), from low to high, none overlapping
std::optional<std::vector<double>> spaceOut(std::span<const Spaced> things, double gap,
                                            std::span<const glm::dvec2> stretches);

}  // namespace velum::session
