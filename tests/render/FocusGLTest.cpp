// What a cut keeps in view, and counts of instances: [VE] 3 and 6.
#include <random>

#include "FocusFixture.h"
#include "model/InstanceStates.h"
#include "render/kept/KeptInstances.h"
#include "scene/Scene.h"
#include "shared/instance.h"

namespace velum {
namespace {

using render::InstanceState;

TEST_F(FocusGL, ClearsWhatAPlainDepthBufferFindsBeforeTheFocus) {
  for (bool guidesDepth : {false, true})
    for (auto projection : {scene::Projection::Perspective, scene::Projection::Orthographic}) {
      scene::Scene scene = focusScene(guidesDepth ? 5 : 6);
      scene.camera.projection = projection;
      scene.cuts[0].model.focus->guidesDepth = guidesDepth;
      std::set<std::size_t> removed = removedIn(scene);
      const Model& model = *scene.model.data;
      glm::ivec2 mask(int(std::lround(shared::kFocusRows * double(kSize.x) / kSize.y)), shared::kFocusRows);
      // Surely hides, and may hide, as spheres are a little smaller or larger.
      std::vector<std::uint8_t> surely(model.instances.size(), 0), maybe(model.instances.size(), 0);
      for (int y = 0; y < mask.y; ++y)
        for (int x = 0; x < mask.x; ++x) {
          TestRay ray = rayThrough(scene.camera, mask, {x + 0.5, y + 0.5});
          for (double grown : {-0.01, 0.01}) {
            double depth = guidesDepth ? std::numeric_limits<double>::infinity() : -1.0;
            bool isThere = false;
            for (std::size_t i = 0; i < model.instances.size(); ++i)
              if (typeOf(scene, i) == 0)
                if (Meeting m = meet(ray, sphereOf(model, i), guidesDepth ? -grown : grown); m.isThere) {
                  depth = guidesDepth ? std::min(depth, m.enters) : std::max(depth, m.leaves);
                  isThere = true;
                }
            if (!isThere) continue;
            for (std::size_t i = 0; i < model.instances.size(); ++i)
              if (typeOf(scene, i) != 0)
                if (Meeting m = meet(ray, sphereOf(model, i), grown); m.isThere && m.enters < depth)
                  (grown < 0 ? surely : maybe)[i] = 1;
          }
        }
      int cleared = 0;
      for (std::size_t i = 0; i < model.instances.size(); ++i) {
        cleared += removed.contains(i);
        EXPECT_TRUE(removed.contains(i) || !surely[i]) << i;
        EXPECT_TRUE(!removed.contains(i) || maybe[i] || surely[i]) << i;
      }
      EXPECT_GT(cleared, 20);
      EXPECT_LT(cleared, 160);
    }
}

TEST_F(FocusGL, WhatItKeepsInViewIsWhole) {
  scene::Scene scene = focusScene(3);
  glm::ivec2 size(shared::kFocusRows, shared::kFocusRows);
  Image cleared = draw(scene, size, kLayers);
  scene::Scene alone = scene;
  alone.model.types = {{.type = "root.b.type1", .visible = false}, {.type = "root.a.type2", .visible = false}};
  Image whole = draw(alone, size, kLayers);
  int shown = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      if (sampleOf(whole, {x, y}, "type") != 0.0f) continue;
      ++shown;
      ASSERT_EQ(sampleOf(cleared, {x, y}, "instance"), sampleOf(whole, {x, y}, "instance")) << x << ", " << y;
    }
  EXPECT_GT(shown, 5000);
}

TEST_F(FocusGL, TheProcessorFindsTheSame) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int states[3] = {0, 0, 0};
  std::size_t wrong = 0;
  for (unsigned round = 0; round < 12; ++round) {
    scene::Scene scene = focusScene(20 + round);
    if (round % 3 == 1) scene.camera.projection = scene::Projection::Orthographic;
    scene::Cut& cut = scene.cuts[0];
    cut.model.spares[0].share = 0.5 + 0.5 * unit(random);
    cut.model.spares[0].viewShare = round % 2 ? unit(random) : 0.0;
    cut.model.spares[0].aperture = round % 4 ? unit(random) : 1.0;
    cut.model.focus->guidesDepth = round % 5 == 0;
    if (round % 3 == 2)
      cut.model.focus->lock = scene::ViewLock{scene::frameCamera(scene, scene::StandardView::Left, 1.0), 1.5};
    if (round % 4 == 3) {
      cut.shape = scene::CutShape::Sphere;
      cut.size = glm::dvec3(220.0);
      scene::Cut plane;
      plane.axis = {1, 1, 0};
      plane.model.spares = {{"root.b", 0.5}};
      scene::addCut(scene, plane);
    }
    std::set<std::size_t> removed = removedIn(scene);
    auto found = render::instanceStates(scene, {}, double(kSize.x) / kSize.y);
    for (std::size_t i = 0; i < found.size(); ++i) {
      ++states[static_cast<int>(found[i])];
      wrong += (found[i] != InstanceState::Kept) != removed.contains(i);
    }
  }
  EXPECT_LE(wrong, 2u) << "of 2,880: a sphere may graze the ray of a pixel";
  for (int state : states) EXPECT_GT(state, 200);
}

TEST_F(FocusGL, AShareOfThoseThatHideItStaysDrawnApartFromTheOtherShare) {
  scene::Scene scene = focusScene(7);
  std::set<std::size_t> all = removedIn(scene);
  scene.cuts[0].model.spares[0].viewShare = 0.4;
  std::set<std::size_t> some = removedIn(scene);
  for (std::size_t i : all) EXPECT_EQ(some.contains(i), randomOf(std::uint32_t(i), 1) >= 0.4f) << i;
  for (std::size_t i : some) EXPECT_TRUE(all.contains(i));
  EXPECT_LT(some.size(), all.size());
}

TEST_F(FocusGL, ALargerApertureClearsMore) {
  scene::Scene scene = focusScene(8, 400);
  std::set<std::size_t> whole = removedIn(scene), before;
  for (double aperture : {0.0, 0.2, 0.5, 0.8, 1.0}) {
    scene.cuts[0].model.spares[0].aperture = aperture;
    std::set<std::size_t> removed = removedIn(scene);
    EXPECT_TRUE(std::includes(removed.begin(), removed.end(), before.begin(), before.end())) << aperture;
    EXPECT_EQ(removed.empty(), aperture == 0.0) << aperture;
    if (aperture == 0.5) {
      EXPECT_GT(removed.size(), 0u);
      EXPECT_LT(removed.size(), whole.size());
    }
    before = removed;
  }
  EXPECT_EQ(before, whole);
}

TEST_F(FocusGL, ALockHoldsWhatIsClearedWhileTheCameraMoves) {
  scene::Scene scene = focusScene(9);
  std::set<std::size_t> here = removedIn(scene);
  scene::Scene moved = scene;
  moved.camera = scene::frameCamera(scene, scene::StandardView::Left, double(kSize.x) / kSize.y);
  EXPECT_NE(removedIn(moved), here);
  moved.cuts[0].model.focus->lock = scene::ViewLock{scene.camera, double(kSize.x) / kSize.y};
  EXPECT_EQ(removedIn(moved), here);
}

TEST_F(FocusGL, ACutThatIsOffChangesNothingWhereverItStands) {
  scene::Scene scene = focusScene(14);
  scene.cuts[0].model.spares[0].viewShare = 0.3;
  scene::Cut plane;
  plane.axis = {1, 1, 0};
  plane.model.wholeInstances = true;
  plane.model.spares = {{"root.b", 0.5}};
  scene::addCut(scene, plane);
  plane.axis = {0, 0, 1};
  plane.model.wholeInstances = false;
  plane.model.spares = {{"root.a", 0.2}};
  scene::addCut(scene, plane);
  std::set<std::size_t> removed = removedIn(scene);
  auto states = render::instanceStates(scene);
  EXPECT_GT(removed.size(), 30u);
  for (std::size_t at = 0; at <= scene.cuts.size(); ++at) {
    scene::Scene other = scene;
    scene::Cut off = scene.cuts[(at + 1) % 3];
    off.id = 99;
    off.enabled = false;
    other.cuts.insert(other.cuts.begin() + std::ptrdiff_t(at), off);
    EXPECT_EQ(removedIn(other), removed) << at;
    EXPECT_EQ(render::instanceStates(other), states) << at;
  }
}

TEST_F(FocusGL, PiecesOfAPictureClearTheSame) {
  scene::Scene scene = focusScene(10);
  Image whole = draw(scene, kSize, kLayers);
  render::Frame frame;
  frame.scene = scene;
  frame.pictureSize = kSize;
  Progress progress;
  Image pieces = render::renderPicture(renderer(), frame, kLayers, 96, progress);
  EXPECT_EQ(differenceOf(whole, pieces).largest, 0.0);
}

TEST_F(FocusGL, DistancesInTheMaskAreExactToOneAndAHalfPixels) {
  model::InstancePrograms programs;
  model::InstanceStates states;
  states.resize({1, 1, 0});
  shared::FocusView view{};
  view.size = {150, 110};
  view.hasAperture = 1;
  std::mt19937 random(2);
  double worst = 0.0;
  for (int round = 0; round < 6; ++round) {
    states.beginFocus(view);
    std::vector<std::uint32_t> mask(std::size_t(view.size.x * view.size.y), 0x3f800000u);
    int holes = round == 0 ? 1 : 6 * round;
    for (int i = 0; i < holes; ++i) mask[random() % mask.size()] = 0;
    states.mask().write(0, mask.size() * sizeof(mask[0]), mask.data());
    states.flood(programs);
    std::vector<std::uint32_t> seeds(mask.size());
    states.seeds().read(0, seeds.size() * sizeof(seeds[0]), seeds.data());
    for (int y = 0; y < view.size.y; ++y)
      for (int x = 0; x < view.size.x; ++x) {
        double nearest = 1e9;
        for (std::size_t at = 0; at < mask.size(); ++at)
          if (mask[at] == 0)
            nearest =
                std::min(nearest, std::hypot(double(int(at) % view.size.x - x), double(int(at) / view.size.x - y)));
        double found = shared::focusDistance({x, y}, seeds[std::size_t(y * view.size.x + x)]);
        worst = std::max(worst, std::abs(found - nearest));
      }
  }
  EXPECT_LE(worst, 1.5);
}

TEST_F(FocusGL, CountsAreThoseOfTheIdLayer) {
  scene::Scene scene = focusScene(11, 600);
  scene.model.copies = 3;
  scene.model.types = {{.type = "root.a.type2", .visible = false}};
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, double(kSize.x) / kSize.y);
  render::InstanceBits bits = bitsOf(scene);
  Image image = renderer().read(kLayers);
  std::set<std::size_t> shown;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (float number = sampleOf(image, {x, y}, "instance"); number >= 1.0f) shown.insert(std::size_t(number) - 1);
  ASSERT_EQ(bits.count, 1800u);
  std::vector<Counts> plain(3);
  for (std::size_t i = 0; i < bits.count; ++i) {
    EXPECT_EQ(bits.isShown(i), shown.contains(i)) << i;
    Counts& count = plain[typeOf(scene, i % 600)];
    ++count[bits.isRemoved(i) ? CountOf::Clipped : shown.contains(i) ? CountOf::Visible : CountOf::Hidden];
    EXPECT_EQ(bits.kindOf(i), bits.isRemoved(i) ? CountOf::Clipped
                              : bits.isShown(i) ? CountOf::Visible
                                                : CountOf::Hidden);
  }
  auto types = render::countTypes(*scene.model.data, bits);
  EXPECT_EQ(types, plain);
  for (const auto& count : types) EXPECT_EQ(count.total(), 600u);
  EXPECT_EQ(types[2].clipped(), 600u) << "what is not shown is not rendered";
  EXPECT_GT(types[1].visible(), 20u);
  EXPECT_GT(types[1].hidden(), 3u);
  EXPECT_GT(types[1].clipped(), 20u);
  auto compartments = render::countCompartments(*scene.model.data, types);
  ASSERT_EQ(compartments.size(), 3u);
  EXPECT_EQ(compartments[0].total(), 1800u);
  Counts below;
  for (std::size_t c = 1; c < 3; ++c) below += compartments[c];
  EXPECT_EQ(below, compartments[0]);
}

TEST_F(FocusGL, SurfacesBesideAModelChangeNoCounts) {
  scene::Scene scene = focusScene(15);
  render::InstanceBits alone = bitsOf(scene);
  for (float z : {-900.0f, -800.0f, -700.0f}) {
    Mesh mesh;
    mesh.positions = {{0, 0, z}, {1, 0, z}, {0, 1, z}};
    mesh.indices = {0, 1, 2};
    scene.surfaces.emplace_back();
    scene.surfaces.back().data = Shared<Mesh>(mesh);
  }
  render::InstanceBits beside = bitsOf(scene);
  EXPECT_EQ(beside.shown, alone.shown);
  EXPECT_EQ(beside.removed, alone.removed);
}

TEST_F(FocusGL, CountingChangesNoPicture) {
  scene::Scene scene = focusScene(12);
  scene.cuts[0].shape = scene::CutShape::Sphere;
  scene.cuts[0].model.focus.reset();
  scene.cuts[0].size = glm::dvec3(200.0);
  scene.cuts[0].model.spares[0].share = 0.4;
  Image plain = draw(scene, kSize, kLayers);
  bitsOf(scene);
  EXPECT_EQ(differenceOf(plain, renderer().read(kLayers)).largest, 0.0);
}

TEST_F(FocusGL, CountsComeWithoutWaitingAndAreExactAtRest) {
  scene::Scene scene = focusScene(13);
  render::InstanceBits wanted = bitsOf(scene);
  scene::Scene other = scene;
  other.camera.eye = scene.camera.target + 0.6 * (scene.camera.eye - scene.camera.target);
  bitsOf(other);
  render::Frame frame;
  frame.scene = scene;
  frame.pictureSize = kSize;
  frame.countsInstances = true;
  while (!renderer().work(frame, 5.0)) {
  }
  std::optional<render::InstanceBits> bits;
  for (int i = 0; i < 1000 && !bits; ++i) bits = renderer().bits();
  ASSERT_TRUE(bits);
  EXPECT_EQ(bits->shown, wanted.shown);
  EXPECT_EQ(bits->removed, wanted.removed);
  EXPECT_FALSE(renderer().bits()) << "once each";
}

}  // namespace
}  // namespace velum
