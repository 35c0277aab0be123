#include "membrane/sheet/Fairing.h"

#include <algorithm>
#include <cmath>

#include "core/Assert.h"
#include "core/Parallel.h"
#include "membrane/sheet/Simulation.h"
#include "scene/Scene.h"

namespace velum::membrane {

namespace {

/// Sweeps a level: what is left after so many is far below a voxel, as each level begins where the coarser one ended.
constexpr int kSweeps = 40;
/// So often slopes become areas anew.
constexpr int kWeighEvery = 8;
/// Over-relaxation; with obstacles more of it overshoots.
constexpr float kOver = 1.7f;
/// The last sweeps of a level go just as far as they should.
constexpr int kPlainSweeps = 8;
/// Stakes are passed in so many of the last sweeps, and as often again after them; by so much, in steps of the lattice.
constexpr int kStakeSweeps = 20, kStakePasses = 20;
constexpr double kClear = 0.75;
/// Levels have half as many rows and columns each, down to so many.
constexpr int kCoarsest = 48;

/// Every stride-th of ascending places, and the last.
std::vector<float> thinned(const std::vector<float>& places, int stride) {
  std::vector<float> some;
  for (std::size_t i = 0; i + 1 < places.size(); i += std::size_t(stride)) some.push_back(places[i]);
  some.push_back(places.back());
  return some;
}

}  // namespace

Fairing::Fairing(Input input) : mInput(std::move(input)) {
  VELUM_ASSERT(mInput.xs.size() > 2 && mInput.ys.size() > 2, "a sheet has particles inside its border");
  int stride = 1;
  while (int(std::max(mInput.xs.size(), mInput.ys.size())) / stride > kCoarsest) stride *= 2;
  begin(stride);
}

/// A level of every stride-th row and column, at the heights of the one before.
void Fairing::begin(int stride) {
  HeightOver before = mLevel.xs.empty() ? mInput.start : heightOf(shape());
  mStride = stride;
  mSweep = 0;
  Level level;
  level.xs = thinned(mInput.xs, stride);
  level.ys = thinned(mInput.ys, stride);
  glm::ivec2 n = level.dims();
  std::vector<glm::vec3> places;
  for (float y : level.ys)
    for (float x : level.xs) places.emplace_back(x, y, before ? float(before({x, y})) : 0.0f);
  glm::dvec2 pitch(mInput.xs.back() - mInput.xs.front(), mInput.ys.back() - mInput.ys.front());
  level.room = roomOf(mInput.corridor, places, pitch / glm::dvec2(n - 1));
  auto reach = float(mInput.reach);
  if (level.room.empty()) level.room.assign(places.size(), {-reach, reach});
  level.rest.assign(places.size(), 0.0f);
  if (mInput.rest)
    for (std::size_t i = 0; i < places.size(); ++i) level.rest[i] = float(mInput.rest(glm::dvec2(places[i])));
  for (auto& room : level.room) room = glm::clamp(room, -reach, reach);
  if (mInput.holds)
    for (const auto& held : mInput.holds(n, places)) level.room[std::size_t(held.particle)] = glm::vec2(held.place.z);
  for (int y = 0; y < n.y; ++y)
    for (int x = 0; x < n.x; ++x) {
      std::size_t i = level.at(x, y);
      bool isBorder = x == 0 || y == 0 || x + 1 == n.x || y + 1 == n.y;
      level.height.push_back(isBorder ? 0.0f : std::clamp(places[i].z, level.room[i].x, level.room[i].y));
    }
  level.weight.assign(places.size(), 1.0f);
  mLevel = std::move(level);
  mTies.clear();
  if (stride == 1) tie();
}

/// Ties the stakes to the particles of the triangles that they lie in (as makeSheetIndex() splits cells).
void Fairing::tie() {
  const auto &xs = mLevel.xs, &ys = mLevel.ys;
  mTies.resize(ys.size() - 1);
  auto cellOf = [](const std::vector<float>& places, float at) {
    auto above = std::upper_bound(places.begin() + 1, places.end() - 1, at);
    return std::size_t(above - places.begin()) - 1;
  };
  glm::dvec2 step = mInput.corridor.step;
  auto clear = float(kClear * std::min(step.x, step.y));
  for (const Stake& stake : mInput.corridor.stakes) {
    if (stake.place.x < xs.front() || stake.place.x > xs.back() || stake.place.y < ys.front() ||
        stake.place.y > ys.back())
      continue;
    std::size_t x = cellOf(xs, stake.place.x), y = cellOf(ys, stake.place.y);
    float u = (stake.place.x - xs[x]) / (xs[x + 1] - xs[x]), v = (stake.place.y - ys[y]) / (ys[y + 1] - ys[y]);
    auto at = [&](int dx, int dy) { return std::uint32_t(mLevel.at(int(x) + dx, int(y) + dy)); };
    float height = stake.place.z + (stake.isBelow ? clear : -clear);
    Tie tie{{at(0, 0), u >= v ? at(1, 0) : at(0, 1), at(1, 1)},
            {1.0f - std::max(u, v), std::abs(u - v), std::min(u, v)},
            height,
            stake.isBelow};
    mTies[y].push_back(tie);
  }
}

/// Moves the particles around each stake that the sheet is on the wrong side of, by as little as it takes.
void Fairing::passStakes() {
  glm::ivec2 n = mLevel.dims();
  auto isFixed = [&](std::uint32_t particle) {
    int x = int(particle) % n.x, y = int(particle) / n.x;
    return x == 0 || y == 0 || x + 1 == n.x || y + 1 == n.y;
  };
  // Rows of cells share a row of particles with the next one.
  for (int odd = 0; odd < 2; ++odd)
    parallelFor(0, (int(mTies.size()) + 1 - odd) / 2, [&](int half) {
      for (const Tie& tie : mTies[std::size_t(2 * half + odd)]) {
        float height = 0.0f, squares = 0.0f;
        for (int k = 0; k < 3; ++k) {
          height += tie.share[k] * mLevel.height[tie.particle[k]];
          if (!isFixed(tie.particle[k])) squares += tie.share[k] * tie.share[k];
        }
        float missing = tie.height - height;
        if (tie.isBelow ? missing <= 0.0f : missing >= 0.0f) continue;
        if (squares < 0.01f) continue;
        for (int k = 0; k < 3; ++k)
          if (!isFixed(tie.particle[k])) mLevel.height[tie.particle[k]] += missing * tie.share[k] / squares;
      }
    });
}

/// One over the area that a unit of the rest plane has under the sheet, at each particle.
void Fairing::weigh() {
  glm::ivec2 n = mLevel.dims();
  parallelFor(1, n.y - 1, [&](int y) {
    for (int x = 1; x + 1 < n.x; ++x) {
      auto slope = [&](float a, float b, float from, float to) { return (b - a) / (to - from); };
      float u = slope(mLevel.height[mLevel.at(x - 1, y)], mLevel.height[mLevel.at(x + 1, y)],
                      mLevel.xs[std::size_t(x) - 1], mLevel.xs[std::size_t(x) + 1]);
      float v = slope(mLevel.height[mLevel.at(x, y - 1)], mLevel.height[mLevel.at(x, y + 1)],
                      mLevel.ys[std::size_t(y) - 1], mLevel.ys[std::size_t(y) + 1]);
      mLevel.weight[mLevel.at(x, y)] = 1.0f / std::sqrt(1.0f + u * u + v * v);
    }
  });
}

void Fairing::relax(int colour, float over) {
  glm::ivec2 n = mLevel.dims();
  auto pull = mInput.pullLength > 0 ? float(1.0 / (mInput.pullLength * mInput.pullLength)) : 0.0f;
  const auto &xs = mLevel.xs, &ys = mLevel.ys;
  parallelFor(1, n.y - 1, [&](int y) {
    float down = ys[std::size_t(y)] - ys[std::size_t(y) - 1], up = ys[std::size_t(y) + 1] - ys[std::size_t(y)];
    float tall = 0.5f * (down + up);
    auto row = std::size_t(n.x);
    for (int x = 1 + ((y + colour) & 1); x + 1 < n.x; x += 2) {
      std::size_t i = mLevel.at(x, y);
      float left = xs[std::size_t(x)] - xs[std::size_t(x) - 1], right = xs[std::size_t(x) + 1] - xs[std::size_t(x)];
      float wide = 0.5f * (left + right);
      const float *w = mLevel.weight.data() + i, *h = mLevel.height.data() + i;
      float a = 0.5f * (w[0] + w[-1]) * tall / left, b = 0.5f * (w[0] + w[1]) * tall / right;
      float c = 0.5f * (w[0] + *(w - row)) * wide / down, d = 0.5f * (w[0] + w[row]) * wide / up;
      float back = pull * wide * tall;
      float wanted =
          (a * h[-1] + b * h[1] + c * *(h - row) + d * h[row] + back * mLevel.rest[i]) / (a + b + c + d + back);
      float moved = h[0] + over * (wanted - h[0]);
      mLevel.height[i] = std::clamp(moved, mLevel.room[i].x, mLevel.room[i].y);
    }
  });
}

bool Fairing::sweep() {
  if (mSweep == kSweeps && mStride == 1) return false;
  if (mSweep == kSweeps) begin(mStride / 2);
  if (mSweep++ % kWeighEvery == 0) weigh();
  float over = mSweep > kSweeps - kPlainSweeps ? 1.0f : kOver;
  relax(0, over);
  relax(1, over);
  if (!mTies.empty() && mSweep > kSweeps - kStakeSweeps) passStakes();
  if (!mTies.empty() && mSweep == kSweeps)
    for (int i = 0; i < kStakePasses; ++i) passStakes();
  return true;
}

scene::SheetShape Fairing::shape() const {
  scene::SheetShape shape;
  shape.particles = mLevel.dims();
  for (std::size_t y = 0; y < mLevel.ys.size(); ++y)
    for (std::size_t x = 0; x < mLevel.xs.size(); ++x)
      shape.places.emplace_back(mLevel.xs[x], mLevel.ys[y], mLevel.height[y * mLevel.xs.size() + x]);
  return shape;
}

}  // namespace velum::membrane
