#include "velum/extrusion/Grower.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "WriteRegion.h"
#include "velum/core/Clock.h"
#include "velum/core/Error.h"
#include "velum/extrusion/LeakGuard.h"

namespace velum::extrusion {

namespace {

/// Regions that are kept: more structures than a hand pulls at in turns.
constexpr std::size_t kMostKept = 4;

/// Least and largest depth of the volume.
glm::dvec2 depths(const Volume& volume, const GrowDomain& domain) {
  return domain.depthRange(glm::ivec3(0), volume.dims - 1);
}

void addSeeds(RegionGrow& region, const Volume& volume, const scene::Growth& step, const Shared<LabelVolume>& begun) {
  for (const auto& seed : step.seeds) region.addSeed(voxelAt(volume, seed));
  if (begun) region.addSeeds(*begun, step.structure);
}

double voxelSize(const Volume& volume) { return std::abs(glm::determinant(glm::dmat3(volume.worldFromVoxel))); }

/// Of a plane through the data across its axis, on the average.
double planeArea(const Volume& volume, const GrowDomain& domain) {
  glm::dvec2 range = depths(volume, domain);
  return double(voxelCount(volume)) * voxelSize(volume) / (range.y - range.x + domain.layer());
}

/// Area of what is joined to the seeds in the layer that lies under the cut.
double crossSection(const Shared<Volume>& volume, const Shared<LabelVolume>& labels, const scene::Growth& step,
                    const GrowDomain& domain, Progress& progress) {
  RegionGrow region(volume, labels, 0, ruleOf(step));
  addSeeds(region, *volume, step, {});
  GrowDomain layer = domain.between(-domain.layer(), 0.0);
  region.grow(layer, progress);
  return double(region.countIn(layer)) * voxelSize(*volume) / domain.layer();
}

/// Grows slab by slab, and tells a guard of each.
class SlabGrowth {
 public:
  SlabGrowth(RegionGrow& region, const Volume& volume, const GrowDomain& domain)
      : mRegion(region),
        mDomain(domain),
        mThickness(slabThickness(volume)),
        mVoxelSize(voxelSize(volume)),
        mBegin(std::floor(std::max(depths(volume, domain).x, 0.0) / mThickness) * mThickness),
        mEnd(std::min(domain.distance(), depths(volume, domain).y)) {}

  /// @param guard  may be null  @return the leak before which it has stopped; then the region has leaked
  std::optional<Leak> grow(LeakGuard* guard, Progress& progress) {
    // The first has the seeds, even where the plane removes nothing.
    for (mSlabs = 1;; ++mSlabs) {
      double end = std::min(mBegin + mSlabs * mThickness, mEnd);
      std::size_t added = mRegion.grow(mDomain.upTo(end), progress);
      if (guard)
        if (auto leak = look(*guard, end, added)) return leak;
      if (!(end < mEnd)) return std::nullopt;
      progress.report(std::clamp(end / mEnd, 0.0, 1.0), "Growing");
    }
  }
  int slabs() const { return mSlabs; }
  /// Where the slab before the last one ended.
  double safe() const { return mBegin + (mSlabs - 1) * mThickness; }

 private:
  std::optional<Leak> look(LeakGuard& guard, double end, std::size_t added) {
    if (mSlabs == 1) guard.beginAs(areaOfFirstLayer());
    // What leaks comes back into the slabs before, too; what was there before the step has not joined in it.
    std::size_t voxels = std::max(added, mRegion.countIn(mDomain.between(end - mThickness, end)));
    Leak leak{end, double(voxels) * mVoxelSize / mThickness, guard.expected()};
    bool leaks = guard.leaks(leak.area, added);
    return leaks ? std::optional(leak) : std::nullopt;
  }

  double areaOfFirstLayer() const {
    std::size_t voxels = mRegion.countIn(mDomain.between(mBegin, mBegin + mDomain.layer()));
    return double(voxels) * mVoxelSize / mDomain.layer();
  }

  RegionGrow& mRegion;
  const GrowDomain& mDomain;
  double mThickness, mVoxelSize;
  double mBegin, mEnd;  ///< no slab is empty because the plane is far from the data
  int mSlabs = 0;
};

void check(const scene::Growth& step) {
  if (step.structure < 1 || step.structure > 65535)
    throw ArgumentError(fmt::format("structure {} to grow: give a label from 1 to 65535", step.structure));
  if (step.within < 0 || step.within > 65535)
    throw ArgumentError(fmt::format("structure {} to grow within: give a label from 0 to 65535", step.within));
}

void addToTable(LabelVolume& labels, int structure) {
  auto place = std::lower_bound(labels.table.begin(), labels.table.end(), structure,
                                [](const LabelInfo& info, int id) { return info.id < id; });
  if (place != labels.table.end() && place->id == structure) return;
  auto id = std::uint16_t(structure);
  labels.table.insert(place, {id, fmt::format("structure {}", id), defaultLabelColor(id), 1.0f});
}

}  // namespace

std::list<Grower::Kept>::iterator Grower::keep(const Shared<Volume>& volume, const Shared<LabelVolume>& labels,
                                               const scene::Growth& step) {
  GrowRule rule = ruleOf(step);
  auto kept = std::find_if(mKept.begin(), mKept.end(), [&](const Kept& k) {
    return k.volume == volume && k.structure == step.structure && k.region.rule() == rule;
  });
  if (kept != mKept.end() && kept->region.follow(labels)) {
    mKept.splice(mKept.begin(), mKept, kept);
    return mKept.begin();
  }
  if (kept != mKept.end()) mKept.erase(kept);
  mKept.push_front({volume, step.structure, RegionGrow(volume, labels, step.structure, std::move(rule))});
  if (mKept.size() > kMostKept) mKept.pop_back();
  return mKept.begin();
}

Grown Grower::grow(const Shared<Volume>& volume, const Shared<LabelVolume>& before, const scene::Growth& step,
                   const GrowOptions& options, Progress& progress) {
  check(step);
  auto start = Clock::now();
  GrowDomain domain(*volume, step.centre, step.axis, step.distance);
  Grown grown;
  grown.labels = before;
  grown.distance = step.distance;
  auto kept = keep(volume, before, step);
  try {
    addSeeds(kept->region, *volume, step, options.begun);
    SlabGrowth slabs(kept->region, *volume, domain);
    if (domain.isEverywhere()) {
      kept->region.grow(domain, progress);
      grown.slabs = 1;
    } else {
      bool isGuarded = options.guard;
      LeakGuard guard(isGuarded ? crossSection(volume, before, step, domain, progress) : 0.0,
                      planeArea(*volume, domain));
      grown.leak = slabs.grow(isGuarded ? &guard : nullptr, progress);
      grown.slabs = slabs.slabs();
    }
    if (grown.leak) {
      // Begun anew, it stops before the slab.
      grown.distance = slabs.safe();
      kept->region = RegionGrow(volume, before, step.structure, ruleOf(step));
      addSeeds(kept->region, *volume, step, options.begun);
      kept->region.grow(domain.upTo(grown.distance), progress);
    }
    kept->region.forgetSeeds();
    // Write what is new.
    LabelVolume labels = *before;
    Written written = writeRegion([&region = kept->region](int y, int z) { return region.row(y, z); },
                                  kept->region.takeChanged(), std::uint16_t(step.structure), labels);
    grown.box = written.box;
    grown.voxels = written.voxels;
    if (grown.voxels > 0) {
      addToTable(labels, step.structure);
      grown.labels = Shared<LabelVolume>(std::move(labels));
      kept->region.adopt(grown.labels);
    }
  } catch (...) {
    // It is no longer as the labels are.
    mKept.erase(kept);
    throw;
  }
  grown.ms = msSince(start);
  return grown;
}

}  // namespace velum::extrusion
