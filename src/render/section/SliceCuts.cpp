#include "SliceCuts.h"

#include <algorithm>
#include <cmath>

#include "FrameSetup.h"
#include "velum/core/Assert.h"

namespace velum::render {

SliceCuts::SliceCuts(const scene::Scene& scene, const scene::SliceFrame& frame, const SheetIndices& sheets)
    : mFrame(frame), mSheets(makeCpuSheets(scene, sheets)) {
  for (const auto& data : makeCutData(scene, frame.centreMm, mSheets.plans))
    mCuts.push_back({data, {}, data.kind.x == shared::kCutMembrane && data.kind.w == shared::kMembraneSlice});
  std::size_t next = 0;
  for (const auto& cut : scene.cuts) {
    if (!cut.enabled) continue;
    VELUM_ASSERT(next < mCuts.size(), "each enabled cut has its data");
    auto& spares = mCuts[next++].spares;
    if (!cut.exempt.empty() && scene.labels.data && scene.labels.visible) spares.resize(65536);
    for (int id : cut.exempt)
      if (!spares.empty() && id > 0 && id < 65536) spares[std::size_t(id)] = true;
  }
}

/// A convex cut removes one stretch of a row, or all but one.
void SliceCuts::markConvex(const SliceCut& cut, const Row& row, std::vector<char>& removed) const {
  glm::vec2 inside = shared::cutInterval(cut.data, row.start, row.along) * float(1.0 / row.mmPerPixel);
  int from = 0, to = 0;
  if (inside.x <= inside.y) {
    from = int(std::clamp(std::ceil(inside.x), 0.0f, float(row.width)));
    to = int(std::clamp(std::floor(inside.y) + 1.0f, float(from), float(row.width)));
  }
  bool takesInside = cut.data.halfSize.w > 0;
  std::fill(removed.begin(), removed.end(), char(!takesInside));
  std::fill(removed.begin() + from, removed.begin() + to, char(takesInside));
}

/// From crossing to crossing; each run is asked in its middle.
void SliceCuts::markMembrane(const SliceCut& cut, const Row& row, std::vector<char>& removed) const {
  float mm = float(row.mmPerPixel), end = mm * float(row.width), t = -0.5f * mm;
  for (int x = 0; x < row.width;) {
    float next = shared::membraneCrossing(cut.data, row.start, row.along, t + 1e-5f * std::max(1.0f, std::abs(t)), end,
                                          mSheets.view())
                     .t;
    next = std::min(next, end);
    bool removes = shared::cutRemoves(cut.data, row.start + 0.5f * (t + next) * row.along, mSheets.view());
    int to = next >= end ? row.width : std::clamp(int(std::ceil(next / mm)), x, row.width);
    std::fill(removed.begin() + x, removed.begin() + to, char(removes));
    x = to;
    t = next;
  }
}

std::vector<char> SliceCuts::removedOf(int y, int width, std::span<const std::uint16_t> ids) const {
  Row row{glm::vec3(scene::worldFromSlicePixel(mFrame, {0.5, y + 0.5}) - mFrame.centreMm), glm::vec3(mFrame.right),
          width, mFrame.mmPerPixel};
  return removedOf(row, ids);
}

std::vector<char> SliceCuts::removedOf(const Row& row, std::span<const std::uint16_t> ids) const {
  VELUM_ASSERT(ids.empty() || ids.size() == std::size_t(row.width), "each pixel has its structure");
  auto count = std::size_t(row.width);
  std::vector<char> removed(count, 0), one(count, 0), outOfSlices(count, 1);
  bool hasSlices = false;
  for (const auto& cut : mCuts) {
    if (cut.data.kind.x == shared::kCutMembrane)
      markMembrane(cut, row, one);
    else
      markConvex(cut, row, one);
    for (std::size_t x = 0; x < one.size(); ++x) {
      bool removes = one[x] && (cut.spares.empty() || ids.empty() || !cut.spares[ids[x]]);
      if (cut.isSlice)
        outOfSlices[x] = outOfSlices[x] && removes;
      else
        removed[x] = removed[x] || removes;
    }
    hasSlices = hasSlices || cut.isSlice;
  }
  for (std::size_t x = 0; hasSlices && x < removed.size(); ++x) removed[x] = removed[x] || outOfSlices[x];
  return removed;
}

}  // namespace velum::render
