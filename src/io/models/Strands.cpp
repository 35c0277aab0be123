#include "io/models/Strands.h"

#include <algorithm>
#include <cmath>

namespace velum::io {

namespace {

/// Pieces of a span between two points: their chords are shorter than the curve by less than a thousandth.
constexpr int kPieces = 16;

/// The uniform spline of Catmull and Rom, from b to c.
glm::vec3 between(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, float t) {
  return 0.5f * (2.0f * b + (c - a) * t + (2.0f * a - 5.0f * b + 4.0f * c - d) * (t * t) +
                 (3.0f * b - a - 3.0f * c + d) * (t * t * t));
}

glm::vec3 acrossTo(glm::vec3 z) {
  glm::vec3 axis = std::abs(z.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return glm::normalize(axis - z * glm::dot(axis, z));
}

/// Walks chords, with a frame that turns no more than they do.
class Walker {
 public:
  Walker(const StrandUnit& unit, const std::function<void(const Pose&)>& body) : mUnit(unit), mBody(body) {}

  void walk(glm::vec3 from, glm::vec3 to) {
    float length = glm::length(to - from);
    if (!(length > 0.0f)) return;
    glm::vec3 z = (to - from) / length;
    glm::vec3 x = mX - z * glm::dot(mX, z);
    mX = glm::length(x) > 1e-3f ? glm::normalize(x) : acrossTo(z);
    double at = mNext;
    for (; at < double(length); at += double(mUnit.step)) emit(from + z * float(at), z);
    mNext = at - double(length);
  }

 private:
  void emit(glm::vec3 place, glm::vec3 z) {
    glm::vec3 y = glm::cross(z, mX);
    glm::vec3 x = mX * std::cos(mTwist) + y * std::sin(mTwist);
    mBody({glm::quat_cast(glm::mat3(x, glm::cross(z, x), z)), place});
    mTwist = std::fmod(mTwist + mUnit.twistRad, 6.2831853f);
  }

  StrandUnit mUnit;
  const std::function<void(const Pose&)>& mBody;
  glm::vec3 mX{0.0f};
  double mNext = 0.0;
  float mTwist = 0.0f;
};

}  // namespace

void walkAlong(std::span<const glm::vec3> points, const StrandUnit& unit,
               const std::function<void(const Pose&)>& body) {
  Walker walker(unit, body);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    glm::vec3 b = points[i], c = points[i + 1];
    glm::vec3 a = i > 0 ? points[i - 1] : 2.0f * b - c, d = i + 2 < points.size() ? points[i + 2] : 2.0f * c - b;
    glm::vec3 from = b;
    for (int piece = 1; piece <= kPieces; ++piece) {
      glm::vec3 to = piece == kPieces ? c : between(a, b, c, d, float(piece) / float(kPieces));
      walker.walk(from, to);
      from = to;
    }
  }
}

}  // namespace velum::io
