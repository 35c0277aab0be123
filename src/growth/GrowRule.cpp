#include "growth/GrowRule.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/Error.h"

namespace velum::growth {

namespace {

double distanceSquared(glm::dvec3 a, glm::dvec3 b, glm::dvec3 p) {
  glm::dvec3 along = b - a, to = p - a;
  double length = glm::dot(along, along);
  double t = length > 0.0 ? std::clamp(glm::dot(to, along) / length, 0.0, 1.0) : 0.0;
  glm::dvec3 away = to - along * t;
  return glm::dot(away, away);
}

}  // namespace

GrowRule ruleOf(const scene::Growth& growth) {
  return {growth.low, growth.high, growth.steepest, growth.within, growth.channel, growth.timeStep, growth.barriers};
}

void checkRule(const GrowRule& rule, const Volume& volume) {
  if (rule.channel < 0 || rule.channel >= volume.channels)
    throw ArgumentError(fmt::format("channel {} to grow in: the volume has {}", rule.channel, volume.channels));
  if (rule.timeStep < 0 || rule.timeStep >= volume.timeSteps)
    throw ArgumentError(fmt::format("time step {} to grow in: the volume has {}", rule.timeStep, volume.timeSteps));
}

glm::ivec3 voxelAt(const Volume& volume, glm::dvec3 world) {
  glm::dvec3 place(glm::inverse(volume.worldFromVoxel) * glm::dvec4(world, 1.0));
  // Clamped to just outside, so that no place is too far away for whole numbers.
  return glm::ivec3(glm::clamp(glm::floor(place + 0.5), glm::dvec3(-1.0), glm::dvec3(volume.dims)));
}

bool isInside(const Volume& volume, glm::ivec3 voxel) {
  return glm::all(glm::lessThan(glm::uvec3(voxel), glm::uvec3(volume.dims)));
}

bool holds(const scene::Barrier& barrier, glm::dvec3 world) {
  double within = barrier.radius * barrier.radius;
  for (std::size_t i = 0; i < barrier.path.size(); ++i) {
    const glm::dvec3& from = barrier.path[i];
    const glm::dvec3& to = barrier.path[std::min(i + 1, barrier.path.size() - 1)];
    if (distanceSquared(from, to, world) <= within) return true;
  }
  return false;
}

}  // namespace velum::growth
