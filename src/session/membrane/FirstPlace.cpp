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

/// How far along a direction what is protected lies, ascending.
std::vector<double> depthsOf(const membrane::ProtectedVoxels& voxels, glm::dvec3 along) {
  std::vector<double> depths;
  glm::ivec3 n = voxels.box.end, at;
  const std::uint8_t* mask = voxels.mask.data();
  for (at.z = 0; at.z < n.z; ++at.z)
    for (at.y = 0; at.y < n.y; ++at.y)
      for (at.x = 0; at.x < n.x; ++at.x)
        if (*mask++) depths.push_back(glm::dot(glm::dvec3(voxels.worldFromVoxel * glm::dvec4(at, 1.0)), along));
  std::sort(depths.begin(), depths.end());
  return depths;
}

/// What the sheet would spare here of what the plane would cut, less what it must cut.
double worthOf(const CoarseLook& look, const scene::Cut& cut, Progress& progress) {
  CoarseLook::Pairs pairs = look.pairsOf(cut, progress);
  return pairs.plane - pairs.sheet - kWorthOfCut * pairs.sheet;
}

}  // namespace

std::optional<glm::dvec3> firstPlaceOf(const scene::Scene& scene, const scene::Cut& cut, Progress& progress) {
  if (!scene::hasData(scene)) return std::nullopt;
  CoarseLook look(scene, cut.membrane->field, progress);
  // What is removed is in front.
  glm::dvec3 axis = unitOr(cut.axis, {0, 0, 1}), front = cut.invert ? -axis : axis;
  std::vector<double> depths = depthsOf(look.voxels(), front);
  if (depths.empty()) return std::nullopt;
  auto behind = [&](double share) { return depths[std::size_t((1.0 - share) * double(depths.size() - 1))]; };
  double from = behind(kBeforeFront), to = behind(kMostInFront);
  std::vector<std::pair<double, glm::dvec3>> tried;
  for (int i = 0; i < kPlaces; ++i) {
    scene::Cut there = cut;
    there.centre += front * (std::lerp(from, to, i / double(kPlaces - 1)) - glm::dot(cut.centre, front));
    tried.emplace_back(worthOf(look, there, progress), there.centre);
  }
  double best = std::max_element(tried.begin(), tried.end(), [](auto& a, auto& b) { return a.first < b.first; })->first;
  double enough = best > 0.0 ? kNearlyAsGood * best : best;
  return std::find_if(tried.begin(), tried.end(), [&](const auto& one) { return one.first >= enough; })->second;
}

}  // namespace velum::session
