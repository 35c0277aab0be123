#include "PulledCanvas.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace velum::session {

namespace {

constexpr std::uint64_t kEmpty = ~0ull;
constexpr std::uint32_t kGone = 0x90202428;
/// Light on a surface that is seen along its side, and from the front: about what the picture that follows has.
constexpr float kAmbient = 0.3f, kMost = 0.9f;
/// Squares are evened out over so many voxels to each side, and no more pixels.
constexpr double kReachVoxels = 1.5;
constexpr int kMostReach = 8;
/// What lies so many voxels nearer or farther is another surface.
constexpr double kSameVoxels = 2.5;
/// Of a pixel where nothing is: farther off than anything that could be the same surface.
constexpr float kNowhere = std::numeric_limits<float>::max();

std::uint32_t colorWord(glm::vec3 color) {
  glm::vec3 bytes = glm::round(255.0f * glm::clamp(color, 0.0f, 1.0f));
  return 0xff000000u | std::uint32_t(bytes.r) << 16 | std::uint32_t(bytes.g) << 8 | std::uint32_t(bytes.b);
}

/// What is seen, pixel by pixel: planes of numbers, so that a processor takes many pixels at a time.
struct Seen {
  static constexpr int kPlanes = 4;  // distance, red, green, blue
  int wide, high;
  std::vector<float> planes[kPlanes];

  Seen(int w, int h) : wide(w), high(h) {
    for (auto& plane : planes) plane.assign(std::size_t(w) * std::size_t(h), 0.0f);
  }
  std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(wide) + std::size_t(x); }
};

/// Means over the same surface along a line. @param step  from a place to the next one; @param count  of places
void meanAlong(const Seen& from, Seen& to, std::size_t first, std::size_t step, int count, int reach, float same) {
  for (int i = 0; i < count; ++i) {
    std::size_t here = first + std::size_t(i) * step;
    float distance = from.planes[0][here];
    if (distance == kNowhere) {
      to.planes[0][here] = kNowhere;
      continue;
    }
    float sum[Seen::kPlanes] = {}, weight = 0.0f;
    int low = std::max(i - reach, 0), high = std::min(i + reach, count - 1);
    for (int k = low; k <= high; ++k) {
      std::size_t there = first + std::size_t(k) * step;
      if (std::abs(from.planes[0][there] - distance) > same) continue;
      weight += 1.0f;
      for (int plane = 0; plane < Seen::kPlanes; ++plane) sum[plane] += from.planes[plane][there];
    }
    for (int plane = 0; plane < Seen::kPlanes; ++plane) to.planes[plane][here] = sum[plane] / weight;
  }
}

Seen evened(const Seen& seen, int reach, float same) {
  Seen rows(seen.wide, seen.high), all(seen.wide, seen.high);
  for (int y = 0; y < seen.high; ++y) meanAlong(seen, rows, seen.at(0, y), 1, seen.wide, reach, same);
  for (int x = 0; x < seen.wide; ++x)
    meanAlong(rows, all, seen.at(x, 0), std::size_t(seen.wide), seen.high, reach, same);
  return all;
}

/// How distances change from pixel to pixel, along a line, where both sides, or one, are the same surface.
float slope(const Seen& seen, std::size_t here, std::size_t step, int place, int count, int wide, float same) {
  float distance = seen.planes[0][here], sum = 0.0f;
  int sides = 0;
  for (int side : {-1, 1}) {
    int there = place + side * wide;
    if (there < 0 || there >= count) continue;
    float other = seen.planes[0][here + std::size_t(std::ptrdiff_t(step) * side * wide)];
    if (std::abs(other - distance) > same) continue;
    sum += float(side) * (other - distance) / float(wide);
    ++sides;
  }
  return sides > 0 ? sum / float(sides) : 0.0f;
}

}  // namespace

PulledCanvas::PulledCanvas(glm::ivec2 size)
    : mSize(size), mLow(size), mCells(std::size_t(size.x) * std::size_t(size.y), kEmpty) {}

void PulledCanvas::setScale(double voxel, double pixelsPerLength) {
  mVoxel = std::max(mVoxel, voxel);
  mPixelsPerLength = std::max(mPixelsPerLength, pixelsPerLength);
}

void PulledCanvas::put(glm::ivec2 low, glm::ivec2 high, float distance, glm::vec3 color) {
  putWord(low, high, distance, colorWord(color));
}

void PulledCanvas::putGone(glm::ivec2 low, glm::ivec2 high) { putWord(low, high, kNowhere, kGone); }

void PulledCanvas::putWord(glm::ivec2 low, glm::ivec2 high, float distance, std::uint32_t color) {
  mLow = glm::min(mLow, low), mEnd = glm::max(mEnd, high + 1);
  std::uint64_t cell = std::uint64_t(std::bit_cast<std::uint32_t>(distance)) << 32 | color;
  for (int y = low.y; y <= high.y; ++y) {
    std::uint64_t* row = mCells.data() + std::size_t(y) * std::size_t(mSize.x);
    for (int x = low.x; x <= high.x; ++x) row[x] = std::min(row[x], cell);
  }
}

std::vector<std::uint32_t> PulledCanvas::pixels() const {
  std::vector<std::uint32_t> pixels(mCells.size(), 0u);
  if (mEnd.x <= mLow.x || mEnd.y <= mLow.y) return pixels;
  Seen seen(mEnd.x - mLow.x, mEnd.y - mLow.y);
  auto cellAt = [&](int x, int y) { return std::size_t(y + mLow.y) * std::size_t(mSize.x) + std::size_t(x + mLow.x); };
  for (int y = 0; y < seen.high; ++y)
    for (int x = 0; x < seen.wide; ++x) {
      std::uint64_t cell = mCells[cellAt(x, y)];
      float distance = cell == kEmpty ? kNowhere : std::bit_cast<float>(std::uint32_t(cell >> 32));
      seen.planes[0][seen.at(x, y)] = distance;
      if (distance == kNowhere) continue;
      for (int plane = 1; plane < Seen::kPlanes; ++plane)
        seen.planes[plane][seen.at(x, y)] = float(cell >> (24 - 8 * plane) & 255) / 255.0f;
    }
  int reach = std::clamp(int(std::ceil(kReachVoxels * mVoxel * mPixelsPerLength)), 1, kMostReach);
  auto same = float(std::max(kSameVoxels * mVoxel, reach / std::max(mPixelsPerLength, 1e-12)));
  Seen even = evened(seen, reach, same);
  int wide = std::max(1, reach / 2);
  for (int y = 0; y < seen.high; ++y)
    for (int x = 0; x < seen.wide; ++x) {
      std::size_t here = seen.at(x, y);
      std::uint64_t cell = mCells[cellAt(x, y)];
      if (cell == kEmpty) continue;
      std::uint32_t& pixel = pixels[cellAt(x, y)] = std::uint32_t(cell);
      if (even.planes[0][here] == kNowhere) continue;
      glm::vec2 rise(slope(even, here, 1, x, seen.wide, wide, same),
                     slope(even, here, std::size_t(seen.wide), y, seen.high, wide, same));
      float light = 1.0f / std::sqrt(1.0f + glm::dot(rise, rise) * float(mPixelsPerLength * mPixelsPerLength));
      glm::vec3 color(even.planes[1][here], even.planes[2][here], even.planes[3][here]);
      pixel = colorWord(color * (kAmbient + (kMost - kAmbient) * light));
    }
  return pixels;
}

}  // namespace velum::session
