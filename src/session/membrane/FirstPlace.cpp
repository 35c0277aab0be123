#include "velum/session/membrane/FirstPlace.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "CoarseLook.h"
#include "velum/core/Vectors.h"

namespace velum::session {

namespace {

constexpr int kPlaces = 14;
/// The places that are tried lie between the front and where so much of what is protected is in front. What lies before
/// the front is too little to count: noise, a cable.
constexpr double kBeforeFront = 0.02, kMostInFront = 0.6;
/// What must be cut counts more than what is spared.
constexpr double kWorthOfCut = 2.0;
/// A place further in front is taken where it is nearly as good.
constexpr double kNearlyAsGood = 0.8;

/// What the sheet would spare here of what the plane would cut, less what it must cut.
double worthOf(const CoarseLook& look, const scene::Cut& cut, Progress& progress) {
  CoarseLook::Pairs pairs = look.pairsOf(cut, progress);
  return pairs.plane - pairs.sheet - kWorthOfCut * pairs.sheet;
}

}  // namespace

std::optional<glm::dvec3> firstPlaceOf(const scene::Scene& scene, const scene::Cut& cut, Progress& progress) {
  if (!scene::hasData(scene)) return std::nullopt;
  return firstPlaceOf(CoarseLook(membrane::Potential(scene), cut.membrane->field, progress), cut, progress);
}

std::optional<glm::dvec3> firstPlaceOf(const CoarseLook& look, const scene::Cut& cut, Progress& progress) {
  // What is removed is in front.
  glm::dvec3 axis = unitOr(cut.axis, {0, 0, 1}), front = cut.invert ? -axis : axis;
  std::vector<double> depths;
  look.forEachProtected([&](glm::ivec3, glm::dvec3 world) { depths.push_back(glm::dot(world, front)); });
  std::sort(depths.begin(), depths.end());
  if (depths.empty()) return std::nullopt;
  auto behind = [&](double share) { return depths[std::size_t((1.0 - share) * double(depths.size() - 1))]; };
  double from = behind(kBeforeFront), to = behind(kMostInFront);
  // What only just fits a coarse look may not fit the sheet: it is tried with a reach a place shorter.
  double depth = look.depthAlong(axis);
  std::vector<std::pair<double, glm::dvec3>> tried;
  for (int i = 0; i < kPlaces; ++i) {
    scene::Cut there = cut;
    there.size.z = std::max(cut.size.z - depth, 0.5 * cut.size.z);
    there.centre += front * (std::lerp(from, to, i / double(kPlaces - 1)) - glm::dot(cut.centre, front));
    tried.emplace_back(worthOf(look, there, progress), there.centre);
  }
  double best = std::max_element(tried.begin(), tried.end(), [](auto& a, auto& b) { return a.first < b.first; })->first;
  double enough = best > 0.0 ? kNearlyAsGood * best : best;
  return std::find_if(tried.begin(), tried.end(), [&](const auto& one) { return one.first >= enough; })->second;
}

}  // namespace velum::session
