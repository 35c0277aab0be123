#include "growth/SmoothRegion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/Parallel.h"
#include "growth/Admission.h"
#include "growth/BitGrid.h"
#include "growth/GrowDomain.h"
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

BitGrid regionIn(const LabelVolume& labels, int structure) {
  BitGrid region(labels.dims());
  forRows(labels.dims(), [&](int y, int z) { labelBits(labels, y, z, std::uint16_t(structure), region.row(y, z)); });
  return region;
}

void keepInside(const GrowDomain& domain, int y, int z, BitGrid& grid) {
  RowSpan span = domain.rowSpan(y, z, grid.dims().x);
  for (int w = 0; w < grid.words(); ++w) grid.row(y, z)[w] &= spanBits(w, span.first, span.end);
}

/// Voxels that may join, whatever their values.
BitGrid allowedTo(const scene::Growth& step, const GrowDomain& domain, const Shared<Volume>& volume,
                  const Shared<LabelVolume>& labels) {
  GrowRule rule = ruleOf(step);
  rule.low = -std::numeric_limits<double>::infinity();
  rule.high = rule.steepest = std::numeric_limits<double>::infinity();
  Admission admission(volume, labels, rule);
  BitGrid allowed(volume->dims);
  forRows(volume->dims, [&](int y, int z) {
    admission.open(y, z, allowed.row(y, z));
    keepInside(domain, y, z, allowed);
  });
  return allowed;
}

VoxelBox boxOf(const BitGrid& grid) {
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
  VoxelBox box = boxOf(region);
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
BitGrid holesOf(const BitGrid& region, const GrowDomain& domain) {
  BitGrid open = region;
  open.invert();
  forRows(region.dims(), [&](int y, int z) { keepInside(domain, y, z, open); });
  BitGrid outside = joinedToBorder(open);
  forRows(region.dims(), [&](int y, int z) {
    for (int w = 0; w < open.words(); ++w) open.row(y, z)[w] &= ~outside.row(y, z)[w];
  });
  return open;
}

void join(BitGrid& region, const BitGrid& more, const BitGrid& allowed) {
  forRows(region.dims(), [&](int y, int z) {
    for (int w = 0; w < region.words(); ++w) region.row(y, z)[w] |= more.row(y, z)[w] & allowed.row(y, z)[w];
  });
}

void takeAway(const BitGrid& what, BitGrid& from) {
  forRows(from.dims(), [&](int y, int z) {
    for (int w = 0; w < from.words(); ++w) from.row(y, z)[w] &= ~what.row(y, z)[w];
  });
}

/// No further than kMostClosingVoxels along any axis.
double radiusOf(const scene::Growth& step, const glm::dmat3& worldFromVoxel) {
  double most = step.closing;
  for (int axis = 0; axis < 3; ++axis) most = std::min(most, kMostClosingVoxels * glm::length(worldFromVoxel[axis]));
  return most;
}

RegionGrow::Changed changeOf(const BitGrid& region) {
  RegionGrow::Changed changed;
  changed.box = boxOf(region);
  for (int z = changed.box.first.z; z < changed.box.end.z; ++z)
    for (int y = changed.box.first.y; y < changed.box.end.y; ++y) changed.rows.push_back({y, z});
  return changed;
}

}  // namespace

bool isSmoothed(const scene::Growth& step) { return step.closing > 0.0 || step.fillHoles; }

Smoothed smoothRegion(const Shared<Volume>& volume, const Shared<LabelVolume>& labels, const scene::Growth& step,
                      const Progress& progress, const Shared<LabelVolume>& others) {
  if (!isSmoothed(step)) return {labels, 0};
  BitGrid region = regionIn(*labels, step.structure);
  GrowDomain domain(*volume, step.centre, step.axis, step.distance);
  BitGrid allowed = allowedTo(step, domain, volume, labels);
  if (others) takeAway(regionIn(*others, 1), allowed);
  glm::dmat3 worldFromVoxel(volume->worldFromVoxel);
  if (step.closing > 0.0) join(region, closed(region, worldFromVoxel, radiusOf(step, worldFromVoxel)), allowed);
  progress.throwIfCancelled();
  if (step.fillHoles) join(region, holesOf(region, domain), allowed);
  progress.throwIfCancelled();
  LabelVolume out = *labels;
  Written written =
      writeRegion([&](int y, int z) { return region.row(y, z); }, changeOf(region), std::uint16_t(step.structure), out);
  if (written.voxels == 0) return {labels, 0};
  return {Shared<LabelVolume>(std::move(out)), written.voxels};
}

}  // namespace velum::growth
