#include "scene/PaperPicture.h"

#include <algorithm>
#include <cmath>

#include "core/Error.h"

namespace velum::scene {

namespace {

// A seam is where the picture changes by so much more than from pixel to pixel in the mean: at its own size, and so
// much smaller, at which grain has gone and what light has left on one side is seen. Waves change half as fast again
// where they are steepest.
constexpr double kSeam = 2.0;
constexpr int kSmall = 24;
constexpr double kGrey = 0.5 / 255.0;  // less is nothing

glm::vec3 colorAt(const Image& picture, glm::ivec2 p) {
  std::size_t channels = picture.channels.size();
  const float* c = &picture.pixels[(std::size_t(p.y) * std::size_t(picture.width) + std::size_t(p.x)) * channels];
  return channels < 3 ? glm::vec3(c[0]) : glm::vec3(c[0], c[1], c[2]);
}

/// Each pixel is the mean of those that it stands for, at least the nearest.
Image resized(const Image& picture, glm::ivec2 size) {
  Image out{size.x, size.y, {"R", "G", "B"}, {}};
  out.pixels.reserve(std::size_t(size.x) * std::size_t(size.y) * 3);
  glm::ivec2 whole(picture.width, picture.height);
  for (glm::ivec2 p(0); p.y < size.y; ++p.y)
    for (p.x = 0; p.x < size.x; ++p.x) {
      glm::ivec2 from(std::int64_t(p.x) * whole.x / size.x, std::int64_t(p.y) * whole.y / size.y);
      glm::ivec2 to((p.x + std::int64_t(1)) * whole.x / size.x, (p.y + std::int64_t(1)) * whole.y / size.y);
      to = glm::max(to, from + 1);
      glm::vec3 sum(0.0f);
      for (int y = from.y; y < to.y; ++y)
        for (int x = from.x; x < to.x; ++x) sum += colorAt(picture, {x, y});
      glm::vec3 mean = glm::clamp(sum / float((to.x - from.x) * (to.y - from.y)), 0.0f, 1.0f);
      out.pixels.insert(out.pixels.end(), {mean.r, mean.g, mean.b});
    }
  return out;
}

/// How much a line of pixels differs from another one, in the mean. @param axis  0: columns, 1: rows
double differenceOf(const Image& picture, int axis, int a, int b) {
  int length = axis == 0 ? picture.height : picture.width;
  double sum = 0.0;
  for (int i = 0; i < length; ++i) {
    glm::ivec2 p(i), q(i);
    p[axis] = a, q[axis] = b;
    glm::vec3 difference = glm::abs(colorAt(picture, p) - colorAt(picture, q));
    sum += double(difference.r + difference.g + difference.b) / 3.0;
  }
  return sum / length;
}

bool hasSeam(const Image& picture, int axis) {
  int lines = axis == 0 ? picture.width : picture.height;
  if (lines < 2) return false;
  double inside = 0.0;
  for (int i = 1; i < lines; ++i) inside += differenceOf(picture, axis, i - 1, i) / (lines - 1);
  return differenceOf(picture, axis, lines - 1, 0) > std::max(kSeam * inside, kGrey);
}

}  // namespace

Image fitPaper(const Image& picture) {
  glm::ivec2 size(picture.width, picture.height);
  if (size.x < 1 || size.y < 1 || picture.channels.empty()) throw ArgumentError("a picture of paper is empty");
  double scale = std::min(1.0, double(kPaperSize) / std::max(size.x, size.y));
  return resized(picture, glm::max(glm::ivec2(glm::round(glm::dvec2(size) * scale)), glm::ivec2(1)));
}

glm::bvec2 tilesOf(const Image& paper) {
  Image small = resized(paper, glm::min(glm::ivec2(paper.width, paper.height), glm::ivec2(kSmall)));
  auto fits = [&](int axis) { return !hasSeam(paper, axis) && !hasSeam(small, axis); };
  return {fits(0), fits(1)};
}

}  // namespace velum::scene
