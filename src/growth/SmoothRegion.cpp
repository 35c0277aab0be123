#include "growth/SmoothRegion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/Error.h"
#include "core/FinestVoxels.h"
#include "core/Memory.h"
#include "core/Parallel.h"
#include "growth/Admission.h"
#include "growth/BoxBits.h"
#include "growth/GrowDomain.h"
#include "growth/LabelRows.h"
#include "growth/WriteRegion.h"

namespace velum::growth {

namespace {

/// Calls body(y, z) for each row of a volume. All cores.
template <class Body>
void forRows(glm::ivec3 dims, const Body& body) {
  parallelFor(0, dims.z, [&](int z) {
    for (int y = 0; y < dims.y; ++y) body(y, z);
  });
}

/// The bricks in which a structure has voxels, with a voxel around them where the grid goes on: what is outside is
/// joined to the grid's border.
VoxelBox boxHolding(const LabelVolume& labels, int structure) {
  constexpr int kEdge = LabelVolume::kBrickSize;
  VoxelBox box{labels.dims(), glm::ivec3(0)};
  glm::ivec3 grid = labels.brickGrid();
  for (glm::ivec3 at(0); at.z < grid.z; ++at.z)
    for (at.y = 0; at.y < grid.y; ++at.y)
      for (at.x = 0; at.x < grid.x; ++at.x) {
        const LabelVolume::Brick& ids = labels.brick(at);
        if (!holdsLabel(ids, structure)) continue;
        box.first = glm::min(box.first, at * kEdge);
        box.end = glm::max(box.end, (at + 1) * kEdge);
      }
  if (box.isEmpty()) return {};
  return {glm::max(box.first - 1, glm::ivec3(0)), glm::min(box.end + 1, labels.dims())};
}

/// @throw InputError where the machine has not the memory for the bits of a box
void expectRoomFor(const VoxelBox& box) {
  constexpr double kGrids = 8.0, kOfMemory = 0.5;  // that are held at a time, and of the memory
  glm::dvec3 size(box.end - box.first);
  double bytes = kGrids * size.x * size.y * size.z / 8.0;
  if (bytes > kOfMemory * machineBytes())
    throw InputError(fmt::format(
        "the structure reaches over a box of {} x {} x {} voxels, and to close it or to fill its holes takes "
        "{:.1f} GB of memory; leave that out, or grow it less far",
        size.x, size.y, size.z, bytes / 1e9));
}

BoxBits regionIn(const LabelVolume& labels, int structure, const VoxelBox& box) {
  BoxBits region(box);
  glm::ivec3 first = region.first();
  WordSpan words{region.firstWord(), region.firstWord() + region.bits().words()};
  forRows(region.bits().dims(), [&](int y, int z) {
    Word* bits = region.bits().row(y, z);
    labelBits(labels, first.y + y, first.z + z, std::uint16_t(structure), words, bits);
    bits[region.bits().words() - 1] &= spanBits(region.bits().words() - 1, 0, region.bits().dims().x);
  });
  return region;
}

/// Voxels that may join, whatever their values.
class Allowed {
 public:
  Allowed(const scene::Growth& step, const GrowDomain& domain, const Shared<Volume>& volume,
          const Shared<LabelVolume>& labels, const Shared<LabelVolume>& others)
      : mAdmission(volume, labels, ruleFor(step)), mDomain(domain), mOthers(others) {}

  /// More of a region joins it, where it may; nothing is looked at elsewhere.
  void join(BoxBits& region, const BitGrid& more) const {
    glm::ivec3 dims = mAdmission.grid().dims;
    forRows(more.dims(), [&](int y, int z) {
      Word* bits = region.bits().row(y, z);
      int gy = region.first().y + y, gz = region.first().z + z;
      RowSpan span = mDomain.rowSpan(gy, gz, dims.x);
      for (int w = 0; w < more.words(); ++w) {
        int inRow = region.firstWord() + w;
        Word left = more.row(y, z)[w] & ~bits[w] & spanBits(inRow, span.first, span.end), may = 0, others = 0;
        if (left == 0) continue;
        mAdmission.open(gy, gz, {inRow, inRow + 1}, &may);
        if (mOthers) labelBits(*mOthers, gy, gz, 1, {inRow, inRow + 1}, &others);
        bits[w] |= left & may & ~others;
      }
    });
  }

 private:
  static GrowRule ruleFor(const scene::Growth& step) {
    GrowRule rule = ruleOf(step);
    rule.low = -std::numeric_limits<double>::infinity();
    rule.high = rule.steepest = std::numeric_limits<double>::infinity();
    return rule;
  }
  Admission mAdmission;
  const GrowDomain& mDomain;
  Shared<LabelVolume> mOthers;
};

VoxelBox bitsBox(const BitGrid& grid) {
  VoxelBox box{grid.dims(), glm::ivec3(0)};
  for (int z = 0; z < grid.dims().z; ++z)
    for (int y = 0; y < grid.dims().y; ++y)
      for (int w = 0; w < grid.words(); ++w) {
        Word bits = grid.row(y, z)[w];
        if (bits == 0) continue;
        box.first = glm::min(box.first, glm::ivec3(w * kWordBits + std::countr_zero(bits), y, z));
        box.end = glm::max(box.end, glm::ivec3((w + 1) * kWordBits - std::countl_zero(bits), y + 1, z + 1));
      }
  return box;
}

/// The closing of a region, which lies in the box around it.
BitGrid closed(const BitGrid& region, const glm::dmat3& worldFromVoxel, double radius) {
  VoxelBox box = bitsBox(region);
  if (box.isEmpty()) return region;
  // With room around, so that no ball at the box's own voxels finds a border.
  std::vector<BallRow> ball = ballRows(worldFromVoxel, radius);
  glm::ivec3 room(0);
  for (const BallRow& row : ball) room = glm::max(room, glm::ivec3(std::max(-row.low, row.high), row.y, row.z));
  BitGrid part(box.end - box.first + 2 * room);
  auto forBox = [&](const auto& body) {
    for (int z = box.first.z; z < box.end.z; ++z)
      for (int y = box.first.y; y < box.end.y; ++y) body(y, z, y - box.first.y + room.y, z - box.first.z + room.z);
  };
  int shift = room.x - box.first.x;
  forBox([&](int y, int z, int py, int pz) {
    shiftRow(region.row(y, z), region.words(), shift, part.row(py, pz), part.words(), part.dims().x);
  });
  part = dilated(part, ball);
  part.invert();
  part = dilated(part, ball);
  part.invert();
  BitGrid out(region.dims());
  forBox([&](int y, int z, int py, int pz) {
    // Without the room, where balls do find a border.
    shiftRow(part.row(py, pz), part.words(), -shift, out.row(y, z), out.words(), out.dims().x);
    for (int w = 0; w < out.words(); ++w) out.row(y, z)[w] &= spanBits(w, box.first.x, box.end.x);
  });
  return out;
}

/// What of a domain is no part of the region, nor joined to the border.
BitGrid holesOf(const BoxBits& region, const GrowDomain& domain, int width) {
  BitGrid open = region.bits();
  glm::ivec3 first = region.first();
  open.invert();
  forRows(open.dims(), [&](int y, int z) {
    RowSpan span = domain.rowSpan(first.y + y, first.z + z, width);
    for (int w = 0; w < open.words(); ++w) open.row(y, z)[w] &= spanBits(w, span.first - first.x, span.end - first.x);
  });
  BitGrid outside = joinedToBorder(open);
  forRows(open.dims(), [&](int y, int z) {
    for (int w = 0; w < open.words(); ++w) open.row(y, z)[w] &= ~outside.row(y, z)[w];
  });
  return open;
}

/// No further than kMostClosingVoxels along any axis.
double radiusOf(const scene::Growth& step, const glm::dmat3& worldFromVoxel) {
  double most = step.closing;
  for (int axis = 0; axis < 3; ++axis) most = std::min(most, kMostClosingVoxels * glm::length(worldFromVoxel[axis]));
  return most;
}

RegionGrow::Changed changeOf(const BoxBits& region) {
  RegionGrow::Changed changed;
  changed.box = bitsBox(region.bits());
  changed.box.first += region.first(), changed.box.end += region.first();
  for (int z = changed.box.first.z; z < changed.box.end.z; ++z)
    for (int y = changed.box.first.y; y < changed.box.end.y; ++y) changed.rows.push_back({y, z});
  return changed;
}

}  // namespace

bool isSmoothed(const scene::Growth& step) { return step.closing > 0.0 || step.fillHoles; }

Smoothed smoothRegion(const Shared<Volume>& volume, const Shared<LabelVolume>& labels, const scene::Growth& step,
                      const Progress& progress, const Shared<LabelVolume>& others) {
  if (!isSmoothed(step)) return {labels, 0};
  VoxelBox box = boxHolding(*labels, step.structure);
  if (box.isEmpty()) return {labels, 0};
  expectRoomFor(box);
  FinestVoxels voxels(*volume);
  const Volume& grid = voxels.grid();
  BoxBits region = regionIn(*labels, step.structure, box);
  GrowDomain domain(grid, step.centre, step.axis, step.distance);
  Allowed allowed(step, domain, volume, labels, others);
  glm::dmat3 worldFromVoxel(grid.worldFromVoxel);
  if (step.closing > 0.0) allowed.join(region, closed(region.bits(), worldFromVoxel, radiusOf(step, worldFromVoxel)));
  progress.throwIfCancelled();
  if (step.fillHoles) allowed.join(region, holesOf(region, domain, grid.dims.x));
  progress.throwIfCancelled();
  LabelVolume out = *labels;
  Written written = writeRegion([&](int y, int z, int w) { return region.word(y, z, w); }, changeOf(region),
                                std::uint16_t(step.structure), out);
  if (written.voxels == 0) return {labels, 0};
  return {Shared<LabelVolume>(std::move(out)), written.voxels};
}

}  // namespace velum::growth
