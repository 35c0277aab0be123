#include "render/kept/RowCuts.h"

#include <algorithm>
#include <cmath>

#include "core/Assert.h"
#include "render/FrameSetup.h"

namespace velum::render {

RowCuts::RowCuts(const scene::Scene& scene, const scene::SectionPlane& plane, const SheetIndices& sheets)
    : mFrame(plane),
      mSheets(makeCpuSheets(scene, sheets)),
      mCuts(makeCutData(scene, plane.centre, mSheets.plans)),
      mSpares(makeSpareTable(scene)) {
  glm::dmat4 worldFromVoxel(0.0);
  if (scene.volume.data)
    worldFromVoxel = scene.volume.data->worldFromVoxel;
  else if (scene.labels.data)
    worldFromVoxel = scene.labels.data->worldFromVoxel();
  mHalfVoxel = 0.5 * std::min({glm::length(glm::dvec3(worldFromVoxel[0])), glm::length(glm::dvec3(worldFromVoxel[1])),
                               glm::length(glm::dvec3(worldFromVoxel[2]))});
}

/// A convex cut removes one stretch of a row, or all but one.
void RowCuts::markConvex(const shared::CutData& cut, const Row& row, std::vector<char>& removed) {
  glm::vec2 inside = shared::cutInterval(cut, row.start, row.along) * float(1.0 / row.lengthPerPixel);
  int from = 0, to = 0;
  if (inside.x <= inside.y) {
    from = int(std::clamp(std::ceil(inside.x), 0.0f, float(row.width)));
    to = int(std::clamp(std::floor(inside.y) + 1.0f, float(from), float(row.width)));
  }
  bool takesInside = cut.halfSize.w > 0;
  std::fill(removed.begin(), removed.end(), char(!takesInside));
  std::fill(removed.begin() + from, removed.begin() + to, char(takesInside));
}

void RowCuts::markWalked(const shared::CutData& cut, const Row& row, std::vector<char>& removed) {
  float pixel = float(row.lengthPerPixel), end = pixel * float(row.width), t = -0.5f * pixel;
  for (int x = 0; x < row.width;) {
    shared::CutRun run = shared::cutWalk(cut, row.start, row.along, t, 1e-5f * end, end);
    bool removes = run.end > t;
    t = std::min(removes ? run.end : run.next, end);
    int to = t >= end ? row.width : std::clamp(int(std::ceil(t / pixel)), x, row.width);
    std::fill(removed.begin() + x, removed.begin() + to, char(removes));
    x = to;
  }
}

/// From crossing to crossing; each run is asked in its middle.
void RowCuts::markMembrane(const shared::CutData& cut, const Row& row, std::vector<char>& removed) const {
  float pixel = float(row.lengthPerPixel), end = pixel * float(row.width), t = -0.5f * pixel;
  for (int x = 0; x < row.width;) {
    float next = shared::membraneCrossing(cut, row.start, row.along, t + 1e-5f * end, end, mSheets.view()).t;
    next = std::min(next, end);
    bool removes = shared::cutRemoves(cut, row.start + 0.5f * (t + next) * row.along, mSheets.view());
    int to = next >= end ? row.width : std::clamp(int(std::ceil(next / pixel)), x, row.width);
    std::fill(removed.begin() + x, removed.begin() + to, char(removes));
    x = to;
    t = next;
  }
}

/// Of what a membrane removes of a row, takes back what lies near its sheet on the side that it removes.
void RowCuts::keepNear(const shared::CutData& cut, Row row, double ease, std::vector<char>& removed) const {
  if (ease <= 0.0 || cut.kind.w != shared::kMembraneClip) return;
  glm::vec3 up = glm::transpose(glm::mat3(cut.localFromScene))[2];
  row.start -= float(ease) * (cut.halfSize.w > 0.0f ? up : -up);
  std::vector<char> further(removed.size(), 0);
  markMembrane(cut, row, further);
  for (std::size_t x = 0; x < removed.size(); ++x) removed[x] = removed[x] && further[x];
}

/// Of what a cut removes of a row, takes back what it spares.
void RowCuts::takeBack(std::size_t cut, const Row& row, std::span<const std::uint16_t> ids,
                       std::vector<char>& removed) const {
  float step = float(row.lengthPerPixel);
  for (std::size_t x = 0; x < removed.size(); ++x) {
    if (!removed[x]) continue;
    float depth = mSpares.depthOf(ids.empty() ? 0 : ids[x], cut);
    if (depth <= 0.0f) continue;
    glm::vec3 p = row.start + float(x) * step * row.along;
    removed[x] = shared::cutAnswer(mCuts[cut], depth, mSpares.hasDepths, p, mSheets.view()) == shared::kCutRemoves;
  }
}

std::vector<char> RowCuts::removedOf(int y, int width, std::span<const std::uint16_t> ids) const {
  Row row{glm::vec3(scene::worldFromSectionPixel(mFrame, {0.5, y + 0.5}) - mFrame.centre), glm::vec3(mFrame.right),
          width, mFrame.lengthPerPixel};
  return removedOf(row, ids, mHalfVoxel);
}

namespace {

/// Half a row's length from its middle nothing of it is further off.
bool missesRow(const shared::CutData& cut, const RowCuts::Row& row) {
  float length = float(row.lengthPerPixel) * float(row.width + 1);
  glm::vec3 middle = row.start + 0.5f * length * row.along;
  return cut.kind.x != shared::kCutMembrane && shared::shapeDistance(cut, middle) > 0.51f * length;
}

}  // namespace

/// To the one before it, or the next one to it.
bool RowCuts::isJoined(std::size_t i) const {
  auto joins = [&](std::size_t at) { return at < mCuts.size() && shared::cutPart(mCuts[at]) == shared::kFoldJoined; };
  return joins(i) || joins(i + 1);
}

std::vector<char> RowCuts::removedOf(const Row& row, std::span<const std::uint16_t> ids, double ease) const {
  VELUM_ASSERT(ids.empty() || ids.size() == std::size_t(row.width), "each pixel has its structure");
  std::vector<char> removed(std::size_t(row.width), 0);
  std::vector<shared::CutFold> folds(removed.size(), shared::emptyFold());
  for (std::size_t i = 0; i < mCuts.size(); ++i) {
    const shared::CutData& cut = mCuts[i];
    // What keeps the whole row matters to those that it is joined with alone.
    bool misses = missesRow(cut, row);
    if (misses && !isJoined(i)) continue;
    if (misses)
      std::fill(removed.begin(), removed.end(), char(0));
    else if (cut.kind.x == shared::kCutMembrane)
      markMembrane(cut, row, removed), keepNear(cut, row, ease, removed);
    else if ((cut.kind.z & shared::kCutWalks) != 0)
      markWalked(cut, row, removed);
    else
      markConvex(cut, row, removed);
    if (!misses && !mSpares.isEmpty()) takeBack(i, row, ids, removed);
    for (std::size_t x = 0; x < removed.size(); ++x)
      folds[x] =
          shared::foldAnswer(folds[x], shared::cutPart(cut), removed[x] ? shared::kCutRemoves : shared::kCutKeeps);
  }
  for (std::size_t x = 0; x < removed.size(); ++x) removed[x] = !shared::foldKeeps(folds[x]);
  return removed;
}

}  // namespace velum::render
