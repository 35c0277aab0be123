#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "Data.h"
#include "ItkGrow.h"
#include "Sections.h"
#include "core/Clock.h"
#include "core/Error.h"
#include "core/LabelVolume.h"
#include "core/Parallel.h"
#include "growth/Grower.h"
#include "io/volumes/ReadVolume.h"

namespace velum::bench {

namespace {

using growth::GrowDomain;
using growth::RegionGrow;

Shared<LabelVolume> noLabels(const Volume& volume) { return LabelVolume(volume.dims, volume.worldFromVoxel); }

/// The same values as other samples.
template <class T>
Volume withSamples(const Volume& from, SampleType type) {
  Volume to = from;
  to.type = type;
  to.voxels = Bytes(voxelCount(to) * sizeof(T));
  visitSamples(from, [&](auto* in) {
    auto* out = reinterpret_cast<T*>(to.voxels.data());
    parallelFor(std::size_t(0), std::size_t(to.dims.z), [&](std::size_t z) {
      std::size_t layer = voxelCount(to) / std::size_t(to.dims.z);
      std::transform(in + z * layer, in + (z + 1) * layer, out + z * layer, [](auto v) { return T(v); });
    });
  });
  return to;
}

struct Region {
  std::string name;
  Shared<Volume> volume;
  double low, high;
};

/// From the middle along x the first voxel that belongs to it.
glm::ivec3 seedOf(const Region& region) {
  glm::ivec3 seed = region.volume->dims / 2;
  for (; seed.x + 1 < region.volume->dims.x; ++seed.x)
    if (double value = valueAt(*region.volume, seed); value >= region.low && value <= region.high) break;
  return seed;
}

struct Ours {
  Timing timing;
  double bitsPerVoxel = 0.0, visitsPerRow = 0.0;
};

Ours growOurs(const Region& region, glm::ivec3 seed) {
  Progress progress;
  Shared<LabelVolume> labels = noLabels(*region.volume);
  auto start = Clock::now();
  RegionGrow grown(region.volume, labels, 0, {region.low, region.high});
  grown.addSeed(seed);
  std::size_t voxels = grown.grow({}, progress);
  Ours ours{{msSince(start), voxels}};
  glm::dvec3 dims(region.volume->dims);
  ours.bitsPerVoxel = 8.0 * double(grown.bytes()) / (dims.x * dims.y * dims.z);
  ours.visitsPerRow = double(grown.visits()) / (dims.y * dims.z);
  return ours;
}

class RegionTable {
 public:
  void add(Report& report, const Region& region, int turns) {
    glm::ivec3 seed = seedOf(region);
    Timing itk = growWithItk(*region.volume, seed, region.low, region.high);
    std::vector<double> ms;
    Ours ours;
    // The first also wakes the threads and gets memory from the system.
    for (int turn = 0; turn < turns; ++turn) {
      ours = growOurs(region, seed);
      ms.push_back(ours.timing.ms);
    }
    if (ours.timing.voxels != itk.voxels)
      throw InputError(fmt::format("{}: {} voxels grown, {} by ITK", region.name, ours.timing.voxels, itk.voxels));
    double typical = median(ms);
    const glm::ivec3& d = region.volume->dims;
    mRows.push_back({region.name, fmt::format("{} x {} x {}", d.x, d.y, d.z), fmt::format("{:.2f}", itk.voxels / 1e6),
                     formatMs(itk.ms), formatMs(ms.front()), formatMs(typical), fmt::format("{:.0f}", itk.ms / typical),
                     fmt::format("{:.0f}", double(itk.voxels) / typical / 1e3),
                     fmt::format("{:.2f}", ours.bitsPerVoxel), fmt::format("{:.2f}", ours.visitsPerRow)});
    report.figure(region.name, {{"voxels", itk.voxels},
                                {"itkMs", itk.ms},
                                {"firstMs", ms.front()},
                                {"medianMs", typical},
                                {"ratio", itk.ms / typical},
                                {"bitsPerVoxel", ours.bitsPerVoxel}});
  }
  void write(Report& report) const {
    report.table({"region", "volume", "million voxels", "ITK", "ours, first", "ours, median", "times faster",
                  "million voxels/s", "bits a voxel", "visits a row"},
                 mRows);
  }

 private:
  std::vector<std::vector<std::string>> mRows;
};

void measureRegions(const Options& options, Report& report) {
  RegionTable table;
  int turns = options.quick ? 3 : 7;
  // Both are joined all through: what is between the gyroid's walls, and a shell.
  for (int n : options.quick ? std::vector<int>{128, 256} : std::vector<int>{128, 256, 512, 960}) {
    Shared<Volume> shells(makeShells(n));
    table.add(report, {fmt::format("between walls, {}", n), shells, 70, 90}, turns);
    table.add(report, {fmt::format("shell, {}", n), shells, 200, 255}, turns);
    if (n != 256) continue;
    table.add(report, {"the same in 16 bits", withSamples<std::int16_t>(*shells, SampleType::Int16), 70, 90}, turns);
    table.add(report, {"the same in floats", withSamples<float>(*shells, SampleType::Float32), 70, 90}, turns);
  }
  const char* cranium = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3";
  if (std::filesystem::exists(cranium)) {
    scene::Source source;
    source.path = cranium;
    Progress progress;
    Volume volume = io::readVolume(source, progress);
    if (volume.scale == 1.0 && volume.offset == 0.0 && volume.channels == 1) {
      Shared<Volume> head(std::move(volume));
      table.add(report, {"CT head, soft tissue", head, -100, 200}, turns);
      table.add(report, {"CT head, bone", head, 250, 4000}, turns);
    }
  }
  table.write(report);
}

/// A tube along z whose slabs hold about so many voxels as those of [ACS] 5.3, and air all around.
Shared<Volume> makeTube() {
  Volume volume = makeShells(32);
  volume.dims = {512, 512, 256};
  volume.type = SampleType::Int16;
  volume.worldFromVoxel = glm::dmat4(1.0);
  volume.voxels = Bytes(voxelCount(volume) * sizeof(std::int16_t));
  auto* out = reinterpret_cast<std::int16_t*>(volume.voxels.data());
  for (int z = 0; z < volume.dims.z; ++z)
    for (int y = 0; y < volume.dims.y; ++y)
      for (int x = 0; x < volume.dims.x; ++x) {
        double dx = x - 256 - 10 * std::sin(z * 0.05), dy = y - 200;
        *out++ = dx * dx + dy * dy < 33.5 * 33.5 ? 300 : -1000;
      }
  return volume;
}

struct Slabs {
  std::vector<double> ms;
  std::size_t voxels = 0;  ///< of a slab
};

/// Slabs of one region, the front kept between them. @param thickness  of each
Slabs growSlabs(const Shared<Volume>& volume, glm::dvec3 axis, double thickness, int count) {
  Progress progress;
  RegionGrow region(volume, noLabels(*volume), 0, {200, 400});
  glm::dvec3 centre(256, 200, 19.5);
  region.addSeed({256, 200, 20});
  Slabs slabs;
  for (int i = 1; i <= count; ++i) {
    auto start = Clock::now();
    slabs.voxels += region.grow(GrowDomain(*volume, centre, axis, i * thickness), progress);
    slabs.ms.push_back(msSince(start));
  }
  slabs.voxels /= std::size_t(count);
  return slabs;
}

/// The same as steps of a drag, with the labels that they make.
Slabs growSteps(const Shared<Volume>& volume, double thickness, int count) {
  Progress progress;
  growth::Grower grower;
  Shared<LabelVolume> labels = noLabels(*volume);
  scene::Growth step;
  step.structure = 1;
  step.seeds = {{256, 200, 20}};
  step.low = 200, step.high = 400;
  step.centre = {256, 200, 19.5}, step.axis = {0, 0, 1};
  Slabs slabs;
  for (int i = 1; i <= count; ++i) {
    step.distance = i * thickness;
    auto grown = grower.grow(volume, labels, step, {}, progress);
    labels = grown.labels;
    slabs.ms.push_back(grown.ms);
    slabs.voxels += grown.voxels / std::size_t(count);
  }
  return slabs;
}

/// Four layers of 512 x 512 voxels of air, each time as the first slab of another region.
Slabs growAir(int count) {
  Volume air = makeShells(32);
  air.dims = {512, 512, 32};
  air.type = SampleType::Int16;
  air.voxels = Bytes(voxelCount(air) * sizeof(std::int16_t));
  std::fill_n(reinterpret_cast<std::int16_t*>(air.voxels.data()), voxelCount(air), std::int16_t(-1000));
  air.worldFromVoxel = glm::dmat4(1.0);
  Shared<Volume> volume(std::move(air));
  Shared<LabelVolume> labels = noLabels(*volume);
  Progress progress;
  Slabs slabs;
  for (int i = 0; i < count; ++i) {
    auto start = Clock::now();
    RegionGrow region(volume, labels, 0, {-1100, -900});
    region.addSeed({256, 256, 0});
    slabs.voxels = region.grow(GrowDomain(*volume, {0, 0, -0.5}, {0, 0, 1}, 4.0), progress);
    slabs.ms.push_back(msSince(start));
  }
  return slabs;
}

void measureSlabs(Report& report) {
  std::vector<std::vector<std::string>> rows;
  auto add = [&](const char* name, const Slabs& slabs, const char* paper) {
    double worst = *std::max_element(slabs.ms.begin(), slabs.ms.end());
    rows.push_back({name, fmt::format("{}", slabs.voxels), fmt::format("{:.3f}", median(slabs.ms)),
                    fmt::format("{:.3f}", slabs.ms.front()), fmt::format("{:.3f}", worst), paper});
    report.figure(name, {{"voxels", slabs.voxels}, {"medianMs", median(slabs.ms)}, {"worstMs", worst}});
  };
  Shared<Volume> tube = makeTube();
  double thickness = growth::slabThickness(*tube);
  add("a slab of a tube", growSlabs(tube, {0, 0, 1}, thickness, 60), "8 to 12 ms");
  add("the same, oblique", growSlabs(tube, {0.3, 0.2, 1.0}, thickness, 50), "8 to 12 ms");
  add("a step of a drag, with its labels", growSteps(tube, thickness, 60), "8 to 12 ms");
  add("air, 4 layers of 512 x 512", growAir(15), "190 ms (958K voxels)");
  report.table({"slab", "voxels", "median, ms", "first", "worst", "paper"}, rows);
}

}  // namespace

void measureGrowing(const Options& options, Report& report) {
  report.section("growing", "Growing regions");
  report.note(
      "Regions joined by faces from one seed, against itk::ConnectedThresholdImageFilter (the filter alone, on one "
      "core, as it has it), in the same run; ours on all cores, with all that is made for it. Both find the same "
      "voxels.");
  measureRegions(options, report);
  report.note("Slabs two voxel diagonals thick, as a hand pulls a structure out of a cut; beside the paper's figures.");
  measureSlabs(report);
}

}  // namespace velum::bench
