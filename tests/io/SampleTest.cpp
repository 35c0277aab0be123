#include <cmath>

#include "SampleParts.h"
#include "core/Error.h"

namespace velum {
namespace {

class EverySample : public testing::TestWithParam<std::string> {};

TEST_P(EverySample, TheSameNameGivesTheSameBytes) {
  // 40 voxels: the law does not depend on the size.
  io::Sample a = make(GetParam(), 40), b = make(GetParam(), 40);
  EXPECT_TRUE(a.volume.voxels == b.volume.voxels);
  EXPECT_TRUE(idsOf(a.labels) == idsOf(b.labels));
  EXPECT_EQ(a.volume.range, b.volume.range);
}

TEST_P(EverySample, VolumeAndLabelsShareTheGrid) {
  const io::Sample& s = cached(GetParam());
  EXPECT_EQ(s.labels.dims(), s.volume.dims);
  EXPECT_EQ(s.labels.worldFromVoxel(), s.volume.worldFromVoxel);
  EXPECT_EQ(std::max({s.volume.dims.x, s.volume.dims.y, s.volume.dims.z}), kSize);
  EXPECT_EQ(s.volume.voxels.size(), timeStepBytes(s.volume) * std::size_t(s.volume.timeSteps));
  EXPECT_EQ(s.volume.name, GetParam());
  EXPECT_LT(s.volume.range.x, s.volume.range.y);
  // The grid stands around the world's origin; a billionth of its size is rounding.
  EXPECT_LT(glm::length(centreOf(s.volume)), 1e-9 * radiusOf(s.volume));
}

TEST_P(EverySample, TheTableListsExactlyTheLabelsInUse) {
  const io::Sample& s = cached(GetParam());
  std::vector<std::uint16_t> listed;
  for (const auto& info : s.labels.table) {
    listed.push_back(info.id);
    EXPECT_FALSE(info.name.empty());
  }
  EXPECT_EQ(listed, s.labels.idsInUse());
}

TEST(Torso, EveryPartIsFoundFromSixtyFourVoxelsOn) { EXPECT_EQ(make("torso", 64).labels.table.size(), 42u); }

TEST_P(EverySample, CancellingStopsIt) {
  Progress* running = nullptr;
  Progress progress([&](double fraction, const std::string&) {
    if (fraction > 0.0) running->cancel();
  });
  running = &progress;
  EXPECT_THROW(io::makeSample(GetParam(), 64, progress), Cancelled);
}

std::vector<std::string> names() {
  std::vector<std::string> out;
  for (const auto& info : io::samples()) out.emplace_back(info.name);
  return out;
}
INSTANTIATE_TEST_SUITE_P(All, EverySample, testing::ValuesIn(names()), [](const auto& instance) {
  std::string name = instance.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(Sample, UnknownNamesAndSizesAreRefused) {
  Progress progress;
  EXPECT_THROW(io::makeSample("teapot", 64, progress), ArgumentError);
  EXPECT_THROW(io::makeSample("torso", 15, progress), ArgumentError);
  EXPECT_THROW(io::makeSample("torso", 1025, progress), ArgumentError);
  EXPECT_THROW(io::makeSample("torso", -1, progress), ArgumentError);
  EXPECT_THROW(io::makeSample("torso", 32, progress, 2), ArgumentError) << "it does not move";
  EXPECT_THROW(io::makeSample("heart", 32, progress, 101), ArgumentError);
  EXPECT_THROW(io::makeSample("heart", 32, progress, -1), ArgumentError);
}

TEST(TwoSpheres, HaveTheVolumeOfASphere) {
  const io::Sample& s = cached("two-spheres");
  double voxel = 128.0 / kSize, radius = 26.0, pi = 3.14159265358979;
  // The count of lattice points in a sphere differs from its volume by far less than a shell one voxel thick.
  double shell = 4.0 * pi * radius * radius * voxel;
  for (const char* name : {"upper sphere", "lower sphere"}) {
    double volume = double(measure(s, name).count) * voxel * voxel * voxel;
    EXPECT_NEAR(volume, 4.0 / 3.0 * pi * radius * radius * radius, 0.1 * shell);
  }
  EXPECT_NEAR(measure(s, "upper sphere").centre.z, 14.0, voxel);
  EXPECT_NEAR(measure(s, "lower sphere").centre.z, -14.0, voxel);
}

TEST(Vessels, EachTreeHangsTogether) {
  EXPECT_GE(connectedPart(cached("vessels"), "arterial tree"), 0.99);
  EXPECT_GE(connectedPart(cached("vessels"), "venous tree"), 0.99);
}

TEST(Skull, SinusesAreAirInBone) {
  const io::Sample& s = cached("skull");
  glm::ivec3 dims = s.volume.dims;
  std::vector<std::uint16_t> ids = idsOf(s.labels);
  std::uint16_t sinus = idOf(s, "frontal sinus"), bone = idOf(s, "skull");
  int held = 0, open = 0;
  for (int z = 1; z + 1 < dims.z; ++z)
    for (int y = 1; y + 1 < dims.y; ++y)
      for (int x = 1; x + 1 < dims.x; ++x) {
        auto at = [&](int dx, int dy, int dz) {
          return ids[std::size_t(((z + dz) * dims.y + y + dy) * dims.x + x + dx)];
        };
        if (at(0, 0, 0) != sinus) continue;
        ++held;
        for (auto beside : {at(1, 0, 0), at(-1, 0, 0), at(0, 1, 0), at(0, -1, 0), at(0, 0, 1), at(0, 0, -1)})
          open += beside != sinus && beside != bone;
      }
  double ml = std::pow(224.0 / double(dims.z), 3.0) / 1000.0;
  EXPECT_GT(held * ml, 5.0);
  EXPECT_LT(held * ml, 25.0);
  EXPECT_EQ(open, 0) << "it is closed on all sides";
}

TEST(Skull, PartsAreAsLargeAndWhereTheyAreInAHead) {
  const io::Sample& s = cached("skull");
  double ml = std::pow(224.0 / double(s.volume.dims.z), 3.0) / 1000.0;
  EXPECT_NEAR(double(measure(s, "brain").count) * ml, 1300.0, 350.0);
  EXPECT_NEAR(double(measure(s, "eyes").count) * ml, 2 * 7.0, 4.0);
  // World: x to the patient's left, y to the back, z to the head.
  auto centre = [&](const char* name) { return measure(s, name).centre; };
  EXPECT_LT(centre("eyes").y, centre("brain").y - 60.0);
  EXPECT_LT(centre("mandible").z, centre("teeth").z);
  EXPECT_LT(centre("teeth").z, centre("maxillary sinuses").z);
  EXPECT_LT(centre("maxillary sinuses").z, centre("frontal sinus").z);
  EXPECT_GT(centre("vertebrae").y, centre("mandible").y + 30.0);
  EXPECT_NEAR(centre("brain").x, 0.0, 2.0);
  EXPECT_NEAR(measure(s, "frontal sinus", 1).mean, -1000.0, 60.0);
}

TEST(Torso, PartsHaveTheirHounsfieldUnits) {
  const io::Sample& s = cached("torso");
  EXPECT_EQ(s.volume.unit, "HU");
  EXPECT_EQ(s.volume.modality, Modality::CT);
  struct Expected {
    const char* name;
    double hu;
  };
  // Deep inside a part only its texture (under 10 HU on average) and the noise's mean error are left.
  const Expected parts[] = {{"liver", 110},       {"spleen", 120},       {"aorta", 350},
                            {"muscle", 55},       {"heart muscle", 100}, {"left ventricle", 340},
                            {"vena cava", 180},   {"visceral fat", -95}, {"gas", -980},
                            {"left atrium", 340}, {"right atrium", 260}, {"colon", 32}};
  for (const auto& part : parts) {
    LabelStatistics inside = measure(s, part.name, 1);
    EXPECT_GT(inside.count, 5u) << part.name;
    EXPECT_NEAR(inside.mean, part.hu, 15.0) << part.name;
  }
  // Lungs hold vessel walls and fissures besides air.
  EXPECT_NEAR(measure(s, "lung left", 1).mean, -850.0, 40.0);
}

TEST(Torso, PartsLieWhereTheyBelong) {
  // World: x to the patient's left, y to the back, z to the head.
  const io::Sample& s = cached("torso");
  auto centre = [&](const char* name) { return measure(s, name).centre; };
  EXPECT_LT(centre("liver").x, -20.0);
  EXPECT_GT(centre("spleen").x, 50.0);
  EXPECT_GT(centre("stomach").x, 10.0);
  EXPECT_LT(centre("aorta").y, centre("vertebrae").y - 15.0);
  EXPECT_GT(centre("aorta").x, 2.0);
  EXPECT_GT(centre("aorta").x, centre("vena cava").x);
  EXPECT_GT(centre("left ventricle").x, 10.0);
  EXPECT_LT(centre("right atrium").x, centre("left ventricle").x);
  EXPECT_LT(centre("right ventricle").y, centre("left atrium").y);
  EXPECT_GT(centre("kidney left").x, 30.0);
  EXPECT_LT(centre("kidney right").x, -30.0);
  EXPECT_LT(centre("kidney right").z, centre("kidney left").z);
  EXPECT_GT(centre("kidney left").y, centre("stomach").y);
  EXPECT_GT(centre("lung left").z, centre("liver").z);
  EXPECT_LT(centre("sternum").y, centre("left ventricle").y);
  EXPECT_LT(centre("hip bones").z, centre("ribs left").z);
}

TEST(Torso, NoBoneLooksOutOfTheSkin) {
  io::Sample s = make("torso", 144);
  std::uint16_t skin = idOf(s, "skin");
  for (const char* part : {"ribs left", "ribs right", "costal cartilage", "sternum", "vertebrae", "scapulae"}) {
    int outside = 0;
    forEachVoxel(s, idOf(s, part), 0, [&](glm::ivec3 v) {
      for (glm::ivec3 step : {glm::ivec3(1, 0, 0), glm::ivec3(0, 1, 0)})
        for (glm::ivec3 w : {v + step, v - step}) outside += s.labels.at(w) == 0 || s.labels.at(w) == skin;
    });
    EXPECT_EQ(outside, 0) << part;
  }
}

/// Voxels of the left half of the heart that hold as much contrast as its ventricle, in one time step.
std::vector<glm::ivec3> cavity(const io::Sample& sample, int frame) {
  std::vector<glm::ivec3> voxels;
  forEachVoxel(sample, idOf(sample, "left ventricle"), 0, [&](glm::ivec3 v) {
    if (valueAt(sample.volume, v, 0, frame) > 230.0) voxels.push_back(v);
  });
  return voxels;
}

/// Mean difference of two time steps, HU.
double difference(const Volume& volume, int a, int b) {
  double sum = 0;
  for (int z = 0; z < volume.dims.z; ++z)
    for (int y = 0; y < volume.dims.y; ++y)
      for (int x = 0; x < volume.dims.x; ++x)
        sum += std::abs(valueAt(volume, {x, y, z}, 0, a) - valueAt(volume, {x, y, z}, 0, b));
  return sum / double(voxelCount(volume));
}

TEST(Seismic, BedsLieOneUponTheOtherAndTheYoungestOnTop) {
  const io::Sample& s = cached("seismic");
  double above = 1e9;
  for (const char* name : {"young cover", "formation A", "formation B", "formation C", "formation D", "formation E"}) {
    double sum = 0, count = 0;
    forEachVoxel(s, idOf(s, name), 0, [&](glm::ivec3 v) { sum += v.z, ++count; });
    double z = sum / count * s.volume.worldFromVoxel[2].z + s.volume.worldFromVoxel[3].z;
    EXPECT_LT(z, above - 50.0 * 1000.0) << name << ": 50 m in the earth's millimetres";
    above = z;
  }
}

TEST(Heart, PartsHaveTheirHounsfieldUnits) {
  const io::Sample& s = cached("heart");
  EXPECT_EQ(s.volume.unit, "HU");
  EXPECT_EQ(s.volume.timeSteps, 12);
  EXPECT_NEAR(s.volume.timeStepSeconds * s.volume.timeSteps, 0.84, 1e-9);
  for (auto [name, hu] : {std::pair("heart muscle", 105.0),
                          {"left ventricle", 350.0},
                          {"right ventricle", 270.0},
                          {"left atrium", 350.0},
                          {"right atrium", 250.0},
                          {"aorta", 370.0}}) {
    LabelStatistics inside = measure(s, name, 1);
    EXPECT_GT(inside.count, 300u) << name;
    EXPECT_NEAR(inside.mean, hu, 15.0) << name;
  }
}

TEST(Heart, ChambersLieWhereTheyBelong) {
  const io::Sample& s = cached("heart");
  auto centre = [&](const char* name) { return measure(s, name).centre; };
  EXPECT_LT(centre("right atrium").x, centre("left ventricle").x);
  EXPECT_LT(centre("right ventricle").y, centre("left atrium").y);
  EXPECT_GT(centre("aorta").z, centre("left ventricle").z);
  EXPECT_GT(centre("left atrium").y, centre("left ventricle").y);
}

TEST(Heart, TheVentricleThrowsOutMoreThanHalfOfItsBlood) {
  const io::Sample& s = cached("heart");
  auto full = double(cavity(s, 0).size()), least = full;
  for (int frame = 1; frame < s.volume.timeSteps; ++frame) least = std::min(least, double(cavity(s, frame).size()));
  EXPECT_LT(least / full, 0.5);
  EXPECT_GT(least / full, 0.2);
}

TEST(Heart, TheBeatGoesRound) {
  // From the last step to the first it is no further than from one to the next elsewhere.
  const Volume& volume = cached("heart").volume;
  double most = 0;
  for (int frame = 1; frame < volume.timeSteps; ++frame) most = std::max(most, difference(volume, frame - 1, frame));
  EXPECT_LE(difference(volume, volume.timeSteps - 1, 0), most);
  EXPECT_GT(difference(volume, 4, 0), 1.5 * difference(volume, volume.timeSteps - 1, 0));
}

TEST(Heart, StepsAreTimesOfOneBeat) {
  // Half as many steps are every other step, but for their noise.
  Progress progress;
  io::Sample four = io::makeSample("heart", 40, progress, 4), two = io::makeSample("heart", 40, progress, 2);
  EXPECT_EQ(four.volume.timeSteps, 4);
  Volume both = four.volume;
  auto bytes = std::ptrdiff_t(timeStepBytes(both));
  std::copy(two.volume.voxels.begin() + bytes, two.volume.voxels.end(), both.voxels.begin());
  EXPECT_LT(difference(both, 0, 2), 12.0);
  EXPECT_GT(difference(four.volume, 0, 2), 30.0);
}

}  // namespace
}  // namespace velum
