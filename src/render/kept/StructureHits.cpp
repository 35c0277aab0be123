#include "render/kept/StructureHits.h"

#include <algorithm>
#include <cmath>

#include "core/Parallel.h"
#include "render/FrameSetup.h"
#include "render/kept/ThresholdFold.h"
#include "render/upload/CutSheets.h"
#include "render/upload/SpareTable.h"
#include "scene/Project.h"
#include "scene/Shown.h"
#include "scene/StructureAt.h"

namespace velum::render {

namespace {

constexpr int kBrick = LabelVolume::kBrickSize;
constexpr int kPlacesByBorder = 4;  // that are asked in a voxel in which structures meet
constexpr int kRowsAtATime = 32;    // enough for many cores, and cancelled soon
static_assert(kLeftNever >= shared::kCutFar);

/// What all rays share.
struct Walk {
  const scene::Scene& scene;
  const LabelVolume& labels;
  std::shared_ptr<const StructureField> field;
  glm::dvec3 origin;  ///< of the cuts' frame, world
  glm::dmat4 voxelFromWorld;
  CpuSheets sheets;
  std::vector<shared::CutData> cuts;
  std::vector<char> isSet;  ///< by enabled cut: one whose distance is asked for
  SpareTable spares;

  Walk(const scene::Scene& of, const std::vector<int>& set, const SheetIndices& live)
      : scene(of),
        labels(*of.labels.data),
        field(scene::structureFieldOf(of)),
        origin(labels.worldFromVoxel() * glm::dvec4(0.5 * glm::dvec3(labels.dims() - 1), 1.0)),
        voxelFromWorld(glm::inverse(labels.worldFromVoxel())),
        sheets(makeCpuSheets(of, live)),
        cuts(makeCutData(of, origin, sheets.plans)),
        spares(makeSpareTable(of)) {
    for (const scene::Cut& cut : scene::enabledOf(of.cuts))
      isSet.push_back(std::find(set.begin(), set.end(), cut.id) != set.end());
  }

  void ask(StructureHit& hit, glm::dvec3 world) const;
};

/// Adds a place of the hit's structure.
void Walk::ask(StructureHit& hit, glm::dvec3 world) const {
  glm::vec3 p(world - origin);
  shared::CutFold now = shared::emptyFold();
  ThresholdFold then(kLeftAlways, kLeftNever);
  for (std::size_t c = 0; c < cuts.size(); ++c) {
    const shared::CutData& cut = cuts[c];
    int part = shared::cutPart(cut);
    float spared = spares.depthOf(hit.structure, c);
    bool removes = shared::cutRemoves(cut, p, sheets.view());
    // As shared::cutAnswer() has it.
    bool asksDepth = removes && (isSet[c] || (spared > 0.0f && spared < shared::kCutFar));
    float depth = asksDepth ? -shared::cutDistance(cut, p, sheets.view()) : 0.0f;
    bool isTaken = removes && spared < shared::kCutFar && !(spared > 0.0f && depth <= spared);
    now = shared::foldAnswer(now, part, isTaken ? shared::kCutRemoves : shared::kCutKeeps);
    float bare = isTaken ? kLeftNever : kLeftAlways;
    float own = removes ? std::max(depth, 0.0f) : kLeftAlways;
    then.add(part, isSet[c] ? own : bare);
  }
  hit.isLeft = hit.isLeft || shared::foldKeeps(now);
  hit.depth = std::min(hit.depth, then.threshold());
}

/// The hit of a structure among those of one ray, which are few.
StructureHit& hitOf(std::vector<StructureHit>& hits, std::size_t first, std::uint32_t pixel, std::uint16_t structure) {
  for (std::size_t i = first; i < hits.size(); ++i)
    if (hits[i].structure == structure) return hits[i];
  return hits.emplace_back(StructureHit{pixel, structure});
}

/// The stretch of a line in the box of all voxels, from its origin on; x > y when it misses.
glm::dvec2 boxInterval(glm::dvec3 o, glm::dvec3 d, glm::ivec3 dims) {
  glm::dvec2 t(0.0, 1e300);
  for (int i = 0; i < 3; ++i) {
    double low = -0.5 - o[i], high = dims[i] - 0.5 - o[i];
    if (d[i] == 0.0) {
      if (low > 0.0 || high < 0.0) return {1.0, -1.0};
      continue;
    }
    t = {std::max(t.x, std::min(low / d[i], high / d[i])), std::min(t.y, std::max(low / d[i], high / d[i]))};
  }
  return t;
}

/// Voxel by voxel; bricks without labels at once.
void walkRay(const Walk& walk, std::uint32_t pixel, const scene::PictureRay& ray, std::vector<StructureHit>& hits) {
  const LabelVolume& labels = walk.labels;
  glm::ivec3 dims = labels.dims();
  glm::dvec3 o(walk.voxelFromWorld * glm::dvec4(ray.origin, 1.0));
  glm::dvec3 d(walk.voxelFromWorld * glm::dvec4(ray.direction, 0.0));
  auto [t, end] = [&] {
    glm::dvec2 range = boxInterval(o, d, dims);
    return std::pair(range.x, range.y);
  }();
  if (!(t < end)) return;
  std::size_t first = hits.size();
  auto voxelAt = [&](double at, glm::ivec3 low, glm::ivec3 high) {
    return glm::clamp(glm::ivec3(glm::floor(o + at * d + 0.5)), low, high);
  };
  glm::ivec3 voxel = voxelAt(t, glm::ivec3(0), dims - 1);
  while (t < end) {
    glm::ivec3 index = voxel / kBrick;
    const LabelVolume::Brick& brick = labels.brick(index);
    bool isEmpty = brick.size() == 1 && brick[0] == 0 && walk.field->brick(index).size() == 1;
    glm::ivec3 low = isEmpty ? index * kBrick : voxel;
    glm::ivec3 high = isEmpty ? glm::min(low + kBrick, dims) - 1 : voxel;
    // Where it leaves them, and through which side.
    double next = 1e300;
    int side = 0;
    for (int i = 0; i < 3; ++i) {
      double at = d[i] == 0.0 ? 1e300 : ((d[i] > 0.0 ? high[i] + 0.5 : low[i] - 0.5) - o[i]) / d[i];
      if (at < next) next = at, side = i;
    }
    next = std::clamp(next, t, end);
    // A ray that only touches a structure meets it in a part of a voxel.
    int places = isEmpty || !(next > t) ? 0 : walk.field->hasBorder(voxel) ? kPlacesByBorder : 1;
    for (int i = 0; i < places; ++i) {
      double at = t + (i + 0.5) / places * (next - t);
      std::uint16_t id = walk.field->at(o + at * d).id;
      if (id == 0) continue;
      StructureHit& hit = hitOf(hits, first, pixel, id);
      bool isKnown = hit.isLeft && hit.depth == kLeftAlways;
      if (!isKnown) walk.ask(hit, ray.origin + at * ray.direction);
    }
    t = next;
    voxel = isEmpty ? voxelAt(t, low, high) : voxel;
    voxel[side] = d[side] > 0.0 ? high[side] + 1 : low[side] - 1;
    if (voxel[side] < 0 || voxel[side] >= dims[side]) break;
  }
  std::sort(hits.begin() + std::ptrdiff_t(first), hits.end(),
            [](const auto& a, const auto& b) { return a.structure < b.structure; });
}

}  // namespace

std::vector<StructureHit> structureHits(const scene::Scene& scene, glm::ivec2 size, const std::vector<int>& cuts,
                                        Progress& progress, const SheetIndices& sheets) {
  if (!scene.labels.data || !scene.labels.visible) return {};
  Walk walk(scene, cuts, sheets);
  std::vector<std::vector<StructureHit>> rows(std::size_t(size.y));
  for (int first = 0; first < size.y; first += kRowsAtATime) {
    progress.report(double(first) / size.y, "following rays");
    parallelFor(first, std::min(size.y, first + kRowsAtATime), [&](int y) {
      for (int x = 0; x < size.x; ++x)
        walkRay(walk, std::uint32_t(y) * std::uint32_t(size.x) + std::uint32_t(x),
                scene::rayFromPixel(scene.camera, size, {x + 0.5, y + 0.5}), rows[std::size_t(y)]);
    });
  }
  std::vector<StructureHit> hits;
  for (const auto& row : rows) hits.insert(hits.end(), row.begin(), row.end());
  return hits;
}

}  // namespace velum::render
