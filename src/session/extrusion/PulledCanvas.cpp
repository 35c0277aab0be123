#include "session/extrusion/PulledCanvas.h"

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
constexpr int kMostReach = 8, kMostStep = 4;
/// What lies so many voxels nearer or farther is another surface.
constexpr double kSameVoxels = 2.5;
/// Of a pixel where nothing is: farther off than anything that could be the same surface.
constexpr float kNowhere = std::numeric_limits<float>::max();

std::uint32_t wordOf(glm::vec3 bytes) {
  glm::uvec3 whole(bytes + 0.5f);
  return 0xff000000u | whole.r << 16 | whole.g << 8 | whole.b;
}

float distanceOf(std::uint64_t cell) { return std::bit_cast<float>(std::uint32_t(cell >> 32)); }

}  // namespace

/// Lines of pixels, one after the other.
struct PulledCanvas::Lines {
  int count, length;
  std::vector<Seen> pixels;

  Lines(int n, int l) : count(n), length(l), pixels(std::size_t(n) * std::size_t(l), Seen(kNowhere, 0, 0, 0)) {}
  std::size_t indexOf(int line, int place) const {
    return std::size_t(line) * std::size_t(length) + std::size_t(place);
  }
  Seen& at(int line, int place) { return pixels[indexOf(line, place)]; }
  const Seen& at(int line, int place) const { return pixels[indexOf(line, place)]; }
};

namespace {

using Lines = PulledCanvas::Lines;
using Seen = PulledCanvas::Seen;

/// The lines across, whose pixels are means along the lines over what is one surface. By sums from its first pixel on:
/// as fast for any reach.
Lines evenedAcross(const Lines& from, int reach, float same) {
  Lines across(from.length, from.count);
  std::vector<Seen> sums(std::size_t(from.length) + 1);
  for (int line = 0; line < from.count; ++line)
    for (int first = 0, end = 0; first < from.length; first = end) {
      Seen base(from.at(line, first).x, 0, 0, 0);
      end = first + 1;
      if (base.x == kNowhere) continue;
      sums[0] = Seen(0.0f), sums[1] = from.at(line, first) - base;
      for (; end < from.length && std::abs(from.at(line, end).x - from.at(line, end - 1).x) <= same; ++end)
        sums[std::size_t(end - first) + 1] = sums[std::size_t(end - first)] + from.at(line, end) - base;
      for (int place = first; place < end; ++place) {
        int low = std::max(place - reach, first), high = std::min(place + reach + 1, end);
        across.at(place, line) =
            base + (sums[std::size_t(high - first)] - sums[std::size_t(low - first)]) / float(high - low);
      }
    }
  return across;
}

/// How much farther what is seen gets from pixel to pixel, by the pixels so far off on both sides, or on the one that
/// is the same surface.
float riseAt(const Lines& seen, glm::ivec2 pixel, glm::ivec2 way, float same) {
  float here = seen.at(pixel.y, pixel.x).x, sum = 0.0f;
  int sides = 0, wide = way.x + way.y;
  for (int side : {-1, 1}) {
    glm::ivec2 at = pixel + side * way;
    if (at.x < 0 || at.y < 0 || at.x >= seen.length || at.y >= seen.count) continue;
    float there = seen.at(at.y, at.x).x;
    if (std::abs(there - here) > same) continue;
    sum += float(side) * (there - here);
    ++sides;
  }
  return sides > 0 ? sum / float(sides * wide) : 0.0f;
}

/// Each pixel in the light that falls on its surface. @param wide  pixels, for its slope
Lines litColors(const Lines& seen, int wide, float same, float perLength) {
  Lines lit = seen;
  for (int y = 0; y < seen.count; ++y)
    for (int x = 0; x < seen.length; ++x) {
      Seen& pixel = lit.at(y, x);
      if (pixel.x == kNowhere) continue;
      glm::vec2 rise(riseAt(seen, {x, y}, {wide, 0}, same), riseAt(seen, {x, y}, {0, wide}, same));
      float light = 1.0f / std::sqrt(1.0f + glm::dot(rise, rise) * perLength * perLength);
      float share = kAmbient + (kMost - kAmbient) * light;
      pixel = Seen(pixel.x, share * pixel.y, share * pixel.z, share * pixel.w);
    }
  return lit;
}

/// The colour of a surface at a distance, there or beside; where nothing beside knows it, its own, lit from the front.
std::uint32_t wordNear(const Lines& lit, glm::ivec2 at, float distance, float same, std::uint32_t own) {
  for (glm::ivec2 off : {glm::ivec2(0), glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
    glm::ivec2 to = glm::clamp(at + off, glm::ivec2(0), glm::ivec2(lit.length, lit.count) - 1);
    const Seen& seen = lit.at(to.y, to.x);
    if (std::abs(seen.x - distance) <= same) return wordOf({seen.y, seen.z, seen.w});
  }
  return wordOf(kMost * glm::vec3(own >> 16 & 255, own >> 8 & 255, own & 255));
}

}  // namespace

PulledCanvas::PulledCanvas(glm::ivec2 size)
    : mSize(size), mLow(size), mCells(std::size_t(size.x) * std::size_t(size.y), kEmpty) {}

void PulledCanvas::setScale(double voxel, double pixelsPerLength) {
  mVoxel = std::max(mVoxel, voxel);
  mPixelsPerLength = std::max(mPixelsPerLength, pixelsPerLength);
}

void PulledCanvas::put(glm::ivec2 low, glm::ivec2 high, float distance, glm::vec3 color) {
  putWord(low, high, distance, wordOf(255.0f * glm::clamp(color, 0.0f, 1.0f)));
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

/// What is seen of every so manyth pixel of the box, as rows.
Lines PulledCanvas::thinned(int step) const {
  glm::ivec2 size = (mEnd - mLow + step - 1) / step;
  Lines rows(size.y, size.x);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      glm::ivec2 at = glm::min(mLow + step * glm::ivec2(x, y) + step / 2, mEnd - 1);
      std::uint64_t cell = mCells[indexOf(at)];
      if (cell != kEmpty) rows.at(y, x) = Seen(distanceOf(cell), cell >> 16 & 255, cell >> 8 & 255, cell & 255);
    }
  return rows;
}

std::vector<std::uint32_t> PulledCanvas::pixels() const {
  std::vector<std::uint32_t> pixels(mCells.size(), 0u);
  if (mEnd.x <= mLow.x || mEnd.y <= mLow.y) return pixels;
  // A pixel of each square says all of it, so that the cost goes with the voxels that are seen.
  double voxelPixels = mVoxel * mPixelsPerLength;
  int step = std::clamp(int(voxelPixels), 1, kMostStep);
  int reach = std::clamp(int(std::ceil(kReachVoxels * voxelPixels / step)), 1, kMostReach);
  auto perLength = float(mPixelsPerLength / step);
  auto same = float(std::max(kSameVoxels * mVoxel, double(reach) / std::max(double(perLength), 1e-12)));
  Lines lit = litColors(evenedAcross(evenedAcross(thinned(step), reach, same), reach, same), std::max(1, reach / 2),
                        same, perLength);
  for (glm::ivec2 at = mLow; at.y < mEnd.y; ++at.y)
    for (at.x = mLow.x; at.x < mEnd.x; ++at.x) {
      std::uint64_t cell = mCells[indexOf(at)];
      if (cell == kEmpty) continue;
      float distance = distanceOf(cell);
      glm::ivec2 in = (at - mLow) / step;
      pixels[indexOf(at)] = distance == kNowhere ? kGone : wordNear(lit, in, distance, same, std::uint32_t(cell));
    }
  return pixels;
}

}  // namespace velum::session
