#include "session/membrane/FirstPlace.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/Vectors.h"
#include "scene/Scene.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/CoarseLook.h"
#include "session/membrane/DefaultField.h"

namespace velum::session {

namespace {

constexpr int kPlaces = 14;
/// The places that are tried lie between the front and where so much of what is protected is in front. What lies before
/// the front is too little to count: noise, a cable.
constexpr double kBeforeFront = 0.02, kMostInFront = 0.6;
/// A pair that must be cut counts so many times as much as a pair that is spared.
constexpr double kWorthOfCut = 2.0;
/// A place further in front is taken where it is nearly as good.
constexpr double kNearlyAsGood = 0.8;
/// No place is taken that spares less than this share of what the best place spares: before the tip of something little
/// is cut, and little is shown.
constexpr double kWorthShowing = 0.25;
/// This share must be kept by a coarse look, as the coarse look may promise a little more than the sheet keeps.
constexpr double kSurelyKept = 0.95;
/// A cut is no more than a scratch where the sheet cuts less than this share of what the plane cuts.
constexpr double kScratch = 0.05;
/// Where no place keeps enough, a place that keeps less than the best by this share counts as good as the best.
constexpr double kAboutAsMuch = 0.03;
/// Reaches that are tried, in parts of the reach that the frame has; no reach goes beyond the data's own depth to
/// either side.
constexpr double kReaches[] = {1.0, 1.5, 2.0, 3.0, 4.5};

struct Tried {
  Placed placed;
  double worth = 0;  ///< pairs that the sheet spares of those that the plane cuts, less what it must cut
  double kept() const { return placed.outlook.fate.kept; }
};

Tried tryIn(const CoarseLook& look, const scene::Cut& cut, Progress& progress) {
  // What only just fits a coarse look may not fit the sheet: it is tried with a reach a place shorter to either side.
  scene::Cut there = cut;
  there.size.z = std::max(cut.size.z - 2.0 * look.depthAlong(unitOr(cut.axis, {0, 0, 1})), 0.5 * cut.size.z);
  CoarseLook::Outlook outlook = look.outlookOf(there, progress);
  return {{cut, outlook}, outlook.planePairs - (1.0 + kWorthOfCut) * outlook.sheetPairs};
}

/// The reaches to try, shortest first.
std::vector<double> reachesOf(const CoarseLook& look, const scene::Cut& cut) {
  std::vector<double> reaches;
  double most = std::max(2.0 * look.wholeDepthAlong(unitOr(cut.axis, {0, 0, 1})), cut.size.z);
  for (double times : kReaches) {
    double reach = std::min(times * cut.size.z, most);
    if (reaches.empty() || reach > reaches.back()) reaches.push_back(reach);
  }
  return reaches;
}

/// From the front inwards, along the axis.
std::vector<glm::dvec3> placesOf(const CoarseLook& look, const scene::Cut& cut) {
  // What is removed is in front.
  glm::dvec3 axis = unitOr(cut.axis, {0, 0, 1}), front = cut.invert ? -axis : axis;
  std::vector<double> depths;
  look.forEachProtected([&](glm::ivec3, glm::dvec3 world) { depths.push_back(glm::dot(world, front)); });
  std::sort(depths.begin(), depths.end());
  std::vector<glm::dvec3> places;
  if (depths.empty()) return places;
  auto behind = [&](double share) { return depths[std::size_t((1.0 - share) * double(depths.size() - 1))]; };
  double from = behind(kBeforeFront), to = behind(kMostInFront);
  for (int i = 0; i < kPlaces; ++i)
    places.push_back(cut.centre + front * (std::lerp(from, to, i / double(kPlaces - 1)) - glm::dot(cut.centre, front)));
  return places;
}

/// The first place that is nearly as good as the best of those that count; null where none does.
template <class Counts>
const Tried* firstOf(const std::vector<Tried>& all, Counts counts) {
  const Tried* best = nullptr;
  for (const Tried& one : all)
    if (counts(one) && (!best || one.worth > best->worth)) best = &one;
  if (!best) return nullptr;
  double enough = best->worth > 0.0 ? kNearlyAsGood * best->worth : best->worth;
  return &*std::find_if(all.begin(), all.end(), [&](const Tried& one) { return counts(one) && one.worth >= enough; });
}

}  // namespace

std::optional<Placed> placedToKeep(const CoarseLook& look, const scene::Cut& cut, Progress& progress,
                                   bool isReachFree) {
  std::vector<glm::dvec3> places = placesOf(look, cut);
  if (places.empty()) return std::nullopt;
  std::vector<Tried> known;
  for (double reach : isReachFree ? reachesOf(look, cut) : std::vector<double>{cut.size.z}) {
    std::vector<Tried> tried;
    double best = -1e300;
    for (glm::dvec3 place : places) {
      scene::Cut there = cut;
      there.centre = place;
      there.size.z = reach;
      tried.push_back(tryIn(look, there, progress));
      best = std::max(best, tried.back().worth);
    }
    auto keeps = [&](const Tried& one) { return one.kept() >= kSurelyKept && one.worth >= kWorthShowing * best; };
    if (const Tried* first = firstOf(tried, keeps)) return first->placed;
    known.insert(known.end(), tried.begin(), tried.end());
  }
  // Nowhere is that much kept.
  double most = 0.0;
  for (const Tried& one : known) most = std::max(most, one.kept());
  return firstOf(known, [&](const Tried& one) { return one.kept() >= most - kAboutAsMuch; })->placed;
}

std::optional<Placed> deepenedToKeep(const CoarseLook& look, const scene::Cut& cut, Progress& progress) {
  std::optional<Placed> first;
  for (double reach : reachesOf(look, cut)) {
    scene::Cut there = cut;
    there.size.z = reach;
    Tried tried = tryIn(look, there, progress);
    if (tried.kept() < kSurelyKept) continue;
    // A little deeper it may be kept without a scratch.
    if (tried.placed.outlook.sheetPairs <= kScratch * tried.placed.outlook.planePairs) return tried.placed;
    if (!first) first = tried.placed;
  }
  return first;
}

std::optional<scene::Cut> placedToKeep(const scene::Scene& scene, const scene::Cut& cut, Progress& progress,
                                       bool isReachFree) {
  if (!scene::hasData(scene)) return std::nullopt;
  CoarseLook look(membrane::Potential(scene), cut.membrane->field, progress);
  auto placed = placedToKeep(look, cut, progress, isReachFree);
  return placed ? std::optional(placed->cut) : std::nullopt;
}

scene::Cut deepenedToKeep(const scene::Scene& scene, const scene::Cut& cut, Progress& progress) {
  if (!scene::hasData(scene)) return cut;
  auto placed = deepenedToKeep(CoarseLook(membrane::Potential(scene), cut.membrane->field, progress), cut, progress);
  return placed ? placed->cut : cut;
}

scene::Cut newMembrane(const scene::Scene& scene, Progress& progress) {
  scene::Cut cut = makeCut(scene, scene::CutShape::Membrane);
  cut.membrane->field = defaultField(scene);
  // Where hands have put the crosshair is where they mean.
  if (!isCrosshairAtRest(scene)) return deepenedToKeep(scene, cut, progress);
  return placedToKeep(scene, cut, progress).value_or(cut);
}

}  // namespace velum::session
