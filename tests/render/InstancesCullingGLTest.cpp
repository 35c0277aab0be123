// Who is hidden is found, and nobody else is left out.
#include <random>

#include "InstancesFixture.h"
#include "gpu/Program.h"
#include "model/Levels.h"

namespace velum {
namespace {

using scene::Projection;

TEST_F(InstancesGL, CullingHidesNothing) {
  ModelMaker maker;
  maker.instances = 6000;
  maker.halfEdge = 150;
  Model model = maker.make();
  Shared<Model> shared(std::move(model));
  Progress progress;
  Shared<LevelSet> levels(model::computeLevels(*shared, progress));
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
    if (step % 4 == 3) scene.model.types = {{.type = "root.a.type0", .visible = false}};
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

}  // namespace
}  // namespace velum
