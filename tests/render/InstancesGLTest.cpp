// Instances of a model: exact spheres, the cuts' fold instance by instance, copies.
#include <random>

#include "InstancesFixture.h"
#include "NaiveCuts.h"
#include "gpu/GpuError.h"
#include "plateSurface.h"
#include "render/kept/KeptInstances.h"

namespace velum {
namespace {

using scene::Projection;

TEST_F(InstancesGL, DepthsAreThoseOfTheSpheres) {
  // Some of a fraction of a pixel, some of many: all of the ways in which they are drawn.
  for (int atoms : {1, 6, 40})
    for (auto projection : {Projection::Perspective, Projection::Orthographic})
      for (double zoom : {1.0, 6.0, 40.0}) {
        ModelMaker maker;
        maker.atoms = atoms;
        maker.instances = 60;
        maker.halfEdge = 60;
        maker.seed = unsigned(atoms);
        Model model = maker.make();
        std::vector<glm::dvec4> spheres;
        for (const Instance& instance : model.instances)
          for (const Atom& atom : model.molecules[instance.molecule].atoms)
            spheres.emplace_back(glm::dvec3(instance.position) + glm::dvec3(instance.rotation * atom.position),
                                 radiusOf(atom.element));
        scene::Scene scene = sceneOfModel(std::move(model));
        scene.model.detail = 0.1;
        scene.camera.projection = projection;
        scene.camera.fieldOfViewDeg /= zoom;
        scene.camera.height /= zoom;
        glm::ivec2 size(90, 70);
        Image image = draw(scene, size, kLayers);
        int wrong = 0, shown = 0;
        for (int y = 0; y < size.y; ++y)
          for (int x = 0; x < size.x; ++x) {
            TestRay ray = rayThrough(scene.camera, size, {x + 0.5, y + 0.5});
            double wanted = firstSphere(ray, spheres);
            float z = sampleOf(image, {x, y}, "Z");
            shown += std::isfinite(z);
            if (std::isfinite(wanted) != std::isfinite(z)) {
              ++wrong;  // a ray may graze
            } else if (std::isfinite(z)) {
              glm::dvec3 at(vectorOf(image, {x, y}, "position"));
              EXPECT_NEAR(glm::length(at - ray.at(wanted)), 0.0, 0.02) << x << ", " << y << " zoom " << zoom;
            }
          }
        EXPECT_GT(shown, 20) << atoms << " " << zoom;
        EXPECT_LE(wrong, 2 + shown / 400) << atoms << " atoms, zoom " << zoom;
      }
}

TEST_F(InstancesGL, NormalsLookOutOfTheSpheres) {
  scene::Scene scene = sceneOfModel(modelOfAtoms({{0, 0, 0}}, kResidue));
  scene.camera.projection = Projection::Orthographic;
  glm::ivec2 size(64, 64);
  Image image = draw(scene, size, kLayers);
  int shown = eachShown(image, [&](glm::ivec2 pixel, glm::vec3 at) {
    EXPECT_LT(glm::length(vectorOf(image, pixel, "normal") - glm::normalize(at)), 0.02f);
  });
  EXPECT_GT(shown, 1500);
}

TEST_F(InstancesGL, CutsLeaveWhatThePlainEvaluationLeaves) {
  constexpr int kEdge = 24;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  auto between = [&](double a, double b) { return a + (b - a) * unit(random); };
  int removedSomewhere = 0;
  for (int round = 0; round < 24; ++round) {
    scene::Scene scene = sceneOfModel(lattice(kEdge, 12.0f));
    scene.camera.projection = Projection::Orthographic;
    scene.camera.height = 12.0 * (kEdge + 1);
    for (int i = 0, count = 1 + round % 4; i < count; ++i) {
      scene::Cut cut;
      cut.shape = static_cast<scene::CutShape>(random() % 5);
      cut.invert = random() % 3 == 0;
      cut.joined = i > 0 && random() % 3 == 0;
      cut.model.wholeInstances = random() % 3 == 0;
      cut.centre = {between(-80, 80), between(-10, 40), between(-80, 80)};
      cut.axis = {between(-1, 1), between(-1, 1), between(-1, 1)};
      cut.spinDeg = between(-90, 90);
      cut.size = {between(60, 200), between(60, 200), between(60, 200)};
      if (random() % 2) {
        scene::TypeSpare spare;
        spare.type = "root";
        spare.share = unit(random);
        if (random() % 2) spare.falloff = between(-60, 60);
        if (random() % 3 == 0) spare.distance = between(0, 50);
        spare.amount = unit(random);
        spare.exponent = between(0.4, 3);
        cut.model.spares = {spare};
      }
      scene::addCut(scene, cut);
    }
    Image image = draw(scene, {kEdge * 10, kEdge * 10}, kLayers);
    std::set<int> shown = shownIn(image);
    std::vector<std::uint8_t> kept = render::keptInstances(scene);
    ASSERT_EQ(kept.size(), std::size_t(kEdge * kEdge));
    for (int i = 0; i < kEdge * kEdge; ++i)
      EXPECT_EQ(shown.contains(i), kept[std::size_t(i)] != 0) << i << " round " << round;
    removedSomewhere += int(shown.size()) < kEdge * kEdge;
    // Plain cuts once more, by a text that shares nothing with the first.
    bool isPlain = std::all_of(scene.cuts.begin(), scene.cuts.end(), [](const scene::Cut& cut) {
      return cut.model.spares.empty() && !cut.model.wholeInstances;
    });
    if (!isPlain) continue;
    for (int i = 0; i < kEdge * kEdge; ++i) {
      Naive answer = naive(scene, glm::dvec3(scene.model.data->instances[std::size_t(i)].position), 0);
      if (answer.isDoubtful) continue;
      EXPECT_EQ(kept[std::size_t(i)] != 0, answer.keeps) << i;
    }
  }
  EXPECT_GT(removedSomewhere, 15);
}

TEST_F(InstancesGL, AShareLeavesThatShareAndAlwaysTheSame) {
  scene::Scene scene = sceneOfModel(lattice(40, 10.0f));
  scene.camera.projection = Projection::Orthographic;
  scene.camera.height = 420;
  scene::Cut cut;
  cut.shape = scene::CutShape::Sphere;
  cut.size = glm::dvec3(5000);
  cut.model.spares = {{}};
  cut.model.spares[0].type = "root";
  scene::addCut(scene, cut);
  std::set<int> before;
  for (double share : {0.0, 0.1, 0.3, 0.7, 1.0}) {
    scene.cuts[0].model.spares[0].share = share;
    std::set<int> shown = shownIn(draw(scene, {420, 420}, kLayers));
    EXPECT_NEAR(double(shown.size()) / 1600.0, share, 0.04);
    EXPECT_TRUE(std::includes(shown.begin(), shown.end(), before.begin(), before.end()))
        << "what a smaller share leaves a larger one leaves, too";
    before = shown;
    // From elsewhere the same ones.
    scene::Scene turned = scene;
    lookAlong(turned, {0.2, -1, 0.1}, 3000);
    EXPECT_EQ(shownIn(draw(turned, {420, 420}, kLayers)), shown);
  }
}

TEST_F(InstancesGL, AtTheUsualDetailOutlinesAreWithinAPixel) {
  ModelMaker maker;
  maker.atoms = 1500;
  maker.moleculeRadius = 26;
  maker.instances = 14;
  maker.halfEdge = 150;
  scene::Scene scene = sceneOfModel(maker.make());
  for (double zoom : {0.15, 0.4, 1.0, 3.0}) {
    scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 1.0);
    scene.camera.eye = scene.camera.target + (scene.camera.eye - scene.camera.target) / zoom;
    scene.model.detail = 1.0;
    glm::ivec2 size(200, 200);
    Image usual = draw(scene, size);
    scene.model.detail = 0.1;
    Image exact = draw(scene, size);
    int far = 0, shown = 0;
    auto covers = [&](const Image& image, glm::ivec2 at) {
      return at.x >= 0 && at.y >= 0 && at.x < size.x && at.y < size.y && sampleOf(image, at, "A") > 0.5f;
    };
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        for (auto [a, b] : {std::pair(&usual, &exact), std::pair(&exact, &usual)}) {
          if (!covers(*a, {x, y})) continue;
          ++shown;
          bool isNear = false;
          for (int v = -1; v <= 1; ++v)
            for (int u = -1; u <= 1; ++u) isNear = isNear || covers(*b, {x + u, y + v});
          far += !isNear;
        }
    EXPECT_GT(shown, 200);
    EXPECT_LE(far, shown / 500) << "zoom " << zoom;
  }
}

TEST_F(InstancesGL, AZoomDoesNotPop) {
  ModelMaker maker;
  maker.atoms = 900;
  maker.moleculeRadius = 24;
  maker.instances = 120;
  scene::Scene scene = sceneOfModel(maker.make());
  scene.lighting.shaded = true;
  glm::dvec3 away = scene.camera.eye - scene.camera.target;
  auto steps = [&](double detail) {
    std::vector<double> differences;
    Image before;
    scene.model.detail = detail;
    for (int step = 0; step < 24; ++step) {
      scene.camera.eye = scene.camera.target + away * std::pow(1.02, step);
      Image image = draw(scene, {150, 150});
      if (step > 0) differences.push_back(differenceOf(before, image).mean);
      before = image;
    }
    return *std::max_element(differences.begin(), differences.end());
  };
  // Atoms alone do not change while one zooms; levels may add a third to what a step changes.
  double atoms = steps(0.1), levels = steps(1.0);
  EXPECT_LT(levels, 1.35 * atoms + 0.2) << "grey levels, mean over the picture";
}

TEST_F(InstancesGL, AModelAndAVolumeHideEachOtherByDepth) {
  glm::ivec3 dims(40, 40, 40);
  scene::Scene scene = sceneOf(makeVolume(
      dims, SampleType::UInt8, [](glm::ivec3) { return 200.0; }, centredFrame(dims)));
  makeSolid(scene);
  scene.unit = LengthUnit::Angstrom;
  // One atom half out of the front face, one behind the volume, one beside it.
  scene.model.data = Shared<Model>(modelOfAtoms({{0, -20, 0}, {0, 30, 0}, {26, 0, 0}}, kResidue));
  scene.camera.target = {0, 0, 0};
  scene.camera.projection = Projection::Orthographic;
  scene.camera.height = 70;
  lookAlong(scene, {0, -1, 0});
  Image image = draw(scene, {140, 140}, kLayers);
  EXPECT_EQ(sampleOf(image, {70, 70}, "instance"), 1.0f) << "the atom stands out of the face";
  EXPECT_EQ(sampleOf(image, {70, 70}, "type"), 0.0f);
  EXPECT_NEAR(vectorOf(image, {70, 70}, "position").y, -20 - radiusOf(kResidue), 0.05);
  EXPECT_EQ(sampleOf(image, {50, 50}, "instance"), 0.0f) << "the volume";
  EXPECT_EQ(sampleOf(image, {122, 70}, "instance"), 3.0f) << "beside it";
  EXPECT_FALSE(shownIn(image).contains(1)) << "what is behind is hidden";
  render::Pick pick = renderer().pick({122, 70});
  EXPECT_EQ(pick.type, 0);
  EXPECT_EQ(pick.modelInstance, 2u);
  EXPECT_EQ(pick.structure, 0);
}

TEST_F(InstancesGL, AModelAVolumeAndASurfaceHideEachOtherAlongEachRay) {
  // In a wide view: far off its axis depth and distance differ by a third.
  glm::ivec3 dims(60, 20, 60);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  std::vector<glm::vec3> places;
  std::vector<glm::dvec4> spheres;
  for (int i = 0; i < 60; ++i) {
    places.emplace_back(28 * unit(random), -10 + 4 * unit(random), 28 * unit(random));
    spheres.emplace_back(glm::dvec3(places.back()), radiusOf(kResidue));
  }
  for (bool isSurface : {false, true}) {
    scene::Scene scene;
    if (isSurface) {
      scene.surfaces = {plateSurface(30, -10)};
      scene.lighting.shaded = false;
      scene.rayCast.samplesPerPixel = 1;
    } else {
      scene = sceneOf(makeVolume(
          dims, SampleType::UInt8, [](glm::ivec3) { return 200.0; }, centredFrame(dims)));
      makeSolid(scene);
    }
    scene.background.transparent = true;
    scene.unit = LengthUnit::Angstrom;
    scene.model.data = Shared<Model>(modelOfAtoms(places, kResidue));
    scene.model.detail = 0.1;
    scene.camera.target = {0, 0, 0};
    scene.camera.projection = Projection::Perspective;
    scene.camera.fieldOfViewDeg = 80;
    lookAlong(scene, {0, -1, 0}, 40);
    glm::ivec2 size(120, 120);
    Image image = draw(scene, size, kLayers);
    int first = int(scene.surfaces.size()) + 1, atoms = 0, hidden = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        TestRay ray = rayThrough(scene.camera, size, {x + 0.5, y + 0.5});
        double sphere = firstSphere(ray, spheres), face = (-10.0 - ray.origin.y) / ray.direction.y;
        if (glm::any(glm::greaterThan(glm::abs(ray.at(face)), glm::dvec3(29.5)))) continue;
        // A block is opaque a little behind its face.
        if (std::abs(sphere - face) < 0.3) continue;
        bool isAtom = int(sampleOf(image, {x, y}, "instance")) >= first;
        EXPECT_EQ(isAtom, sphere < face) << (isSurface ? "surface" : "volume") << ", " << x << ", " << y;
        (isAtom ? atoms : hidden) += std::isfinite(sphere);
      }
    EXPECT_GT(atoms, 1000);
    EXPECT_GT(hidden, 500);
  }
}

TEST_F(InstancesGL, CopiesStandSideBySide) {
  scene::Scene scene = sceneOfModel(lattice(3, 20.0f));
  scene.model.copies = 5;
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 1.0);
  scene.camera.projection = Projection::Orthographic;
  std::set<int> shown = shownIn(draw(scene, {300, 300}, kLayers));
  EXPECT_EQ(shown.size(), 45u);
  EXPECT_EQ(*shown.rbegin(), 44);
}

TEST_F(InstancesGL, EachCopyStandsWhereTheGridOfCopiesHasIt) {
  scene::Scene scene = sceneOfModel(lattice(3, 20.0f));
  scene.model.detail = 0.1;
  const Model& model = *scene.model.data;
  int count = int(model.instances.size());
  for (int copies : {2, 5, 12}) {
    scene.model.copies = copies;
    scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 1.0);
    scene.camera.projection = Projection::Orthographic;
    Image image = draw(scene, {200, 200}, kLayers);
    scene::CopyGrid grid = scene::copyGrid(scene.model);
    std::set<int> shown;
    double worst = 0.0;
    eachShown(image, [&](glm::ivec2 pixel, glm::vec3 at) {
      int instance = int(sampleOf(image, pixel, "instance")) - 1, copy = instance / count;
      int line = copy / grid.counts.x;
      glm::dvec3 block(copy % grid.counts.x, line % grid.counts.y, line / grid.counts.y);
      glm::dvec3 middle = glm::dvec3(model.instances.at(std::size_t(instance % count)).position) + block * grid.step;
      worst = std::max(worst, std::abs(glm::distance(glm::dvec3(at), middle) - double(radiusOf(kResidue))));
      shown.insert(copy);
    });
    // Positions are as exact as depths are, see DepthsAreThoseOfTheSpheres.
    EXPECT_LT(worst, 0.02) << copies << " copies";
    EXPECT_EQ(int(shown.size()), copies);
  }
}

TEST_F(InstancesGL, FarFromTheOriginThePictureIsTheSame) {
  // As files have them that keep the coordinates of a tomogram.
  auto drawAt = [&](glm::vec3 shift) {
    Model model = ModelMaker{}.make();
    for (Instance& instance : model.instances) instance.position += shift;
    model.low += shift;
    model.high += shift;
    scene::Scene scene = sceneOfModel(std::move(model));
    scene.model.detail = 0.1;
    return draw(scene, {100, 100});
  };
  // Positions are floats: at 16384 angstrom a thousandth of one.
  EXPECT_LT(differenceOf(drawAt({0, 0, 0}), drawAt({16384, -8192, 4096})).mean, 0.6);
}

TEST_F(InstancesGL, TheSameSceneGivesTheSameBytes) {
  ModelMaker maker;
  maker.instances = 3000;
  scene::Scene scene = sceneOfModel(maker.make());
  scene.lighting.shaded = true;
  scene.lighting.fog = 0.5;
  scene.rayCast.samplesPerPixel = 3;
  scene.finish.contours = 0.8;
  Image first = draw(scene, {100, 80}, kLayers);
  for (int i = 0; i < 3; ++i) {
    renderer().clear();
    expectIdentical(first, draw(scene, {100, 80}, kLayers), "again");
  }
}

TEST_F(InstancesGL, WhatIsShownAloneHoldsWhatIsShown) {
  ModelMaker maker;
  maker.instances = 400;
  scene::Scene scene = sceneOfModel(maker.make());
  scene::Cut cut;
  cut.axis = {1, 0, 0};
  scene::addCut(scene, cut);
  scene.model.types = {{.type = "root.b.type1", .visible = false}};
  auto kept = render::keptInstances(scene);
  Model shown = render::shownModel(scene, kept);
  std::size_t wanted = 0;
  const Model& model = *scene.model.data;
  for (std::size_t i = 0; i < kept.size(); ++i)
    wanted += kept[i] && model.types[model.molecules[model.instances[i].molecule].type].name != "type1";
  EXPECT_EQ(shown.instances.size(), wanted);
  EXPECT_EQ(shown.types.size(), 2u);
  for (const Instance& instance : shown.instances) EXPECT_LE(instance.position.x, 0.0f);
  // It draws as the cut scene does.
  scene::Scene alone = sceneOfModel(std::move(shown));
  alone.camera = scene.camera;
  alone.model.palette = scene.model.palette = scene::Palette::Compartment;
  EXPECT_LT(differenceOf(draw(scene, {100, 100}), draw(alone, {100, 100})).mean, 3.0);
}

TEST_F(InstancesGL, MoreThanTheDriverHasRoomForAreRefusedInOneLine) {
  ::setenv("VELUM_MAX_TEXTURE_BUFFER", "65536", 1);
  auto small = gpu::Context::create(gpu::ContextKind::Auto);
  ::unsetenv("VELUM_MAX_TEXTURE_BUFFER");
  render::Renderer other(*small);
  EXPECT_NO_THROW(drawWith(other, sceneOfModel(lattice(181, 10.0f)), {32, 32}));
  try {
    drawWith(other, sceneOfModel(lattice(182, 10.0f)), {32, 32});  // 33,124 instances, two texels each
    ADD_FAILURE() << "drawn";
  } catch (const gpu::GpuError& error) {
    EXPECT_NE(std::string(error.what()).find("32768 are the most: leave out"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace velum
