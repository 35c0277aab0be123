// Instances of a model: exact spheres, the cuts' fold instance by instance, culling that hides nothing.
#include <cstdlib>
#include <random>
#include <set>

#include "NaiveCuts.h"
#include "RenderFixture.h"
#include "makeModel.h"
#include "velum/gpu/GpuError.h"
#include "velum/gpu/Program.h"
#include "velum/mesoscale/Levels.h"
#include "velum/render/section/KeptInstances.h"

namespace velum {
namespace {

using scene::Projection;

class InstancesGL : public RenderTest {
 protected:
  static constexpr render::Layers kLayers{true, true, true, true, true, true};

  /// A model seen from the front: no light, one sample, no background.
  static scene::Scene sceneOfModel(Model model) {
    scene::Scene scene;
    scene.unit = LengthUnit::Angstrom;
    scene.model.data = Shared<Model>(std::move(model));
    scene.lighting.shaded = false;
    scene.rayCast.samplesPerPixel = 1;
    scene.background.transparent = true;
    scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 1.0);
    return scene;
  }
  /// Atoms of and over a floor across y, lit, orthographic from the front.
  static scene::Scene floorScene(const std::vector<glm::vec3>& places) {
    scene::Scene scene = sceneOfModel(modelOfAtoms(places, kResidue));
    scene.camera.target = {0, 0, 0};
    scene.camera.projection = Projection::Orthographic;
    scene.camera.height = 90;
    lookAlong(scene, {0, -1, 0}, 300);
    scene.lighting.shaded = true;
    return scene;
  }
  /// Instances of the model that a picture shows.
  static std::set<int> shownIn(const Image& image, int first = 1) {
    std::set<int> shown;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        if (float instance = sampleOf(image, {x, y}, "instance"); instance >= float(first))
          shown.insert(int(instance) - first);
    return shown;
  }
  /// Atoms on a square lattice before the eye, so far apart that none hides another.
  static Model lattice(int edge, float apart) {
    std::vector<glm::vec3> places;
    for (int z = 0; z < edge; ++z)
      for (int x = 0; x < edge; ++x)
        places.emplace_back((float(x) - 0.5f * float(edge - 1)) * apart, 3.0f * float((7 * x + 3 * z) % 11),
                            (float(z) - 0.5f * float(edge - 1)) * apart);
    return modelOfAtoms(places, kResidue);
  }
};

/// Where a ray first meets one of some spheres; infinity: nowhere.
double firstSphere(const TestRay& ray, const std::vector<glm::dvec4>& spheres) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& s : spheres) {
    glm::dvec3 q = glm::dvec3(s) - ray.origin;
    double b = glm::dot(q, ray.direction), left = s.w * s.w - (glm::dot(q, q) - b * b);
    if (left < 0) continue;
    double t = b - std::sqrt(left);
    if (t > 0) nearest = std::min(nearest, t);
  }
  return nearest;
}

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
      cut.wholeInstances = random() % 3 == 0;
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
        cut.typeSpares = {spare};
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
    bool isPlain = std::all_of(scene.cuts.begin(), scene.cuts.end(),
                               [](const scene::Cut& cut) { return cut.typeSpares.empty() && !cut.wholeInstances; });
    if (!isPlain) continue;
    for (int i = 0; i < kEdge * kEdge; ++i) {
      Naive answer = naive(scene, glm::dvec3(scene.model.data->instances[std::size_t(i)].position), 0, 0.0);
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
  cut.typeSpares = {{}};
  cut.typeSpares[0].type = "root";
  scene::addCut(scene, cut);
  std::set<int> before;
  for (double share : {0.0, 0.1, 0.3, 0.7, 1.0}) {
    scene.cuts[0].typeSpares[0].share = share;
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

TEST_F(InstancesGL, CullingHidesNothing) {
  ModelMaker maker;
  maker.instances = 6000;
  maker.halfEdge = 150;
  Model model = maker.make();
  Shared<Model> shared(std::move(model));
  Progress progress;
  Shared<LevelSet> levels(mesoscale::computeLevels(*shared, progress));
  scene::Scene scene = sceneOfModel(ModelMaker{}.make());
  scene.model.data = shared;
  scene.model.levels = levels;
  scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 1.0);
  // One renderer remembers what was seen while the camera moves, far and near; the other one begins anew each time.
  render::Renderer fresh(context());
  for (int step = 0; step < 9; ++step) {
    double turn = 0.7 * step;
    lookAlong(scene, {std::sin(turn), -std::cos(turn), 0.3 * std::sin(2 * turn)},
              step % 3 == 2 ? 130 : 500 + 60 * step);
    scene.model.types.clear();
    if (step % 4 == 3) scene.model.types = {{"root.a.type0", false, {}, ""}};
    Image image = draw(scene, {120, 90}, kLayers);
    fresh.clear();
    expectIdentical(image, drawWith(fresh, scene, {120, 90}, kLayers), "step " + std::to_string(step));
  }
}

TEST_F(InstancesGL, WhatShowsOnlyInTheLastColumnsOrRowsIsFoundAgain) {
  // A wall that ends before the last pixels, and an atom behind it that shows there and nowhere else: widths and
  // heights that halve without and with a rest, tile by tile of four pixels.
  const double pixel = 0.1, radius = double(radiusOf(6));
  for (bool isTall : {false, true})
    for (int tiles : {20, 21, 22, 23, 25, 27}) {
      glm::ivec2 size(4 * tiles, 40);
      if (isTall) std::swap(size.x, size.y);
      glm::dvec3 along = isTall ? glm::dvec3(0, 0, -1) : glm::dvec3(1, 0, 0);
      glm::dvec3 across = isTall ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, -1);
      // The wall's rim is where the last four pixels begin.
      double rim = pixel * (2 * tiles - 4);
      std::vector<glm::vec3> places{glm::vec3(along * (rim - 1.0) + glm::dvec3(0, 30, 0))};
      for (double u = 0.0; u < 2.0 * rim + 6.0; u += 0.4)
        for (double v = -4.0; v <= 4.0; v += 0.1) places.emplace_back(along * (rim - radius - u) + across * v);
      scene::Scene scene = sceneOfModel(modelOfAtoms(places));
      scene.model.detail = 0.1;
      scene.camera.projection = Projection::Orthographic;
      scene.camera.height = pixel * size.y;
      // All of the atom is behind the wall; then the eye moves to where its edge shows.
      scene.camera.target = along * (-3.0);
      lookAlong(scene, {0, -1, 0}, 100);
      EXPECT_FALSE(shownIn(draw(scene, size, kLayers)).contains(0)) << tiles;
      scene.camera.target = {0, 0, 0};
      lookAlong(scene, {0, -1, 0}, 100);
      EXPECT_TRUE(shownIn(draw(scene, size, kLayers)).contains(0)) << (isTall ? "rows" : "columns") << ", " << tiles;
    }
}

TEST_F(InstancesGL, HiddenInstancesAreFoundByBruteForce) {
  // Whatever is culled: the picture of all balls is that of the nearest of all.
  ModelMaker maker;
  maker.instances = 1500;
  maker.atoms = 12;
  maker.halfEdge = 60;
  Model model = maker.make();
  std::vector<glm::dvec4> spheres;
  std::vector<int> owner;
  for (std::size_t i = 0; i < model.instances.size(); ++i)
    for (const Atom& atom : model.molecules[model.instances[i].molecule].atoms) {
      const Instance& instance = model.instances[i];
      spheres.emplace_back(glm::dvec3(instance.position) + glm::dvec3(instance.rotation * atom.position),
                           radiusOf(atom.element));
      owner.push_back(int(i));
    }
  scene::Scene scene = sceneOfModel(std::move(model));
  scene.model.detail = 0.1;
  glm::ivec2 size(80, 80);
  draw(scene, size);  // so that some were seen before
  lookAlong(scene, {0.1, -1, 0.05}, glm::length(scene.camera.eye - scene.camera.target));
  Image image = draw(scene, size, kLayers);
  int wrong = 0, shown = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      TestRay ray = rayThrough(scene.camera, size, {x + 0.5, y + 0.5});
      double nearest = 1e30;
      int who = -1;
      for (std::size_t i = 0; i < spheres.size(); ++i) {
        double t = firstSphere(ray, {spheres[i]});
        if (t < nearest) nearest = t, who = owner[i];
      }
      shown += who >= 0;
      wrong +=
          int(sampleOf(image, {x, y}, "instance")) - 1 != who && (who >= 0 || sampleOf(image, {x, y}, "instance") >= 0);
    }
  EXPECT_GT(shown, 2000);
  EXPECT_LE(wrong, shown / 500) << "rays that graze, and spheres that meet in a pixel";
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
      Mesh mesh;
      mesh.positions = {{-30, -10, -30}, {30, -10, -30}, {30, -10, 30}, {-30, -10, 30}};
      mesh.indices = {0, 1, 2, 0, 2, 3};
      scene::Surface surface;
      surface.data = Shared<Mesh>(mesh);
      scene.surfaces = {surface};
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

TEST_F(InstancesGL, InFullFogTheDeepestIsTheBackgroundBehindIt) {
  std::vector<glm::vec3> places{{0, -100, 0}};
  for (int i = -4; i <= 4; ++i) places.emplace_back(10.0f, 100.0f, 10.0f * float(i));
  scene::Scene scene = sceneOfModel(modelOfAtoms(places, kResidue));
  scene.camera.target = {0, 0, 0};
  scene.camera.projection = Projection::Orthographic;
  scene.camera.height = 100;
  lookAlong(scene, {0, -1, 0}, 400);
  scene.background.transparent = false;
  scene.background.top = {1, 0.2f, 0};
  scene.background.bottom = {0, 0.2f, 1};
  glm::ivec2 size(100, 100);
  Image clear = draw(scene, size, kLayers);
  scene.lighting.fog = 1.0;
  Image image = draw(scene, size, kLayers);
  int far = 0, near = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      int instance = int(sampleOf(image, {x, y}, "instance"));
      if (instance < 1) continue;
      glm::vec3 behind = glm::mix(scene.background.top, scene.background.bottom, (float(y) + 0.5f) / 100.0f);
      // Its front is not quite as deep as it reaches.
      glm::vec3 wanted = instance == 1 ? glm::vec3(colorOf(clear, {x, y})) : behind;
      EXPECT_LT(glm::length(glm::vec3(colorOf(image, {x, y})) - wanted), 0.03f) << x << ", " << y;
      ++(instance == 1 ? near : far);
    }
  EXPECT_GT(near, 20);
  EXPECT_GT(far, 200);
}

/// Atoms so close on a plane across y that it is nearly flat, in a rectangle of x and z.
void addFloor(std::vector<glm::vec3>& places, float y, glm::vec2 low, glm::vec2 high) {
  for (float x = low.x; x <= high.x; x += 2.0f)
    for (float z = low.y; z <= high.y; z += 2.0f) places.emplace_back(x, y, z);
}

TEST_F(InstancesGL, AShadowFallsAwayFromTheLight) {
  std::vector<glm::vec3> places;
  addFloor(places, 0.0f, {-40, -40}, {40, 40});
  for (int i = 0; i < 27; ++i) places.emplace_back(2 * (i % 3) - 2, -20 + 2 * (i / 3 % 3) - 2, 13 + 2 * (i / 9));
  scene::Scene scene = floorScene(places);
  scene.lighting.occlusion = scene.lighting.specular = 0.0;
  scene.lighting.diffuse = 1.0;
  scene.rayCast.samplesPerPixel = 4;
  glm::ivec2 size(180, 180);
  // What hangs 20 before the floor at x = 0, z = 15 throws its shadow as far to the side.
  struct Case {
    glm::dvec3 key;
    glm::dvec2 shadow;
  };
  for (const Case& c : {Case{{-1, 0, 1}, {20, 15}}, Case{{1, 0, 1}, {-20, 15}}, Case{{0, 1, 1}, {0, -5}}}) {
    scene.lighting.keyDirection = c.key;
    scene.lighting.shadow = 0.0;
    Image plain = draw(scene, size, kLayers);
    scene.lighting.shadow = 1.0;
    Image shadowed = draw(scene, size, kLayers);
    double in = 0, beside = 0;
    int countIn = 0, countBeside = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        glm::dvec3 p(vectorOf(shadowed, {x, y}, "position"));
        double off = glm::distance(glm::dvec2(p.x, p.z), c.shadow);
        if (std::abs(p.y) > 4.0 || glm::length(glm::dvec2(p.x, p.z)) > 35) continue;
        double dark = double(sampleOf(plain, {x, y}, "G") - sampleOf(shadowed, {x, y}, "G"));
        if (off < 2.0) in += dark, ++countIn;
        if (off > 9.0) beside += dark, ++countBeside;
      }
    ASSERT_GT(countIn, 20);
    ASSERT_GT(countBeside, 1000);
    EXPECT_GT(in / countIn, 4.0 * beside / countBeside + 0.05)
        << "light from " << c.key.x << ", " << c.key.y << ": " << in / countIn << " and " << beside / countBeside;
  }
}

TEST_F(InstancesGL, WhatLiesOpenIsDarkWhereItIsCovered) {
  // A block over the middle of a floor: its shade lies around it, not half a pixel to a side.
  std::vector<glm::vec3> places;
  addFloor(places, 0.0f, {-40, -40}, {40, 40});
  for (int i = 0; i < 27; ++i) places.emplace_back(2 * (i % 3) - 2, -8 + 2 * (i / 3 % 3) - 2, 2 * (i / 9) - 2);
  scene::Scene scene = floorScene(places);
  scene.lighting.shadow = scene.lighting.specular = 0.0;
  scene.rayCast.samplesPerPixel = 4;
  glm::ivec2 size(120, 120);
  scene.lighting.occlusion = 0.0;
  Image open = draw(scene, size, kLayers);
  scene.lighting.occlusion = 1.0;
  Image covered = draw(scene, size, kLayers);
  double sum = 0, x = 0, z = 0;
  for (glm::ivec2 pixel(0); pixel.y < size.y; ++pixel.y)
    for (pixel.x = 0; pixel.x < size.x; ++pixel.x) {
      glm::dvec3 p(vectorOf(covered, pixel, "position"));
      double off = glm::length(glm::dvec2(p.x, p.z));
      if (std::abs(p.y) > 4.0 || off > 30.0) continue;
      double dark = double(sampleOf(open, pixel, "G") - sampleOf(covered, pixel, "G"));
      sum += dark, x += dark * p.x, z += dark * p.z;
    }
  ASSERT_GT(sum, 10.0);
  double pixel = scene.camera.height / size.y;
  EXPECT_NEAR(x / sum / pixel, 0.0, 0.2);
  EXPECT_NEAR(z / sum / pixel, 0.0, 0.2);
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
  scene.model.types = {{"root.b.type1", false, {}, ""}};
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

TEST_F(InstancesGL, APictureOfMorePixelsThanGroupsInARowRemembersWhatItSaw) {
  // 64 pixels a group, and 65,535 groups along an axis are all that drivers promise.
  scene::Scene scene = sceneOfModel(lattice(3, 10.0f));
  glm::ivec2 size(2200, 2000);
  ASSERT_GT(size.x * size.y, 64 * gpu::kMostGroups);
  Image first = draw(scene, size);
  EXPECT_GT(coverageOf(first), 0.01);
  scene.background.top = {0.5f, 0.5f, 0.5f};  // which asks for a picture anew, of the same
  expectIdentical(draw(scene, size), first, "what was seen before comes first");
}

TEST_F(InstancesGL, MoreThanTheDriverHasRoomForAreRefusedInOneLine) {
  scene::Scene scene = sceneOfModel(lattice(3, 10.0f));
  ::setenv("VELUM_MAX_TEXTURE_BUFFER", "65536", 1);
  auto small = gpu::Context::createEgl();
  ::unsetenv("VELUM_MAX_TEXTURE_BUFFER");
  {
    render::Renderer other(*small);
    scene.model.copies = 3640;  // times nine, twice, are just fewer than 65,536
    EXPECT_NO_THROW(drawWith(other, scene, {32, 32}));
    scene.model.copies = 3641;
    try {
      drawWith(other, scene, {32, 32});
      ADD_FAILURE() << "drawn";
    } catch (const gpu::GpuError& error) {
      EXPECT_NE(std::string(error.what()).find("32768 are the most: take fewer copies"), std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace velum
