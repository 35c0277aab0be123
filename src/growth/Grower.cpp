#include "growth/Grower.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/Clock.h"
#include "core/Error.h"
#include "core/FinestVoxels.h"
#include "growth/LeakGuard.h"
#include "growth/OwnPart.h"
#include "growth/SolidPart.h"
#include "growth/WriteRegion.h"

namespace velum::growth {

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

/// Of the voxels of a region in a domain, what share is inside of something solid.
double solidShare(const RegionGrow& region, const Volume& volume, const GrowDomain& known, const GrowDomain& where) {
  std::size_t count = region.countIn(where);
  return count == 0 ? 0.0 : double(countSolid(region, volume.dims, known, where)) / double(count);
}

/// What is joined to the seeds in a layer.
Section sectionIn(const GrowDomain& layer, const Shared<Volume>& volume, const Shared<LabelVolume>& labels,
                  const scene::Growth& step, Progress& progress) {
  FinestVoxels voxels(*volume);
  const Volume& grid = voxels.grid();
  RegionGrow region(volume, labels, 0, ruleOf(step));
  addSeeds(region, grid, step, {});
  region.grow(layer, progress);
  double area = double(region.countIn(layer)) * voxelSize(grid) / layer.layer();
  return {area, area, area * solidShare(region, grid, layer, layer)};
}

/// What is joined to the seeds in the layer that lies under the cut; where nothing of it does, in their own.
Section crossSection(const Shared<Volume>& volume, const Shared<LabelVolume>& labels, const scene::Growth& step,
                     const GrowDomain& domain, Progress& progress) {
  Section section = sectionIn(domain.between(-domain.layer(), 0.0), volume, labels, step, progress);
  if (section.area > 0.0 || step.seeds.empty()) return section;
  double depth = domain.depth(voxelAt(FinestVoxels(*volume).grid(), step.seeds.front()));
  return sectionIn(domain.between(depth - domain.layer(), depth), volume, labels, step, progress);
}

/// Grows slab by slab, and tells a guard of each.
class SlabGrowth {
 public:
  /// @param done  depth to which it has grown from the same seeds; of what lies there the last slabs are looked at
  /// again
  SlabGrowth(RegionGrow& region, const Volume& volume, const GrowDomain& domain, double done)
      : mRegion(region),
        mVolume(volume),
        mDomain(domain),
        mThickness(slabThickness(volume)),
        mVoxelSize(voxelSize(volume)),
        mBegin(std::floor(std::max(depths(volume, domain).x, 0.0) / mThickness) * mThickness),
        mEnd(std::min(domain.distance(), depths(volume, domain).y)),
        mSlabs(std::max(int((std::min(done, mEnd) - mBegin) / mThickness) - int(LeakGuard::kSlabsBefore), 0)) {}

  /// @param guard  may be null  @return the leak before which it has stopped; then the region has leaked
  std::optional<Leak> grow(LeakGuard* guard, Progress& progress) {
    // The first has the seeds, even where the plane removes nothing.
    while (true) {
      ++mSlabs;
      double end = std::min(mBegin + mSlabs * mThickness, mEnd);
      std::size_t before = guard ? mRegion.countIn(mDomain.between(safe(), end)) : 0;
      std::size_t added = mRegion.grow(mDomain.upTo(end), progress);
      if (guard)
        if (auto leak = look(*guard, end, added, before)) return leak;
      if (!(end < mEnd)) return std::nullopt;
      progress.report(std::clamp(end / mEnd, 0.0, 1.0), "Growing");
    }
  }
  int slabs() const { return mSlabs; }
  bool beginsAtCut() const { return mSlabs == 0; }
  /// Where the slab before the last one ended.
  double safe() const { return mBegin + (mSlabs - 1) * mThickness; }

 private:
  std::optional<Leak> look(LeakGuard& guard, double end, std::size_t added, std::size_t before) {
    GrowDomain known = mDomain.upTo(end);
    GrowDomain first = mDomain.between(mBegin, mBegin + mDomain.layer());
    if (mSlabs == 1) guard.beginAs(sectionOf(first, mDomain.layer(), known));
    GrowDomain slab = mDomain.between(safe(), end);
    // A drag may have come to a part of it only. Its layers are counted up, as voxels are in one or the other.
    double layers = std::ceil((end - safe()) / mDomain.layer() - 1e-9) * mDomain.layer();
    Section section = sectionOf(slab, std::min(std::max(layers, mDomain.layer()), mThickness), known);
    // What leaks comes back into the slabs before, too; what was there before the step has not joined in it.
    std::size_t forward = mRegion.countIn(slab) - before, back = added - std::min(added, forward);
    double returned = double(back) * mVoxelSize / mThickness;
    section.joined += returned;
    if (returned > section.area) section.solid = section.area * solidShare(mRegion, mVolume, known, known);
    Leak leak{end, guard.width(section), guard.expected()};
    return guard.leaks(section, added) ? std::optional(leak) : std::nullopt;
  }

  Section sectionOf(const GrowDomain& slab, double thickness, const GrowDomain& known) const {
    double area = double(mRegion.countIn(slab)) * mVoxelSize / thickness;
    return {area, area, area * solidShare(mRegion, mVolume, known, slab)};
  }

  RegionGrow& mRegion;
  const Volume& mVolume;
  const GrowDomain& mDomain;
  double mThickness, mVoxelSize;
  double mBegin, mEnd;  ///< no slab is empty because the plane is far from the data
  int mSlabs;           ///< looked at, or passed over
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

/// True when a step begins with what has been grown, and may go on from there.
bool Grower::Kept::hasDone(const scene::Growth& step) const {
  if (!last) return false;
  scene::Growth done = *last;
  done.distance = step.distance;
  return done == step && last->distance <= step.distance;
}

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
  mKept.push_front({volume, step.structure, RegionGrow(volume, labels, step.structure, std::move(rule)), {}});
  if (mKept.size() > kMostKept) mKept.pop_back();
  return mKept.begin();
}

/// All that it may take, then what of that is its own.
void Grower::divide(const Shared<Volume>& volume, const Shared<LabelVolume>& before, const scene::Growth& step,
                    const GrowOptions& options, Grown& grown, Progress& progress) const {
  FinestVoxels voxels(*volume);
  GrowDomain domain(voxels.grid(), step.centre, step.axis, step.distance);
  RegionGrow region(volume, before, step.structure, ruleOf(step));
  addSeeds(region, voxels.grid(), step, options.begun);
  region.grow(domain, progress);
  RegionGrow::Changed changed = region.takeChanged();
  auto part = ownPartOf(region, *volume, *before, step, domain, options, progress);
  if (part) grown.others = part->others;
  auto word = [&](int y, int z, int w) { return part ? part->own.word(y, z, w) : region.word(y, z, w); };
  LabelVolume labels = *before;
  Written written = writeRegion(word, changed, std::uint16_t(step.structure), labels);
  grown.slabs = 1;
  grown.box = written.box;
  grown.voxels = written.voxels;
  if (grown.voxels == 0) return;
  addToTable(labels, step.structure);
  grown.labels = Shared<LabelVolume>(std::move(labels));
}

Grown Grower::grow(const Shared<Volume>& volume, const Shared<LabelVolume>& before, const scene::Growth& step,
                   const GrowOptions& options, Progress& progress) {
  check(step);
  auto start = Clock::now();
  FinestVoxels voxels(*volume);
  const Volume& grid = voxels.grid();
  GrowDomain domain(grid, step.centre, step.axis, step.distance);
  Grown grown;
  grown.labels = before;
  grown.distance = step.distance;
  if (!step.others.empty() || options.othersBegun) {
    divide(volume, before, step, options, grown, progress);
    grown.ms = msSince(start);
    return grown;
  }
  auto kept = keep(volume, before, step);
  try {
    addSeeds(kept->region, grid, step, options.begun);
    double done = kept->hasDone(step) && !options.begun ? kept->last->distance : 0.0;
    SlabGrowth slabs(kept->region, grid, domain, done);
    if (domain.isEverywhere()) {
      kept->region.grow(domain, progress);
      grown.slabs = 1;
    } else {
      bool isGuarded = options.guard;
      bool hasSection = isGuarded && slabs.beginsAtCut();
      LeakGuard guard(hasSection ? crossSection(volume, before, step, domain, progress) : Section(),
                      planeArea(grid, domain));
      grown.leak = slabs.grow(isGuarded ? &guard : nullptr, progress);
      grown.slabs = slabs.slabs();
    }
    if (grown.leak) {
      // Begun anew, it stops before the slab.
      grown.distance = slabs.safe();
      kept->region = RegionGrow(volume, before, step.structure, ruleOf(step));
      addSeeds(kept->region, grid, step, options.begun);
      kept->region.grow(domain.upTo(grown.distance), progress);
    }
    kept->last = grown.leak ? std::nullopt : std::optional(step);
    kept->region.forgetSeeds();
    // Write what is new.
    LabelVolume labels = *before;
    Written written = writeRegion([&region = kept->region](int y, int z, int w) { return region.word(y, z, w); },
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

}  // namespace velum::growth
