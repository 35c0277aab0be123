#include "growth/GrowDomain.h"

#include <algorithm>
#include <cmath>

#include "core/Error.h"

namespace velum::growth {

namespace {

bool isFinite(glm::dvec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// The first of 0..width, in which `holds` goes from false to true once, for which it does; width where it never does.
/// @param guess  near to it; NaN and infinities are allowed
template <class Holds>
int firstWhere(double guess, int width, const Holds& holds) {
  int x = guess > 0.0 ? int(std::min(guess, double(width))) : 0;
  while (x > 0 && holds(x - 1)) --x;
  while (x < width && !holds(x)) ++x;
  return x;
}

}  // namespace

GrowDomain::GrowDomain(const Volume& volume, glm::dvec3 centre, glm::dvec3 axis, double distance) {
  if (!isFinite(centre) || !isFinite(axis))
    throw ArgumentError("the plane to grow from has a number that is not finite");
  if (std::isnan(distance)) throw ArgumentError("the distance to grow is not a number");
  double largest = std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)});
  if (largest == 0.0) return;
  mIsEverywhere = false;
  mTo = distance;
  glm::dvec3 normal = glm::normalize(axis / largest);
  const glm::dmat4& m = volume.worldFromVoxel;
  mAtOrigin = glm::dot(glm::dvec3(m[3]) - centre, normal);
  for (int i = 0; i < 3; ++i) mPerVoxel[i] = glm::dot(glm::dvec3(m[i]), normal);
}

GrowDomain GrowDomain::upTo(double distance) const {
  GrowDomain other = *this;
  if (!mIsEverywhere) other.mTo = distance;
  return other;
}

GrowDomain GrowDomain::between(double from, double to) const {
  GrowDomain other = upTo(to);
  if (!mIsEverywhere) other.mFrom = from;
  return other;
}

double GrowDomain::depth(glm::ivec3 voxel) const {
  // In this order everywhere: sums and products of doubles stay in order when they are rounded.
  return mAtOrigin + voxel.z * mPerVoxel.z + voxel.y * mPerVoxel.y + voxel.x * mPerVoxel.x;
}

bool GrowDomain::contains(glm::ivec3 voxel) const {
  if (mIsEverywhere) return true;
  double d = depth(voxel);
  return d > mFrom && d <= mTo;
}

RowSpan GrowDomain::rowSpan(int y, int z, int width) const {
  if (mIsEverywhere) return {0, width};
  double start = depth({0, y, z}), step = mPerVoxel.x;
  if (step == 0.0) return start > mFrom && start <= mTo ? RowSpan{0, width} : RowSpan{};
  double toFrom = (mFrom - start) / step, toEnd = (mTo - start) / step;
  auto isBehindFrom = [&](int x) { return start + x * step > mFrom; };
  auto isBehindEnd = [&](int x) { return start + x * step > mTo; };
  if (step > 0.0) return {firstWhere(toFrom, width, isBehindFrom), firstWhere(toEnd, width, isBehindEnd)};
  return {firstWhere(toEnd, width, [&](int x) { return !isBehindEnd(x); }),
          firstWhere(toFrom, width, [&](int x) { return !isBehindFrom(x); })};
}

glm::dvec2 GrowDomain::depthRange(glm::ivec3 first, glm::ivec3 last) const {
  glm::ivec3 low, high;
  for (int i = 0; i < 3; ++i) {
    low[i] = mPerVoxel[i] > 0.0 ? first[i] : last[i];
    high[i] = mPerVoxel[i] > 0.0 ? last[i] : first[i];
  }
  return {depth(low), depth(high)};
}

bool GrowDomain::mayMeet(glm::ivec3 first, glm::ivec3 last) const {
  if (mIsEverywhere) return true;
  glm::dvec2 range = depthRange(first, last);
  return range.y > mFrom && range.x <= mTo;
}

double GrowDomain::layer() const { return std::abs(mPerVoxel.x) + std::abs(mPerVoxel.y) + std::abs(mPerVoxel.z); }

double slabThickness(const Volume& volume) { return 2.0 * glm::length(spacingOf(volume)); }

}  // namespace velum::growth
