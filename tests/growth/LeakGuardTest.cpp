#include "growth/LeakGuard.h"

#include <gtest/gtest.h>

#include <functional>

#include "growth/FirstDoubt.h"
#include "growth/GrowDomain.h"
#include "growth/Grower.h"
#include "growth/LabelsFor.h"
#include "growth/SolidPart.h"
#include "makeVolume.h"

namespace velum::growth {
namespace {

/// Distance from a place to the axis of a tube, negative inside of it; and what else there is.
using Shape = std::function<double(glm::dvec3)>;

/// What is to be grown and what it leaks into, with values that are alike: 200 and 215, both with noise of 15, in 60.
struct Phantom {
  glm::ivec3 dims;
  Shape structure, other;

  Volume volume() const {
    return makeVolume(dims, SampleType::Int16, [&](glm::ivec3 v) {
      double noise = 30.0 * (hashNoise(v) - 0.5);
      return (structure(v) <= 0.0 ? 200.0 : other(v) <= 0.0 ? 215.0 : 60.0) + noise;
    });
  }
};

double ball(glm::dvec3 p, glm::dvec3 centre, double radius) { return glm::distance(p, centre) - radius; }
double nothing(glm::dvec3) { return 1.0; }

/// @param at  on the structure, in the cut  @param axis  towards the removed side
scene::Growth pull(glm::dvec3 at, glm::dvec3 axis, double distance) {
  scene::Growth step;
  step.structure = 1;
  step.seeds = {at};
  step.low = 150, step.high = 250;
  step.centre = at, step.axis = axis, step.distance = distance;
  return step;
}

Grown grow(const Phantom& phantom, const scene::Growth& step, bool guard) {
  Shared<Volume> volume(phantom.volume());
  Progress progress;
  return Grower().grow(volume, labelsFor(*volume, {}), step, {guard}, progress);
}

/// Overlap of what was grown with the structure's part that the step is meant to take.
double diceOf(const Phantom& phantom, const scene::Growth& step, const LabelVolume& labels) {
  std::size_t both = 0, sum = 0;
  for (int z = 0; z < phantom.dims.z; ++z)
    for (int y = 0; y < phantom.dims.y; ++y)
      for (int x = 0; x < phantom.dims.x; ++x) {
        glm::dvec3 p(x, y, z);
        double depth = glm::dot(p - step.centre, glm::normalize(step.axis));
        bool wanted = phantom.structure(p) <= 0.0 && depth > 0.0 && depth <= step.distance;
        bool is = labels.at(glm::ivec3(p)) == 1;
        both += wanted && is, sum += std::size_t(wanted) + std::size_t(is);
      }
  return 2.0 * double(both) / double(sum);
}

/// Prints and compares. @param least  what the guard's result must reach
void expectBetterWithGuard(const char* name, const Phantom& phantom, const scene::Growth& step, double least) {
  Grown with = grow(phantom, step, true), without = grow(phantom, step, false);
  double guarded = diceOf(phantom, step, *with.labels), leaked = diceOf(phantom, step, *without.labels);
  std::printf("%s: Dice %.3f with the guard (stopped at %.1f of %.1f), %.3f without\n", name, guarded, with.distance,
              step.distance, leaked);
  ASSERT_TRUE(with.leak);
  EXPECT_GT(with.leak->depth, with.distance);
  EXPECT_GT(with.leak->area, with.leak->widestBefore);
  EXPECT_FALSE(without.leak);
  EXPECT_GT(guarded, least);
  EXPECT_GT(guarded, leaked + 0.3) << "clearly better";
  // What is told to be safe is what was grown.
  scene::Growth safe = step;
  safe.distance = with.distance;
  EXPECT_EQ(grow(phantom, safe, false).voxels, with.voxels);
}

/// A ball under a vault.
Phantom lesionAtBone() {
  return {{128, 128, 90},
          [](glm::dvec3 p) {
            return ball(p, {64, 64, 40}, 15);
          },
          [](glm::dvec3 p) {
            return std::abs(ball(p, {64, 64, -46}, 103)) - 4.0;
          }};
}

/// A vessel that winds past a vertebra.
Phantom vesselAtBone() {
  return {{100, 100, 140},
          [](glm::dvec3 p) {
            glm::dvec2 middle(40 + 6 * std::sin(p.z / 25.0), 50 + 4 * std::cos(p.z / 19.0));
            return glm::distance(glm::dvec2(p), middle) - 5.0;
          },
          [](glm::dvec3 p) {
            return ball(p, {62, 50, 95}, 24);
          }};
}

TEST(LeakGuard, ALesionDoesNotBecomeTheBoneThatItTouches) {
  expectBetterWithGuard("lesion at bone", lesionAtBone(), pull({64, 64, 33}, {0, 0, 1}, 50), 0.8);
  expectBetterWithGuard("lesion at bone, oblique", lesionAtBone(), pull({64, 64, 36}, {0.3, 0.2, 1}, 50), 0.8);
}

TEST(LeakGuard, AVesselDoesNotBecomeTheBoneThatItTouches) {
  expectBetterWithGuard("vessel at bone", vesselAtBone(), pull({44, 52, 20}, {0, 0, 1}, 115), 0.6);
  expectBetterWithGuard("vessel at bone, oblique", vesselAtBone(), pull({44, 52, 20}, {0.2, -0.1, 1}, 110), 0.6);
}

TEST(LeakGuard, AThreadThatOpensIntoABlockWithinTheFirstSlabIsHeldAtTheCut) {
  Phantom phantom{{90, 90, 60},
                  [](glm::dvec3 p) {
                    return glm::distance(glm::dvec2(p), {45, 45}) - 6.0;
                  },
                  [](glm::dvec3 p) {
                    return std::max({22.5 - p.z, std::abs(p.x - 45) - 38, std::abs(p.y - 45) - 38});
                  }};
  // What counts is the thread, as it was clicked on and as it begins: the slab is thicker than that.
  Grown grown = grow(phantom, pull({45, 45, 20}, {0, 0, 1}, 30), true);
  ASSERT_TRUE(grown.leak);
  EXPECT_EQ(grown.distance, 0.0);
  EXPECT_LE(grown.voxels, 1u) << "the seed";
  EXPECT_LT(grown.leak->widestBefore, 10.0 * 3.1416 * 36.0) << "some times the thread, not the block";
}

TEST(LeakGuard, WhatBeginsBeforeTheCutIsHeldAgainstHowItBegins) {
  Phantom phantom{{90, 90, 60},
                  [](glm::dvec3 p) {
                    return p.z > 20.5 ? glm::distance(glm::dvec2(p), {45, 45}) - 6.0 : 1.0;
                  },
                  [](glm::dvec3 p) {
                    return std::max({22.5 - p.z, std::abs(p.x - 45) - 38, std::abs(p.y - 45) - 38});
                  }};
  scene::Growth step = pull({45, 45, 20}, {0, 0, 1}, 30);
  step.seeds = {{45, 45, 21}};
  Grown grown = grow(phantom, step, true);
  ASSERT_TRUE(grown.leak) << "behind the cut there is nothing of it";
  EXPECT_EQ(grown.distance, 0.0);
}

TEST(LeakGuard, StopsAtTheSamePlaceWhereverInFrontOfTheDataThePlaneStands) {
  Phantom phantom = vesselAtBone();
  double slab = slabThickness(phantom.volume());
  auto stopped = [&](int slabsBefore) {
    scene::Growth step = pull({44, 52, 2}, {0, 0, 1}, 115.0 + slabsBefore * slab);
    step.centre.z = -0.5 - slabsBefore * slab;
    return grow(phantom, step, true);
  };
  Grown near = stopped(0);
  ASSERT_TRUE(near.leak);
  for (int slabs : {1, 20}) {
    Grown far = stopped(slabs);
    ASSERT_TRUE(far.leak) << slabs;
    EXPECT_NEAR(far.distance - slabs * slab, near.distance, 1e-6) << slabs;
    EXPECT_NEAR(far.leak->depth - slabs * slab, near.leak->depth, 1e-6) << slabs;
    EXPECT_EQ(far.voxels, near.voxels) << slabs;
  }
}

TEST(LeakGuard, LetsStructuresBeThatBecomeWiderByThemselves) {
  const glm::ivec3 dims(110, 110, 110);
  struct Case {
    const char* name;
    Shape structure;
    glm::dvec3 at;
  };
  const Case cases[] = {
      {"ball, cut in its middle",
       [](glm::dvec3 p) {
         return ball(p, {55, 55, 50}, 30);
       },
       {55, 55, 50}},
      {"ball, cut low",
       [](glm::dvec3 p) {
         return ball(p, {55, 55, 50}, 30);
       },
       {55, 55, 24}},
      {"ball, cut at its cap",
       [](glm::dvec3 p) {
         return ball(p, {55, 55, 50}, 30);
       },
       {55, 55, 22}},
      {"cone of 45 degrees",
       [](glm::dvec3 p) {
         return glm::distance(glm::dvec2(p), {55, 55}) - p.z * 0.7;
       },
       {55, 55, 5}},
      {"vessel that forks",
       [](glm::dvec3 p) {
         double apart = std::max(p.z - 40.0, 0.0) * 0.5;
         glm::dvec2 q(p);
         return std::min(glm::distance(q, {55 - apart, 55}), glm::distance(q, {55 + apart, 55})) - 6.0;
       },
       {55, 55, 8}},
      {"vessel with an aneurysm",
       [](glm::dvec3 p) {
         return glm::distance(glm::dvec2(p), {55, 55}) - 6.0 - 8.0 * std::exp(-std::pow((p.z - 50) / 14.0, 2.0));
       },
       {55, 55, 8}},
      {"plate across the cut", [](glm::dvec3 p) { return std::abs(p.x - 55.0) - 5.0; }, {55, 55, 8}},
  };
  for (const Case& c : cases)
    for (glm::dvec3 axis : {glm::dvec3(0, 0, 1), glm::dvec3(0.2, 0.1, 1)}) {
      Grown grown = grow({dims, c.structure, nothing}, pull(c.at, axis, 100), true);
      EXPECT_FALSE(grown.leak) << c.name << " at " << (grown.leak ? grown.leak->depth : 0.0);
    }
}

TEST(LeakGuard, IsADragsGuardAsItIsOneStepsGuard) {
  // Pulled a little at a time, it stops at the same place.
  Shared<Volume> volume(vesselAtBone().volume());
  scene::Growth step = pull({44, 52, 20}, {0, 0, 1}, 115);
  Progress progress;
  Grower once, drag;
  double whole = once.grow(volume, labelsFor(*volume, {}), step, {true}, progress).distance;
  auto labels = labelsFor(*volume, {});
  std::optional<double> stopped;
  for (double distance = 3.0; distance < 115.0 && !stopped; distance += 5.0) {
    step.distance = distance;
    Grown grown = drag.grow(volume, labels, step, {true}, progress);
    labels = grown.labels;
    if (grown.leak) stopped = grown.distance;
  }
  ASSERT_TRUE(stopped);
  EXPECT_NEAR(*stopped, whole, 5.0);
}

Section solid(double area) { return {area, area, area}; }
Section thin(double area) { return {area, area, 0.0}; }

TEST(LeakGuard, ComparesWithWhatIsExpected) {
  LeakGuard guard(solid(100.0));
  EXPECT_TRUE(guard.leaks(solid(1000), 1000)) << "the first against the cut";
  EXPECT_FALSE(guard.leaks(solid(1000), 50)) << "few voxels do no harm";
  LeakGuard steady(solid(100.0));
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(steady.leaks(solid(100 + 60 * i), 1000));
  EXPECT_TRUE(steady.leaks(solid(3000), 10000));
  EXPECT_FALSE(steady.leaks(solid(700), 1000)) << "what leaks does not count";
  LeakGuard unknown;
  EXPECT_FALSE(unknown.leaks(solid(1e6), 1000000)) << "nothing to tell from";
}

TEST(LeakGuard, WhatIsSmallBesideThePlaneMayChangeAsItLikes) {
  LeakGuard guard(solid(5.0), 20000.0), other(solid(5.0));
  for (double area : {40.0, 8.0, 90.0, 200.0, 900.0, 200.0, 200.0, 200.0})
    EXPECT_FALSE(guard.leaks(solid(area), 1000)) << "a thread into its tree";
  EXPECT_TRUE(other.leaks(solid(40.0), 1000)) << "of a plane that nobody knows nothing is small";
  EXPECT_TRUE(guard.leaks(solid(3000.0), 9000)) << "a tenth of the plane is not small";
}

TEST(LeakGuard, WhatIsThinMayBeJoinedByMoreThatIsThin) {
  LeakGuard guard(thin(50.0), 10000.0);
  EXPECT_FALSE(guard.leaks(thin(60.0), 1000));
  Section rest = thin(1200.0);
  rest.joined = 9000.0;
  EXPECT_FALSE(guard.leaks(rest, 30000)) << "the rest of a tree, most of which comes back";
  LeakGuard sponge(thin(50.0), 10000.0);
  EXPECT_FALSE(sponge.leaks(thin(60.0), 1000));
  EXPECT_TRUE(sponge.leaks(thin(4000.0), 9000)) << "much of the plane is no tree";
  LeakGuard vessel(solid(50.0), 10000.0);
  EXPECT_FALSE(vessel.leaks(solid(60.0), 1000));
  EXPECT_TRUE(vessel.leaks(rest, 30000)) << "but what is solid does not become a tree";
}

TEST(LeakGuard, WhatIsThinDoesNotBecomeSolid) {
  auto becomes = [](const Section& next) {
    LeakGuard guard(thin(1000.0), 10000.0);
    EXPECT_FALSE(guard.leaks(thin(1000.0), 9000));
    return guard.leaks(next, 9000);
  };
  EXPECT_TRUE(becomes(solid(2500.0)));
  EXPECT_FALSE(becomes(thin(2500.0)));
  EXPECT_FALSE(becomes(solid(1500.0))) << "a bone that becomes denser";
}

TEST(LeakGuard, TheFirstSlabIsHeldAgainstHowItBegins) {
  // One click joins few of the pieces of which a section through spongy bone consists; in the slab they are one.
  LeakGuard guard(solid(10.0));
  guard.beginAs(solid(300.0));
  EXPECT_FALSE(guard.leaks(solid(400.0), 1000));
  LeakGuard leak(solid(10.0));
  leak.beginAs(solid(12.0));
  EXPECT_TRUE(leak.leaks(solid(400.0), 1000));
}

TEST(LeakGuard, SaysHowWideItWasToBe) {
  LeakGuard guard(solid(100.0));
  EXPECT_EQ(guard.expected(), 100.0);
  EXPECT_FALSE(guard.leaks(solid(150), 1000));
  EXPECT_EQ(guard.expected(), 200.0) << "it goes on as steeply";
  EXPECT_GT(guard.widest(solid(150)), guard.expected());
}

/// A lattice of struts: few layers join those that stand on them, as in spongy bone.
TEST(LeakGuard, SpongyBoneIsNotHeldAtItsCut) {
  Phantom phantom{{64, 64, 60},
                  [](glm::dvec3 p) {
                    glm::ivec3 v(p);
                    bool isIn = std::abs(p.x - 32) < 20 && std::abs(p.y - 32) < 20;
                    int struts = (v.x % 4 == 0) + (v.y % 4 == 0) + (v.z % 6 == 4);
                    return isIn && struts >= 2 ? -1.0 : 1.0;
                  },
                  nothing};
  for (int z : {7, 8, 9, 13, 14}) {
    Grown grown = grow(phantom, pull({32, 32, double(z)}, {0, 0, 1}, 30), true);
    EXPECT_FALSE(grown.leak) << "at " << z;
    EXPECT_GT(grown.voxels, 2000u);
  }
}

/// Columns that a plate joins close to the cut, as the pieces of a base of a skull: one is pulled.
TEST(LeakGuard, WhatIsCutIntoPiecesThatJoinWithinTheFirstSlabIsNotHeld) {
  Phantom columns{{90, 90, 60},
                  [](glm::dvec3 p) {
                    glm::ivec3 v(p);
                    return v.z == 22 || (v.x % 30 < 14 && v.y % 30 < 14) ? -1.0 : 1.0;
                  },
                  nothing};
  Grown grown = grow(columns, pull({36, 36, 20}, {0, 0, 1}, 30), true);
  EXPECT_FALSE(grown.leak) << (grown.leak ? grown.leak->depth : 0.0);
}

/// Threads that a few bars join far from the cut: one is pulled.
TEST(LeakGuard, AThreadIsNotHeldWhereTheRestOfItsTreeJoins) {
  Phantom tree{{90, 90, 70},
               [](glm::dvec3 p) {
                 glm::ivec3 v(p);
                 bool isThread = v.x % 6 < 2 && v.y % 6 < 2, isBar = v.z == 51 && (v.x % 6 == 0 || v.y % 6 == 0);
                 return isThread || isBar ? -1.0 : 1.0;
               },
               nothing};
  Grown grown = grow(tree, pull({42, 42, 20}, {0, 0, 1}, 45), true);
  EXPECT_FALSE(grown.leak) << (grown.leak ? grown.leak->depth : 0.0);
  EXPECT_GT(grown.voxels, 20000u);
}

/// A lattice of struts, and an even block beside it that a few of them reach.
TEST(LeakGuard, SpongyBoneDoesNotBecomeTheVesselThatItTouches) {
  Phantom phantom{{80, 90, 60},
                  [](glm::dvec3 p) {
                    glm::ivec3 v(p);
                    bool isIn = std::abs(p.x - 22) < 18 && std::abs(p.y - 45) < 36;
                    int struts = (v.x % 4 == 0) + (v.y % 4 == 0) + (v.z % 4 == 0);
                    return isIn && struts >= 2 ? -1.0 : 1.0;
                  },
                  [](glm::dvec3 p) {
                    bool isBridge = std::abs(p.x - 42) <= 4 && std::abs(p.y - 44) < 2 && std::abs(p.z - 40) < 2;
                    return isBridge || (std::abs(p.x - 48) < 5 && std::abs(p.y - 45) < 36 && p.z > 35) ? -1.0 : 1.0;
                  }};
  Grown grown = grow(phantom, pull({20, 44, 8}, {0, 0, 1}, 45), true);
  ASSERT_TRUE(grown.leak);
  EXPECT_NEAR(grown.leak->depth, 32.0, 4.0) << "where the bridge is";
  EXPECT_LT(grown.leak->area, 3.0 * grown.leak->widestBefore) << "no jump that would tell by itself";
}

/// A tube, and beside it a block that they share a bridge with and that begins two layers before it.
TEST(LeakGuard, SmallMovesAreHeldWhereOneStepIs) {
  int held = 0;
  for (int wide = 12; wide <= 40; wide += 2) {
    Phantom phantom{{100, 90, 70},
                    [](glm::dvec3 p) {
                      return glm::distance(glm::dvec2(p), {20, 45}) - 10.0;
                    },
                    [wide](glm::dvec3 p) {
                      bool isBridge = std::abs(p.x - 33) <= 4 && std::abs(p.y - 45) < 3 && p.z >= 31 && p.z <= 32;
                      return isBridge || (p.x > 35 && p.x <= 35 + wide && std::abs(p.y - 45) < 20 && p.z >= 29) ? -1
                                                                                                                : 1;
                    }};
    scene::Growth step = pull({20, 45, 20}, {0, 0, 1}, 40);
    bool isHeld = grow(phantom, step, true).leak.has_value(), isDragHeld = false;
    Shared<Volume> volume(phantom.volume());
    Grower drag;
    auto labels = labelsFor(*volume, {});
    Progress progress;
    for (step.distance = 1.0; step.distance <= 40.0 && !isDragHeld; step.distance += 1.0) {
      Grown grown = drag.grow(volume, labels, step, {true}, progress);
      labels = grown.labels;
      isDragHeld = grown.leak.has_value();
    }
    EXPECT_TRUE(isDragHeld || !isHeld) << wide;
    held += isHeld;
  }
  EXPECT_GT(held, 3);
  EXPECT_LT(held, 14);
}

TEST(LeakGuard, GoesOnFromWhereADragStandsAsIfItLookedAtAllOfIt) {
  Shared<Volume> volume(vesselAtBone().volume());
  scene::Growth step = pull({44, 52, 20}, {0.2, -0.1, 1}, 0);
  Progress progress;
  Grower kept;
  auto labels = labelsFor(*volume, {});
  for (step.distance = 2.0; step.distance < 100.0; step.distance += 2.0) {
    Grown with = kept.grow(volume, labels, step, {true}, progress);
    Grown anew = Grower().grow(volume, labels, step, {true}, progress);
    ASSERT_EQ(with.leak.has_value(), anew.leak.has_value()) << step.distance;
    ASSERT_EQ(with.voxels, anew.voxels);
    ASSERT_EQ(with.slabs, anew.slabs);
    if (with.leak) return;
    labels = with.labels;
  }
  FAIL() << "it leaks";
}

/// Against eroding voxel by voxel.
TEST(SolidPart, IsWhatErosionLeaves) {
  const glm::ivec3 dims(70, 23, 19);
  Shared<Volume> volume(makeVolume(dims, SampleType::Int16, [](glm::ivec3 v) {
    return ball(v, {34, 11, 9}, 12) < 0.0 || ball(v, {62, 4, 9}, 8) < 0.0 || v.x < 3 || hashNoise(v) < 0.02 ? 200.0
                                                                                                            : 0.0;
  }));
  for (glm::dvec3 axis : {glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0), glm::dvec3(0.5, 0.3, -0.6)}) {
    GrowDomain all(*volume, glm::dvec3(33.0, 8.0, 7.0), axis, 9.0), slab = all.between(2.0, 6.5);
    RegionGrow region(volume, labelsFor(*volume, {}), 0, {.low = 100, .high = 300});
    for (int x = 0; x < dims.x; ++x) region.addSeed({x, 9, 9});
    Progress progress;
    region.grow(all, progress);
    auto isLeft = [&](auto& self, glm::ivec3 v, int stage) -> bool {
      if (glm::any(glm::lessThan(v, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(v, dims))) return true;
      if (!all.contains(v)) return true;
      if (stage == 0) return region.has(v);
      for (int i = 0; i < 27; ++i) {
        glm::ivec3 off(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        bool isFace = std::abs(off.x) + std::abs(off.y) + std::abs(off.z) <= 1;
        if ((stage == 2 || isFace) && !self(self, v + off, stage - 1)) return false;
      }
      return true;
    };
    std::size_t expected = 0;
    for (glm::ivec3 v(0); v.z < dims.z; ++v.z)
      for (v.y = 0; v.y < dims.y; ++v.y)
        for (v.x = 0; v.x < dims.x; ++v.x) expected += slab.contains(v) && region.has(v) && isLeft(isLeft, v, 2);
    EXPECT_EQ(countSolid(region, dims, all, slab), expected) << axis.x;
    EXPECT_GT(expected, 100u);
  }
}

TEST(FirstDoubt, IsOfWhatReachesTheDarkestOfTheData) {
  Volume volume = lesionAtBone().volume();
  scene::Growth step = pull({64, 64, 33}, {0, 0, 1}, 50);
  EXPECT_FALSE(reachesTheDarkest(volume, step));
  step.low = volume.range.x - 1.0;
  EXPECT_TRUE(reachesTheDarkest(volume, step));
  // A scan's circle is filled up with something far below its air.
  auto* values = reinterpret_cast<std::int16_t*>(volume.voxels.data());
  for (int i = 0; i < 500; ++i) values[i] = -2000;
  computeRange(volume);
  step.low = 40.0;
  EXPECT_TRUE(reachesTheDarkest(volume, step));
  step.low = 100.0;
  EXPECT_FALSE(reachesTheDarkest(volume, step));
}

TEST(FirstDoubt, IsOfWhatIsMostOfItsPlane) {
  Phantom lesion{{96, 96, 60}, lesionAtBone().structure, nothing};
  Shared<Volume> volume(lesion.volume());
  Progress progress;
  auto isMost = [&](glm::dvec3 at, double low, double high, double distance) {
    scene::Growth step = pull(at, {0, 0, 1}, distance);
    step.low = low, step.high = high;
    for (int i = 0; i < 9; ++i) step.seeds.push_back(at + glm::dvec3(i % 3, i / 3, 1));  // some are noise
    auto labels = Grower().grow(volume, labelsFor(*volume, {}), step, {}, progress).labels;
    return isMostOfItsPlane(*volume, *labels, step);
  };
  EXPECT_FALSE(isMost({64, 64, 33}, 150, 250, 10)) << "a lesion";
  EXPECT_TRUE(isMost({10, 10, 33}, 46, 120, 30)) << "what it lies in";
  EXPECT_TRUE(isMost({10, 10, 33}, 46, 120, 1.0)) << "a layer says it";
}

TEST(LeakGuard, ANeckIsNoLeak) {
  LeakGuard guard(solid(100.0));
  for (double area : {100.0, 100.0, 10.0, 10.0, 100.0}) EXPECT_FALSE(guard.leaks(solid(area), 1000)) << area;
}

}  // namespace
}  // namespace velum::growth
