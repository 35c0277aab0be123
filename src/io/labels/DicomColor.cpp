#include "io/labels/DicomColor.h"

#include <algorithm>
#include <cmath>

#include "core/Color.h"

namespace velum::io {

namespace {

/// White of D50.
constexpr double kWhiteX = 0.9642, kWhiteZ = 0.8249;
/// Bradford-adapted from D50; columns are X, Y, Z.
const glm::dmat3 kLinearFromXyz(3.1338561, -0.9787684, 0.0719453, -1.6168667, 1.9161415, -0.2289914, -0.4906146,
                                0.0334540, 1.4052427);

double unfold(double t) { return t > 6.0 / 29 ? t * t * t : 3 * 36.0 / 841 * (t - 4.0 / 29); }
double fold(double t) { return t > 216.0 / 24389 ? std::cbrt(t) : t * 841.0 / 108 + 4.0 / 29; }

std::uint16_t word(double share) { return std::uint16_t(std::lround(std::clamp(share, 0.0, 1.0) * 65535)); }

}  // namespace

glm::vec3 srgbFromDicomLab(const DicomLab& lab) {
  double l = lab[0] * 100.0 / 65535, a = lab[1] * 255.0 / 65535 - 128, b = lab[2] * 255.0 / 65535 - 128;
  double fy = (l + 16) / 116;
  glm::dvec3 xyz(kWhiteX * unfold(fy + a / 500), unfold(fy), kWhiteZ * unfold(fy - b / 200));
  glm::dvec3 linear = glm::clamp(kLinearFromXyz * xyz, 0.0, 1.0);
  glm::vec3 color;
  for (int i = 0; i < 3; ++i) color[i] = float(srgbFromLinear(linear[i]));
  return color;
}

DicomLab dicomLabFromSrgb(const glm::vec3& srgb) {
  glm::dvec3 linear;
  for (int i = 0; i < 3; ++i) linear[i] = linearFromSrgb(std::clamp(double(srgb[i]), 0.0, 1.0));
  glm::dvec3 xyz = glm::inverse(kLinearFromXyz) * linear;
  double fx = fold(xyz.x / kWhiteX), fy = fold(xyz.y), fz = fold(xyz.z / kWhiteZ);
  return {word((116 * fy - 16) / 100), word((500 * (fx - fy) + 128) / 255), word((200 * (fy - fz) + 128) / 255)};
}

}  // namespace velum::io
