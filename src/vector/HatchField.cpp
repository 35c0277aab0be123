#include "vector/HatchField.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/Parallel.h"

namespace velum::vector {

namespace {

// As in shaders/shared/finish.h, and render::kStrokeSteps.
constexpr double kCellPeriods = 1.6;
constexpr int kAlignSteps = 12;
constexpr double kTurn = 6.283185307179586;

glm::dvec2 crossed(glm::dvec2 across) { return {across.y, -across.x}; }

struct Tensor {
  glm::dvec3 turns{0.0};  // xx, xy, yy
  double weight = 0.0;
};

/// shaders/render/stroke_turns.comp
Tensor turnsAt(const SurfaceMap& map, const std::vector<SeenPixel>& seen, glm::dvec2 middle, double cellPixels) {
  auto at = [&](glm::dvec2 place) -> const SeenPixel& {
    glm::ivec2 p = glm::clamp(glm::ivec2(place), glm::ivec2(0), map.size - 1);
    return seen[std::size_t(p.y) * std::size_t(map.size.x) + std::size_t(p.x)];
  };
  Tensor sum;
  double half = 0.5 * cellPixels;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      glm::dvec2 place = middle + (glm::dvec2(i, j) - 2.0) * half;
      const SeenPixel &a = at(place), &b = at(place + glm::dvec2(half, 0.0)), &c = at(place + glm::dvec2(0.0, half));
      glm::dvec2 x(b.normal - a.normal), y(c.normal - a.normal);
      bool bends = a.id > 0 && a.id == b.id && a.id == c.id && glm::dot(x, x) < 0.8 && glm::dot(y, y) < 0.8;
      if (!bends) continue;
      sum.turns += glm::dvec3(glm::dot(x, x), glm::dot(x, y), glm::dot(y, y));
      sum.weight += 1.0;
    }
  sum.turns /= std::max(sum.weight, 1.0);
  double share = sum.weight > 0.0 ? 1.0 / (sum.turns.x + sum.turns.z + 0.004) : 0.0;
  sum.weight = std::min(sum.weight, 4.0);
  sum.turns *= share * sum.weight;
  return sum;
}

std::uint32_t hashOf(glm::ivec2 p) {
  std::uint32_t h = (std::uint32_t(p.x) * 0x8da6b343u) ^ (std::uint32_t(p.y) * 0xd8163841u);
  h = (h ^ h >> 15) * 0x2c1b3c6du;
  h = (h ^ h >> 12) * 0x297a2d39u;
  return h ^ h >> 15;
}
double randomOf(glm::ivec2 p) { return double(hashOf(p) >> 8) / 16777216.0; }
double noiseAt(glm::dvec2 p) {
  glm::dvec2 whole = glm::floor(p), part = p - whole;
  part = part * part * (3.0 - 2.0 * part);
  glm::ivec2 at(whole);
  double low = glm::mix(randomOf(at), randomOf(at + glm::ivec2(1, 0)), part.x);
  double high = glm::mix(randomOf(at + glm::ivec2(0, 1)), randomOf(at + glm::ivec2(1, 1)), part.x);
  return glm::mix(low, high, part.y);
}

}  // namespace

HatchField::HatchField(const SurfaceMap& map, const std::vector<SeenPixel>& seen, double spacing)
    : mWave(kTurn / spacing), mCellPixels(kCellPeriods * spacing) {
  mCount = glm::ivec2(glm::floor(glm::dvec2(map.size) / mCellPixels)) + 1;
  auto count = std::size_t(mCount.x) * std::size_t(mCount.y);
  std::vector<Tensor> tensors(count);
  auto indexOf = [&](glm::ivec2 cell) {
    cell = glm::clamp(cell, glm::ivec2(0), mCount - 1);
    return std::size_t(cell.y) * std::size_t(mCount.x) + std::size_t(cell.x);
  };
  parallelFor(0, mCount.y, [&](int y) {
    for (int x = 0; x < mCount.x; ++x) tensors[indexOf({x, y})] = turnsAt(map, seen, middleOf({x, y}), mCellPixels);
  });
  mCells.resize(count);
  parallelFor(0, mCount.y, [&](int y) {
    for (int x = 0; x < mCount.x; ++x) {
      constexpr int kReach = 3;
      Tensor sum;
      for (int j = -kReach; j <= kReach; ++j)
        for (int i = -kReach; i <= kReach; ++i) {
          const Tensor& tensor = tensors[indexOf({x + i, y + j})];
          double near = std::exp(-0.25 * (i * i + j * j));
          sum.turns += near * tensor.turns;
          sum.weight += near * tensor.weight;
        }
      glm::dvec3 turns = sum.turns / std::max(sum.weight, 1e-6) + 0.03 * glm::dvec3(1, -1, 1);
      double along = 0.5 * std::atan2(2.0 * turns.y, turns.x - turns.z);
      glm::dvec2 across(-std::sin(along), std::cos(along)), middle = middleOf({x, y});
      mCells[indexOf({x, y})] = {across,
                                 mWave * glm::dvec2(glm::dot(middle, across), glm::dot(middle, crossed(across)))};
    }
  });
  for (int step = 0; step < kAlignSteps; ++step) align();
}

const HatchField::Cell& HatchField::cellAt(glm::ivec2 cell) const {
  cell = glm::clamp(cell, glm::ivec2(0), mCount - 1);
  return mCells[std::size_t(cell.y) * std::size_t(mCount.x) + std::size_t(cell.x)];
}

void HatchField::align() {
  std::vector<Cell> next(mCells.size());
  parallelFor(0, mCount.y, [&](int y) {
    for (int x = 0; x < mCount.x; ++x) {
      const Cell& own = cellAt({x, y});
      glm::dvec4 sum(0.0);
      for (int i = 0; i < 9; ++i) {
        glm::ivec2 to(i % 3 - 1, i / 3 - 1), at = glm::clamp(glm::ivec2(x, y) + to, glm::ivec2(0), mCount - 1);
        const Cell& other = cellAt(at);
        double cosine = glm::dot(own.across, other.across), side = cosine < 0.0 ? -1.0 : 1.0;
        glm::dvec2 way = glm::dvec2(glm::ivec2(x, y) - at) * mCellPixels,
                   across = 0.5 * (own.across + side * other.across);
        glm::dvec2 phase =
            side * other.phase + mWave * glm::dvec2(glm::dot(way, across), glm::dot(way, crossed(across)));
        double weight = std::exp(-0.5 * double(to.x * to.x + to.y * to.y)) * std::abs(cosine);
        sum += weight * glm::dvec4(std::cos(phase.x), std::sin(phase.x), std::cos(phase.y), std::sin(phase.y));
      }
      next[std::size_t(y) * std::size_t(mCount.x) + std::size_t(x)] = {
          own.across, {std::atan2(sum.y, sum.x + 1e-9), std::atan2(sum.w, sum.z + 1e-9)}};
    }
  });
  mCells = std::move(next);
}

HatchField::Phases HatchField::at(glm::dvec2 place) const {
  glm::dvec2 inCells = place / mCellPixels - 0.5, whole = glm::floor(inCells), part = inCells - whole;
  glm::ivec2 cell(whole);
  glm::dvec2 own = cellAt(cell).across;
  glm::dvec4 sum(0.0);
  for (int i = 0; i < 4; ++i) {
    glm::ivec2 to(i & 1, i >> 1), next = glm::clamp(cell + to, glm::ivec2(0), mCount - 1);
    const Cell& other = cellAt(next);
    double side = glm::dot(other.across, own) < 0.0 ? -1.0 : 1.0;
    glm::dvec2 way = place - middleOf(next), across = side * other.across;
    glm::dvec2 near = glm::mix(1.0 - part, part, glm::dvec2(to));
    glm::dvec2 phase = side * other.phase + mWave * glm::dvec2(glm::dot(way, across), glm::dot(way, crossed(across)));
    sum += near.x * near.y * glm::dvec4(std::cos(phase.x), std::sin(phase.x), std::cos(phase.y), std::sin(phase.y));
  }
  return {own, {std::atan2(sum.y, sum.x), std::atan2(sum.w, sum.z)}};
}

glm::dvec2 strokeWidths(glm::dvec2 place, double darkness, double unitsPerPixel) {
  constexpr double kLeastDark = 0.08;
  if (darkness <= kLeastDark) return glm::dvec2(0.0);
  double hand = 0.14 * (noiseAt(place * unitsPerPixel * 0.11) - 0.5);
  return {std::clamp((darkness - 0.16) * 1.05 + hand, 0.0, 0.72), std::clamp((darkness - 0.60) * 1.5 + hand, 0.0, 0.6)};
}

}  // namespace velum::vector
