#include "velum/render/section/StayingShares.h"

#include <algorithm>
#include <cmath>

#include "FrameSetup.h"
#include "shared/instance.h"
#include "velum/core/Parallel.h"
#include "velum/mesoscale/InstanceRows.h"

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

/// As shared::CutFold, of shares rather than of answers: who must keep a thing all, the largest; where one is enough,
/// the least.
struct ShareFold {
  float before = kStaysAlways, last = kStaysAlways, inlay = kStaysNever;
  bool hasInlay = false;

  void add(int part, float share) {
    if (part == shared::kFoldInlay) {
      hasInlay = true;
      inlay = std::min(inlay, share);
    } else if (part == shared::kFoldJoined) {
      last = std::min(last, share);
    } else {
      before = std::max(before, last);
      last = share;
    }
  }
  float share() const { return std::max({before, last, hasInlay ? inlay : kStaysAlways}); }
};

/// What holds for all types.
struct Asked {
  const scene::Scene& scene;
  CpuSheets sheets;
  glm::dvec3 origin{0.0};
  double scale = 1.0;
  std::vector<shared::CutData> cuts;
  std::vector<bool> isSet;  ///< by cut: one of those whose share is asked for
  std::uint32_t whole = 0;
  scene::CopyGrid copies;
};

/// The share from which on all cuts together leave an instance.
/// @param rows  what each cut does with its type  @param number  over all copies
float shareOf(const Asked& asked, const shared::TypeSpareRow* rows, std::size_t number) {
  const Model& model = *asked.scene.model.data;
  const Instance& instance = model.instances[number % model.instances.size()];
  const Molecule& molecule = model.molecules[instance.molecule];
  int copy = int(number / model.instances.size());
  glm::ivec3 counts = asked.copies.counts;
  glm::dvec3 cell(copy % counts.x, copy / counts.x % counts.y, copy / (counts.x * counts.y));
  glm::dvec3 middle = glm::dvec3(instance.position) + glm::dvec3(instance.rotation * molecule.centre) +
                      asked.copies.step * cell;
  glm::vec3 p(middle * asked.scale - asked.origin);
  float u = randomOf(std::uint32_t(number)), radius = float(molecule.radius * asked.scale);
  ShareFold fold;
  for (std::size_t c = 0; c < asked.cuts.size(); ++c) {
    const shared::CutData& cut = asked.cuts[c];
    float reach = c < 32 && (asked.whole >> c & 1u) != 0 ? radius : 0.0f;
    bool isDecided = !asked.isSet[c] || rows[c].share < 1.0f;
    float bare = isDecided ? shared::typeSpareDepth(rows[c], u) : 0.0f;
    bool isLeft = shared::instanceAnswer(cut, bare, reach, p, asked.sheets.view()) == shared::kCutKeeps;
    float share = isLeft ? kStaysAlways : kStaysNever;
    if (!isDecided) {
      bool asksDepth = rows[c].falloff != 0.0f || (!isLeft && rows[c].distance < shared::kCutFar);
      float depth = asksDepth ? -(shared::cutDistance(cut, p, asked.sheets.view()) + reach) : 0.0f;
      share = stayingShare(rows[c], u, depth, !isLeft);
    }
    fold.add(shared::cutPart(cut), share);
  }
  return fold.share();
}

}  // namespace

std::vector<std::vector<float>> stayingShares(const scene::Scene& scene, const std::vector<int>& cuts,
                                              const std::vector<std::uint32_t>& types, const SheetIndices& sheets) {
  if (!scene.model.data) return {};
  const Model& model = *scene.model.data;
  scene::ModelBox box = scene::modelBox(scene.model);
  double scale = unitsPer(LengthUnit::Angstrom, scene.unit);
  glm::dvec3 origin = 0.5 * (box.low + box.high) * scale;
  Asked asked{scene, makeCpuSheets(scene, sheets), origin, scale, {}, {}, 0, scene::copyGrid(scene.model)};
  asked.cuts = makeCutData(scene, origin, asked.sheets.plans);
  for (const scene::Cut& cut : scene.cuts)
    if (cut.enabled) asked.isSet.push_back(std::find(cuts.begin(), cuts.end(), cut.id) != cuts.end());
  asked.whole = mesoscale::wholeInstanceBits(scene);
  std::vector<shared::TypeSpareRow> rows = mesoscale::makeTypeSpareRows(scene);
  std::vector<std::vector<float>> shares;
  for (std::uint32_t type : types) {
    const MoleculeType& of = model.types[type];
    std::vector<float>& ofType = shares.emplace_back(of.instanceCount * std::size_t(std::max(1, scene.model.copies)));
    parallelForRanges(std::size_t(0), ofType.size(), std::size_t(4096), [&](std::size_t begin, std::size_t end) {
      for (std::size_t at = begin; at < end; ++at) {
        std::size_t number = at / of.instanceCount * model.instances.size() + of.firstInstance + at % of.instanceCount;
        ofType[at] = shareOf(asked, rows.data() + type * asked.cuts.size(), number);
      }
    });
  }
  return shares;
}

}  // namespace velum::render
