#include "model/WholeModel.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <numeric>
#include <utility>

namespace velum::model {

namespace {

constexpr float kFirstCells = 64.0f;   // along the longest edge of the model
constexpr float kCoarserCells = 1.5f;  // from level to level: a third of the balls
constexpr float kCellError = 0.5f;     // of a cell: how far outlines may be off
constexpr float kFullCell = 0.62f;     // of a cell: radius of the ball of its volume
constexpr float kNextToNothing = 0.01f;

/// What is in a cell: the middle of all, the area that they hide together, the type that was drawn.
struct Member {
  glm::vec3 centre{0.0f};
  float area = 0.0f;
  std::uint32_t type = 0;
};

/// Balls of all instances, by the coarsest levels of these that are fine enough.
std::vector<Member> membersOf(const Model& model, const LevelSet& levels, float error) {
  std::vector<Member> members;
  members.reserve(2 * model.instances.size());
  for (const Instance& instance : model.instances) {
    std::span<const Level> own = levels.of(instance.molecule);
    std::size_t level = own.size() - 1;
    while (level > 0 && own[level].error > error) --level;
    for (std::uint32_t i = own[level].first; i < own[level].first + own[level].count; ++i) {
      const Ball& ball = levels.balls[i];
      members.push_back({instance.position + instance.rotation * ball.centre,
                         glm::pi<float>() * ball.radius * ball.radius, model.molecules[instance.molecule].type});
    }
  }
  return members;
}

/// One of some members, each as likely as it is large.
std::uint32_t drawnType(const std::vector<Member>& members, const std::pair<std::uint64_t, std::uint32_t>* first,
                        const std::pair<std::uint64_t, std::uint32_t>* end, float area) {
  float left = randomOf(std::uint32_t(first->first ^ first->first >> 32), 2) * area;
  for (; first + 1 != end; ++first) {
    left -= members[first->second].area;
    if (left < 0.0f) break;
  }
  return members[first->second].type;
}

/// What is in the cells of a grid.
std::vector<Member> inCells(const std::vector<Member>& members, glm::vec3 low, float cell) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> byCell;
  byCell.reserve(members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    glm::uvec3 at(glm::max((members[i].centre - low) / cell, 0.0f));
    byCell.emplace_back(std::uint64_t(at.z) << 42 | std::uint64_t(at.y) << 21 | at.x, std::uint32_t(i));
  }
  std::sort(byCell.begin(), byCell.end());
  std::vector<Member> cells;
  for (std::size_t first = 0, end = 0; first < byCell.size(); first = end) {
    Member all;
    glm::vec3 sum(0.0f);
    for (end = first; end < byCell.size() && byCell[end].first == byCell[first].first; ++end) {
      const Member& one = members[byCell[end].second];
      sum += one.area * (one.centre - low);
      all.area += one.area;
    }
    all.centre = low + sum / std::max(all.area, 1e-30f);
    all.type = drawnType(members, &byCell[first], byCell.data() + end, all.area);
    cells.push_back(all);
  }
  return cells;
}

/// A level's cells by their places in the grid, and how much of what is behind them they hide, 0..1.
struct Cells {
  std::vector<glm::ivec3> places;
  std::vector<float> hides;
};

/// Notes which cells are seen along an axis: bit 2 * axis for who looks towards larger coordinates, the next for who
/// looks back.
void noteSeen(const Cells& cells, int axis, std::vector<std::uint8_t>& seen) {
  std::vector<std::uint32_t> order(cells.places.size());
  std::iota(order.begin(), order.end(), 0u);
  auto lineOf = [&](std::uint32_t i) {
    glm::ivec3 at = cells.places[i];
    return std::pair(at[(axis + 1) % 3], at[(axis + 2) % 3]);
  };
  std::sort(order.begin(), order.end(), [&](auto a, auto b) {
    return std::pair(lineOf(a), cells.places[a][axis]) < std::pair(lineOf(b), cells.places[b][axis]);
  });
  for (int back = 0; back < 2; ++back) {
    float passes = 1.0f;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i == 0 || lineOf(order[i]) != lineOf(order[i - 1])) passes = 1.0f;
      if (passes > kNextToNothing) seen[order[i]] |= std::uint8_t(1 << (2 * axis + back));
      passes *= 1.0f - cells.hides[order[i]];
    }
    std::reverse(order.begin(), order.end());
  }
}

/// Adds the balls of a level that are seen towards each octant.
void addSides(WholeModel& whole, const Cells& cells) {
  std::vector<std::uint8_t> seen(cells.places.size());
  for (int axis = 0; axis < 3; ++axis) noteSeen(cells, axis, seen);
  Level of = whole.levels[whole.sides.size()];
  std::array<Level, 8>& sides = whole.sides.emplace_back();
  for (unsigned octant = 0; octant < 8; ++octant) {
    unsigned wanted = 0;
    for (unsigned axis = 0; axis < 3; ++axis) wanted |= 1u << (2 * axis + (octant >> axis & 1u ? 0 : 1));
    Level& side = sides[octant] = of;
    side.first = std::uint32_t(whole.balls.size());
    for (std::uint32_t i = 0; i < of.count; ++i)
      if (seen[i] & wanted) whole.balls.push_back(WholeBall(whole.balls[of.first + i]));
    side.count = std::uint32_t(whole.balls.size()) - side.first;
  }
}

}  // namespace

WholeModel makeWholeModel(const Model& model, const LevelSet& levels) {
  glm::vec3 size = glm::max(model.high - model.low, 1e-3f);
  float longest = std::max({size.x, size.y, size.z}), cell = longest / kFirstCells;
  std::vector<Member> members = membersOf(model, levels, kCellError * cell);
  WholeModel whole;
  std::vector<Cells> cells;
  for (std::size_t before = 0; before != 1; cell *= kCoarserCells) {
    members = inCells(members, model.low, cell);
    if (members.size() == before) continue;
    before = members.size();
    // A cell may reach beyond the model.
    glm::vec3 within = glm::min(glm::vec3(cell), size);
    float edge = std::cbrt(within.x * within.y * within.z);
    whole.levels.push_back({std::uint32_t(whole.balls.size()), std::uint32_t(members.size()), kCellError * cell, 0.0f});
    cells.emplace_back();
    for (const Member& one : members) {
      // As much as balls anywhere in the cell, whatever they are before and behind each other.
      float hidden = 1.0f - std::exp(-one.area / (edge * edge));
      cells.back().places.emplace_back((one.centre - model.low) / cell);
      cells.back().hides.push_back(hidden);
      whole.balls.push_back({one.centre, kFullCell * edge * std::sqrt(hidden), one.type});
      whole.levels.back().largest = std::max(whole.levels.back().largest, whole.balls.back().radius);
    }
    if (members.empty()) break;
  }
  for (const Cells& level : cells) addSides(whole, level);
  return whole;
}

}  // namespace velum::model
