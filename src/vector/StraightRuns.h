#pragma once
#include <optional>
#include <span>
#include <vector>

#include "vector/LineFit.h"

namespace velum::vector {

/// Points one after the other that lie about a straight line, as what is drawn on pixels does.
struct StraightRun {
  int first = 0, end = 0;
  int length() const { return end - first; }
};

/// Divides points into straight runs, as long as they may be; where one ends is moved until both lie best.
/// @param first, end  end - first is at least 1
std::vector<StraightRun> findRuns(const LineFits& fits, std::span<const glm::dvec2> points, int first, int end);

/// One past the last point of the longest run, nearly, that begins somewhere.
int longestRun(const LineFits& fits, std::span<const glm::dvec2> points, int first, int end);

/// Moves the ends of neighbouring runs to where they lie best.
void settleRuns(const LineFits& fits, std::span<StraightRun> runs);

/// The corner between two runs that follow each other; nothing where the line is round there. @param middle  where the
/// track passes from one to the other: a corner is within a pixel of it
std::optional<glm::dvec2> findCorner(const LineFits& fits, std::span<const glm::dvec2> points,
                                     const StraightRun& before, const StraightRun& after, glm::dvec2 middle);

}  // namespace velum::vector
