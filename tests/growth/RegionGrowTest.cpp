#include "growth/RegionGrow.h"

#include <gtest/gtest.h>

#include <thread>

#include "GrowOracle.h"
#include "RandomGrowing.h"
#include "core/Error.h"

namespace velum::growth {
namespace {

constexpr SampleType kTypes[] = {SampleType::UInt8,  SampleType::Int8,  SampleType::UInt16,  SampleType::Int16,
                                 SampleType::UInt32, SampleType::Int32, SampleType::Float32, SampleType::Float64};

/// How many voxels one has and the other has not.
std::size_t differences(const GrowOracle& oracle, const RegionGrow& region) {
  std::size_t count = 0;
  oracle.each([&](glm::ivec3 v) { count += oracle.has(v) != region.has(v); });
  return count;
}

struct Situation {
  explicit Situation(unsigned seed) : random(seed) {
    glm::ivec3 dims = random.dims();
    volume = random.volume(kTypes[seed % 8], dims, seed % 5 == 0 ? 3 : 1);
    labels = random.whole(0, 2) ? random.labels(*volume) : makeLabels(dims, [](glm::ivec3) { return 0; });
    rule.low = random.number(20, 60), rule.high = rule.low + random.number(5, 60);
    rule.within = random.whole(0, 3) == 0 ? 2 : 0;
    rule.channel = random.whole(0, volume->channels - 1);
    for (int i = random.whole(-2, 2); i > 0; --i)
      rule.barriers.push_back({{place(), place(), place()}, random.number(0.5, 4.0)});
    if (random.whole(0, 3) == 0) rule.steepest = random.number(3, 20);
  }
  glm::dvec3 place() { return glm::dvec3(volume->worldFromVoxel * glm::dvec4(random.voxel(volume->dims), 1.0)); }
  /// Not on a voxel's middle: there two ways to compute a depth of 0 may differ in the last bit.
  glm::dvec3 planePlace() { return place() + glm::dvec3(0.0123, 0.00711, 0.00537); }

  RandomGrowing random;
  Shared<Volume> volume;
  Shared<LabelVolume> labels;
  GrowRule rule;
};

TEST(RegionGrow, EqualsAPlainQueueHoweverPlanesMove) {
  std::size_t all = 0;
  for (unsigned seed = 0; seed < 160; ++seed) {
    Situation s(seed);
    GrowOracle oracle(*s.volume, *s.labels, 1, s.rule);
    RegionGrow region(s.volume, s.labels, 1, s.rule);
    ASSERT_EQ(differences(oracle, region), 0u);
    Progress progress;
    glm::dvec3 centre = s.planePlace(), axis = s.random.direction();
    for (int step = 0; step < 6; ++step) {
      if (s.random.whole(0, 3) == 0) centre = s.planePlace();
      if (s.random.whole(0, 4) == 0) axis = s.random.whole(0, 4) ? s.random.direction() : glm::dvec3(0.0);
      double distance = s.random.number(-2.0, 30.0);
      std::vector<glm::ivec3> seeds;
      for (int i = s.random.whole(-1, 2); i > 0; --i) seeds.push_back(s.random.voxel(s.volume->dims + 1));
      for (auto voxel : seeds) region.addSeed(voxel);
      std::size_t before = region.voxelCount(), added = region.grow({*s.volume, centre, axis, distance}, progress);
      region.forgetSeeds();
      oracle.step(seeds, centre, axis, distance);
      ASSERT_EQ(differences(oracle, region), 0u) << "seed " << seed << " step " << step;
      ASSERT_EQ(region.voxelCount(), oracle.count());
      // The seeds' own voxels have joined before.
      ASSERT_LE(region.voxelCount() - before, added);
    }
    all += oracle.count();
  }
  EXPECT_GT(all, 500000u) << "the situations are such that something grows";
}

TEST(RegionGrow, SlabsGiveWhatOneStepGives) {
  for (unsigned seed = 300; seed < 340; ++seed) {
    Situation s(seed);
    glm::dvec3 centre = s.place(), axis = s.random.direction();  // on a voxel's middle, so that depths of 0 occur
    glm::ivec3 start = s.random.voxel(s.volume->dims);
    Progress progress;
    RegionGrow once(s.volume, s.labels, 0, s.rule), slabs(s.volume, s.labels, 0, s.rule);
    once.addSeed(start), slabs.addSeed(start);
    double end = 12.0 * slabThickness(*s.volume);
    once.grow({*s.volume, centre, axis, end}, progress);
    for (int i = 1; i <= 12; ++i)
      slabs.grow({*s.volume, centre, axis, std::min(i * slabThickness(*s.volume), end)}, progress);
    // Back and forth again, as a hand does.
    slabs.grow({*s.volume, centre, axis, 0.3 * end}, progress);
    slabs.grow({*s.volume, centre, axis, end}, progress);
    ASSERT_EQ(once.voxelCount(), slabs.voxelCount());
    for (int z = 0; z < s.volume->dims.z; ++z)
      for (int y = 0; y < s.volume->dims.y; ++y)
        for (int x = 0; x < s.volume->dims.x; ++x) ASSERT_EQ(once.has({x, y, z}), slabs.has({x, y, z}));
  }
}

TEST(RegionGrow, GoesOnFromWhatLabelsHold) {
  for (unsigned seed = 400; seed < 430; ++seed) {
    Situation s(seed);
    Progress progress;
    glm::dvec3 centre = s.planePlace(), axis = s.random.direction();
    RegionGrow kept(s.volume, s.labels, 1, s.rule);
    kept.addSeed(s.random.voxel(s.volume->dims));
    kept.grow({*s.volume, centre, axis, 5.0}, progress);
    kept.forgetSeeds();
    LabelVolume written = makeLabels(
        s.volume->dims, [&](glm::ivec3 v) { return kept.has(v) ? 1 : int(s.labels->at(v)); }, s.volume->worldFromVoxel);
    RegionGrow anew(s.volume, written, 1, s.rule);
    ASSERT_EQ(anew.voxelCount(), kept.voxelCount());
    GrowDomain further(*s.volume, centre + axis, s.random.direction(), 20.0);
    EXPECT_EQ(anew.grow(further, progress), kept.grow(further, progress));
    for (int z = 0; z < s.volume->dims.z; ++z)
      for (int y = 0; y < s.volume->dims.y; ++y)
        for (int x = 0; x < s.volume->dims.x; ++x) ASSERT_EQ(anew.has({x, y, z}), kept.has({x, y, z}));
  }
}

TEST(RegionGrow, CancelledItGoesOnWithoutLoss) {
  Shared<Volume> volume(makeVolume({200, 300, 300}, SampleType::Int16, [](glm::ivec3 v) {
    // Walls with a gap at alternating ends make a long way.
    return v.z % 4 == 0 && (v.z % 8 == 0 ? v.y > 2 : v.y < 297) ? 0 : 1;
  }));
  Shared<LabelVolume> labels(LabelVolume(volume->dims, volume->worldFromVoxel));
  auto begin = [&] {
    RegionGrow region(volume, labels, 0, {1.0, 1.0});
    region.addSeed({0, 0, 1});
    return region;
  };
  Progress untroubled;
  RegionGrow whole = begin();
  std::size_t all = whole.grow({}, untroubled);
  RegionGrow region = begin();
  int cancelled = 0;
  for (bool isDone = false; !isDone;) {
    Progress progress;
    std::thread stop([&] {
      std::this_thread::sleep_for(std::chrono::microseconds(200 + 300 * cancelled));
      progress.cancel();
    });
    try {
      region.grow({}, progress);
      isDone = true;
    } catch (const Cancelled&) {
      ++cancelled;
    }
    stop.join();
    std::size_t count = 0;
    for (int z = 0; z < 300; z += 7)
      for (int y = 0; y < 300; ++y)
        count += region.word(y, z, 0) != 0;
    ASSERT_LE(count, region.voxelCount());
  }
  EXPECT_EQ(region.voxelCount(), all);
  EXPECT_EQ(region.countIn({}), all);
}

TEST(RegionGrow, CountsWhatLiesInADomain) {
  for (unsigned seed = 500; seed < 520; ++seed) {
    Situation s(seed);
    Progress progress;
    RegionGrow region(s.volume, s.labels, 1, s.rule);
    region.grow({}, progress);
    GrowDomain domain = GrowDomain(*s.volume, s.place(), s.random.direction(), 0.0).between(-4.0, 7.0);
    std::size_t count = 0;
    for (int z = 0; z < s.volume->dims.z; ++z)
      for (int y = 0; y < s.volume->dims.y; ++y)
        for (int x = 0; x < s.volume->dims.x; ++x) count += region.has({x, y, z}) && domain.contains({x, y, z});
    EXPECT_EQ(region.countIn(domain), count);
  }
}

TEST(RegionGrow, RefusesWhatMakesNoSense) {
  Shared<Volume> volume(makeVolume({4, 4, 4}, SampleType::UInt8, [](glm::ivec3) { return 1; }));
  Shared<LabelVolume> labels(LabelVolume(volume->dims, volume->worldFromVoxel));
  Shared<LabelVolume> other(LabelVolume({4, 4, 5}, volume->worldFromVoxel));
  EXPECT_THROW(RegionGrow(volume, other, 0, {0, 1}), ArgumentError);
  GrowRule rule{0, 1};
  rule.channel = 1;
  EXPECT_THROW(RegionGrow(volume, labels, 0, rule), ArgumentError);
  rule.channel = 0, rule.timeStep = -1;
  EXPECT_THROW(RegionGrow(volume, labels, 0, rule), ArgumentError);
  double nan = std::nan("");
  EXPECT_THROW(GrowDomain(*volume, {nan, 0, 0}, {0, 0, 1}, 1.0), ArgumentError);
  EXPECT_THROW(GrowDomain(*volume, {0, 0, 0}, {0, 0, 1}, nan), ArgumentError);
}

}  // namespace
}  // namespace velum::growth
