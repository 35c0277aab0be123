#include "render/kept/StayingShares.h"

#include <algorithm>
#include <cmath>

#include "render/kept/Instances.h"
#include "render/kept/ThresholdFold.h"
#include "scene/Shown.h"

namespace velum::render {

namespace {

/// The share from which on one cut leaves an instance with the number u. Of typeSpareDepth(), solved for the share.
/// @param depth  how deep it lies in the removed side; below 0: outside
float stayingShare(const shared::TypeSpareRow& row, float u, float depth, bool isInside) {
  if (row.falloff < 0.0f && !isInside) {
    // 1 - share <= (1 - u) / w, where w is how much of them goes at this distance.
    float w = row.amount * (1.0f - std::pow(std::min(depth / row.falloff, 1.0f), row.exponent));
    float share = w > 0.0f ? 1.0f - (1.0f - u) / w : kStaysAlways;
    return share > 0.0f ? share : kStaysAlways;
  }
  if (!isInside) return kStaysAlways;
  float bare = row.distance >= shared::kCutFar || depth <= row.distance ? u : kStaysNever;
  if (!(row.falloff > 0.0f) || depth > row.falloff) return bare;
  // u < share + (1 - share) w, where w is how much more of them stays at this depth.
  float w = row.amount * (1.0f - std::pow(std::max(depth, 0.0f) / row.falloff, row.exponent));
  float share = w < 1.0f ? (u - w) / (1.0f - w) : kStaysAlways;
  return std::min(bare, share > 0.0f ? share : kStaysAlways);
}

/// The share from which on all cuts together leave an instance. @param isSet  by cut: one whose share is asked for
float shareOf(const Instances& all, const std::vector<bool>& isSet, std::size_t number) {
  float u = randomOf(std::uint32_t(number));
  glm::vec3 p = all.middleOf(number);
  ThresholdFold fold(kStaysAlways, kStaysNever);
  for (std::size_t c = 0; c < all.cuts.size(); ++c) {
    const shared::CutData& cut = all.cuts[c];
    const shared::TypeSpareRow& row = all.spareOf(number, c);
    float reach = all.reachOf(number, c);
    bool isDecided = !isSet[c] || row.share < 1.0f;
    float bare = isDecided ? shared::typeSpareDepth(row, u) : 0.0f;
    bool isLeft = shared::instanceAnswer(cut, bare, reach, p, all.sheets.view()) == shared::kCutKeeps;
    float share = isLeft ? kStaysAlways : kStaysNever;
    if (!isDecided) {
      bool asksDepth = row.falloff != 0.0f || (!isLeft && row.distance < shared::kCutFar);
      float depth = asksDepth ? -(shared::cutDistance(cut, p, all.sheets.view()) + reach) : 0.0f;
      share = stayingShare(row, u, depth, !isLeft);
    }
    fold.add(shared::cutPart(cut), share);
  }
  return fold.threshold();
}

}  // namespace

std::vector<std::vector<float>> stayingShares(const scene::Scene& scene, const std::vector<int>& cuts,
                                              const std::vector<std::uint32_t>& types, const SheetIndices& sheets) {
  if (!scene.model.data) return {};
  Instances all(scene, sheets);
  std::vector<bool> isSet;
  for (const scene::Cut& cut : scene::enabledOf(scene.cuts))
    isSet.push_back(std::find(cuts.begin(), cuts.end(), cut.id) != cuts.end());
  std::size_t instances = all.model.instances.size(), copies = all.count() / std::max<std::size_t>(1, instances);
  std::vector<std::vector<float>> shares;
  for (std::uint32_t type : types) {
    const MoleculeType& of = all.model.types[type];
    std::vector<float>& ofType = shares.emplace_back(of.instanceCount * copies);
    parallelForRanges(std::size_t(0), ofType.size(), std::size_t(4096), [&](std::size_t begin, std::size_t end) {
      for (std::size_t at = begin; at < end; ++at) {
        std::size_t number = at / of.instanceCount * instances + of.firstInstance + at % of.instanceCount;
        ofType[at] = shareOf(all, isSet, number);
      }
    });
  }
  return shares;
}

}  // namespace velum::render
