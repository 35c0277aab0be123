#include "render/kept/KeptPlaces.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/FrameSetup.h"
#include "render/upload/CutSheets.h"
#include "render/upload/SpareTable.h"
#include "scene/Shown.h"
#include "shared/cuts.h"

namespace velum::render {

struct KeptPlaces::Parts {
  glm::dvec3 middle;
  CpuSheets sheets;
  std::vector<shared::CutData> cuts;
  std::vector<int> ids;
  SpareTable spares;

  /// What one cut leaves of a structure.
  KeptDistance of(std::size_t i, glm::vec3 p, std::uint16_t structure) const {
    const shared::CutData& cut = cuts[i];
    float spared = spares.depthOf(structure, i);
    if (spared >= shared::kCutFar) return {};
    double size = std::abs(double(shared::cutDistance(cut, p, sheets.view())));
    double own = shared::cutRemoves(cut, p, sheets.view()) ? -size : size;
    return {spared > 0.0f ? own + double(spared) : own, ids[i]};
  }
};

namespace {

KeptDistance lesser(const KeptDistance& a, const KeptDistance& b) { return b.distance < a.distance ? b : a; }
KeptDistance larger(const KeptDistance& a, const KeptDistance& b) { return b.distance > a.distance ? b : a; }

}  // namespace

KeptPlaces::KeptPlaces(const scene::Scene& scene, glm::dvec3 middle, const SheetIndices& live)
    : mParts(std::make_unique<Parts>()) {
  mParts->middle = middle;
  mParts->sheets = makeCpuSheets(scene, live);
  mParts->cuts = makeCutData(scene, middle, mParts->sheets.plans);
  mParts->spares = makeSpareTable(scene);
  for (const scene::Cut& cut : scene::enabledOf(scene.cuts)) mParts->ids.push_back(cut.id);
}

KeptPlaces::~KeptPlaces() = default;
KeptPlaces::KeptPlaces(KeptPlaces&&) noexcept = default;

bool KeptPlaces::isEmpty() const { return mParts->cuts.empty(); }

bool KeptPlaces::hasSheets() const {
  return std::any_of(mParts->cuts.begin(), mParts->cuts.end(),
                     [](const auto& cut) { return cut.kind.x == shared::kCutMembrane; });
}

// As shared::foldAnswer() joins answers: of what all must leave the least distance counts, of what one is enough to
// leave the largest.
KeptDistance KeptPlaces::distance(glm::dvec3 world, std::uint16_t structure) const {
  glm::vec3 p(world - mParts->middle);
  KeptDistance before, last, inlay{-1e30, 0};
  bool hasInlay = false;
  for (std::size_t i = 0; i < mParts->cuts.size(); ++i) {
    KeptDistance own = mParts->of(i, p, structure);
    int part = shared::cutPart(mParts->cuts[i]);
    if (part == shared::kFoldInlay) {
      hasInlay = true;
      inlay = larger(inlay, own);
    } else if (part == shared::kFoldJoined) {
      last = larger(last, own);
    } else {
      before = lesser(before, last);
      last = own;
    }
  }
  KeptDistance kept = lesser(before, last);
  return hasInlay ? lesser(kept, inlay) : kept;
}

}  // namespace velum::render
