#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "model/Levels.h"

namespace velum::model {

/// Finds balls near a point: their numbers, sorted by the cell of a grid in which their middles lie. Only numbers are
/// kept, so that the balls may change meanwhile, except for their middles.
class BallGrid {
 public:
  /// @param cell  edge of a cell; made longer where the grid would have many more cells than balls
  BallGrid(std::span<const Ball> balls, float cell) : mCell(cell) {
    glm::vec3 low(0.0f), high(0.0f);
    if (!balls.empty()) low = high = balls.front().centre;
    for (const Ball& ball : balls) low = glm::min(low, ball.centre), high = glm::max(high, ball.centre);
    mLow = low;
    double most = 8.0 * double(balls.size()) + 64.0;
    for (;; mCell *= 1.5f) {
      glm::dvec3 cells = glm::floor(glm::dvec3(high - low) / double(mCell)) + 1.0;
      if (cells.x * cells.y * cells.z > most) continue;
      mSize = glm::ivec3(cells);
      break;
    }
    mFirst.assign(std::size_t(mSize.x) * std::size_t(mSize.y) * std::size_t(mSize.z) + 1, 0);
    for (const Ball& ball : balls) ++mFirst[indexOf(cellOf(ball.centre)) + 1];
    for (std::size_t i = 1; i < mFirst.size(); ++i) mFirst[i] += mFirst[i - 1];
    mOrder.resize(balls.size());
    std::vector<std::uint32_t> next(mFirst.begin(), mFirst.end() - 1);
    for (std::size_t i = 0; i < balls.size(); ++i) mOrder[next[indexOf(cellOf(balls[i].centre))]++] = std::uint32_t(i);
  }

  /// Calls visit(number) for all balls whose middle is within a distance of p, and for some others near by.
  template <class Visit>
  void forNear(glm::vec3 p, float distance, const Visit& visit) const {
    glm::ivec3 from = glm::max(glm::ivec3(glm::floor((p - distance - mLow) / mCell)), glm::ivec3(0));
    glm::ivec3 to = glm::min(glm::ivec3(glm::floor((p + distance - mLow) / mCell)), mSize - 1);
    for (int z = from.z; z <= to.z; ++z)
      for (int y = from.y; y <= to.y; ++y) {
        if (from.x > to.x) continue;
        std::size_t first = mFirst[indexOf({from.x, y, z})], end = mFirst[indexOf({to.x, y, z}) + 1];
        for (std::size_t i = first; i < end; ++i) visit(mOrder[i]);
      }
  }

 private:
  glm::ivec3 cellOf(glm::vec3 p) const {
    return glm::clamp(glm::ivec3(glm::floor((p - mLow) / mCell)), glm::ivec3(0), mSize - 1);
  }
  std::size_t indexOf(glm::ivec3 cell) const {
    return std::size_t(cell.x) +
           std::size_t(mSize.x) * (std::size_t(cell.y) + std::size_t(mSize.y) * std::size_t(cell.z));
  }

  float mCell;
  glm::vec3 mLow{0.0f};
  glm::ivec3 mSize{1};
  std::vector<std::uint32_t> mFirst;  ///< by cell: its first entry in mOrder; one more at the end
  std::vector<std::uint32_t> mOrder;
};

}  // namespace velum::model
