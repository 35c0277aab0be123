#include "model/Silhouette.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace velum::model {

namespace {

constexpr int kMargin = 4;  // pixels

// std::floor and std::ceil are calls of functions where the processor may be one without SSE 4.1, and here they were a
// third of what opening a large model took. Of values that an int can be.
int floorOf(float value) {
  int whole = int(value);
  return whole - (float(whole) > value ? 1 : 0);
}
int ceilOf(float value) {
  int whole = int(value);
  return whole + (float(whole) < value ? 1 : 0);
}

/// The bits of a word of a row from one pixel of the row to another, both included; the word has one of them.
std::uint64_t runIn(int word, int from, int to) {
  int first = std::max(from - word * 64, 0), last = std::min(to - word * 64, 63);
  return (~std::uint64_t(0) >> (63 - last)) & (~std::uint64_t(0) << first);
}

}  // namespace

Silhouette::Silhouette(glm::vec3 side, std::span<const Ball> around, float pixel) : mPixel(pixel) {
  glm::vec3 helper = std::abs(side.z) < 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
  mRight = glm::normalize(glm::cross(helper, side));
  mUp = glm::cross(side, mRight);
  glm::vec2 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
  for (const Ball& ball : around) {
    glm::vec2 at(glm::dot(ball.centre, mRight), glm::dot(ball.centre, mUp));
    low = glm::min(low, at - ball.radius);
    high = glm::max(high, at + ball.radius);
  }
  mLow = low - float(kMargin) * pixel;
  mSize = glm::ivec2((high - low) / pixel) + 2 * kMargin + 1;
  mWords = (mSize.x + 63) / 64;
  mBits.assign(std::size_t(mWords) * std::size_t(mSize.y), 0);
}

Silhouette Silhouette::blank() const {
  Silhouette out = *this;
  std::fill(out.mBits.begin(), out.mBits.end(), 0);
  return out;
}

/// Pixels from one to another, both included.
void Silhouette::addRun(int y, int from, int to) {
  std::uint64_t* row = &mBits[std::size_t(y) * std::size_t(mWords)];
  for (int word = from / 64; word <= to / 64; ++word) row[word] |= runIn(word, from, to);
}

/// True when all pixels of a rectangle are set, its edges included.
bool Silhouette::covers(glm::ivec2 low, glm::ivec2 high) const {
  for (int word = low.x / 64; word <= high.x / 64; ++word) {
    const std::uint64_t run = runIn(word, low.x, high.x);
    for (int y = low.y; y <= high.y; ++y)
      if (run & ~mBits[std::size_t(y) * std::size_t(mWords) + std::size_t(word)]) return false;
  }
  return true;
}

void Silhouette::add(std::span<const Ball> balls) {
  for (const Ball& ball : balls) {
    // In pixels; middles of pixels lie at whole numbers.
    glm::vec2 at = (glm::vec2(glm::dot(ball.centre, mRight), glm::dot(ball.centre, mUp)) - mLow) / mPixel;
    float radius = ball.radius / mPixel;
    int top = std::max(ceilOf(at.y - radius), 0), bottom = std::min(floorOf(at.y + radius), mSize.y - 1);
    int left = std::max(ceilOf(at.x - radius), 0), right = std::min(floorOf(at.x + radius), mSize.x - 1);
    // Most atoms lie behind others: that is seen sooner than their pixels are set.
    if (left <= right && top <= bottom && covers({left, top}, {right, bottom})) continue;
    for (int y = top; y <= bottom; ++y) {
      float dy = float(y) - at.y, half = std::sqrt(std::max(radius * radius - dy * dy, 0.0f));
      int from = std::max(ceilOf(at.x - half), 0), to = std::min(floorOf(at.x + half), mSize.x - 1);
      if (from <= to) addRun(y, from, to);
    }
  }
}

bool Silhouette::holds(const Silhouette& other) const {
  for (std::size_t i = 0; i < mBits.size(); ++i)
    if (other.mBits[i] & ~mBits[i]) return false;
  return true;
}

/// By a pixel to all sides: to four neighbours, or to eight.
void Silhouette::grow(bool diagonally) {
  auto words = std::size_t(mWords);
  std::vector<std::uint64_t> across(mBits.size());
  for (std::size_t i = 0; i < mBits.size(); ++i) {
    std::size_t inRow = i % words;
    std::uint64_t before = inRow > 0 ? mBits[i - 1] >> 63 : 0, after = inRow + 1 < words ? mBits[i + 1] << 63 : 0;
    across[i] = mBits[i] | mBits[i] << 1 | mBits[i] >> 1 | before | after;
  }
  const std::vector<std::uint64_t>& aside = diagonally ? across : mBits;
  std::vector<std::uint64_t> out = across;
  for (std::size_t i = 0; i < mBits.size(); ++i) {
    if (i >= words) out[i] |= aside[i - words];
    if (i + words < mBits.size()) out[i] |= aside[i + words];
  }
  mBits = std::move(out);
}

float distanceBetween(const Silhouette& a, const Silhouette& b) {
  int most = std::max(a.mSize.x, a.mSize.y), worst = 0;
  for (auto [from, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    Silhouette grown = *from;
    int steps = 0;
    // By turns to four and to eight sides: an octagon is a circle within a tenth.
    for (; steps < most && !grown.holds(*to); ++steps) grown.grow(steps % 2 == 1);
    worst = std::max(worst, steps);
  }
  return (float(worst) + 0.5f) * a.mPixel;
}

}  // namespace velum::model
