#include "session/lettering/Block.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/Assert.h"

namespace velum::session {

namespace {

constexpr double kGlowBlur = 0.15;  // radius of each of three blurs, ems
constexpr float kGlowGain = 3.2f, kGlowMost = 0.86f;

/// Means of 2 * radius + 1 values along a line of values. @param step  from one value to the next
void blurLine(float* line, int count, std::ptrdiff_t step, int radius, std::vector<float>& sums) {
  sums.assign(std::size_t(count) + 1, 0.0f);
  for (int i = 0; i < count; ++i) sums[std::size_t(i) + 1] = sums[std::size_t(i)] + line[i * step];
  for (int i = 0; i < count; ++i) {
    int from = std::max(0, i - radius), to = std::min(count, i + radius + 1);
    line[i * step] = (sums[std::size_t(to)] - sums[std::size_t(from)]) / float(2 * radius + 1);
  }
}

}  // namespace

std::vector<Mark> Block::onGlow(glm::vec3 ground, double em) const {
  std::vector<float> field(std::size_t(mSize.x) * std::size_t(mSize.y)), sums;
  for (const Mark& mark : mMarks)
    for (std::size_t i = 0; i < mark.covers.size(); ++i) {
      glm::ivec2 at = mark.corner - mCorner + glm::ivec2(int(i) % mark.size.x, int(i) / mark.size.x);
      float& value = field[std::size_t(at.y) * std::size_t(mSize.x) + std::size_t(at.x)];
      value = std::max(value, float(mark.covers[i]) / 255.0f);
    }
  int radius = std::max(1, int(std::lround(kGlowBlur * em)));
  for (int pass = 0; pass < 3; ++pass) {
    for (int y = 0; y < mSize.y; ++y) blurLine(&field[std::size_t(y) * std::size_t(mSize.x)], mSize.x, 1, radius, sums);
    for (int x = 0; x < mSize.x; ++x) blurLine(&field[std::size_t(x)], mSize.y, mSize.x, radius, sums);
  }
  Mark glow{mCorner, mSize, ground, std::vector<std::uint8_t>(field.size())};
  for (std::size_t i = 0; i < field.size(); ++i)
    glow.covers[i] = std::uint8_t(std::lround(255.0f * std::min(kGlowMost, kGlowGain * field[i])));
  std::vector<Mark> all{std::move(glow)};
  all.insert(all.end(), mMarks.begin(), mMarks.end());
  return all;
}

void addRectangle(Mark& mark, glm::dvec2 low, glm::dvec2 high, double radius, double from, double to) {
  glm::dvec2 origin(mark.corner);
  low -= origin, high -= origin, from -= origin.x, to -= origin.x;
  glm::dvec2 middle = 0.5 * (low + high), half = 0.5 * (high - low) - radius;
  glm::ivec2 first = glm::max(glm::ivec2(glm::floor(low)) - 1, glm::ivec2(0)),
             last = glm::min(glm::ivec2(glm::ceil(high)) + 1, mark.size);
  for (int y = first.y; y < last.y; ++y)
    for (int x = first.x; x < last.x; ++x) {
      auto within = [](double a, double b, double at) {
        return std::clamp(std::min(b, at + 1.0) - std::max(a, at), 0.0, 1.0);
      };
      double share = within(from, to, x);
      if (radius > 0.0) {
        glm::dvec2 outside = glm::abs(glm::dvec2(x, y) + 0.5 - middle) - half;
        double distance = glm::length(glm::max(outside, 0.0)) + std::min(std::max(outside.x, outside.y), 0.0) - radius;
        share *= std::clamp(0.5 - distance, 0.0, 1.0);
      } else {
        share *= within(low.x, high.x, x) * within(low.y, high.y, y);
      }
      std::uint8_t& covers = mark.covers[std::size_t(y) * std::size_t(mark.size.x) + std::size_t(x)];
      covers = std::max(covers, std::uint8_t(std::lround(255.0 * share)));
    }
}

void fade(std::vector<Mark>& marks, double opacity) {
  VELUM_ASSERT(marks.size() == 2 && marks[0].size == marks[1].size, "a glow, and one mark on it");
  std::vector<std::uint8_t>&glow = marks[0].covers, &ink = marks[1].covers;
  for (std::size_t i = 0; i < ink.size(); ++i) {
    // The glow must not shine through letters that are faint now: it gives as much to the picture as before, in
    // proportion.
    double t = ink[i] / 255.0, share = opacity * (1.0 - t) / std::max(1.0 - opacity * t, 1e-6);
    glow[i] = std::uint8_t(std::lround(share * glow[i]));
    ink[i] = std::uint8_t(std::lround(opacity * ink[i]));
  }
}

}  // namespace velum::session
